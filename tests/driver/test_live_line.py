"""What the screen shows while the program works, and the file of --log: test_live_line.py NDFRAME DECKS MPIEXEC."""

import fcntl
import os
import pathlib
import pty
import re
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

MPIEXEC, DECKS, PROGRAM = sys.argv.pop(), pathlib.Path(sys.argv.pop()), sys.argv.pop()
PUNCH = str(DECKS / "punch.xml")
#: Long enough that a stage lasts some hundredths of a second on any machine.
FINE = ["--set", "Bodies/punch/Mesh/Cells={90, 90}", "--set", "Bodies/foundation/Mesh/Cells={180, 90}"]
PATIENCE = 0.02
LIVE = re.compile(r"^  \S.* \.\.\. \d+ s$")


def environment(**changes):
    plain = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "TERM")}
    return {**plain, "TERM": "xterm", **changes}


def on_terminal(*arguments, columns=200, **changes):
    """All bytes that a terminal gets, standard output and error alike."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    child = subprocess.Popen([PROGRAM, *arguments], stdin=slave, stdout=slave, stderr=slave, env=environment(**changes))
    os.close(slave)
    text = b""
    while True:
        try:
            more = os.read(master, 65536)
        except OSError:  # the last one who wrote is gone
            break
        if not more:
            break
        text += more
    os.close(master)
    child.wait()
    return text.decode().replace("\r\n", "\n")


def on_pipe(*arguments):
    done = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment())
    return done.returncode, done.stdout


def left_on(text):
    """What stays on the screen: a line's end where it was erased is gone."""
    text = re.sub(r"\x1b\[\d*m", "", text)
    return "\n".join(line.split("\r\x1b[K")[-1] for line in text.split("\n"))


def timeless(text):
    """Without numbers that are different in every run: seconds and memory."""
    text = re.sub(r"\d+\.\d+ s, \d+ MB", "TIME", text)
    return re.sub(r"(?m)^(  [a-z ]+?) +\d+\.\d{3} +\d+$", r"\1 STAGE", text)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = ["--set", f"Output/Directory={self.folder.name}", "--set", "Output/Exodus=false"]
        self.log = str(pathlib.Path(self.folder.name) / "run.log")

    def logged(self, stages=False):
        text = pathlib.Path(self.log).read_text()
        return text if stages else "".join(line for line in text.splitlines(True) if not line.startswith("# "))


class Terminal(Folder):
    def test_a_line_appears_and_is_erased(self):
        given = [PUNCH, *FINE, *self.output]
        shown = on_terminal(*given, "--live", str(PATIENCE))
        self.assertRegex(shown, r"\x1b\[2m  \S.* \.\.\. \d+ s\x1b\[0m")
        self.assertEqual(timeless(left_on(shown)), timeless(on_pipe(*given, "--live", "0")[1]))

    def test_lines_are_not_longer_than_the_terminal(self):
        shown = on_terminal(PUNCH, *FINE, *self.output, "--live", str(PATIENCE), columns=9)
        drawn = set(re.findall(r"\x1b\[2m(.*?)\x1b\[0m", shown))
        self.assertEqual({len(line) for line in drawn}, {8})

    def test_short_runs_show_none(self):
        shown = on_terminal(PUNCH, *self.output, "--live", "60")
        self.assertNotIn("\x1b", shown)

    def test_no_color_is_honoured(self):
        for changes in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            shown = on_terminal(PUNCH, *FINE, *self.output, "--live", str(PATIENCE), **changes)
            self.assertNotIn("\x1b", shown)
            self.assertNotIn("\r", shown)
            self.assertTrue(any(LIVE.match(line) for line in shown.split("\n")), "a line of its own instead")
        self.assertRegex(on_terminal(PUNCH, *FINE, *self.output, "--live", str(PATIENCE), NO_COLOR=""), "\x1b")

    def test_mistakes_are_coloured(self):
        wrong = [PUNCH, "--set", "Coupling/Stopping/Tolerance=7"]
        self.assertRegex(on_terminal(*wrong), r"\x1b\[31m[^\x1b]*Tolerance[^\x1b]*\x1b\[0m")
        self.assertNotIn("\x1b", on_terminal(*wrong, NO_COLOR="1"))
        self.assertNotIn("\x1b", on_pipe(*wrong)[1])


class Pipe(Folder):
    def test_a_line_after_each_patience_and_no_more(self):
        begin = time.monotonic()
        code, text = on_pipe(PUNCH, *FINE, *self.output, "--live", str(PATIENCE))
        elapsed = time.monotonic() - begin
        lines = [line for line in text.split("\n") if LIVE.match(line)]
        self.assertEqual(code, 0)
        self.assertGreaterEqual(len(lines), 1, text)
        self.assertLessEqual(len(lines), elapsed / PATIENCE)
        self.assertNotIn("\x1b", text)
        silent = on_pipe(PUNCH, *FINE, *self.output)[1]
        self.assertEqual([line for line in silent.split("\n") if LIVE.match(line)], [], "ten seconds by default")
        rest = "\n".join(line for line in text.split("\n") if not LIVE.match(line))
        self.assertEqual(timeless(rest), timeless(silent))

    def test_says_which_case_and_how_far(self):
        _, text = on_pipe(PUNCH, *FINE, *self.output, "--live", str(PATIENCE), "--study", "Coupling/Type=Monolithic; FETI",
                          "--study", "Bodies/punch/Material/Young Modulus=1; 2")
        self.assertRegex(text, r"(?m)^  case 1 of 4, 0 %, \w+, bodies done \d of 2, \d+ % ")
        self.assertRegex(text, r"(?m)^  case [234] of 4, \d+ % \(about \d+ s left\), ")

    def test_says_how_far_levels_are(self):
        _, text = on_pipe(PUNCH, *self.output, "--live", "0.005", "--set", "Accuracy/Target=0.001")
        self.assertRegex(text, r"(?m)^  level \d+, bound \d\.\d+ \(until 0\.001\), [a-z ]+ ")

    def test_says_how_far_iterations_and_certificates_of_solids_are(self):
        block = str(DECKS.parent / "regression/cases/multigrid/multigrid.xml")
        code, text = on_pipe(block, *self.output, "--live", "0.002", "--set", "Bodies/block/Mesh/Cells={14, 14, 14}")
        self.assertEqual(code, 0, text)
        self.assertRegex(text, r"(?m)^  recover, iteration \d+, residual \S+ \(until 1e-12, about \d+ s left\) \.\.\. \d+ s$")
        self.assertRegex(text, r"(?m)^  certify recovery, cell \d+ of \d+, \d+ % ")
        self.assertRegex(text, r"(?m)^  certify recovery, step \d+, gain \S+ \(until 0\.01, about \d+ s left\)")

    def test_a_wrong_patience_is_refused(self):
        for wrong in ("-1", "soon"):
            code, text = on_pipe(PUNCH, "--live", wrong)
            self.assertEqual((code, "--live" in text), (2, True), text)


class LogFile(Folder):
    def run_logged(self, *arguments):
        return on_pipe(PUNCH, *self.output, "--live", "0", "--log", self.log, *arguments)

    def test_holds_what_the_screen_showed(self):
        code, shown = self.run_logged()
        self.assertEqual(code, 0)
        self.assertEqual(self.logged(), shown)
        for stage in ("read", "factor", "couple", "write"):
            self.assertRegex(self.logged(stages=True), rf"(?m)^# \d\d:\d\d:\d\d  \+\d+\.\d{{3}} s  {stage}$")

    def test_holds_warnings_and_misses(self):
        code, shown = self.run_logged("--set", "Expect/wrong/Quantity=energy", "--set", "Expect/wrong/Value=0",
                                      "--set", "Expect/wrong/Tolerance=0", "--set", "Bodies/punch/Loads/press/Value=1e3")
        self.assertEqual(code, 4, shown)
        self.assertIn("MISSED wrong", shown)
        self.assertIn("warning", shown)
        self.assertEqual(sorted(self.logged().split("\n")), sorted(shown.split("\n")))

    def test_holds_no_live_lines(self):
        on_terminal(PUNCH, *FINE, *self.output, "--live", str(PATIENCE), "--log", self.log)
        self.assertNotIn("\x1b", self.logged())
        self.assertEqual([line for line in self.logged().split("\n") if LIVE.match(line)], [])

    def test_holds_what_quiet_does_not_show(self):
        self.run_logged()
        before = self.logged()
        self.assertEqual(self.run_logged("-q"), (0, ""))
        self.assertEqual(timeless(self.logged()), timeless(before))

    def test_holds_why_a_deck_is_wrong(self):
        code, shown = self.run_logged("--set", "Bodies/punch/Mesh/Type=Box of cards")
        self.assertEqual(code, 2)
        self.assertEqual(self.logged(), shown)

    def test_holds_the_last_words(self):
        child = subprocess.Popen([PROGRAM, PUNCH, *self.output, "--log", self.log, "--set", "Bodies/punch/Mesh/Cells={600, 600}"],
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while not (os.path.exists(self.log) and "  read" in self.logged(stages=True)):
            self.assertIsNone(child.poll())
            time.sleep(0.005)
        child.send_signal(signal.SIGINT)
        _, words = child.communicate()
        self.assertIn("interrupted by Ctrl-C", words)
        self.assertIn(words, self.logged())

    def test_is_written_by_one_rank(self):
        shown = subprocess.run([MPIEXEC, "--oversubscribe", "-n", "3", PROGRAM, PUNCH, *self.output, "--live", "0", "--log", self.log],
                               stdout=subprocess.PIPE, text=True, check=True).stdout
        self.assertEqual(self.logged(), shown)

    def test_a_file_that_cannot_be_written_is_refused(self):
        for name, reason in ((self.folder.name + "/none/run.log", "No such file or directory"), (self.folder.name, "Is a directory")):
            code, shown = on_pipe(PUNCH, *self.output, "--log", name)
            self.assertEqual((code, shown.split("\n")[0]), (2, f'--log: cannot write "{name}": {reason}.'))
        code, shown = on_pipe(PUNCH, *self.output, "--log", "/dev/full")
        self.assertEqual(code, 2)
        self.assertIn('cannot write "/dev/full" (--log)', shown)

    def test_the_deck_is_not_overwritten(self):
        deck = pathlib.Path(self.folder.name) / "deck.xml"
        deck.write_text(pathlib.Path(PUNCH).read_text())
        code, shown = on_pipe(str(deck), *self.output, "--log", str(pathlib.Path(self.folder.name) / "." / "deck.xml"))
        self.assertEqual(code, 2)
        self.assertIn("is the deck", shown)
        self.assertEqual(deck.read_text(), pathlib.Path(PUNCH).read_text())


if __name__ == "__main__":
    unittest.main()
