"""Spacetime runs: the same bits from any number of threads, wherever they are stopped, however they go on."""
import random
import re
import signal
import time
import unittest

from support import Case, rows

COUNT = 12  # quadrilaterals along a side, each split in two triangles


def plate(extra="", end=1.2, instants=0.02):
    """A plate of two materials with a crack along part of their interface, pulled at its lower edge."""
    jitter = random.Random(5)
    number, nodes, elements = {}, [], []
    for j in range(COUNT + 1):
        for i in range(COUNT + 1):
            number[i, j] = len(number) + 1
            x, y = 2 * i / COUNT - 1, 2 * j / COUNT - 1
            if 0 < i < COUNT and 0 < j < COUNT and 2 * j != COUNT:
                x, y = x + jitter.uniform(-0.03, 0.03), y + jitter.uniform(-0.03, 0.03)
            nodes.append(f"{number[i, j]:8d}{x:16.8f}{y:16.8f}{0.0:16.8f}\n")
    for j in range(COUNT):
        for i in range(COUNT):
            corners = (number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1])
            elements.append(f"{len(elements) + 1:8d}{1 + 2 * j // COUNT:8d}" + "".join(f"{n:8d}" for n in corners) + "\n")
    low = "".join(f"{number[i, 0]:10d}" + 3 * f"{number[i + 1, 0]:10d}" + "\n" for i in range(COUNT))
    high = [f"{number[i, COUNT]:10d}" for i in range(COUNT + 1)]
    middle, tip = number[COUNT // 2, COUNT // 2], number[COUNT // 4, COUNT // 2]
    part = "".join(f"*PART\npart {p}\n{p:10d}         1{p:10d}\n" for p in (1, 2))
    return "".join([
        f"*KEYWORD\n*TITLE\na plate of two materials\n*CONTROL_TERMINATION\n{end:10.4f}\n",
        "*CONTROL_SPACETIME\n         3         3\n         0         1\n",
        f"*DATABASE_GLSTAT\n{instants:10.5f}\n*DATABASE_NODOUT\n{0.7 * instants:10.5f}\n",
        f"*DATABASE_MATSUM\n{2 * instants:10.5f}\n*DATABASE_SPCFORC\n{3 * instants:10.5f}\n",
        f"*DATABASE_BINARY_D3PLOT\n{end / 4:10.4f}\n*DATABASE_HISTORY_NODE\n{middle:10d}{tip:10d}         1\n",
        "*SECTION_SHELL_SDG\n         1\n", part,
        "*MAT_ELASTIC\n         1       1.0       1.0       0.3\n*MAT_ELASTIC\n         2       2.0       5.0       0.2\n",
        "*DEFINE_CURVE\n         1\n                  0.                  1.\n               1000.                  1.\n",
        "*SET_SEGMENT\n         1\n", low, "*LOAD_SEGMENT_SET\n         1         1       -1.\n",
        "*SET_NODE_LIST\n         2\n", "".join(high[:8]), "\n", "".join(high[8:]), "\n",
        "*BOUNDARY_SPC_SET\n         2         0         1         1         0\n",
        "*BOUNDARY_PRECRACK\n         1         1         2\n      -0.5        0.        0.\n       0.5        0.        0.\n",
        extra, "*NODE\n", *nodes, "*ELEMENT_SHELL\n", *elements, "*END\n"])


class Spacetime(Case):
    def whole_run(self, deck):
        self.cleave("run", deck, "-o", "whole", "-q", "-j", 2)
        whole = self.folder / "whole"
        self.assert_whole(whole)
        self.assertEqual(self.summary(whole)["ending"], "end_time")
        return whole

    def test_threads(self):
        deck = self.write("plate.k", plate(end=0.6))
        whole = self.whole_run(deck)
        self.assertGreater(max(abs(row["y_displacement"]) for row in rows(whole / "nodout.csv")), 0.1)
        for threads in (1, 3, 7):
            self.cleave("run", deck, "-o", f"threads{threads}", "-q", "-j", threads)
            self.assert_same(whole, self.folder / f"threads{threads}")

    def test_a_signal_in_mid_run(self):
        deck = self.write("plate.k", plate())
        whole = self.whole_run(deck)
        for number, threads in ((signal.SIGTERM, 7), (signal.SIGINT, 1)):
            with self.subTest(number):
                run = self.folder / f"signal{number}"
                summary = self.stop_by_signal(number, run, 9, deck, "-j", 3)
                self.assertLess(summary["final_time"], 1.2)
                self.cleave("restart", run, "-q", "-j", threads)
                self.assertEqual(self.summary(run)["ending"], "end_time")
                self.assert_same(whole, run)

    def test_a_kill_leaves_files_to_go_on_from(self):
        deck = self.write("plate.k", plate(extra="*DATABASE_BINARY_RUNRSF\n         7\n"))
        whole = self.whole_run(deck)
        moment = random.Random(3)
        for threads in (1, 3):
            with self.subTest(threads):
                run = self.folder / f"killed{threads}"
                process = self.start("run", deck, "-o", run, "-q", "-j", 2)
                self.wait_for_rows(process, run / "glstat.csv", moment.randrange(12, 25))
                time.sleep(moment.random() * 0.02)
                process.kill()
                process.communicate(timeout=60)
                self.assert_whole(run, unfinished_allowed=True)
                self.cleave("restart", run, "-q", "-j", threads)
                self.assert_whole(run)
                self.assert_same(whole, run)

    def test_stops_at_cycles(self):
        deck = self.write("plate.k", plate(end=0.6))
        whole = self.whole_run(deck)
        run = self.folder / "by_cycle"
        self.cleave("run", deck, "-o", run, "-q", "-j", 1, "--stop-at-cycle", 1)
        for cycle, threads in ((2, 7), (13, 3), (14, 1)):
            self.assertLess(self.summary(run)["cycles"], cycle)
            self.cleave("restart", run, "-q", "-j", threads, "--stop-at-cycle", cycle)
            self.assertEqual(self.summary(run)["cycles"], cycle)
        self.cleave("restart", run, "-q", "-j", 2)
        self.assert_same(whole, run)

    def test_the_page_counts_the_elements(self):
        self.cleave("run", self.write("plate.k", plate(end=0.1)), "-o", "whole", "-q")
        summary = self.summary(self.folder / "whole")
        self.assertEqual(summary["counts"]["elements"], COUNT * COUNT)
        self.assertEqual(summary["facts"]["simplices"], 2 * COUNT * COUNT)
        self.assertEqual([part["elements"] for part in summary["parts"]], 2 * [COUNT * COUNT // 2])
        self.assertEqual(summary["eroded_elements"], 0)
        self.assertRegex((self.folder / "whole" / "messag").read_text(), r"quad4 +%d\n" % (COUNT * COUNT))
        self.assertEqual(summary["parts"][0]["initial"]["low"], [-1.0, -1.0, 0.0])

    def test_a_front_that_cannot_go_on(self):
        # From 0.3 on the traction is beyond the largest number: no patch at the lower edge can be solved.
        deck = plate(end=0.6).replace("                  0.                  1.\n               1000.                  1.\n",
                                      "                  0.                  0.\n                 0.3                  0.\n"
                                      "                0.31              1.e200\n               1000.              1.e200\n")
        deck = self.write("plate.k", deck.replace("         1         1       -1.\n", "         1         1    1.e200\n"))
        for command in (("run", deck, "-o", "run", "-q", "-j", 2), ("restart", "run", "-q", "-j", 3)):
            _, err = self.cleave(*command, status=4)
            run = self.folder / "run"
            self.assert_whole(run)
            log = (run / "messag").read_text()
            found = re.findall(r"at node (\d+), time (\S+) \(it should rise by at least (\S+)\): no tent is low enough", log)
            node, time_, bound = found[-1]
            self.assertLessEqual(int(node), COUNT + 1)   # of the lower edge
            self.assertTrue(0.2 < float(time_) < 0.32 and 0 < float(bound) < 0.2, found)
            self.assertTrue((run / "restart.h5").is_file())
            self.assertEqual(self.summary(run)["ending"], "physics")
            self.assertLess(self.summary(run)["final_time"], 0.32)
            self.assertEqual(len(set(found)), 1)   # a restarted run ends at the same place

    def test_energies_beyond_numbers_end_the_run(self):
        deck = plate(end=0.6).replace("         1         1       -1.\n", "         1         1    1.e160\n")
        deck = deck.replace("         0         1\n", "         0         0\n", 1)   # or verification stops it
        self.cleave("run", self.write("plate.k", deck), "-o", "run", "-q", status=4)
        self.assertIn("the energy of the body is not a finite number", (self.folder / "run" / "messag").read_text())


if __name__ == "__main__":
    unittest.main()
