"""A run that is killed, in the solve or while it writes, leaves no file that could be taken for a result."""

import os
import re
import signal

from robust import PROGRAM, PUNCH, RoughWorld, cells, main, nicely, on_ranks, wait_for_line, wait_until

HEADER = "interface nodes"  # the line before the bodies are factored
SWEEPS = "eps_tau"  # the line before the first sweep
# Megabytes to write: every sweep is a step.
LONG_WRITE = (*cells(40), "--set", "Output/Steps=All Sweeps", "--set", "Coupling/Stopping/Tolerance=1e-9")


class Signals(RoughWorld):
    def killed_at(self, line, number):
        """The exit code, and the last words of the run."""
        process = self.start(PROGRAM, "-i", PUNCH, *cells(60), preexec_fn=nicely)
        self.assertTrue(wait_for_line(process, line))
        process.send_signal(number)
        return process.wait(timeout=60), process.stderr.read()

    def killed_while_writing(self, number):
        """The exit code of a run that got the signal while an unfinished file was there."""
        for _ in range(5):  # on a busy machine the moment may be missed
            process = self.start(PROGRAM, "-q", "-i", PUNCH, *LONG_WRITE, preexec_fn=nicely)
            if wait_until(lambda: bool(self.unfinished()), process):
                process.send_signal(number)
                if process.wait(timeout=60) != 0:
                    return process.returncode
        return self.fail("a run was never caught writing")

    def test_the_solve_ends_by_the_signal(self):
        for number, cause in ((signal.SIGTERM, "ended by SIGTERM"), (signal.SIGHUP, "ended by SIGHUP"),
                              (signal.SIGINT, "interrupted by Ctrl-C (SIGINT)")):
            code, words = self.killed_at(HEADER, number)
            self.assertEqual(code, -number)
            self.assertRegex(words, rf'^{re.escape(cause)}.*; this run has written no file\.\n$')
        self.assertEqual(self.killed_at(SWEEPS, signal.SIGTERM)[0], -signal.SIGTERM)
        self.assertEqual(self.files(), [])

    def test_unfinished_files_are_removed(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            self.assertEqual(self.killed_while_writing(number), -number)
            self.assertEqual(self.unfinished(), [])

    def test_after_sigkill_the_next_run_cleans_up(self):
        self.assertEqual(self.killed_while_writing(signal.SIGKILL), -signal.SIGKILL)
        (left,) = self.unfinished()
        self.assertTrue(left.startswith(".punch."), left)
        mine = left.replace(left.split(".")[-2], str(os.getpid()))  # of a process that lives
        (self.folder / mine).touch()
        (self.folder / ".punch.e.tmp").touch()  # not ours
        self.assertEqual(self.run_program("-q", "-i", PUNCH).returncode, 0)
        self.assertEqual(self.unfinished(), sorted([mine, ".punch.e.tmp"]))

    def test_an_ignored_signal_stays_ignored(self):
        def like_nohup():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)
        process = self.start(PROGRAM, "-i", PUNCH, *cells(20), preexec_fn=like_nohup)
        self.assertTrue(wait_for_line(process, HEADER))
        process.send_signal(signal.SIGHUP)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)

    def test_all_ranks_end(self):
        process = self.start(*on_ranks(2, PROGRAM, "-i", PUNCH, *cells(150)))  # mpirun takes its time to pass it on
        self.assertTrue(wait_for_line(process, HEADER))
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)  # the ranks hold its streams: they are gone too
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    main()
