"""What the tests of the command line share: a deck of any size, running the program, looking at run directories.

The program is named by the environment variable CLEAVE (an absolute path).
"""
import csv
import json
import os
import re
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

PROGRAM = os.environ.get("CLEAVE", "cleave")
ROOT = Path(__file__).resolve().parents[2]
LIMIT_S = 300


def bar(cells=(4, 4, 44), end=1.5e-5, extra="", material="", speed=-227.0e3, step_rows="       0.0       0.9\n"):
    """A copper bar flying into a rigid wall at z = 0: a Taylor bar as a keyword deck [tonne, mm, s]."""
    nx, ny, nz = cells
    across, length = 6.4, 32.4
    material = material or ("*MAT_PLASTIC_KINEMATIC\n         1  8.93E-09  1.17E+05      0.35     400.0     100.0\n\n")
    text = ["*KEYWORD\n*TITLE\nbar against a wall\n", f"*CONTROL_TERMINATION\n{end:10.3e}\n",
            "*CONTROL_TIMESTEP\n", step_rows, "*CONTROL_ENERGY\n         2         2\n",
            f"*DATABASE_BINARY_D3PLOT\n{end / 3:10.3e}\n",
            "".join(f"*DATABASE_{name}\n{end / 40:10.3e}\n" for name in ("GLSTAT", "MATSUM", "NODOUT", "ELOUT", "RWFORC")),
            f"*DATABASE_HISTORY_NODE\n         1{(nx + 1) * (ny + 1) * nz:10d}\n",
            f"*DATABASE_HISTORY_SOLID\n         1{nx * ny * nz:10d}\n",
            material, "*SECTION_SOLID\n         1         1\n*HOURGLASS\n         1         4      0.05\n",
            "*PART\nbar\n         1         1         1         0         1\n",
            f"*INITIAL_VELOCITY_GENERATION\n         1         2       0.0       0.0       0.0{speed:10.3e}\n\n",
            "*RIGIDWALL_PLANAR\n         0         0         0\n",
            "       0.0       0.0       0.0       0.0       0.0       1.0       0.0\n", extra, "*NODE\n"]
    number = {}
    for k in range(nz + 1):
        for j in range(ny + 1):
            for i in range(nx + 1):
                number[i, j, k] = len(number) + 1
                x, y, z = across * i / nx, across * j / ny, length * k / nz
                text.append(f"{number[i, j, k]:8d}{x:16.8e}{y:16.8e}{z:16.8e}\n")
    text.append("*ELEMENT_SOLID\n")
    element = 0
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                element += 1
                corners = [number[i + a, j + b, k + c] for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                text.append(f"{element:8d}{1:8d}" + "".join(f"{n:8d}" for n in corners) + "\n")
    text.append("*END\n")
    return "".join(text)


class Case(unittest.TestCase):
    """A test in a folder of its own, which is the working folder of every program it starts."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name).resolve()

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="latin-1")
        return path

    def start(self, *words, **options):
        """The program, started and not waited for."""
        process = subprocess.Popen([PROGRAM, *map(str, words)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def cleave(self, *words, status=0, **options):
        """Runs the program, asserts its exit status, returns what it printed: (output, errors)."""
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=LIMIT_S, **options)
        out, err = done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")
        self.assertEqual(done.returncode, status, f"cleave {' '.join(map(str, words))}\n{out}\n{err}")
        return out, err

    def wait_for_rows(self, process, path, rows):
        """Until a history of a run has so many rows."""
        deadline = time.monotonic() + LIMIT_S
        while not path.is_file() or path.read_bytes().count(b"\n") <= rows:
            self.assertIsNone(process.poll(), "the run ended before it could be interrupted")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.002)

    def stop_by_signal(self, number, run, after_rows, *words):
        """Starts a run and ends it by a signal once its glstat has so many rows. Returns its summary."""
        process = self.start("run", *words, "-o", run, "-q")
        self.wait_for_rows(process, run / "glstat.csv", after_rows)
        process.send_signal(number)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + number)
        self.assert_whole(run)
        summary = self.summary(run)
        self.assertEqual(summary["ending"], "signal")
        return summary

    def assert_whole(self, run, unfinished_allowed=False):
        """Every file of a run directory is complete: nothing a user opens is half written."""
        for path in run.rglob("*"):
            if path.suffix == ".part":
                self.assertTrue(unfinished_allowed, f"{path} was left behind")
            elif path.suffix == ".csv":
                text = path.read_bytes().decode()
                self.assertTrue(not text or text.endswith("\n"), f"{path} ends within a line")
                widths = {len(row) for row in csv.reader(text.splitlines())}
                self.assertLessEqual(len(widths), 1, f"rows of {path} differ in length")
            elif path.suffix == ".json":
                json.loads(path.read_text())
            elif path.suffix == ".vtu":
                self.assertTrue(path.read_bytes().rstrip().endswith(b"</VTKFile>"), path)
            elif path.suffix == ".pvd":
                for frame in xml.etree.ElementTree.parse(path).iter("DataSet"):
                    self.assertTrue((run / frame.attrib["file"]).is_file(), frame.attrib)
            elif path.suffix == ".h5":
                self.assertEqual(path.read_bytes()[:8], b"\x89HDF\r\n\x1a\n", path)
            elif path.suffix == ".png":
                self.assertTrue(path.read_bytes().endswith(b"IEND\xaeB`\x82"), path)

    def assert_same(self, first, second):
        """Two run directories hold the same results, bit for bit."""
        def names(run):
            return sorted(p.relative_to(run) for p in run.rglob("*")
                          if p.suffix in (".csv", ".vtu", ".pvd") or p.name == "restart.h5")
        self.assertEqual(names(first), names(second))
        self.assertIn(Path("glstat.csv"), names(first))
        self.assertTrue(any(n.suffix == ".vtu" for n in names(first)))
        for name in names(first):
            same = (first / name).read_bytes() == (second / name).read_bytes()
            self.assertTrue(same, f"{name} of {first.name} and {second.name} differ")

    def summary(self, run):
        return json.loads((run / "summary.json").read_text())


def rows(path):
    """The rows of a history as dictionaries of numbers."""
    with path.open(newline="") as stream:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(stream, skipinitialspace=True)]


def plain(text):
    """Text without colour."""
    return re.sub(r"\x1b\[[0-9;]*m", "", text)
