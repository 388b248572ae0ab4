"""Contact in weighted means: test_mortar.py NDFRAME MPIEXEC.

All couplings that ask for it agree, whichever side is named first and on any number of ranks; tractions are polynomials on
the facets as they were drawn, however short the pieces that the other side cuts.
"""

import csv
import io
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import side_scenes
from runs import Program

PROGRAM = Program(*sys.argv[1:3])
MORTAR = "Interfaces/contact/Pairing/Type=Mortar"
SHIFT = 0.03  # of the lower body's columns against those of the upper one


def bodies(load="1", young=1.0):
    upper = side_scenes.Block("upper", side_scenes.even(8), 4, side_scenes.box(0, 0, 1, 0.5), "bottom",
                              supports={"left": "Roller"}, pressure=load)
    places = [x + SHIFT * (x > 0) for x in side_scenes.even(12)] + [1.25, 1.5]
    lower = side_scenes.Block("lower", [x / 1.5 for x in places], 4, side_scenes.box(0, -0.5, 1.5, 0), "top", young=young,
                              supports={"left": "Roller", "bottom": "Clamp"})
    return upper, lower


def solve(first, second, *settings):
    with tempfile.TemporaryDirectory() as folder:
        run = PROGRAM.run(side_scenes.write_scene(folder, first, second), MORTAR, "Output/Exodus=false",
                          "Error Estimation/Estimators={Global}", *settings)
    assert run.code == 0, run.screen
    assert run.summary["errors"]["global"]["guaranteed"], run.screen
    return run


def rows(run):
    return [{key: float(value) for key, value in row.items() if key != "interface"}
            for row in csv.DictReader(io.StringIO(run.contact))]


class Mortar(unittest.TestCase):
    def test_couplings_agree(self):
        for order in (1, 2):
            for conditions in ("Nodal", "Bernstein"):
                settings = (f"Discretization/Order={order}", f"Discretization/Contact Conditions={conditions}")
                runs = [solve(*bodies("(x<0.5)"), *settings, f"Coupling/Type={coupling}")
                        for coupling in ("Automatic", "Monolithic", "FETI", "Neumann-Neumann")]
                closed = [[row["closed"] for row in rows(run)] for run in runs]
                self.assertTrue(0 < sum(closed[0]) < len(closed[0]))  # or this test shows little
                for run, statuses in zip(runs, closed):
                    self.assertEqual(statuses, closed[0])
                    self.assertAlmostEqual(run.summary["energy"] / runs[0].summary["energy"], 1.0, delta=1e-9)
                    self.assertAlmostEqual(run.summary["errors"]["global"]["absolute"] / runs[0].summary["errors"]["global"]["absolute"],
                                           1.0, delta=1e-6)

    def test_automatic_says_why_it_does_not_sweep(self):
        self.assertIn("sweeps do not ask for contact in means", solve(*bodies(), "Coupling/Type=Automatic").screen)

    def test_either_side_may_be_the_first(self):
        one, other = solve(*bodies("(x<0.5)"), "Coupling/Type=Monolithic"), solve(*bodies("(x<0.5)")[::-1], "Coupling/Type=Monolithic")
        self.assertAlmostEqual(one.summary["energy"] / other.summary["energy"], 1.0, delta=1e-11)

    def test_tractions_are_polynomials_on_the_facets_as_drawn(self):
        """Three values of a piece and those of the next one, of one facet of the lower body: one parabola."""
        table = rows(solve(*bodies(young=0.1), "Coupling/Type=Monolithic"))
        drawn = [x + SHIFT * (x > 0) for x in side_scenes.even(12)]
        checked = 0
        for left, right in zip(drawn, drawn[1:]):
            inside = [(row["x"], row["traction_dirichlet"]) for row in table if left - 1e-9 < row["x"] < right + 1e-9]
            if len(inside) < 5:
                continue
            (a, fa), (b, fb), (c, fc) = inside[0], inside[len(inside) // 2], inside[-1]
            for x, value in inside:
                parabola = (fa * (x - b) * (x - c) / (a - b) / (a - c) + fb * (x - a) * (x - c) / (b - a) / (b - c)
                            + fc * (x - a) * (x - b) / (c - a) / (c - b))
                self.assertAlmostEqual(value, parabola, delta=1e-9)
            checked += 1
        self.assertGreater(checked, 5)
        force = sum(row["nodal_force"] for row in table)
        self.assertAlmostEqual(force, -1.0, delta=1e-12)
        self.assertTrue(all(row["pressure"] >= 0.0 for row in table))

    def test_ranks_agree(self):
        energies = []
        for ranks in (1, 2, 3):
            with tempfile.TemporaryDirectory() as folder:
                deck = side_scenes.write_scene(folder, *bodies("(x<0.5)"))
                run = PROGRAM.run(deck, MORTAR, "Output/Exodus=false", "Linear Solver/Type=Mumps", ranks=ranks)
            self.assertEqual(run.code, 0, run.screen)
            energies.append(run.summary["energy"])
        for energy in energies:
            self.assertAlmostEqual(energy / energies[0], 1.0, delta=1e-10)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
