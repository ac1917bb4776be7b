"""What is wrong with a deck of spacetime parts is said with its line."""
import unittest

from support import Case

SQUARE = """*KEYWORD
*CONTROL_TERMINATION
1.0
*MAT_ELASTIC
1,2.0,2.5,0.25
*SECTION_SHELL_SDG
1,
*PART
square
1,1,1
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0.5,0.5,0
*ELEMENT_SHELL
11,1,1,2,5,5
12,1,2,3,5,5
13,1,3,4,5,5
14,1,4,1,5,5
*DEFINE_CURVE
9
0,0
2,2
"""


class Decks(Case):
    def refused(self, deck, line, *words):
        name = self.write("square.k", deck + "*END\n")
        _, err = self.cleave("check", name, status=3)
        self.assertIn(f"square.k:{line}:", err)
        for word in words:
            self.assertIn(word, err)

    def test_a_good_one(self):
        out, _ = self.cleave("check", self.write("square.k", SQUARE + "*END\n"))
        self.assertIn("mass 2,", out)
        self.assertRegex(out, r"least height 0\.5, of element 11 of part 1\n  first tents  0\.3\d+ \(node 5 at 0\.5 0\.5 0\) "
                              r"to \S+ high; about \S+ to the end at 1\n")

    def test_elements(self):
        self.refused(SQUARE.replace("12,1,2,3,5,5", "12,1,3,2,5,5"), 19, "element 12 is inverted", "ELEMENT_SHELL")
        self.refused(SQUARE.replace("5,0.5,0.5,0", "5,0.5,0.0,0"), 18, "element 11 has no area")
        self.refused(SQUARE.replace("5,0.5,0.5,0\n", "5,0.5,0.5,0\n6,0.5,-1,0\n7,0.5,0,0\n")
                     + "*ELEMENT_SHELL\n15,1,1,6,7,7\n16,1,6,2,7,7\n", 18, "vertex 7 hangs on a face of element 11")

    def test_conditions(self):
        silent = "*SET_SEGMENT\n4\n4,1\n*BOUNDARY_NON_REFLECTING\n4,\n*SET_SEGMENT\n5\n1,2\n"
        self.refused(SQUARE + silent + "*LOAD_INCIDENT_WAVE\n5,1,9\n1,0,0\n", 35, "face 1-2 is not silent",
                     "BOUNDARY_NON_REFLECTING")
        self.refused(SQUARE + "*BOUNDARY_PRECRACK\n1,1,2\n0.1,0.2,0\n0.5,0.5,0\n", 27, "crack segment 1 from (0.1, 0.2)")
        self.refused(SQUARE + "*BOUNDARY_SPC_NODE\n5,0,1,1\n", 27, "nodes inside the body")


if __name__ == "__main__":
    unittest.main()
