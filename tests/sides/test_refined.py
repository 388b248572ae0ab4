"""A drawn scene stays what it is when its meshes are halved: test_refined.py NDFRAME.

Sides in the plane that stand for curves, with few facets: whichever bodies have `Refine`, contact has the directions of the
meshes as drawn, so that the energy brackets of all runs have the exact energy in common.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import side_scenes
from runs import Program

PROGRAM = Program(sys.argv[1])
CERTIFIED = ("Coupling/Type=Monolithic", "Output/Exodus=false", "Error Estimation/Estimators={Global}", "Strain Limit=1")


def sector(inner, outer):
    def place(u, v):
        r, angle = inner + (outer - inner) * v, (1.0 - u) * math.pi / 2
        return r * math.cos(angle), r * math.sin(angle)

    return place


def chords(place, columns, foot):
    """The map with straight edges between its columns at the foot: more columns halve the facets of the same polygon."""
    def bent(u, v):
        near = 1.0 - v if foot == "bottom" else v
        i = min(int(u * columns * (1.0 + 1e-12)), columns - 1)
        s = u * columns - i
        (x, y), (x0, y0), (x1, y1) = place(u, v), place(i / columns, v), place((i + 1) / columns, v)
        chord = ((1.0 - s) * x0 + s * x1, (1.0 - s) * y0 + s * y1)
        return x + near * (chord[0] - x), y + near * (chord[1] - y)

    return bent


def shell(columns, place, rows=2):
    return side_scenes.Block("shell", side_scenes.even(columns), rows, place, "bottom", 1.0, 0.3,
                             {"right": "Roller"}, "0.02*(1+x)")


def core(columns, place, rows=2):
    return side_scenes.Block("core", side_scenes.even(columns), rows, place, "top", 3.0, 0.2, {"bottom": "Clamp"})


class Refined(unittest.TestCase):
    def assert_one_scene(self, first, second, halvings, settings=None, *given):
        """halvings: per run those of each body that is not rigid."""
        lowest, highest, told = -math.inf, math.inf, []
        bodies = [block.name for block in (first, second) if block.foot]
        with tempfile.TemporaryDirectory() as folder:
            deck = side_scenes.write_scene(folder, first, second, settings)
            for numbers in halvings:
                refine = [f"Bodies/{body}/Mesh/Refine={k}" for body, k in zip(bodies, numbers)]
                run = PROGRAM.run(deck, *CERTIFIED, *given, *refine)
                self.assertEqual(run.code, 0, run.screen)
                self.assertTrue(run.summary["errors"]["global"]["guaranteed"], run.screen)
                bracket = run.summary["errors"]["energy_bracket"]
                told.append((numbers, bracket["lower"], bracket["upper"]))
                lowest, highest = max(lowest, bracket["lower"]), min(highest, bracket["upper"])
        self.assertLess(lowest, highest, told)

    def test_along_sides_that_match(self):
        for order in (1, 2):
            self.assert_one_scene(core(4, sector(1, 1.5)), shell(4, sector(1.5, 2)), [(0, 0), (1, 1), (2, 2), (3, 3)], None,
                                  f"Discretization/Order={order}")

    def test_where_bodies_are_halved_differently(self):
        self.assert_one_scene(core(4, sector(1, 1.5)), shell(4, sector(1.5, 2)), [(0, 0), (0, 2), (2, 0), (3, 2), (3, 3)])
        self.assert_one_scene(shell(4, sector(1.5, 2)), core(4, sector(1, 1.5)), [(0, 0), (0, 2), (2, 0), (3, 2), (3, 3)])

    def test_where_halving_makes_sides_match(self):
        fine = side_scenes.even(8)
        inner, outer = core(4, sector(1, 1.5)), shell(4, chords(sector(1.5, 2), 4, "bottom"))
        outer.columns = fine
        self.assert_one_scene(inner, outer, [(0, 0), (1, 0), (2, 1), (3, 2)])

    def test_along_sides_that_do_not_match(self):
        self.assert_one_scene(core(3, sector(1, 1.5)), shell(4, sector(1.5, 2)), [(0, 0), (1, 1), (2, 2), (3, 3)],
                              {"Gap From Geometry": ("string", "No")})
        self.assert_one_scene(core(4, sector(1, 1.5)), shell(3, sector(1.5, 2)), [(0, 0), (1, 0), (0, 2), (2, 2), (3, 3)])

    def test_on_rigid_bodies(self):
        pin = side_scenes.Block("pin", side_scenes.even(4), 2, sector(1.01, 1.5), "bottom", 1.0, 0.3, {"right": "Roller"},
                                "0.02*(1+x)")
        self.assert_one_scene(pin, side_scenes.cylinder((0.0, 0.0), 1.0), [(0,), (1,), (2,), (3,)])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
