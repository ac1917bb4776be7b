#!/usr/bin/env python3
"""Shows that the self-checking decks can fail: changes one value of each, runs it, and expects a failed check.

usage: break_decks.py CLEAVE [NAME...]      (default: all; prints the tables of docs/verification-decks.md)

Ends with status 1 if a changed deck still passes. Takes about twenty minutes; nothing runs it by itself.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))
import run_decks  # noqa: E402

# family: {deck: changes}; a change is (words, keyword, row after it, column, factor or "=VALUE" [, deck to change instead]),
# (words, lines to insert) or (words, text, "->", text). KEYWORD#2 is the second of its kind. Columns are 10 wide, 20 where
# the keyword ends in +; comments are no rows.
DENSITY, YOUNG, POISSON = 1, 2, 3
SAFETY = ("*CONTROL_TIMESTEP", 0, 1)
MOTION = [("one velocity of one node", "*BOUNDARY_PRESCRIBED_MOTION_NODE+", 3, 4, 1.2)]
CYLINDER = [("PR", "*MAT_ELASTIC", 0, POISSON, 0.8)]
E_OF = lambda factor: ("E", "*MAT_ELASTIC", 0, YOUNG, factor)
LOAD_CURVE = lambda factor: ("load", "*LOAD_SEGMENT_SET", 0, 2, factor)
YIELD = ("SIGY", "*MAT_PLASTIC_KINEMATIC", 0, 4)
SPEED = ("speed", "*INITIAL_VELOCITY", 1, 2)
RIGID = ("RO", "*MAT_RIGID", 0, DENSITY)
SURFACES = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE"
SINGLE = "*CONTACT_AUTOMATIC_SINGLE_SURFACE"
SIDES = ("sides exchanged", "\n         1         2         3         3\n", "->",
         "\n         2         1         3         3\n")
ALONG = ("speed", "*INITIAL_VELOCITY", 1, 0, 1.2)
FRICTION = lambda factor: ("FS", SURFACES, 1, 0, factor)
METHODS = ("nodes", "soft", "segments")
TESTED = "tests/verification", "tests/validation", "tests/regression", "examples"
FAMILIES = {
    "Bodies that deform": {
        "bending_beam_nodal_pressure": [E_OF(0.8)],
        "bending_beam_selective": [E_OF(0.8)],
        "cantilever_vibration": [E_OF(1.2)],
        "collapsing_shell": [YIELD + (1.2,)],
        "cook_nodal_pressure": [E_OF(0.8)],
        "cook_selective": [E_OF(0.8)],
        **{f"patch_{name}": MOTION for name in ("hex_one_point_bindeman", "hex_one_point_flanagan", "hex_one_point_viscous",
                                                "hex_selective", "tet", "tet_nodal_pressure", "tet_quadratic", "wedge")},
        "plastic_wave": [("ETAN", "*MAT_PLASTIC_KINEMATIC", 0, 5, 1.2), YIELD + (1.2,)],
        "pressure_bath": [LOAD_CURVE(1.2), ("PR", "*MAT_ELASTIC", 0, POISSON, 1.2)],
        "simple_shear": [("PR", "*MAT_ELASTIC", 0, POISSON, 1.2)],
        "standing_wave_8": [E_OF(1.2) + ("standing_wave_32",)],
        "thick_cylinder_030": CYLINDER,
        "thick_cylinder_0499": CYLINDER,
        "thick_cylinder_04999": CYLINDER,
        "tube_inflation": [("B", "*MAT_MOONEY-RIVLIN_RUBBER", 0, 4, 1.2)],
        "tumbling": [("damping of 1e-9 added", "*DAMPING_GLOBAL\n         0      1e-9"),
                     ("TSSFAC",) + SAFETY + (1.2,)],
        "wave_exact": [("TSSFAC",) + SAFETY + (0.8,)],
        "one_element_loadcontrol": [("E", "*MAT_ELASTIC", 0, YOUNG, 1.2)],
        "cube": [("displacement", "*BOUNDARY_PRESCRIBED_MOTION_SET", 0, 4, 1.2)],
    },
    "Walls": {
        "bar_rebound": [E_OF(1.2)],
        "wall_friction_two_ways": [(name, "*RIGIDWALL_PLANAR_ORTHO", 2, column, 1.2)
                                   for name, column in (("SFRICA", 0), ("DFRICB", 3))] +
                                  [("DECAYB", "*RIGIDWALL_PLANAR_ORTHO", 2, 5, "=0")],
        "wall_hollow": [("RADCYL", "*RIGIDWALL_GEOMETRIC_CYLINDER_INTERIOR", 2, 0, 1.2),
                        ("RADSPH", "*RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR", 2, 0, 1.2)],
        "wall_moving_flat": [E_OF(1.2), ("BIRTH", "*RIGIDWALL_GEOMETRIC_FLAT_DISPLAY_MOTION_ID", 1, 3, 1.2)],
        **{f"wall_rebound_{name}": [E_OF(1.2)] for name in ("cylinder", "flat", "prism", "sphere")},
    },
    "Rigid bodies": {
        "box_drop": [("damping of 20 added", "*DAMPING_GLOBAL\n         0      20.0")],
        "rigid_ball": [RIGID + (1.2,)],
        "rigid_bar_impact": [YIELD + (1.2,)],
        "rigid_driven": [("angle", "*BOUNDARY_PRESCRIBED_MOTION_RIGID", 0, 4, 1.2)],
        "rigid_hits_bar": [E_OF(1.2), RIGID + (1.2,)],
        "rigid_merged": [RIGID + (1.2,)],
        "rigid_nodes_in_bar": [E_OF(1.2)],
        "rigid_pushed": [RIGID + (1.2,), ("force", "*LOAD_RIGID_BODY", 0, 3, 1.2)],
        "rigid_rolling": [FRICTION(1.2), ("inertia", "*PART_INERTIA", 3, 3, 1.2)],
        "rigid_walls": [("RWPNAL off", "*CONTROL_CONTACT", 0, 1, "=0"),
                        ("FRIC", "*RIGIDWALL_PLANAR_FINITE_ID", 2, 6, 1.2),
                        ("MASS", "*RIGIDWALL_PLANAR_MOVING_ID", 3, 0, 1.2)],
        "rigid_top": [("spin", "*INITIAL_VELOCITY_RIGID_BODY", 0, 6, 1.2)],
        "rigid_tumbling": [("damping of 1e-9 added", "*DAMPING_GLOBAL\n         0      1e-9")],
    },
    "Contact": {
        **{f"contact_bars_{name}": [E_OF(1.2), ("RO", "*MAT_ELASTIC#2", 0, DENSITY, 1.2), ALONG]
           for name in METHODS + ("soft_damped",)},
        **{f"contact_bounce_{name}": [("VDC", SURFACES, 1, 4, "=20")] for name in METHODS},
        "contact_box": [("SFSA", SINGLE, 2, 0, 0.5), ("DT", SINGLE, 1, 7, "=10")],
        "contact_crush": [("SFSA", SINGLE, 2, 0, 0.1), ("DT", SINGLE, 1, 7, "=0.05")],
        **{f"contact_erode_{name}": [SPEED + (1.2,)] for name in METHODS},
        **{f"contact_erode_bars_{name}": [("EROSOP", "*CONTACT_ERODING_SURFACE_TO_SURFACE", 3, 1, "=0"),
                                          ("RO", "*MAT_ELASTIC#2", 0, DENSITY, 1.2)] for name in METHODS},
        "contact_erode_bars_single": [("EROSOP", "*CONTACT_ERODING_SINGLE_SURFACE", 3, 1, "=0"),
                                      ("RO", "*MAT_ELASTIC#2", 0, DENSITY, 1.2)],
        "contact_fast": [E_OF(1.2), ALONG],
        **{f"contact_fold_{name}": [("speed of one prong", "*INITIAL_VELOCITY", 1, 1, 1.2)] for name in METHODS},
        "contact_forming": [E_OF(1.2), ("way of the punch", "*BOUNDARY_PRESCRIBED_MOTION_SET", 0, 4, 1.2),
                            ("SFSA", "*CONTACT_FORMING_ONE_WAY_SURFACE_TO_SURFACE", 2, 0, 1.2)],
        "contact_hertz": [E_OF(1.2), ("SFSA", SURFACES, 2, 0, 0.2)],
        **{f"contact_incline_{name}_{what}": [FRICTION(factor)] for name in METHODS
           for what, factor in (("slides", 1.2), ("sticks", 0.8))},
        **{f"contact_patch_{angle}": [LOAD_CURVE(1.2), ("SOFT", SURFACES, 3, 0, "=0")] for angle in (0, 15)},
        **{f"contact_slide_{name}": [FRICTION(1.2), ALONG, ("RO", "*MAT_ELASTIC", 0, DENSITY, 1.2)] for name in METHODS},
        "contact_tied_patch_nodes": [LOAD_CURVE(1.2), ("PR", "*MAT_ELASTIC", 0, POISSON, "=0.3"), SIDES],
        "contact_tied_patch_springs": [LOAD_CURVE(1.2), ("PR", "*MAT_ELASTIC", 0, POISSON, "=0.3"),
                                       ("springs at nodes", "*CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET", "->",
                                        "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET")],
    },
    "Spacetime": {
        "spacetime_bar_8": [E_OF(1.2) + ("spacetime_bar_32",)],
        "spacetime_block": [E_OF(1.2)],
        "spacetime_cavity": [("PR", "*MAT_ELASTIC", 0, POISSON, 0.9), LOAD_CURVE(1.02)],
        "spacetime_centre_crack": [E_OF(1.1), LOAD_CURVE(1.05)],
        "spacetime_fibres": [("EA", "*MAT_ORTHOTROPIC_ELASTIC", 0, 2, 1.1), ("PRCB", "*MAT_ORTHOTROPIC_ELASTIC", 0, 7, 1.2)],
        "spacetime_mixed": [E_OF(1.2)],
        "spacetime_pushed_crack": [("PR", "*MAT_ELASTIC", 0, POISSON, 0.8), LOAD_CURVE(1.05)],
        "spacetime_pushed_crack_one_field": [LOAD_CURVE(1.05)],
        "spacetime_pushed_crack_three_fields": [LOAD_CURVE(1.05)],
        "spacetime_pushed_penny": [E_OF(1.2), LOAD_CURVE(1.1)],
        "spacetime_pushed_penny_early": [E_OF(1.2), LOAD_CURVE(1.1)],
        "spacetime_repeat": [E_OF(1.2), LOAD_CURVE(1.2)],
        "spacetime_shear": [E_OF(1.2)],
        "spacetime_step_plate": [("PR", "*MAT_ELASTIC", 0, POISSON, 0.9), LOAD_CURVE(1.02)],
        "spacetime_strip": [E_OF(1.2), LOAD_CURVE(1.2)],
    },
    "Taylor bars": {
        **{f"taylor_{name}": [YIELD + (1.2,), SPEED + (1.2,)] for name in (
            "6061_169", "6061_262", "6061_306", "6061_373", "6061_478", "nodal_pressure", "one_point", "selective")},
        **{f"taylor_{name}": [("A", "*MAT_JOHNSON_COOK", 1, 0, 1.2), ("B", "*MAT_JOHNSON_COOK", 1, 1, 1.2), SPEED + (1.2,)]
           for name in ("4340_343", "copper_130", "copper_190")},
        "taylor_4340_208": [("A", "*MAT_JOHNSON_COOK", 1, 0, 1.2), SPEED + (1.2,)],
        # Measured lengths only: A or B alone, 20 % off, stays within the tenth of the shortening.
        "taylor_copper_123": [SPEED + (1.2,)],
        "taylor_copper_183": [SPEED + (1.2,)],
    },
    "Examples": {
        "crack_step": [("PR", "*MAT_ELASTIC", 0, POISSON, 0.9)],
        "penny_crack": [E_OF(1.2), LOAD_CURVE(1.2)],
        "plate_impact": [("speed", "*INITIAL_VELOCITY_GENERATION", 0, 5, 1.2),
                         ("EROSOP", "*CONTACT_ERODING_SURFACE_TO_SURFACE", 3, 1, "=0")],
        "spacetime_mesh": [LOAD_CURVE(1.2)],
        "taylor": [YIELD + (1.2,), SPEED + (1.2,)],
        "wave_scattering": [("PR", "*MAT_ELASTIC", 0, POISSON, 0.8)],
    },
}


def changed(text, change):
    """The deck with one field changed, and 'from -> to'."""
    words, keyword, *rest = change
    lines = text.split("\n")
    if not rest:
        at = max(i for i, line in enumerate(lines) if line.strip().upper() == "*END")
        return "\n".join(lines[:at] + keyword.split("\n") + lines[at:]), words
    if rest[0] == "->":
        if text.count(keyword) != 1:
            sys.exit(f"{words}: found {text.count(keyword)} times")
        return text.replace(keyword, rest[1]), words
    row, column, how = rest[:3]
    keyword, _, nth = keyword.partition("#")
    at = [i for i, line in enumerate(lines) if line == keyword][int(nth or 1) - 1]
    at = [i for i in range(at + 1, len(lines)) if not lines[i].startswith("$")][row]
    width = 20 if keyword.endswith("+") else 10
    part = slice(column * width, (column + 1) * width)
    fields = lines[at].split(",")  # the other way to write a card
    old = float(lines[at][part] if len(fields) == 1 else fields[column])
    new = float(how[1:]) if isinstance(how, str) else old * how
    if new == old:
        sys.exit(f"{words}: {old} stays as it is")
    field = f"{new:.5g}" if width == 10 else f"{new:.12g}"
    if len(fields) == 1:
        lines[at] = lines[at][:part.start].ljust(part.start) + field.rjust(width) + lines[at][part.stop:]
    else:
        lines[at] = ",".join(fields[:column] + [field] + fields[column + 1:])
    return "\n".join(lines), f"{words} {old:.4g} -> {float(field):.4g}"


def with_includes(path, folders=()):
    """The text of a deck with the files it includes in their places, so that they can be changed too."""
    text = path.read_text(encoding="latin-1")
    named = re.findall(r"(?m)^\*INCLUDE_PATH_RELATIVE\s*\n(.+)$", text)
    folders = [path.parent, *(path.parent / name for name in named), *folders]

    def included(match):
        for folder in folders:
            if (folder / match[1].strip()).is_file():
                return re.split(r"(?mi)^\*END\s*$", with_includes(folder / match[1].strip(), folders))[0]
        sys.exit(f"{path}: {match[1]} is not found")

    return re.sub(r"(?m)^\*INCLUDE\s*\n(.+)\n", included, text)


def broken(program, deck, change):
    """(what was changed, checks that failed, checks in all) of one changed deck."""
    with tempfile.TemporaryDirectory() as folder:
        finer = [name for names in re.findall(r" with=(\S+)", deck.read_text()) for name in names.split(",")]
        for name in (deck.name, *finer):
            (Path(folder) / name).write_text(with_includes(deck.parent / name))
        where = Path(folder) / (change[5] + ".k" if len(change) > 5 else deck.name)
        text, words = changed(where.read_text(), change)
        where.write_text(text)
        words += f" in {change[5]}" if len(change) > 5 else ""
        first = Path(folder) / deck.name  # one variation is enough
        text = re.sub(r"(?m)^\$@ vary.*\n", "", first.read_text())
        first.write_text(text)
        done = subprocess.run([sys.executable, "-c", f"import sys; sys.path.insert(0, {str(ROOT / 'tests')!r}); "
                               "import run_decks; run_decks.LIMIT_S = 400; sys.exit(run_decks.main(sys.argv[1:]))",
                               program, first], capture_output=True, text=True)
    failed = [line.split("FAIL", 1)[1].strip() for line in done.stdout.splitlines() if "  FAIL" in line]
    return words, failed, done.stdout.count("\n  ok ") + len(failed)


def compact(line):
    """The check that failed, with seven digits."""
    line = re.sub(r", off by.*|^\w+: ", "", line).rstrip(":")
    return re.sub(r"-?\d+\.\d{4,}(e[-+]\d+)?", lambda m: f"{float(m[0]):.7g}", line)


def decks():
    """Every deck that states a case, by its name."""
    return {path.stem: path for folder in TESTED for path in sorted((ROOT / folder).rglob("*.k"))
            if re.search(r"(?m)^\$@ case", path.read_text(encoding="latin-1"))}


def main(program, names):
    good, known = True, decks()
    for family, changes in FAMILIES.items():
        wanted = [name for name in changes if not names or name in names]
        if wanted:
            print(f"\n**{family}**\n\n| deck | changed | checks that fail | the first of them |\n|---|---|---|---|")
        for name in wanted:
            for change in changes[name]:
                words, failed, count = broken(program, known[name], change)
                good = good and bool(failed)
                first = compact(failed[0]) if failed else "**none**"
                print(f"| `{name}` | {words} | {len(failed)} of {count} | {first} |", flush=True)
    missing = set(known) - {name for changes in FAMILIES.values() for name in changes if changes[name]}
    if missing:
        sys.exit(f"no change is stated for {', '.join(sorted(missing))}")
    return 0 if good else 1


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(str(Path(sys.argv[1]).resolve()), sys.argv[2:]))
