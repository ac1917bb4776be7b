#!/usr/bin/env python3
"""The rules of the house that a machine can see. Prints each breach as FILE:LINE: RULE; exit status 1 if any.

usage: check_layers.py [ROOT]

  layers      a file of src/ROOM (or tests/unit/ROOM) includes only that room and those above it
  cycles      no file includes itself through others
  length      no source file over 800 lines; those over 400 are listed
  catalogue   every entry defined in a catalogued folder has its line in the catalogue, and the reverse
  packages    cmake's find_package, the lists in ./x and docs/dependencies.md name the same packages
  promises    no path of one machine, no promise of work to come
The order of the rooms is read from the cleave_room() lines of CMakeLists.txt.
"""
import re
import subprocess
import sys
from pathlib import Path

CODE = {".cpp", ".hpp", ".h", ".inc", ".cmake", ".py", ".sh"}
TEXT = CODE | {".txt", ".md", ".json", ".yml", ".css", ".js", ".html", ".supp", ""}
# (entry type, catalogue macro, folder of the entries, catalogue)
CATALOGUES = [
    ("LawEntry", "CLEAVE_LAW", "src/model/material", "src/model/material/catalogue.inc"),
    ("PressureEntry", "CLEAVE_EOS", "src/model/material", "src/model/material/eos_catalogue.inc"),
    ("FormulationEntry", "CLEAVE_FORMULATION", "src/discretisation", "src/discretisation/catalogue.inc"),
]
PROMISES = [
    (re.compile(r"/(?:wor[k]|far[m]|roo[t]|hom[e])/"), "path of one machine"),
    (re.compile(r"\b(?:TOD[O]|FIXM[E]|XX[X])\b"), "promise left in the code"),
]


def project_files(root):
    """Files git knows or would add; without git, everything outside hidden and built folders."""
    try:
        git = subprocess.run(["git", "-C", root, "ls-files", "-z", "-c", "-o", "--exclude-standard"],
                             capture_output=True, check=True)
        names = [Path(n) for n in git.stdout.decode().split("\0") if n]
    except (FileNotFoundError, subprocess.CalledProcessError):
        names = [p.relative_to(root) for p in root.rglob("*")]
        names = [n for n in names if n.parts[0] not in ("build", "out", ".git") and "__pycache__" not in n.parts]
    return sorted(n for n in names if (root / n).is_file() and not (root / n).is_symlink())


def read(path):
    return path.read_text(encoding="utf-8", errors="replace")


def generated(name):
    """Data tables are exempt from the length rule: they are generated, and lie in a folder data/."""
    return "data" in name.parts


class Checker:
    def __init__(self, root):
        self.root = root
        self.files = project_files(root)
        self.breaches = []
        self.notes = []

    def breach(self, name, line, text):
        self.breaches.append(f"{name}:{line}: {text}")

    # --- layers and cycles ---------------------------------------------------------------------
    def includes(self, name):
        """(line, path below src/) of every include of ours."""
        for number, line in enumerate(read(self.root / name).splitlines(), 1):
            match = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
            if match:
                beside = name.parent / match[1]
                if (self.root / "src" / match[1]).is_file():
                    yield number, Path(match[1])
                elif beside.parts[0] == "src" and (self.root / beside).is_file():
                    yield number, beside.relative_to("src")

    def check_layers(self):
        rooms = re.findall(r"^cleave_room\((\w+)\)", read(self.root / "CMakeLists.txt"), re.M)
        graph = {}
        for name in self.files:
            if name.suffix not in (".cpp", ".hpp", ".h", ".inc"):
                continue
            if name.parts[0] == "src":
                room = name.parts[1]
            elif name.parts[:2] == ("tests", "unit"):
                room = name.parts[2]
            else:
                continue
            if room not in rooms:
                self.breach(name, 1, f"'{room}' is not a room of CMakeLists.txt")
                continue
            for line, target in self.includes(name):
                if name.parts[0] == "src":
                    graph.setdefault(name.relative_to("src"), []).append((line, target))
                if target.parts[0] in rooms and rooms.index(target.parts[0]) > rooms.index(room):
                    self.breach(name, line, f"room {room} must not include {target}, of a later room")
        self.check_cycles(graph)

    def check_cycles(self, graph):
        """Depth-first: an include of a file that is still open closes a cycle."""
        closed, open_files = set(), []

        def visit(name):
            open_files.append(name)
            for line, target in graph.get(name, []):
                if target in open_files:
                    loop = open_files[open_files.index(target):] + [target]
                    self.breach("src" / name, line, "include cycle: " + " -> ".join(map(str, loop)))
                elif target not in closed:
                    visit(target)
            open_files.pop()
            closed.add(name)

        for name in sorted(graph):
            if name not in closed:
                visit(name)

    # --- length, promises ----------------------------------------------------------------------
    def check_text(self):
        for name in self.files:
            if name.suffix not in TEXT or generated(name):
                continue
            lines = read(self.root / name).splitlines()
            if name.suffix in CODE and len(lines) > 800:
                self.breach(name, 801, f"{len(lines)} lines; 800 is the limit, split it by noun")
            elif name.suffix in CODE and len(lines) > 400:
                self.notes.append(f"{name}: {len(lines)} lines, over 400")
            for number, line in enumerate(lines, 1):
                for pattern, what in PROMISES:
                    if pattern.search(line):
                        self.breach(name, number, f"{what}: {line.strip()[:80]}")

    # --- catalogues ----------------------------------------------------------------------------
    def check_catalogues(self):
        for entry, macro, folder, catalogue in CATALOGUES:
            defined = {}
            for name in self.files:
                if name.suffix == ".cpp" and name.is_relative_to(folder):
                    for match in re.finditer(rf"^\s*extern\s+const\s+{entry}\s+(\w+)\s*[{{=(]",
                                             read(self.root / name), re.M):
                        defined[match[1]] = name
            path = self.root / catalogue
            text = re.sub(r"//.*", "", read(path)) if path.is_file() else ""
            listed = re.findall(rf"\b{macro}\((\w+)\)", text)
            for name in sorted(defined.keys() - set(listed)):
                self.breach(defined[name], 1, f"{entry} {name} has no line {macro}({name}) in {catalogue}")
            for name in sorted(set(listed) - defined.keys()):
                self.breach(catalogue, 1, f"{macro}({name}) has no {entry} in {folder}")
            for name in sorted({n for n in listed if listed.count(n) > 1}):
                self.breach(catalogue, 1, f"{macro}({name}) is listed twice")

    # --- packages ------------------------------------------------------------------------------
    def check_packages(self):
        script = read(self.root / "x")
        lists = {m[1]: m[2].split() for m in re.finditer(r'^(core|checks)="([^"]*)"', script, re.M)}
        listed = set(lists.get("core", [])) | set(lists.get("checks", []))
        core = set(lists.get("core", []))
        reasons = set(re.findall(r"^\| `([^`]+)` \|", read(self.root / "docs/dependencies.md"), re.M))
        for package in sorted(listed - reasons):
            self.breach("docs/dependencies.md", 1, f"no reason for the package {package}, which ./x installs")
        for package in sorted(reasons - listed):
            self.breach("docs/dependencies.md", 1, f"./x does not install {package}")
        known = set()  # what cmake/packages.cmake finds may be asked for again anywhere
        files = [n for n in self.files if n.suffix == ".cmake" or n.name == "CMakeLists.txt"]
        for name in sorted(files, key=lambda n: n.name != "packages.cmake"):
            lines = read(self.root / name).splitlines()
            for number, line in enumerate(lines, 1):
                asked = re.match(r"\s*(?:find_package|find_library|find_path|pkg_check_modules)\((\w+)", line)
                if not asked or asked[1] in known:
                    continue
                named = re.compile(r"#\s*apt:\s*(\S+)")
                match = named.search(line) or named.search(lines[max(number - 2, 0)])
                wanted = listed if name.parts[0] == "bench" else core
                if not match:
                    self.breach(name, number, "say the Debian package, '# apt: NAME', on this line or the one before")
                elif match[1] not in wanted:
                    self.breach(name, number, f"./x does not install {match[1]}")
                elif name.name == "packages.cmake":
                    known.add(asked[1])

    def run(self):
        self.check_layers()
        self.check_text()
        self.check_catalogues()
        self.check_packages()
        for note in self.notes:
            print("note:", note)
        for breach in self.breaches:
            print(breach)
        print(f"{len(self.files)} files, {len(self.breaches)} breaches")
        return 1 if self.breaches else 0


if __name__ == "__main__":
    sys.exit(Checker(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()).run())
