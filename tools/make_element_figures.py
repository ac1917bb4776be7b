#!/usr/bin/env python3
"""Draws each solid element beside two checks of it: a beam against its closed form, and Cook's membrane.

usage: make_element_figures.py CLEAVE [FOLDER]      (default folder: docs/figures; further words
name single figures)

The beam (Timoshenko & Goodier, article 21; plane strain, nu = 0.3) is clamped with the exact displacements, so its tip
must converge, about with the square of the cell size. Cook's membrane (nu = 0.4999; 7.695 per unit load, order 4
spectral elements) shows who locks. hourglass.svg is the cantilever of tests/verification with one-point hexahedra and each type of control.
Fails where a result is not what docs/formulations says of it.
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/verification/make"))
import make  # noqa: E402
import statics  # noqa: E402
from deck import Deck  # noqa: E402
from mesh import mirrored, tetrahedra, wedges  # noqa: E402

COLOURS = ("#1f4e9c", "#c4481b", "#2c7a3f", "#8a5a00", "#6b3fa0", "#777777")
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
HEX_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
TET, TET_EDGES = [(0, 0, 0), (1, 0, 0), (0.2, 1, 0), (0.3, 0.3, 1)], [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
MIDDLES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
WEDGE = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
WEDGE_EDGES = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)]
mean = lambda points: tuple(sum(p[i] for p in points) / len(points) for i in range(3))
mix = lambda corners, weights: tuple(sum(w * c[i] for w, c in zip(weights, corners)) for i in range(3))
G = 0.5 - 0.5 / math.sqrt(3)
HEX_POINTS = [(x, y, z) for x in (G, 1 - G) for y in (G, 1 - G) for z in (G, 1 - G)]
TET_POINTS = [mix(TET, [0.58541020 if k == a else 0.13819660 for k in range(4)]) for a in range(4)]
TRIANGLE = [(1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3)]
WEDGE_POINTS = [(x, y, z) for x, y in TRIANGLE for z in (G, 1 - G)]
same, cut = (lambda m: m), (lambda m: tetrahedra(m))

# figure: title, ELFORM, hourglass card, how hexahedra are split, (corners, edges, points); cells of beam and membrane,
# order of the beam's error (least, most), error of its finest mesh at most, share of Cook's tip on the finest (from, to).
ELEMENTS = {
    "hex8-one-point": ("Hexahedron, one point (ELFORM 1, IHQ 6, QM 1)", 1, [1, 6, 1.0], same, (CUBE, HEX_EDGES, [mean(CUBE)]),
                       (2, 4, 8), (4, 8, 16), (1.6, 2.6), 0.02, (0.97, 1.005)),
    "hex8-selective": ("Hexahedron, eight points (ELFORM 2)", 2, None, same, (CUBE, HEX_EDGES, HEX_POINTS),
                       (2, 4, 8), (4, 8, 16), (1.6, 2.6), 0.02, (0.98, 1.005)),
    "tet4": ("Linear tetrahedron (ELFORM 10)", 10, None, cut, (TET, TET_EDGES, [mean(TET)]),
             (4, 8, 16), (4, 8, 16), (1.5, 2.6), 0.08, (0.2, 0.7)),
    "tet4-nodal-pressure": ("Linear tetrahedron, nodal pressure (ELFORM 13)", 13, None, cut, (TET, TET_EDGES, [mean(TET)]),
                            (4, 8, 16), (4, 8, 16), (1.5, 2.6), 0.08, (0.94, 1.005)),
    "penta6": ("Wedge (ELFORM 15)", 15, None, wedges, (WEDGE, WEDGE_EDGES, WEDGE_POINTS),
               (4, 8, 16), (4, 8, 16), (1.5, 2.6), 0.08, (0.25, 0.35)),
    "tet10": ("Quadratic tetrahedron (ELFORM 16)", 16, None, lambda m: tetrahedra(m, quadratic=True),
              (TET + [mean((TET[a], TET[b])) for a, b in MIDDLES], TET_EDGES, TET_POINTS),
              (1, 2, 4), (2, 4, 8), (2.2, 4.5), 0.0005, (0.92, 1.005))}


def histories(program, text, *columns, file="nodout"):
    """Columns of a history of the run of this deck."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "element.k").write_text(text)
        done = subprocess.run([program, "run", "element.k", "-q", "-o", "out"], cwd=folder, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
        with open(Path(folder) / f"out/{file}.csv", newline="") as stream:
            rows = list(csv.DictReader(stream, skipinitialspace=True))
    return [[float(row[column]) for row in rows] for column in columns]


def with_control(text, form, control):
    """The deck with another ELFORM and an hourglass card."""
    number = "".join(str(v).rjust(10) for v in (1, form))
    lines = text.split("\n")
    lines[lines.index("*SECTION_SOLID") + 1] = number
    if control:
        lines[lines.index("*PART") + 2] = "".join(str(v).rjust(10) for v in (1, 1, 1, 0, 1))
        at = lines.index("*PART")
        lines[at:at] = ["*HOURGLASS", "".join(str(v).rjust(10) for v in control)]
    return "\n".join(lines)


def edge_loads(mesh, at, traction):
    """Consistent nodal forces of a shear traction(y) on the quadratic triangles in the plane x = at. A quadratic traction
    lies in the span of the shape functions, so the integrals of their products, over area / 180, are exact."""
    products = ((6, -1, -1, 0, -4, 0), (-1, 6, -1, 0, 0, -4), (-1, -1, 6, -4, 0, 0),
                (0, 0, -4, 32, 16, 16), (-4, 0, 0, 16, 32, 16), (0, -4, 0, 16, 16, 32))
    force = {}
    for _, nodes in mesh.elements:
        for face, middles in (((0, 1, 2), (4, 5, 6)), ((0, 1, 3), (4, 8, 7)), ((1, 2, 3), (5, 9, 8)), ((0, 2, 3), (6, 9, 7))):
            corners = [mesh.nodes[nodes[k] - 1] for k in face]
            if all(abs(c[0] - at) < 1e-9 for c in corners):
                (_, a, b), (_, c, d), (_, e, f) = corners
                area = 0.5 * abs((c - a) * (f - b) - (e - a) * (d - b))
                six = [nodes[k] for k in (*face, *middles)]
                here = [traction(mesh.nodes[n - 1][1]) for n in six]
                for n, row in zip(six, products):
                    force[n] = force.get(n, 0.0) + area / 180 * sum(p * t for p, t in zip(row, here))
    return force


def deck_of(case, form, control, quadratic, at, traction):
    """Text of a deck of make.py; quadratic meshes get their own loads in place of the ones for linear edges."""
    kept = {}
    real = Deck.mesh
    Deck.mesh = lambda deck, mesh: (kept.update(mesh=mesh), real(deck, mesh))
    try:
        text = case().text()
    finally:
        Deck.mesh = real
    if quadratic:
        lines = text.split("\n")
        first = lines.index("*LOAD_NODE_POINT") + 1
        last = next(i for i in range(first, len(lines)) if lines[i].startswith("*"))
        lines[first:last] = [f"{n},2,1,{f:.10g}" for n, f in sorted(edge_loads(kept["mesh"], at, traction).items())]
        text = "\n".join(lines)
    return with_control(text, form, control)


def beam(program, form, control, split, cells):
    """Tip displacement over the closed form, cells across the depth."""
    depth, load = 12.0, 1000.0
    case = lambda: statics.bending_beam("beam", form, split, (4 * cells, cells), 1.0, poisson=0.3)
    exact = float(next(line for line in case().head if "expect" in line).split("node=")[1].split()[1])
    traction = lambda y: -load / (2 * depth ** 3 / 12) * (depth * depth / 4 - y * y)
    text = deck_of(case, form, control, form == 16, 48.0, traction)
    # Twice the time of the deck: what is left of the motion is then below 1e-5.
    text = text.replace("*CONTROL_TERMINATION\n       0.3", "*CONTROL_TERMINATION\n       0.6")
    (tip,) = histories(program, text, "y_displacement")
    return tip[-1] / exact


def membrane(program, form, control, split, cells):
    """Tip displacement of Cook's membrane over the reference. Diagonals from upper left to lower right, except for
    wedges and quadratic tetrahedra, whose page quotes the other way."""
    turned = (lambda m: split(mirrored(m))) if form in (10, 13) else split
    case = lambda: statics.cook("cook", form, turned, cells, 7.695e-3, 1.0)
    (tip,) = histories(program, deck_of(case, form, control, form == 16, 48.0, lambda y: 6.25e-3), "y_displacement")
    return tip[-1] / 7.695e-3


def ticks(low, high, logarithmic=False):
    if logarithmic:
        return [10.0 ** k for k in range(math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9) + 1)]
    raw = (high - low) / 4
    step = 10 ** math.floor(math.log10(raw))
    step *= next(m for m in (1, 2, 5, 10) if m * step >= raw)
    return [step * k for k in range(math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9) + 1)]


def panel(left, width, title, across, up, curves, named_x=None, logarithmic=False):
    """Lines of SVG of one graph; curves: (label, [(x, y)], style) with style one of line, rings, points, dashes."""
    height, bottom, top = 320, 45, 60
    xs = [x for _, c, _ in curves for x, _ in c]
    ys = [y for _, c, _ in curves for _, y in c] + ([] if logarithmic else [0.0])
    scale = (lambda v: math.log10(v)) if logarithmic else (lambda v: v)
    ty = ticks(min(ys), max(ys), logarithmic)
    tx = named_x or ticks(min(xs), max(xs))
    fx = math.log2 if named_x else (lambda v: v)
    margin = 0.1 * (fx(max(tx)) - fx(min(tx))) if named_x else 0.0
    x0, x1, y0, y1 = fx(min(tx)) - margin, fx(max(tx)) + margin, scale(ty[0]), scale(ty[-1])
    px = lambda x: left + (fx(x) - x0) / (x1 - x0) * width
    py = lambda y: height - bottom - (scale(y) - y0) / (y1 - y0) * (height - bottom - top)
    short = lambda y: f"1e{round(math.log10(y))}" if logarithmic and y < 0.005 else f"{y:g}"
    out = [f'<text x="{left}" y="48" font-weight="bold">{title}</text>']
    for x in tx:
        out.append(f'<path d="M{px(x):.1f} {py(ty[0]):.1f}V{py(ty[-1]):.1f}" stroke="#ddd"/>'
                   f'<text x="{px(x):.1f}" y="{height - bottom + 16}" text-anchor="middle">{x:g}</text>')
    for y in ty:
        out.append(f'<path d="M{left} {py(y):.1f}H{left + width}" stroke="#ddd"/>'
                   f'<text x="{left - 5}" y="{py(y) + 4:.1f}" text-anchor="end">{short(y)}</text>')
    out.append(f'<text x="{left + width / 2}" y="{height - 10}" text-anchor="middle">{across}</text>'
               f'<text transform="translate({left - 44} {(height - bottom + top) / 2}) rotate(-90)" text-anchor="middle">{up}</text>')
    for number, (label, line, style) in enumerate(curves):
        colour = "#888" if style == "dashes" else COLOURS[number % len(COLOURS)]
        if style == "rings":
            out += [f'<circle cx="{px(x):.1f}" cy="{py(y):.1f}" r="3" fill="none" stroke="#222"/>' for x, y in line]
            colour = "#222"
        else:
            dash = ' stroke-dasharray="5 4"' if style == "dashes" else ""
            out.append(f'<path fill="none" stroke="{colour}" stroke-width="1.7"{dash} d="M'
                       + " ".join(f"{px(x):.1f} {py(y):.1f}" for x, y in line) + '"/>')
        if style == "points":
            out += [f'<circle cx="{px(x):.1f}" cy="{py(y):.1f}" r="3.5" fill="{colour}"/>' for x, y in line]
        if label:
            out.append(f'<text x="{left + width - 4}" y="{top + 14 + 16 * number}" text-anchor="end" fill="{colour}">{label}</text>')
    return out


def drawing(left, size, corners, edges, points):
    """The element, its nodes and its points, in a parallel projection."""
    project = lambda p: (left + size * (0.86 * p[0] + 0.42 * p[1]), 262 - size * (0.86 * p[2] + 0.26 * p[1]))
    out = [f'<text x="{left}" y="48" font-weight="bold">nodes, points</text>']
    for a, b in edges:
        (xa, ya), (xb, yb) = project(corners[a]), project(corners[b])
        hidden = ' stroke-dasharray="4 3"' if 3 in (a, b) and len(corners) == 8 else ""
        out.append(f'<path d="M{xa:.1f} {ya:.1f}L{xb:.1f} {yb:.1f}" stroke="#444"{hidden}/>')
    for number, corner in enumerate(corners, 1):
        x, y = project(corner)
        out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5"/><text x="{x + 6:.1f}" y="{y - 6:.1f}">{number}</text>')
    for point in points:
        x, y = project(point)
        out.append(f'<path d="M{x - 4:.1f} {y - 4:.1f}l8 8m0 -8l-8 8" stroke="#c4481b" stroke-width="1.8"/>')
    return out


def write(path, title, width, lines):
    head = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} 320" font-family="sans-serif" font-size="12">',
            f"<title>{title}</title>", f'<rect width="{width}" height="320" fill="#fff"/>',
            f'<text x="14" y="22" font-weight="bold" font-size="14">{title}</text>']
    path.write_text("\n".join(head + lines + ["</svg>", ""]))


def must(name, value, low, high):
    print(f"{name:50} {value:8.4f}, expected {low:g} to {high:g}", flush=True)
    if not low <= value <= high:
        sys.exit(f"{name}: {value:.5g} is not between {low:g} and {high:g}")


def element(program, folder, name):
    title, form, control, split, shape, beams, membranes, orders, finest, share = ELEMENTS[name]
    errors = [abs(beam(program, form, control, split, n) - 1.0) for n in beams]
    must(f"{name}: order of the beam", math.log2(errors[-2] / errors[-1]), *orders)
    must(f"{name}: error of the beam", errors[-1], 0.0, finest)
    tips = [membrane(program, form, control, split, n) for n in membranes]
    must(f"{name}: Cook's membrane", tips[-1], *share)
    slope = [(n, errors[-1] * (beams[-1] / n) ** 2) for n in beams]
    write(folder / f"element-{name}.svg", title, 900, drawing(24, 140, *shape)
          + panel(300, 240, "bending beam, nu = 0.3", "cells across the depth", "error of the tip, relative",
                  [("", list(zip(beams, errors)), "points"), ("square of the cell size", slope, "dashes")], beams, True)
          + panel(630, 250, "Cook's membrane, nu = 0.4999", "cells along an edge", "tip displacement / reference",
                  [("", list(zip(membranes, tips)), "points"), ("reference", [(n, 1.0) for n in membranes], "dashes")], membranes))


def hourglass(program, folder):
    """The vibrating cantilever, one-point hexahedra: what each type stores or takes, and where the tip goes."""
    text = make.CASES["cantilever_vibration"]().text()
    period, height = 0.25489, 0.023134
    shares, tips, previous = [], [], None
    for kind, coefficient in ((1, 0.1), (2, 0.1), (3, 0.1), (4, 0.05), (5, 0.05), (6, 1.0)):
        deck = with_control(text, 1, [1, kind, coefficient])
        time, held, internal, ratio = histories(program, deck, "time", "hourglass_energy", "internal_energy", "energy_ratio",
                                                file="glstat")
        at, tip = histories(program, deck, "time", "y_displacement")
        largest = max(internal)
        must(f"hourglass type {kind}: energy ratio, off by", max(abs(r - 1) for r in ratio), 0.0, 0.01)
        must(f"hourglass type {kind}: share of the energy", max(held) / largest, 1e-6, 0.1)
        crossing = [a + (b - a) * u / (u - v) for a, b, u, v in zip(at, at[1:], tip, tip[1:]) if a > 0.1 and u * v <= 0]
        # One point per cell misses the bending inside the cell, 1/n^2 of the whole with n cells across the depth.
        soft = 1 / math.sqrt(1 - 1 / 4 ** 2)
        low, high = {6: (0.99, 1.01), 5: (0.99, soft + 0.01), 4: (0.99, soft + 0.01)}.get(kind, (soft - 0.01, soft + 0.01))
        must(f"hourglass type {kind}: half period / exact", crossing[0] / (period / 2), low, high)
        share = [(t, e / largest) for t, e in zip(time, held)]
        if kind in (2, 3, 5):
            if share != previous:
                sys.exit(f"hourglass type {kind} is not the same as the one before")
            continue
        previous = share
        label = {1: "1 to 3, QM = 0.1", 4: "4 and 5, QM = 0.05", 6: "6, QM = 1"}[kind]
        shares.append((label, share[::5], "line"))
        tips.append(("", list(zip(at, tip))[::5], "line"))
    rings = [(t, height * math.sin(2 * math.pi * t / period)) for t in (0.26 * k / 26 for k in range(27))]
    write(folder / "hourglass.svg", "Hourglass control of a vibrating cantilever, 40 x 4 one-point hexahedra", 900,
          panel(70, 360, "hourglass energy / largest internal energy, types 1 to 6", "time [s]", "share", shares)
          + panel(520, 360, "tip, all types; rings: closed form", "time [s]", "displacement [m]", tips + [("", rings, "rings")]))


def main(program, folder, names):
    for name in names or [*ELEMENTS, "hourglass"]:
        hourglass(program, folder) if name == "hourglass" else element(program, folder, name)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2] if len(sys.argv) > 2 else "docs/figures"), sys.argv[3:])
