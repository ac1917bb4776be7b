"""Each check of tests/run_decks.py, seen to hold and seen to fail, on a program that writes known histories."""
import contextlib
import io
import stat
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
import run_decks  # noqa: E402

# A stand-in for the solver: the error of `tip` falls by 4 from coarse.k to fine.k to finest.k.
PROGRAM = """#!/usr/bin/env python3
import json, pathlib, sys
deck, words = sys.argv[2], sys.argv[3:]
if sys.argv[1] == "restart":
    (pathlib.Path(deck) / "glstat.csv").rename(pathlib.Path(deck) / "other.csv" if "drift" in deck else
                                               pathlib.Path(deck) / "glstat.csv")
    sys.exit(0)
options = dict(zip(words[::2], words[1::2]))
out, threads = pathlib.Path(options["-o"]), int(options.get("--threads", 1))
if "refuse" in deck:
    print("refuse.k:3:21 MAT_ELASTIC: PR must be below 0.5")
    sys.exit(3)
if "crash" in deck:
    sys.exit("PR must be below 0.5")
out.mkdir()
error = {"coarse": 0.16, "fine": 0.04, "finest": 0.01}.get(pathlib.Path(deck).stem, 0.0)
(out / "glstat.csv").write_text("time,kinetic_energy,tip\\n" +
    "".join(f"{t},{10.0 - t},{1.0 + error}\\n" for t in (0.0, 1.0, 2.0)))
(out / "elout.csv").write_text("time,id,point,stress_zz\\n0,1,1,0\\n0,2,1,0\\n1,1,1,0.21\\n1,2,1,-0.5\\n")
if "drift" in deck and threads > 1:
    (out / "glstat.csv").write_text("time,kinetic_energy,tip\\n0,10.000000001,1\\n")
(out / "summary.json").write_text(json.dumps({"end": "finished", "ok": True, "parts": [{"length": 21.5}]}))
"""


class Decks(unittest.TestCase):
    def run_case(self, *directives, name="case.k", more=(), twins=(), off=False):
        with tempfile.TemporaryDirectory() as folder:
            for preset in ("release", *twins):
                program = Path(folder) / preset / "program"
                program.parent.mkdir()
                program.write_text(PROGRAM.replace("finest", "never" if preset == "scalar" and off else "finest"))
                program.chmod(program.stat().st_mode | stat.S_IXUSR)
            program = Path(folder) / "release" / "program"
            for other in more:
                (Path(folder) / other).write_text("*KEYWORD\n")
            deck = Path(folder) / name
            deck.write_text("$@ case  a case\n" + "".join(f"$@ {d}\n" for d in directives) + "*KEYWORD\n*END\n")
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                status = run_decks.main([str(program), str(deck)])
            self.said = said.getvalue()
            return status

    def good(self, *directives, **keys):
        self.assertEqual(self.run_case(*directives, **keys), 0, self.said)

    def bad(self, text, *directives, **keys):
        self.assertEqual(self.run_case(*directives, **keys), 1, self.said)
        self.assertIn(text, self.said)

    def test_value_of_an_element(self):
        self.good("expect stress_zz element=1 time=1.0  0.21  rel=1e-9 (roundoff)")
        self.good("expect stress_zz element=1 point=1 time=0.5  0.105  rel=1e-9 (roundoff)")
        self.bad("FAIL elout: stress_zz id=1 time=end", "expect stress_zz element=1  0.22  rel=1e-9 (roundoff)")
        self.bad("no row with", "expect stress_zz element=3 0.21 rel=1 (model)")
        self.bad("it has no time 3.0", "expect stress_zz element=1 time=3.0 0.21 rel=1 (model)")
        self.bad("no column stress_xx", "expect stress_xx element=1 0.21 rel=1 (model)")
        self.bad("wrote no nodout.csv", "expect displacement_x node=1 0.21 rel=1 (model)")

    def test_over_time(self):
        self.good("expect kinetic_energy max 10 (exact)", "expect kinetic_energy min 8 (exact)",
                  "expect kinetic_energy range 2 (exact)", "expect stress_zz element=2 peak 0.5 (exact)")
        self.bad("FAIL", "expect kinetic_energy max 10.0000001 (exact)")

    def test_summary(self):
        self.good("expect summary parts.0.length 21.6 abs=0.25 (model: published 21.4 (several) to 21.7)",
                  "expect summary end finished (exact)", "expect summary ok true (exact)")
        self.bad("no parts.0.width", "expect summary parts.0.width 1 (exact)")
        self.bad("expected aborted", "expect summary end aborted (exact)")

    def test_variations_have_the_same_bits(self):
        self.good("expect kinetic_energy max 10 (exact)", "vary threads=1,2,3,7")
        self.bad("run_threads2 has the bits of run_threads1 glstat.csv", "expect tip 1 (exact)",
                 "vary threads=1,2", name="drift.k")
        self.good("expect tip 1 (exact)", "vary threads=1,2 restart=no,57")
        self.bad("run_restartno_threads2 has the bits", "expect tip 1 (exact)", "vary restart=no,57 threads=1,2",
                 name="drift.k")
        lanes = ("expect tip max 1.01 rel=1e-9 (order)", "vary lanes=native,scalar")
        self.good(*lanes, name="finest.k")
        self.assertIn("note lanes=scalar not compared", self.said)
        self.good(*lanes, name="finest.k", twins=("scalar",))
        self.assertIn("run_lanesscalar has the bits of run_lanesnative", self.said)
        self.bad("run_lanesscalar has the bits of run_lanesnative glstat.csv", *lanes, name="finest.k",
                 twins=("scalar",), off=True)
        self.bad("cannot vary 'colour'", "expect tip 1 (exact)", "vary colour=1,2")

    def test_refusal(self):
        self.good('expect-fail "PR must be below 0.5"', name="refuse.k")
        self.bad('FAIL says "RO must be positive"', 'expect-fail "RO must be positive"', name="refuse.k")
        self.bad("FAIL refused (status 0)", 'expect-fail "PR must be below 0.5"')
        self.bad("ended with status 3", "expect tip 1 (exact)", name="refuse.k")
        self.bad("FAIL refused (status 1)", 'expect-fail "PR must be below 0.5"', name="crash.k")

    def test_order(self):
        finer = {"name": "coarse.k", "more": ("fine.k", "finest.k")}
        self.good("order tip exact=1 in=1.9..2.1 with=fine.k,finest.k (order)", **finer)
        self.bad("FAIL order of glstat: tip", "order tip exact=1 in=0.9..1.1 with=fine.k,finest.k (order)", **finer)
        self.bad("at least three meshes", "order tip exact=1 in=1.9..2.1 with=fine.k (order)", **finer)

    def test_analysis(self):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "halve.py"
            script.write_text("import pathlib, sys\nif sys.argv[3] == '0': sys.exit('nothing to divide by')\n"
                              "(pathlib.Path(sys.argv[1]) / 'halves.csv').write_text(f'time,value\\n0,{1 / float(sys.argv[3])}\\n')\n")
            known, run_decks.ANALYSES = run_decks.ANALYSES, Path(folder)
            try:
                self.good("analyse halve.py 2", "expect value file=halves 0.5 (exact)")
                self.bad("FAIL halves: value", "analyse halve.py 4", "expect value file=halves 0.5 (exact)")
                self.bad("nothing to divide by", "analyse halve.py 0", "expect value file=halves 0.5 (exact)")
                self.bad("there is no analysis thirds.py", "analyse thirds.py 2", "expect value file=halves 0.5 (exact)")
            finally:
                run_decks.ANALYSES = known

    def test_statement(self):
        self.bad("states no expectation")
        self.bad("case.k:2: end the line with the name", "expect tip 1 rel=1e-3")
        self.bad("every other tolerance needs one", "expect tip 1 (model)")
        self.bad("'exact' takes no rel=", "expect tip 1 rel=1e-3 (exact)")
        self.bad("'$@ expects' is not known", "expects tip 1 (exact)")


if __name__ == "__main__":
    unittest.main()
