"""Runs that are stopped on the way, kindly or not, and what is left of them."""
import os
import random
import re
import signal
import time
import unittest

from support import Case, bar, rows


class Stopped(Case):
    def setUp(self):
        super().setUp()
        # A restart file on the way (every 100 cycles) is what a killed run can go on from.
        self.deck = self.write("bar.k", bar(end=2.5e-5, extra="*DATABASE_BINARY_RUNRSF\n       100\n"))

    def whole_run(self):
        self.cleave("run", self.deck, "-o", "whole", "-q", "-j", 2)
        return self.folder / "whole"

    def test_a_signal_ends_the_cycle_and_the_run_goes_on_with_the_same_bits(self):
        whole = self.whole_run()
        for number, name in ((signal.SIGINT, "SIGINT"), (signal.SIGTERM, "SIGTERM")):
            with self.subTest(name):
                run = self.folder / name
                summary = self.stop_by_signal(number, run, 7, self.deck, "-j", 2)
                self.assertTrue(summary["normal"])
                self.assertLess(summary["final_time"], 2.5e-5)
                self.assertIn("a signal asked it to stop", (run / "messag").read_text())
                self.cleave("restart", run, "-q", "-j", 1)
                self.assert_whole(run)
                self.assertEqual(self.summary(run)["ending"], "end_time")
                self.assert_same(whole, run)

    def test_a_kill_leaves_whole_files_to_go_on_from(self):
        whole = self.whole_run()
        moment = random.Random(20)
        for trial in range(6):
            with self.subTest(trial=trial):
                run = self.folder / f"killed{trial}"
                process = self.start("run", self.deck, "-o", run, "-q", "-j", 2)
                self.wait_for_rows(process, run / "glstat.csv", moment.randrange(8, 30))
                time.sleep(moment.random() * 0.02)
                process.kill()
                process.communicate(timeout=60)
                self.assertEqual(process.returncode, -signal.SIGKILL)
                self.assert_whole(run, unfinished_allowed=True)
                if (run / "restart.h5").is_file():
                    self.cleave("restart", run, "-q", "-j", 3)
                else:
                    self.cleave("run", self.deck, "-o", run, "-q", "-j", 3)
                self.assert_whole(run)
                self.assert_same(whole, run)

    def test_switches_in_a_file(self):
        run = self.folder / "switched"
        process = self.start("run", self.deck, "-o", run, "-q", "--end-time", 10.0, "-j", 1)
        self.wait_for_rows(process, run / "glstat.csv", 3)
        log = run / "messag"
        frames = len(list((run / "result").glob("*.vtu")))

        def switch(word):
            (run / "d3kil.new").write_text(word + "\n")
            os.replace(run / "d3kil.new", run / "d3kil")
            deadline = time.monotonic() + 60
            while (run / "d3kil").exists() and process.poll() is None:
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.005)

        switch("sw3")
        switch("sw4")
        switch("SW2")
        deadline = time.monotonic() + 60
        while len(list((run / "result").glob("*.vtu"))) <= frames and time.monotonic() < deadline:
            time.sleep(0.005)
        switch("sw1")
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.summary(run)["ending"], "switched_off")
        self.assertGreaterEqual(len(re.findall(r"write restart\.h5", log.read_text())), 2)
        self.assertGreater(len(list((run / "result").glob("*.vtu"))), frames)
        self.assert_whole(run)

    def test_a_restart_keeps_what_the_command_line_said_of_the_deck(self):
        inner = self.folder / "mesh"
        inner.mkdir()
        text = bar((1, 1, 9), end=1e-4)
        head, mesh = text.split("*NODE\n")
        (inner / "mesh.k").write_text("*NODE\n" + mesh)
        self.write("bar.k", head + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n\n\n\n*INCLUDE\nmesh.k\n*END\n")
        words = ["-q", "-I", "mesh", "--allow-unsupported", "--end-time", "2e-5"]
        self.cleave("run", "bar.k", "-o", "whole", *words)
        self.cleave("run", "bar.k", "-o", "parts", *words, "--stop-at-cycle", 3)
        self.cleave("restart", "parts", "-q")
        self.assert_same(self.folder / "whole", self.folder / "parts")
        self.assertLess(self.summary(self.folder / "parts")["final_time"], 2.5e-5)
        self.cleave("restart", "parts", "-q", "--end-time", "3e-5")
        self.assertGreater(self.summary(self.folder / "parts")["final_time"], 2.9e-5)

    def test_stop_at_a_cycle(self):
        whole = self.whole_run()
        run = self.folder / "by_cycle"
        self.cleave("run", self.deck, "-o", run, "-q", "--stop-at-cycle", 57)
        self.assertEqual(self.summary(run)["cycles"], 57)
        self.cleave("restart", run, "-q", "--stop-at-cycle", 58)
        self.assertEqual(self.summary(run)["cycles"], 58)
        self.cleave("restart", run, "-q")
        self.assert_same(whole, run)
        self.assertEqual(rows(whole / "glstat.csv")[-1], rows(run / "glstat.csv")[-1])


if __name__ == "__main__":
    unittest.main()
