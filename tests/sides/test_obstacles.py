"""Rigid bodies (Signorini's problem): test_obstacles.py NDFRAME DECKS.

Hertz on a plane and on a cylinder; the same obstacle said in several ways; two halves of a plane are the plane; an
obstacle that is moved; targets are reached, guaranteed, with one factorisation; mistakes are told.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import side_scenes
from runs import Program

PROGRAM, DECKS = Program(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
QUIET = ("Output/Exodus=false", "Output/Contact Table=false")


def block(columns=12, rows=10, pressure="0.01*(1+x)", place=None, held=("left",)):
    return side_scenes.Block("block", side_scenes.even(columns), rows, place or side_scenes.box(0, 0, 1, 1), "bottom", 1.0,
                             0.3, {side: "Roller" for side in held}, pressure)


def solve(body, rigid, *settings):
    with tempfile.TemporaryDirectory() as folder:
        return PROGRAM.run(side_scenes.write_scene(folder, body, rigid), *QUIET, *settings)


def expression(text):
    return side_scenes.Rigid("floor", {"Type": ("string", "Expression"), "Distance": ("string", text)})


def contact(run):
    return run.summary["interfaces"][0]


class Obstacles(unittest.TestCase):
    def test_a_half_disc_on_a_plane_is_hertz(self):
        a = math.sqrt(4 * 1.0788e-3 / (math.pi * 1.098901))
        peak = 2 * 1.0788e-3 / (math.pi * a)
        with tempfile.TemporaryDirectory() as folder:
            text = (DECKS / "hertz-drawn.xml").read_text().replace("meshes/", f"{DECKS}/meshes/")
            start, end = text.index('    <ParameterList name="block">'), text.index('  <ParameterList name="Interfaces">')
            text = text[:start] + side_scenes.plane((0.0, 0.0), (0.0, 1.0)).deck() + "</ParameterList>" + text[end:]
            text = text.replace('value="block"', 'value="floor"')
            text = text.replace('<Parameter name="Neumann Side" type="string" value="flat"/>', "")
            text = text[:text.index('  <ParameterList name="Expect">')] + "</ParameterList>"
            deck = pathlib.Path(folder) / "disc.xml"
            deck.write_text(text)
            run = PROGRAM.run(deck, "Accuracy/Target=0.01", *QUIET)
        self.assertEqual(run.code, 0, run.screen)
        self.assertTrue(run.summary["errors"]["global"]["guaranteed"])
        self.assertAlmostEqual(contact(run)["largest_pressure"] / peak, 1.0, delta=0.01)
        end = contact(run)["end_brackets"][0]
        self.assertLess(end[0][0], 1.01 * a)
        self.assertGreater(end[1][0], 0.99 * a)

    def test_a_block_on_a_cylinder_is_hertz(self):
        run = PROGRAM.run(DECKS / "rigid-cylinder.xml", "Accuracy/Target=0.01", *QUIET)
        self.assertEqual(run.code, 0, run.screen)
        self.assertTrue(run.summary["errors"]["global"]["guaranteed"])
        a = math.sqrt(4 * 0.004 * 2 / (math.pi / 0.91))
        self.assertAlmostEqual(contact(run)["largest_pressure"] / (2 * 0.004 / (math.pi * a)), 1.0, delta=0.01)
        self.assertAlmostEqual(contact(run)["contact_length"] / a, 1.0, delta=0.03)  # the mesh's

    def test_one_obstacle_has_many_names(self):
        body = block()
        ways = ((side_scenes.cylinder((0.2, -3.0), 3.0), expression("3-sqrt(9-(x-0.2)^2)")),
                (side_scenes.plane((0.0, 0.0), (0.0, 1.0)), expression("0")))
        for one, other in ways:
            runs = [solve(body, rigid) for rigid in (one, other)]
            for run in runs:
                self.assertEqual(run.code, 0, run.screen)
                self.assertEqual(run.summary["ledger"]["counts"]["factorisations"], 1)
            self.assertAlmostEqual(runs[0].summary["energy"] / runs[1].summary["energy"], 1.0, delta=1e-11)

    def test_a_rigid_body_is_what_a_clamped_one_is(self):
        body = block()
        clamped = side_scenes.Block("below", side_scenes.even(12), 1, side_scenes.box(0, -0.1, 1, 0), "top", 1.0, 0.3,
                                    {"top": "Clamp"})
        energies = [solve(body, other).summary["energy"] for other in (clamped, side_scenes.plane((0.0, 0.0), (0.0, 2.0)))]
        self.assertAlmostEqual(energies[0] / energies[1], 1.0, delta=1e-11)

    def test_a_hole_is_where_nothing_is(self):
        whole = solve(block(8, 8), side_scenes.plane((0.0, 0.0), (0.0, 1.0)))
        part = solve(block(8, 8), side_scenes.plane((0.0, 0.0), (0.0, 1.0), Extent=(-1.0, 0.61)))
        self.assertAlmostEqual(contact(whole)["contact_length"], 1.0, delta=1e-12)
        self.assertAlmostEqual(contact(part)["contact_length"], 0.61, delta=1e-12)
        self.assertGreater(part.summary["energy"], whole.summary["energy"])

    def test_it_presses_when_it_is_moved(self):
        body = block(pressure="0", held=("left", "top"))
        run = solve(body, side_scenes.plane((0.0, -0.01), (0.0, 1.0), Displacement=(0.3, 0.03)))
        self.assertEqual(run.code, 0, run.screen)
        # uniform: eps_yy = -0.02, free sideways, plane strain
        self.assertAlmostEqual(contact(run)["contact_force"], 0.02 / 0.91, delta=1e-10)
        rigid = run.summary["bodies"][1]["supports"][0]
        self.assertAlmostEqual(rigid["force"][1], 0.02 / 0.91, delta=1e-10)

    def test_targets_are_reached_and_levels_agree(self):
        for rigid in (side_scenes.cylinder((0.0, -2.0), 2.0), side_scenes.plane((0.0, 0.0), (0.02, 1.0))):
            run = solve(block(), rigid, "Accuracy/Target=0.02")
            self.assertEqual(run.code, 0, run.screen)
            self.assertTrue(run.accuracy["reached"])
            self.assertTrue(run.summary["errors"]["global"]["guaranteed"])

    def refused(self, message, body, rigid, *settings):
        run = solve(body, rigid, *settings)
        self.assertEqual(run.code, 2, run.screen)
        self.assertIn(message, run.screen)

    def test_mistakes_are_told(self):
        plane = side_scenes.plane((0.0, 0.0), (0.0, 1.0))
        self.refused("is zero; it points out of the rigid body", block(),
                     side_scenes.plane((0.0, 0.0), (0.0, 0.0)))
        self.refused("no part of side", block(), side_scenes.plane((0.0, 0.0), (0.0, -1.0)))
        self.refused("overlap at the start: by 0.1", block(), side_scenes.plane((0.0, 0.1), (0.0, 1.0)))
        self.refused("takes two numbers", block(), side_scenes.plane((0.0, 0.0), (0.0, 1.0), Extent=(1.0, 0.0)))
        self.refused("give two", block(), side_scenes.plane((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
        self.refused("has no sides; remove this", block(), plane, "Interfaces/contact/Neumann Side=top")
        self.refused("name it as Neumann Body", block(), plane, "Interfaces/contact/Dirichlet Body=floor")
        self.refused("has no meaning for a rigid body", block(), plane, "Bodies/floor/Loads/l/Type=Body Force",
                     "Bodies/floor/Loads/l/Y=1")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
