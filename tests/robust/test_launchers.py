"""Processes that other launchers than mpirun start, and what a terminal, or what only looks like one, gets to see."""

import json
import os
import pty
import subprocess
import sys

from robust import DECKS, PROGRAM, PUNCH, RESULTS, SECONDS, RoughWorld, main, on_ranks

sys.path.insert(0, str(DECKS.parent / "python"))
from ndframe import deck_text  # noqa: E402

ERASE = "\x1b[K"
SQUARE = """\
    Point(1) = {0, 0, 0, 1}; Point(2) = {1, 0, 0, 1}; Point(3) = {1, 1, 0, 1}; Point(4) = {0, 1, 0, 1};
    Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
    Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Physical Curve("bottom") = {1};
    """


class Launchers(RoughWorld):
    def ranks(self):
        return json.loads((self.folder / "punch.summary.json").read_text())["ranks"]

    def test_a_launcher_that_tells_the_number_of_processes_to_mpi_only(self):
        """As PMIx does, below prterun or srun --mpi=pmix."""
        done = self.run_command(*on_ranks(2, "env", "-u", "OMPI_COMM_WORLD_SIZE", PROGRAM, "-q", "-i", PUNCH))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.ranks(), 2)

    def test_processes_that_mpi_does_not_join_are_refused_by_one_voice(self):
        for size, rank in (("PMI_SIZE", "PMI_RANK"), ("SLURM_STEP_NUM_TASKS", "SLURM_PROCID")):
            first, second = (self.run_command("env", f"{size}=2", f"{rank}={r}", PROGRAM, "-q", "-i", PUNCH)
                             for r in (0, 1))
            self.assert_refused(first, f"2 processes were started ({size}), but this program's MPI joins only 1",
                                f"unset {size}")
            self.assertEqual((second.returncode, second.stderr), (2, ""))
            self.assertEqual(self.files(), [])

    def test_the_job_of_a_script_is_no_launcher(self):
        done = self.run_command("env", "SLURM_NTASKS=4", "SLURM_JOB_ID=7", PROGRAM, "-q", "-i", PUNCH)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.ranks(), self.files()), (1, RESULTS))


class Terminals(RoughWorld):
    """Of a run whose first stage lasts longer than a second."""

    def setUp(self):
        super().setUp()
        (self.folder / "slow.geo").write_text(SQUARE + 'SystemCall "sleep 1.5";\n')
        body = {"Mesh": {"Type": "Gmsh", "File": "slow.geo", "Allow Commands": True},
                "Material": {"Young Modulus": 1.0, "Poisson Ratio": 0.3},
                "Supports": {"ground": {"Type": "Clamp", "Side": "bottom"}}}
        (self.folder / "slow.xml").write_text(deck_text({"Bodies": {"block": body}}, "slow"))

    def on_terminal(self, *command, **variables):
        """What a terminal shows of a command."""
        inner, outer = pty.openpty()
        process = subprocess.Popen(command, cwd=self.folder, stdout=outer, stderr=outer,
                                   env={**os.environ, "TERM": "xterm", **variables})
        os.close(outer)
        shown = b""
        while True:
            try:
                block = os.read(inner, 65536)
            except OSError:  # the other end is closed
                break
            if not block:
                break
            shown += block
        os.close(inner)
        self.assertEqual(process.wait(SECONDS), 0)
        return shown.decode()

    def test_live_lines_are_for_terminals_that_can_erase_them(self):
        run = (PROGRAM, "-i", "slow.xml")
        self.assertIn(ERASE, self.on_terminal(*run))
        for variables in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\x1b", self.on_terminal(*run, **variables))

    def test_ranks_write_none(self):
        """mpirun gives its processes terminals and may write what they say to a file."""
        self.assertNotIn("\x1b", self.on_terminal(*on_ranks(1, PROGRAM, "-i", "slow.xml")))


if __name__ == "__main__":
    main()
