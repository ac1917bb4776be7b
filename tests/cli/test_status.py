"""Exit statuses, and what is left on disk when something is wrong."""
import os
import resource
import stat
import unittest

from support import Case, bar, plain

# Over-fast: the first elements turn inside out.
CRASH = {"cells": (1, 1, 3), "end": 1e-3, "speed": -1e8,
         "material": "*MAT_ELASTIC\n         1  8.93E-09  1.17E+05      0.35\n"}


class Statuses(Case):
    def test_help_and_version_are_done(self):
        for words in (["--help"], ["run", "--help"], ["--version"], ["examples"], ["explain", "NODE"]):
            out, err = self.cleave(*words)
            self.assertTrue(out)
            self.assertEqual(err, "")

    def test_usage(self):
        for words in ([], ["walk"], ["run"], ["run", "--no-such-option", "a.k"], ["run", "a.k", "-j", "0"],
                      ["explain", "NODAL"], ["examples", "no-such-example"], ["run", "a.k", "--stop-at-cycle", "x"],
                      ["run", "a.k", "--end-time", "-1"]):
            with self.subTest(words):
                out, err = self.cleave(*words, status=2)
                self.assertTrue(out + err)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_refused_deck_leaves_nothing_behind(self):
        deck = self.write("bad.k", bar((1, 1, 2)).replace("      0.35", "      0.75"))
        for words in (["run", deck], ["check", deck], ["convert", deck, "-o", "out.k"]):
            _, err = self.cleave(*words, status=3)
            self.assertIn("bad.k:", err)
            self.assertIn("PR", err)
            self.assertIn("the deck was not accepted", err)
        self.assertEqual(os.listdir(self.folder), ["bad.k"])

    def test_a_misspelt_keyword_is_no_small_thing(self):
        deck = self.write("bar.k", bar((1, 1, 9), end=1e-6).replace("*RIGIDWALL_PLANAR", "*RIGIDWALL_PLANER"))
        _, err = self.cleave("run", deck, status=3)
        self.assertIn("bar.k:39:1: error: unknown keyword '*RIGIDWALL_PLANER'", err)
        self.assertIn("did you mean *RIGIDWALL_PLANAR?", err)
        _, err = self.cleave("run", deck, "-q", "--allow-unsupported")
        self.assertIn("warning: unknown keyword '*RIGIDWALL_PLANER': it is skipped", err)

    def test_decks_that_are_none(self):
        self.write("empty.k", "")
        self.write("letter.k", "Dear solver,\nplease compute.\n")
        (self.folder / "folder.k").mkdir()
        for name, word in (("absent.k", "absent.k"), ("folder.k", "folder"), ("empty.k", "empty.k"),
                           ("letter.k", "letter.k")):
            with self.subTest(name):
                _, err = self.cleave("run", name, status=3)
                self.assertIn(word, err)
                self.assertIn("error", err)
        self.assertEqual(sorted(os.listdir(self.folder)), ["empty.k", "folder.k", "letter.k"])

    def test_check_tells_everything_but_an_end_time(self):
        text = bar((1, 1, 9), end=1e-6)
        card = text[text.index("*CONTROL_TERMINATION"):]
        card = card[:card.index("*", 1)]
        deck = self.write("endless.k", text.replace(card, ""))
        out, err = self.cleave("check", deck, status=3)
        self.assertIn("endless.k:1:1: error: *CONTROL_TERMINATION ENDTIM: the deck gives no end time", err)
        for word in ("MAT_", "jacobian", "time step", "MiB", "9 elements"):
            self.assertIn(word, out)
        self.cleave("run", deck, "-q", status=3)
        self.cleave("run", deck, "-q", "--end-time", "1e-7")

    def test_a_deck_that_wants_no_solution_is_checked(self):
        text = bar((1, 1, 9), end=1e-6)
        at = text.index("*CONTROL_TERMINATION\n") + len("*CONTROL_TERMINATION\n")
        end = text.index("\n", at)
        deck = self.write("nosol.k", text[:end].ljust(at + 10) + " " * 49 + "1" + text[end:])
        out, _ = self.cleave("run", deck)
        for word in ("jacobian", "time step", "9 elements", "NOSOL = 1: nothing was computed"):
            self.assertIn(word, out)
        self.assertEqual(os.listdir(self.folder), ["nosol.k"])

    def test_an_element_unfit_for_its_form_has_its_line(self):
        text = bar((1, 1, 2))
        lines = text.splitlines()
        at = lines.index("*ELEMENT_SOLID") + 2
        words = lines[at - 1].split()
        self.write("turned.k", "\n".join(
            lines[:at - 1] + ["".join(f"{w:>8}" for w in words[:2] + words[6:] + words[2:6])] + lines[at:]) + "\n")
        _, err = self.cleave("check", "turned.k", status=3)
        self.assertIn(f"turned.k:{at}:1: error: *ELEMENT_SOLID EID: element {words[0]} has volume 0 or less", err)

    def test_failed_physics(self):
        self.cleave("run", self.write("crash.k", bar(**CRASH)), "-q", status=4)
        run = self.folder / "crash.run"
        summary = self.summary(run)
        self.assertEqual((summary["ending"], summary["normal"]), ("physics", False))
        self.assertTrue(summary["failure"])
        self.assertIn("E r r o r   t e r m i n a t i o n", (run / "messag").read_text())
        self.assert_whole(run)

    def test_a_folder_of_other_files_is_left_alone(self):
        deck = self.write("bar.k", bar((1, 1, 2), end=1e-7))
        other = self.folder / "thesis"
        other.mkdir()
        (other / "chapter1.tex").write_text("it was a dark night")
        _, err = self.cleave("run", deck, "-o", other, status=5)
        self.assertIn("not of a run", err)
        self.assertEqual(os.listdir(other), ["chapter1.tex"])

    def test_a_run_may_replace_a_run(self):
        deck = self.write("bar.k", bar((1, 1, 9), end=1e-5))
        self.cleave("run", deck, "-q")
        self.cleave("run", deck, "-q", "--end-time", "5e-6")
        self.assertLess(self.summary(self.folder / "bar.run")["final_time"], 7e-6)
        self.assert_whole(self.folder / "bar.run")

    def test_places_that_cannot_be_written(self):
        deck = self.write("bar.k", bar((1, 1, 2), end=1e-7))
        for words in (["run", deck, "-o", deck / "below"], ["convert", deck, "-o", "no/such/folder.k"],
                      ["restart", "absent.run"], ["view", "absent.run"]):
            with self.subTest(words):
                _, err = self.cleave(*words, status=5)
                self.assertIn("cleave: ", err)

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_a_deck_without_permission(self):
        deck = self.write("secret.k", bar((1, 1, 2)))
        deck.chmod(stat.S_IWUSR)
        self.cleave("run", deck, status=3)

    def test_a_full_disk(self):
        deck = self.write("bar.k", bar((2, 2, 12), end=4e-6))
        self.cleave("run", deck, "-q", "-o", "room")
        largest = max(p.stat().st_size for p in (self.folder / "room").rglob("*") if p.is_file())
        for limit in (0, 300, 3000, largest // 2):
            with self.subTest(limit=limit):
                run = self.folder / f"limit{limit}"
                _, err = self.cleave(
                    "run", deck, "-q", "-o", run, status=5,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                self.assertIn("File too large", plain(err))
                self.assert_whole(run)

    def test_a_restart_of_another_deck(self):
        deck = self.write("bar.k", bar((1, 1, 9), end=1e-5))
        self.cleave("run", deck, "-q", "--stop-at-cycle", 3)
        deck.write_text(bar((1, 1, 8), end=1e-5))
        _, err = self.cleave("restart", "bar.run", status=3)
        self.assertIn("does not fit", err)
        restart = self.folder / "bar.run/restart.h5"
        restart.write_bytes(restart.read_bytes()[:1000])
        _, err = self.cleave("restart", "bar.run", status=5)
        self.assertIn("restart.h5", err)

    def test_old_habits(self):
        self.write("bar.k", bar((1, 1, 9), end=1e-5))
        self.cleave("i=bar.k", "ncpu=2", "memory=20m", "o=old", "endtime=5e-6")
        self.assertLess(self.summary(self.folder / "old")["final_time"], 7e-6)
        self.assertIn("threads   2", (self.folder / "old/messag").read_text())

    def test_examples_run(self):
        out, _ = self.cleave("examples")
        self.assertIn("taylor", out)
        out, _ = self.cleave("examples", "taylor")
        self.assertEqual(out.strip(), "taylor/taylor.k")
        self.cleave("check", "taylor/taylor.k")
        self.cleave("run", "taylor/taylor.k", "-q", "--stop-at-cycle", 2)


if __name__ == "__main__":
    unittest.main()
