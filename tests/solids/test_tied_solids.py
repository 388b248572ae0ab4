"""Solids that are tied: one body of several materials, whatever the meshes of their flat sides."""

import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from solid_scenes import Solid, pressure, write_scene

QUIET = ("Output/Exodus=false", "Output/Contact Table=false", "Error Estimation/Estimators={Global}",
         "Error Estimation/Check Equilibrium=true")
TIED = [("Tied", "bool", "true")]


def halves(cells=(3, 2), young=(1.0, 1.0), load="1+x", supports=None):
    upper = Solid("upper", (*cells, 2), lambda r, s, t: (r, 0.8 * s, 0.5 * t), "bottom", young[0], 0.3,
                  {"left": "Roller", "front": "Roller"}, {"press": pressure("top", load)}, 0.0, 3)
    lower = Solid("lower", (*cells, 2), lambda r, s, t: (r, 0.8 * s, 0.5 * t - 0.5), "top", young[1], 0.3,
                  supports or {"bottom": "Clamp"}, {}, 0.0, 4)
    return upper, lower


def solve(pair, *settings):
    with tempfile.TemporaryDirectory() as folder:
        return PROGRAM.run(write_scene(folder, *pair, TIED), *QUIET, *settings)


class TiedSolids(unittest.TestCase):
    def guaranteed(self, run):
        self.assertEqual(run.code, 0, run.screen)
        self.assertTrue(run.summary["errors"]["global"]["guaranteed"])
        self.assertLess(run.summary["errors"]["equilibrium"], 1e-11)
        return run

    def test_two_halves_are_one_body(self):
        held = {"bottom": "Clamp", "left": "Roller", "front": "Roller"}
        tied = self.guaranteed(solve(halves(supports=held)))
        whole = Solid("whole", (3, 2, 4), lambda r, s, t: (r, 0.8 * s, t - 0.5), "bottom", 1.0, 0.3, held,
                      {"press": pressure("top", "1+x")}, 0.0, 5)
        with tempfile.TemporaryDirectory() as folder:
            whole.write(folder)
            path = pathlib.Path(folder) / "whole.xml"
            path.write_text(f'<ParameterList name="whole"><ParameterList name="Bodies">{whole.deck()}</ParameterList>'
                            "</ParameterList>")
            one = self.guaranteed(PROGRAM.run(path, *QUIET))
        self.assertAlmostEqual(tied.summary["energy"] / one.summary["energy"], 1.0, delta=1e-11)
        bounds = [run.summary["errors"]["global"]["absolute"] for run in (tied, one)]
        self.assertAlmostEqual(bounds[0] / bounds[1], 1.0, delta=1e-5)  # steps have single precision

    def test_uniform_stress_is_exact(self):
        run = self.guaranteed(solve(halves(load="1", supports={"bottom": "Roller", "left": "Roller", "front": "Roller"})))
        self.assertAlmostEqual(run.summary["energy"], 0.8, delta=1e-12)  # volume 0.8, E = 1
        self.assertLess(run.summary["errors"]["global"]["relative"], 1e-7)

    def test_other_moduli_stay_within_the_bounds_of_finer_meshes(self):
        brackets = [self.guaranteed(solve(halves(cells, young=(30.0, 1.0)))).summary["errors"]["energy_bracket"]
                    for cells in ((2, 2), (4, 3))]
        self.assertLess(max(b["lower"] for b in brackets), min(b["upper"] for b in brackets))

    def test_a_tied_pair_pulls(self):
        run = self.guaranteed(solve(halves(load="-1")))
        pressed = self.guaranteed(solve(halves(load="1")))
        self.assertAlmostEqual(run.summary["energy"], pressed.summary["energy"], delta=1e-10)

    def test_sides_with_other_meshes_are_cut(self):
        held = {"bottom": "Roller", "left": "Roller", "front": "Roller"}
        for cells in ((2, 2), (1, 5), (4, 3)):
            run = self.guaranteed(solve((halves(load="1")[0], halves(cells, supports=held)[1])))
            self.assertAlmostEqual(run.summary["energy"], 0.8, delta=1e-11)
            self.assertLess(run.summary["errors"]["global"]["relative"], 1e-6)

    def test_other_meshes_stay_within_the_bounds_of_equal_ones(self):
        brackets = [self.guaranteed(solve((halves()[0], halves(cells)[1]))).summary["errors"]["energy_bracket"]
                    for cells in ((3, 2), (4, 5))]
        self.assertLess(max(b["lower"] for b in brackets), min(b["upper"] for b in brackets))

    def test_sides_that_lie_on_nothing_are_refused(self):
        upper, lower = halves((2, 2))
        lower.place = lambda r, s, t: (r + 3.0, 0.8 * s, 0.5 * t - 0.5)
        run = solve((upper, lower))
        self.assertEqual(run.code, 2, run.screen)
        self.assertIn("no part of upper/bottom lies on lower/top; tied sides of solids must be flat", run.screen)

    def test_sides_that_cannot_be_cut_are_refused(self):
        upper, lower = halves((3, 3))
        upper.place = lambda r, s, t: (r + 3e-4, 0.8 * s + 2e-4, 0.5 * t)
        run = solve((upper, lower))
        self.assertEqual(run.code, 2, run.screen)
        self.assertIn("Bodies/upper + lower/Mesh: sides of solids that were meshed independently cannot be cut to match", run.screen)


if __name__ == "__main__":
    PROGRAM = Program(sys.argv.pop(1))
    unittest.main()
