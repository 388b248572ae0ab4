"""ndbench with the program, on the coarsest meshes: true errors against another way to find them, tables, targets.

Usage: test_ndbench.py SOURCE_FOLDER PROGRAM
"""

import csv
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE, PROGRAM = pathlib.Path(sys.argv.pop(1)), sys.argv.pop(1)
sys.path.insert(0, str(SOURCE / "apps/ndbench"))

from bench import campaign, references
from bench.program import run
from bench.scenes import SCENES
from bench.truth import contact_term, true_error

BY_NAME = {scene.name: scene for scene in SCENES}
STOPPED = "Coupling/Stopping/Tolerance=0.5"
ORDER_1 = "Discretization/Order=1"
HALVED = 2  # the reference: every edge halved so often


def ndbench(folder, *arguments):
    command = [SOURCE / "apps/ndbench/ndbench", "--program", PROGRAM, "--folder", folder, *arguments]
    return subprocess.run(command, capture_output=True, text=True)


class TrueErrors(unittest.TestCase):
    def distances(self, name, cells, *settings, halved=HALVED):
        """The true error of a run by ndbench, and by the estimator Reference: distances to a finer solution and from
        there to the exact one, which is found by ndbench on the finer mesh, where it is small."""
        scene, exact = BY_NAME[name], references.load()[name]
        estimators = "Error Estimation/Estimators={Global, Reference}"
        against = (estimators, f"Error Estimation/Reference/Refinements={halved}")
        coarse = run(PROGRAM, scene.deck, (*scene.on(cells), *settings, *against))
        finer = [setting.split("Cells=")[0] + f"Refine={halved}" for setting in scene.meshes(cells)]
        fine_order = [setting for setting in settings if setting == ORDER_1]
        fine = run(PROGRAM, scene.deck, (*scene.on(cells), *finer, "Coupling/Type=Monolithic", *fine_order))
        near = coarse.summary["errors"]["reference"]["displacement"]
        error = true_error(coarse, scene.gap, exact)
        return coarse, error, math.hypot(near, true_error(fine, scene.gap, exact).best)

    def test_closed_contact_obeys_pythagoras(self):
        """Galerkin solutions on nested meshes are orthogonal projections, wherever the sweeps stopped."""
        for settings in ((STOPPED,), (ORDER_1,)):
            run_, error, other = self.distances("punch", 3, *settings)
            self.assertLess(abs(error.best - other), 1e-6 * other, settings)
            self.assertLess(error.low, other)
            self.assertLess(error.best, run_.bound)

    def test_solids_in_contact_obey_it_too(self):
        """Where contact is lost the error is an upper bound, within a percent."""
        for name, tolerance in (("punch-3d", 1e-6), ("contact-loss-3d", 0.01)):
            run_, error, other = self.distances(name, 2, "Coupling/Type=Monolithic", halved=1)
            self.assertLess(abs(error.best - other), tolerance * other, name)
            self.assertLess(error.best, run_.bound)

    def test_lost_contact_is_accounted_for(self):
        """Not orthogonal: within a percent."""
        for name, cells, settings in (("contact-loss", 4, (STOPPED,)), ("hertz", 8, (ORDER_1,))):
            coarse, error, other = self.distances(name, cells, *settings)
            self.assertLess(abs(error.best - other), 0.01 * other, name)
        share = contact_term(coarse, BY_NAME["hertz"].gap, references.load()["hertz"]) / error.best**2
        self.assertGreater(abs(share), 0.02, "the last scene must need its contact term")


class Campaign(unittest.TestCase):
    def test_rows_are_complete_and_errors_fall_with_the_size(self):
        with tempfile.TemporaryDirectory() as folder:
            done = ndbench(folder, "--short", "--scene", "punch", "--scene", "beam-3d")
            self.assertEqual(done.returncode, 0, done.stderr)
            files = pathlib.Path(folder)
            with open(files / "bench.csv", newline="") as table:
                rows = list(csv.DictReader(table))
            with open(files / "stages.csv", newline="") as table:
                stages = {row["stage"] for row in csv.DictReader(table)}
            self.assertEqual(len(list(files.glob("bench-*.png"))), 4)
            self.assertIn("Aitken", (files / "finest.md").read_text())
            self.assertIn("| punch |", (files / "fastest.md").read_text())
        self.assertEqual(tuple(rows[0]), campaign.COLUMNS)
        self.assertLessEqual({"read", "order", "factor", "write", "between stages", "start and exit"}, stages)
        self.check_rows(rows)

    def check_rows(self, rows):
        lines = {}
        for row in rows:
            lines.setdefault((row["scene"], row["method"]), []).append(row)
            self.assertLessEqual(float(row["error_low"]), float(row["error_high"]))
            if "certified" in row["method"]:
                self.assertGreater(float(row["effectivity"]), 1.0, row)
        for method, (coarse, fine) in lines.items():
            self.assertLess(int(coarse["dofs"]), int(fine["dofs"]), method)
            self.assertLess(float(fine["error"]), float(coarse["error"]), method)

    def test_uniform_meshes_stand_beside_a_target(self):
        with tempfile.TemporaryDirectory() as folder:
            done = ndbench(folder, "--accuracy", "--short", "--scene", "punch", "--scene", "contact-loss")
            self.assertEqual(done.returncode, 0, done.stderr)
            tables = {}
            for name in ("accuracy", "last-mesh"):
                with open(pathlib.Path(folder) / f"{name}.csv", newline="") as table:
                    tables[name] = list(csv.DictReader(table))
                self.assertIn("| punch | 5 % |", (pathlib.Path(folder) / f"{name}.md").read_text())
        self.assertEqual([row["beside"] for row in tables["accuracy"]], ["", "its bound", "its error"] * 2)
        for whole, *uniform in (tables["accuracy"][:3], tables["accuracy"][3:]):
            limits = [float(whole[key]) for key in ("bound", "error")]
            self.assertLessEqual(limits[0], float(whole["target"]))
            for row, limit in zip(uniform, limits):
                self.assertTrue(0.7 * limit < float(row["error"]) <= limit, row)
                self.assertGreater(int(row["dofs"]), 4 * int(whole["dofs"]))
        self.check_last_meshes(tables["last-mesh"])

    def check_last_meshes(self, rows):
        """The mesh read back is the same one: so is its bound, but for the sweeps."""
        for row in rows:
            self.assertLess(abs(float(row["same_bound"]) - 1), 0.1, row)
            self.assertGreater(float(row["work"]), 1, row)

    def test_solids_in_contact_have_their_own_table(self):
        """No bound is below the upper end of what the true error may be."""
        with tempfile.TemporaryDirectory() as folder:
            done = ndbench(folder, "--solids", "--short")
            self.assertEqual(done.returncode, 0, done.stderr)
            files = pathlib.Path(folder)
            with open(files / "solids.csv", newline="") as table:
                rows = list(csv.DictReader(table))
            self.assertEqual([path.name for path in files.glob("*.png")], ["bench-solids.png"])
            self.assertIn("| punch-3d | adaptive, certified, target 10 % |", (files / "solids.md").read_text())
            for name in ("contact-loss-3d", "hertz-3d"):
                self.assertIn(f"| {name} |", (files / "solids-fastest.md").read_text())
        self.assertEqual(len(rows), 3 * 3 * 2)
        self.check_rows(rows)
        for row in rows:
            self.assertEqual(row["exit"], "0")
            self.assertEqual(bool(row["bound"]), "certified" in row["method"], row)
            self.assertGreaterEqual(float(row["bound"] or "inf"), float(row["error_high"]), row)
            if "target" in row["size"]:
                self.assertLessEqual(100 * float(row["bound"]), float(row["size"].split()[1]), row)

    def test_targets_are_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            done = ndbench(folder, "--targets", "--short")
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(pathlib.Path(folder) / "targets.csv", newline="") as table:
                rows = list(csv.DictReader(table))
        self.assertEqual(len(rows), 17)
        self.assertTrue(all(row["met"] in ("aim", "must", "no") for row in rows))

    def test_a_scene_without_targets_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            done = ndbench(folder, "--accuracy", "--scene", "beam-3d")
        self.assertEqual(done.returncode, 1)
        self.assertIn("none of the scenes has targets", done.stderr)

    def test_a_missing_program_is_named(self):
        done = ndbench("unused", "--program", "/nowhere")
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no program /nowhere", done.stderr)


if __name__ == "__main__":
    unittest.main()
