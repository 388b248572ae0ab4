"""Solids whose meshes are halved are the scene that is drawn: test_refined_solids.py NDFRAME MPIEXEC.

A shell on a core along a part of a cylinder or sphere of few squares: whichever solids have `Refine`, on one process or on
several that have shares of them, with a target or without, contact has the directions of the meshes as drawn, so that the
energy brackets of all runs have the exact energy in common.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from curved_solids import between, cylinder, sphere
from runs import Program
from solid_scenes import Solid, pressure, write_scene

PROGRAM = Program(sys.argv[1], sys.argv[2])
CERTIFIED = ("Coupling/Type=Monolithic", "Error Estimation/Estimators={Global}", "Output/Exodus=false", "Strain Limit=1")
BENT = cylinder(1.2, 0.8, 0.3)
COLUMNS, ROWS = 3, 2


def shell(place=BENT, columns=COLUMNS, rows=ROWS):
    return Solid("shell", (columns, rows, 1), between(place, 1.0, 1.5), "bottom", 1.0, 0.3, {"left": "Roller", "front": "Roller"},
                 {"press": pressure("top", "0.05*(1.5-x)"), "side": pressure("right", "0.01")}, 0.1, 3)


def core(place=BENT):
    return Solid("core", (COLUMNS, ROWS, 1), between(place, 0.5, 1.0), "top", 3.0, 0.2, {"bottom": "Clamp"}, {}, 0.1, 4)


def chords(place):
    """The map with the flat squares of COLUMNS columns, which more columns divide."""
    def flat(r, q, radius):
        i = min(int(r * COLUMNS * (1.0 + 1e-12)), COLUMNS - 1)
        s = r * COLUMNS - i
        ends = [place((i + k) / COLUMNS, q, radius) for k in (0, 1)]
        return tuple((1.0 - s) * a + s * b for a, b in zip(*ends))

    return flat


class Refined(unittest.TestCase):
    def solve(self, deck, core_halvings, shell_halvings, *settings, ranks=1):
        run = PROGRAM.run(deck, *CERTIFIED, f"Bodies/core/Mesh/Refine={core_halvings}",
                          f"Bodies/shell/Mesh/Refine={shell_halvings}", *settings, ranks=ranks)
        self.assertEqual(run.code, 0, run.screen)
        self.assertTrue(run.summary["errors"]["global"]["guaranteed"], run.screen)
        return run.summary

    def assert_one_scene(self, first, second, halvings):
        lowest, highest, told = -math.inf, math.inf, []
        with tempfile.TemporaryDirectory() as folder:
            deck = write_scene(folder, first, second)
            for numbers in halvings:
                bracket = self.solve(deck, *numbers)["errors"]["energy_bracket"]
                told.append((numbers, bracket["lower"], bracket["upper"]))
                lowest, highest = max(lowest, bracket["lower"]), min(highest, bracket["upper"])
        self.assertLess(lowest, highest, told)

    def test_along_sides_that_match(self):
        round_ = sphere(0.9, 0.7, 0.3)
        self.assert_one_scene(core(), shell(), [(0, 0), (1, 1), (2, 2)])
        self.assert_one_scene(shell(round_), core(round_), [(0, 0), (1, 1)])

    def test_where_solids_are_halved_differently(self):
        self.assert_one_scene(core(), shell(), [(0, 0), (1, 0), (0, 1), (1, 1), (2, 1)])
        self.assert_one_scene(shell(), core(), [(0, 0), (1, 0), (0, 1), (1, 1)])

    def test_where_halving_makes_sides_match(self):
        fine = shell(chords(BENT), 2 * COLUMNS, 2 * ROWS)
        self.assert_one_scene(core(chords(BENT)), fine, [(0, 0), (1, 0), (2, 1)])

    def test_with_a_target(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = write_scene(folder, core(), shell())
            drawn = self.solve(deck, 0, 0)["errors"]["energy_bracket"]
            for start in ("Deck", "Coarsest"):
                summary = self.solve(deck, 1, 1, "Accuracy/Target=0.06", f"Accuracy/Start={start}")
                self.assertGreater(len(summary["accuracy"]["levels"]), 1)
                bracket = summary["errors"]["energy_bracket"]
                self.assertLess(max(drawn["lower"], bracket["lower"]), min(drawn["upper"], bracket["upper"]))

    def test_a_reference_is_of_the_same_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = write_scene(folder, core(), shell())
            errors = self.solve(deck, 1, 1, "Error Estimation/Estimators={Global, Reference}",
                                "Error Estimation/Reference/Refinements=1")["errors"]
        self.assertLess(errors["reference"]["displacement"], errors["global"]["absolute"])

    def test_in_shares(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = write_scene(folder, core(), shell())
            for halvings in (1, 2):  # rank 0 halves the meshes once itself where they are twice
                one = self.solve(deck, halvings, halvings, "Linear Solver/Type=Multigrid")
                shared = self.solve(deck, halvings, halvings, "Linear Solver/Type=Multigrid", ranks=3)
                self.assertEqual(shared["ledger"]["counts"].get("shared bodies"), 2)
                for body, other in zip(one["bodies"], shared["bodies"]):
                    self.assertLess(abs(body["energy"] - other["energy"]), 1e-9 * body["energy"])
                lower, other = (summary["errors"]["energy_bracket"]["lower"] for summary in (one, shared))
                self.assertLess(abs(lower - other), 1e-6 * abs(lower))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
