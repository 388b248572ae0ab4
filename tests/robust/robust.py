"""The program in a rough world: what the tests of this folder share. Each script: TEST.py PROGRAM DECKS MPIEXEC."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
PROGRAM, DECKS, MPIEXEC = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1)), sys.argv.pop(1)
PUNCH = DECKS / "punch.xml"
RESULTS = ["punch.contact.csv", "punch.e", "punch.summary.json"]
SECONDS = 120  # nothing takes so long: a run that does hangs


def cells(number):
    """Settings of the punch: so many cells along an edge of it."""
    return ("--set", f"Bodies/punch/Mesh/Cells={{{number}, {number}}}",
            "--set", f"Bodies/foundation/Mesh/Cells={{{2 * number}, {number}}}")


def on_ranks(number, *command):
    return (MPIEXEC, "--oversubscribe", "-np", str(number), *command)


def limited(what, size, *command):
    """The command under a limit in bytes on `what`, in prlimit's words: "as" (memory) or "fsize"."""
    return ("prlimit", f"--{what}={size}", *command)


def nicely():
    """For preexec_fn: whoever waits for a moment of the process is in time."""
    os.nice(19)


class RoughWorld(unittest.TestCase):
    """A folder a test, and what it must hold at the end."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_command(self, *command, **options):
        """Exit code and the two streams, at the end."""
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.run(command, cwd=self.folder, text=True, timeout=SECONDS, errors="replace", **options)

    def run_program(self, *arguments, **options):
        return self.run_command(PROGRAM, *arguments, **options)

    def start(self, *command, **options):
        """A process with a session of its own, gone at the end of the test whatever happens."""
        process = subprocess.Popen(command, cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   start_new_session=True, **options)
        self.addCleanup(end_session, process)
        return process

    def files(self):
        return sorted(os.listdir(self.folder))

    def unfinished(self):
        return [name for name in self.files() if name.endswith(".tmp")]

    def assert_refused(self, done, *messages):
        """Exit code 2 with these messages."""
        self.assertEqual(done.returncode, 2, done.stderr)
        for message in messages:
            self.assertIn(message, done.stderr)


def end_session(process):
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.communicate()


def wait_for_line(process, text):
    """Reads the screen up to a line with this text; False when the process ended before."""
    return any(text in line for line in process.stdout)


def wait_until(condition, process):
    """Polls; False when the process ended before. The process should be started `nicely`."""
    while not condition():
        if process.poll() is not None:
            return False
        time.sleep(0.0005)
    return True


def main():
    unittest.main(verbosity=2)
