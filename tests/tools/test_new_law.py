"""The skeleton of `./x new law` compiles against the headers of the day and satisfies the layer check."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_layers  # noqa: E402


class NewLaw(unittest.TestCase):
    def new_law(self, root, name):
        return subprocess.run([sys.executable, ROOT / "tools/new_law.py", name, root], capture_output=True, text=True)

    def test_skeleton(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            material = root / "src/model/material"
            material.mkdir(parents=True)
            (material / "catalogue.inc").write_text("// the laws, one line each\n")
            self.assertEqual(self.new_law(root, "my_metal").returncode, 0)
            checker = check_layers.Checker(root)
            checker.check_catalogues()
            self.assertEqual(checker.breaches, [])
            self.assertIn("is there already", self.new_law(root, "my_metal").stderr)
            self.assertIn("snake_case", self.new_law(root, "MyMetal").stderr)
            compiler = shutil.which("g++")
            done = subprocess.run([compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-Wno-psabi", "-fsyntax-only",
                                   "-I", ROOT / "src", material / "my_metal.cpp"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
