"""./x explains itself, README names every command, and a wrong one is refused."""
import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Door(unittest.TestCase):
    def x(self, *words):
        return subprocess.run(["bash", ROOT / "x", *words], capture_output=True, text=True)

    def test_readme_names_every_command(self):
        listed = set(re.findall(r"^  (\w+) ", self.x("help").stdout, re.M))
        self.assertIn("demo", listed)
        self.assertEqual(listed, set(re.findall(r"^\| `\./x (\w+)", (ROOT / "README.md").read_text(), re.M)))

    def test_readme_opens_with_the_two_commands(self):
        lines = [line for line in (ROOT / "README.md").read_text().splitlines() if line]
        self.assertEqual(lines[:5], ["# Cleave", "```", "./x demo", "./x test", "```"])

    def test_wrong_words_are_refused(self):
        self.assertEqual(self.x("dance").returncode, 2)
        self.assertEqual(self.x("new", "law").returncode, 2)


if __name__ == "__main__":
    unittest.main()
