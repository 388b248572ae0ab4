"""Targets whose levels are shared out: test_shared_targets.py NDFRAME DECKS MPIEXEC.

Levels that are large enough for the processes are shared out; the others are whole. Meshes, bounds and the bracket of all certificates are those
of one process, and runs that are ended between levels or on one go on.
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from shares_test import SharesTest  # noqa: E402

LOSS = ["Linear Solver/Type=Multigrid", "Accuracy/Target=0.04"]
LAST = 17187  # dofs of the last level; the first has 60 vertices, too few for two processes


class SharedTargets(SharesTest):
    def compare_levels(self, one, shared, bound):
        levels, others = one["accuracy"]["levels"], shared["accuracy"]["levels"]
        self.assertEqual(len(levels), len(others))
        for level, other in zip(levels, others):  # meshes follow solutions that are loose but for the last one
            self.assertAlmostEqual(other["dofs"] / level["dofs"], 1.0, delta=0.02)
            self.assertAlmostEqual(other["bound"] / level["bound"], 1.0, delta=bound)
            self.assertEqual(other["worst_shape"], level["worst_shape"])
            self.assertTrue(other["guaranteed"])
        brackets = [run["errors"]["energy_bracket"] for run in (one, shared)]
        self.assertGreaterEqual(brackets[1]["certificates"], len(levels), "all certificates are of one scene")
        self.assertLess(max(bracket["lower"] for bracket in brackets), min(bracket["upper"] for bracket in brackets))

    def test_levels_are_those_of_one_process(self):
        root = self.bare("contact-loss-3d")
        one = self.right(root, 1, *LOSS)
        self.assertAlmostEqual(one["accuracy"]["dofs"] / LAST, 1.0, delta=0.02)
        for ranks in (2, 3):
            done, shared = self.run_deck(root, ranks, *LOSS, "Error Estimation/Check Equilibrium=true")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = [int(line.split()[0]) for line in done.stdout.splitlines()
                    if line.endswith(f"note: meshes are shared out among the {ranks} processes from here on")]
            self.assertEqual(len(said), 1, done.stdout)
            self.compare_levels(one, shared, 0.01)
            self.assertLess(shared["errors"]["equilibrium"], 1e-10)
            counts = shared["ledger"]["counts"]["shared bodies"]
            self.assertGreater(said[0], 1, "the first level is whole")
            self.assertEqual(counts, 2 * (len(shared["accuracy"]["levels"]) - said[0] + 1), "those from then on")

    def test_the_first_level_may_be_shared(self):
        """What follows it is carried from one share to another: no more iterations than on one process."""
        root = self.bare("contact-loss-3d")
        fine = [*LOSS, "Accuracy/Start=Deck", "Accuracy/Target=0.05", "Bodies/upper/Mesh/Refine=1", "Bodies/upper/Mesh/Cells={3, 3, 2}",
                "Bodies/lower/Mesh/Cells={6, 6, 3}", "Bodies/lower/Mesh/Refine=1", "Output/Exodus Files=Single"]
        one = self.right(root, 1, *fine)
        done, shared = self.run_deck(root, 2, *fine)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("shared out among the 2 processes", done.stdout)
        self.assertNotIn("from here on", done.stdout, "the header says it")
        self.compare_levels(one, shared, 0.01)
        self.assertEqual(shared["ledger"]["counts"]["shared bodies"], 2 * len(shared["accuracy"]["levels"]))
        counts = [run["ledger"]["counts"]["Krylov iterations"] for run in (one, shared)]
        self.assertLess(counts[1], 1.25 * counts[0])

    def test_killed_runs_go_on(self):
        root, caught, on_level = self.bare("contact-loss-3d"), 0, 0
        kept = [*LOSS, "Output/Checkpoint=true", "Output/Exodus=false"]
        whole = self.right(root, 2, *kept, name="whole")
        for times, ranks in ((3, 2), (6, 3), (8, 2), (10, 3)):
            if not self.killed(root, 2, "np2", times, *kept):
                continue
            caught += 1
            on_level += bool(self.parts("np2"))
            done, summary = self.run_deck(root, ranks, *kept, name="np2", more=["--restart"])
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("not solved again", done.stdout)
            self.assertEqual(self.parts("np2"), [])
            self.compare_levels(whole, summary, 0.01)
            if ranks == 2:
                self.assertEqual(summary["energy"], whole["energy"])
                self.assertEqual(summary["errors"]["global"], whole["errors"]["global"])
            (self.folder / "np2.summary.json").unlink(missing_ok=True)
        self.assertGreater(caught, 1)
        self.assertGreater(on_level, 0, "one was killed between passes on shares")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
