"""Breaks each rule of tools/check_docs.py once."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_docs  # noqa: E402

PAGES = {
    "docs/README.md": "# Start\n[one](one.md) and [two](one.md#two-words) [web](https://example.org/none.md)\n",
    "docs/one.md": "# One\n## Two words\n`[not](a-link.md)`\n```\n[nor](this.md)\n# nor a heading\n```\n",
}


class Docs(unittest.TestCase):
    def breaches(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**PAGES, **{k.replace("__", "/") + ".md": v for k, v in pages.items()}}.items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_docs.check(Path(folder).resolve())[1]

    def test_rules(self):
        self.assertEqual(self.breaches(), [])
        self.assertIn("docs/one.md:1: gone.md leads nowhere", self.breaches(docs__one="[x](gone.md)\n## Two words\n"))
        self.assertIn("one.md#two-words: no such heading", self.breaches(docs__one="# One\n")[0])
        self.assertIn("docs/lost.md:1: no page leads here", self.breaches(docs__lost="# Lost\n")[0])
        self.assertEqual(self.breaches(docs__laws__a="# A\n", docs__one="[all](laws/)\n## Two words\n"), [])


if __name__ == "__main__":
    unittest.main()
