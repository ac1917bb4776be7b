"""Breaks each rule of tools/check_layers.py once, on a small house of its own."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_layers  # noqa: E402

HOUSE = {
    "CMakeLists.txt": "cleave_room(base)\ncleave_room(model)\n",
    "cmake/packages.cmake": "find_package(TBB REQUIRED)  # apt: libtbb-dev\n",
    "x": 'core="libtbb-dev"\nchecks="gcovr"\n',
    "docs/dependencies.md": "| `libtbb-dev` | why |\n| `gcovr` | why |\n",
    "src/base/a.hpp": "#pragma once\n",
    "src/base/b.hpp": '#include "base/a.hpp"\n',
    "src/model/m.cpp": '#include "base/b.hpp"\n',
    "src/model/material/elastic.cpp": "extern const LawEntry elastic{};\n",
    "src/model/material/catalogue.inc": "// the laws\nCLEAVE_LAW(elastic)\n",
    "tests/unit/base/a_test.cpp": '#include "base/a.hpp"\n',
}


class Layers(unittest.TestCase):
    def breaches(self, **changes):
        """The breaches of the small house after some of its files are replaced."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**HOUSE, **changes.pop("files", {})}.items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            checker = check_layers.Checker(Path(folder))
            checker.check_layers()
            checker.check_text()
            checker.check_catalogues()
            checker.check_packages()
            self.notes = checker.notes
            return checker.breaches

    def one(self, files, text):
        found = self.breaches(files=files)
        self.assertEqual(len(found), 1, found)
        self.assertIn(text, found[0])

    def test_the_small_house_is_in_order(self):
        self.assertEqual(self.breaches(), [])

    def test_wrong_way_include(self):
        self.one({"src/base/a.hpp": '#include "model/n.hpp"\n', "src/model/n.hpp": ""}, "of a later room")

    def test_wrong_way_include_beside_in_a_test(self):
        self.one({"tests/unit/base/a_test.cpp": '#include "model/n.hpp"\n', "src/model/n.hpp": ""}, "later room")

    def test_room_that_is_none(self):
        self.one({"src/utils/a.hpp": "#pragma once\n"}, "not a room")

    def test_include_cycle(self):
        self.one({"src/base/a.hpp": '#include "base/b.hpp"\n'},
                 "include cycle: base/a.hpp -> base/b.hpp -> base/a.hpp")

    def test_length(self):
        self.one({"src/base/a.hpp": "//\n" * 801}, "800 is the limit")
        self.assertEqual(self.breaches(files={"src/base/a.hpp": "//\n" * 401}), [])
        self.assertEqual(len(self.notes), 1)
        self.assertEqual(self.breaches(files={"src/base/data/a.inc": "1,\n" * 9000}), [])

    def test_law_without_line(self):
        self.one({"src/model/material/catalogue.inc": "// CLEAVE_LAW(elastic)\n"}, "has no line")

    def test_line_without_law(self):
        self.one({"src/model/material/elastic.cpp": "// extern const LawEntry other;\n"}, "has no LawEntry")

    def test_line_twice(self):
        self.one({"src/model/material/catalogue.inc": "CLEAVE_LAW(elastic)\nCLEAVE_LAW(elastic)\n"}, "twice")

    def test_formulation_without_line(self):
        self.one({"CMakeLists.txt": "cleave_room(base)\ncleave_room(model)\ncleave_room(discretisation)\n",
                  "src/discretisation/fem/hex.cpp": "extern const FormulationEntry hex{};\n"}, "has no line")

    def test_package_not_installed(self):
        self.one({"cmake/packages.cmake": "find_package(fmt)  # apt: libfmt-dev\n"}, "does not install libfmt-dev")

    def test_package_not_named(self):
        self.one({"cmake/packages.cmake": "find_package(TBB)\n"}, "say the Debian package")

    def test_package_asked_for_twice(self):
        self.assertEqual(self.breaches(files={"src/base/room.cmake": "find_package(TBB REQUIRED)\n"}), [])
        self.one({"src/base/room.cmake": "find_package(fmt REQUIRED)\n"}, "say the Debian package")

    def test_package_without_reason(self):
        self.one({"x": 'core="libtbb-dev mold"\nchecks="gcovr"\n'}, "no reason for the package mold")

    def test_reason_without_package(self):
        self.one({"x": 'core="libtbb-dev"\nchecks=""\n'}, "does not install gcovr")

    def test_promises(self):
        self.one({"src/base/a.hpp": "// TO" "DO later\n"}, "promise")
        self.one({"docs/a.md": "see /ho" "me/me/x\n"}, "path of one machine")


if __name__ == "__main__":
    unittest.main()
