"""What a study leaves that was killed or ran out of memory."""

import csv
import signal

from robust import PROGRAM, PUNCH, RoughWorld, cells, limited, main, nicely, wait_until

PARTIAL, WHOLE = "punch.study.partial.csv", "punch.study.csv"
# Every case factors again, for long enough to be caught at it.
STIFFNESSES = "; ".join(str(E) for E in range(1, 21))
# The cases in the middle are too large: the first for CHOLMOD, which says so, the second for anything, as its size says.
SIZES = ("Bodies/punch/Mesh/Cells={5, 5}; {90, 90}; {200, 200}; {6, 6}"
         " && Bodies/foundation/Mesh/Cells={10, 5}; {180, 90}; {400, 200}; {12, 6}")


class Studies(RoughWorld):
    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def killed_after_two_cases(self, number):
        process = self.start(PROGRAM, "-q", "-i", PUNCH, *cells(30), "--study",
                             f"Bodies/punch/Material/Young Modulus={STIFFNESSES}", preexec_fn=nicely)
        written = lambda: PARTIAL in self.files() and len(self.rows(PARTIAL)) >= 2
        self.assertTrue(wait_until(written, process), "the study ended before it was caught")
        process.send_signal(number)
        self.assertEqual(process.wait(timeout=60), -number)
        return process.stderr.read()

    def test_that_is_killed_leaves_the_cases_it_has_solved(self):
        for number in (signal.SIGTERM, signal.SIGKILL):
            words = self.killed_after_two_cases(number)
            if number != signal.SIGKILL:
                self.assertIn(f"complete files of this run: {PARTIAL}.", words)
            rows = self.rows(PARTIAL)
            self.assertLess(len(rows), 20)
            self.assertEqual([row["case"] for row in rows], [str(k + 1) for k in range(len(rows))])
            self.assertEqual({row["exit_code"] for row in rows}, {"0"})
            self.assertNotIn(WHOLE, self.files())

    def test_a_case_without_memory_ends_alone(self):
        done = self.run_command("env", "OMP_NUM_THREADS=1",
                                *limited("as", 480 << 20, PROGRAM, "-q", "-i", PUNCH, "--study", SIZES))
        self.assertEqual(done.returncode, 2, done.stderr)
        rows = self.rows(WHOLE)
        self.assertEqual([row["exit_code"] for row in rows], ["0", "2", "2", "0"])
        self.assertIn("does not fit into memory", rows[1]["reason"])
        self.assertIn("are available: use coarser meshes", rows[2]["reason"])
        self.assertEqual(self.files(), [WHOLE])


if __name__ == "__main__":
    main()
