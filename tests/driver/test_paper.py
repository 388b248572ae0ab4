"""The paper's tables and figures on a few coarse meshes: test_paper.py NDFRAME PAPER, with the folder of docs/paper/paper.py.

Everything that the page claims is checked by the script itself, also in ./bootstrap paper; here it is run, and made to fail.
"""

import copy
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

NDFRAME, PAPER = sys.argv[1:3]
sys.path.insert(0, PAPER)
sys.dont_write_bytecode = True

import pictures
import scenes
import tables


class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        command = [sys.executable, "-B", pathlib.Path(PAPER) / "paper.py", NDFRAME, "--quick", cls.folder]
        cls.run_ = subprocess.run(command, capture_output=True, text=True)

    def table(self, name):
        with open(self.folder / f"{name}.csv") as file:
            return [{key: float(value) for key, value in row.items() if key != "guaranteed"} for row in csv.DictReader(file)]

    def test_every_claim_holds(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stdout + self.run_.stderr)
        self.assertNotIn("FAILS", self.run_.stdout)

    def test_iteration_part_of_the_punch_is_near_the_printed_one_on_every_mesh(self):
        for row in self.table("table1"):
            self.assertAlmostEqual(row["nda"], row["paper_nda"], delta=0.1)

    def test_sweeps_are_those_printed_or_one_off(self):
        for row in self.table("table3"):
            self.assertLessEqual(abs(row["sweeps"] - row["paper_sweeps"]), 1)

    def test_optimal_bound_is_sharper_than_projected_and_that_than_element_recovery(self):
        for row in self.table("table1") + self.table("table2"):
            self.assertLess(1, row["gamma"])
            self.assertLess(row["glob"], row["glob_projected"])
            self.assertLess(row["glob_projected"], row["glob_eet"])

    def test_page_and_pictures_are_there(self):
        self.assertEqual({path.name for path in self.folder.glob("*.png")}, {f"figure{n}.png" for n in range(5, 10)})
        page = (self.folder / "README.md").read_text()
        for name in ("table1", "table2", "table3"):
            self.assertEqual(page.count(f"{{{name}}}"), 0)
        for row in self.table("table1"):
            self.assertIn(f"| {row['ndof']:.0f} ({row['paper_ndof']:.0f}) |", page)


class Claims(unittest.TestCase):
    """A claim that cannot fail says nothing."""

    TABLES = {
        "table1": [{"sweeps": 5, "nda": 4.1, "gamma": 1.05, "guaranteed": True}],
        "table2": [{"nda": 5.0, "gamma": 1.1, "guaranteed": True}],
        "table3": [{"sweeps": n, "glob": 8.7, "dis": 8.7, "gamma": 1.1, "guaranteed": True} for n in (4, 5, 9, 11, 15, 28)],
    }

    def failures(self, table, **changed):
        tables_ = copy.deepcopy(self.TABLES)
        tables_[table][-1].update(changed)
        return [sentence for sentence, holds in tables.claims(tables_) if not holds]

    def test_hold_for_the_paper(self):
        self.assertEqual(self.failures("table1"), [])

    def test_fail_for_other_numbers(self):
        for table, changed, sentence in (
            ("table1", {"guaranteed": False}, "guaranteed"),
            ("table2", {"gamma": 0.999}, "below the error"),
            ("table1", {"sweeps": 6}, "five sweeps"),
            ("table1", {"nda": 4.21}, "eta_nda is 4.0"),
            ("table1", {"gamma": 1.13}, "gamma is at most 1.12"),
            ("table3", {"sweeps": 30}, "28-29 sweeps"),
            ("table3", {"glob": 8.73}, "levels off, the last four"),
            ("table3", {"dis": 9.0}, "at the discretisation part"),
        ):
            with self.subTest(changed):
                (failure,) = self.failures(table, **changed)
                self.assertIn(sentence, failure)

    def test_table_2_needs_the_same_iteration_part_on_all_meshes(self):
        tables_ = copy.deepcopy(self.TABLES)
        tables_["table2"].append({**tables_["table2"][0], "nda": 5.2})
        self.assertIn("differs by less than 2 %", str([sentence for sentence, holds in tables.claims(tables_) if not holds]))


class NodalForces(unittest.TestCase):
    def test_of_one_converged_traction_are_those_of_the_program(self):
        run = scenes.PUNCH.run(NDFRAME, 3, "Coupling/Type=Monolithic")
        _, forces, _ = pictures.nodal_forces(run)
        numpy.testing.assert_allclose(forces, -run.contact["nodal_force"], rtol=1e-9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
