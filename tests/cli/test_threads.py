"""The same bits from any number of threads, with everything at work that sums over nodes or elements."""
import unittest

from support import Case, bar, rows

ERODE = ("*MAT_PLASTIC_KINEMATIC\n         1  8.93E-09  1.17E+05      0.35     400.0     100.0       1.0\n"
         "       0.0       0.0      0.45\n")  # columns SRC SRP FS
SCALE = "       0.0       0.9         0       0.0-1.200E-7\n"  # DT2MS < 0: mass where the step is smaller


class Threads(Case):
    def compare(self, deck):
        runs = []
        for threads in (1, 2, 3, 7):
            runs.append(self.folder / f"threads{threads}")
            self.cleave("run", deck, "-o", runs[-1], "-q", "-j", threads)
            self.assert_same(runs[0], runs[-1])
        return runs[0]

    def test_bar_against_a_wall(self):
        run = self.compare(self.write("bar.k", bar()))
        self.assertGreater(rows(run / "rwforc.csv")[10]["normal_force"], 0.0)

    def test_erosion(self):
        run = self.compare(self.write("erode.k", bar(material=ERODE, end=2e-5)))
        self.assertGreater(self.summary(run)["eroded_elements"], 0)

    def test_mass_scaling(self):
        run = self.compare(self.write("scale.k", bar(step_rows=SCALE)))
        self.assertGreater(self.summary(run)["mass"]["added"], 0.0)


if __name__ == "__main__":
    unittest.main()
