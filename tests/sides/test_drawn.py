"""Bodies as they are drawn: test_drawn.py NDFRAME DECKS.

Hertz from an arc and a line, whichever body gives the normals; a press fit of rings that are meshed independently,
against Lame; targets are reached, guaranteed; overlaps are told.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import side_scenes
from runs import Program

TARGET = "Accuracy/Target=0.01"
PROGRAM, DECKS = Program(sys.argv[1]), pathlib.Path(sys.argv[2])


def sector(inner, outer):
    def place(u, v):
        r, angle = inner + (outer - inner) * v, (1.0 - u) * math.pi / 2
        return r * math.cos(angle), r * math.sin(angle)

    return place


def lame_energy(a, b, young, poisson):
    """a(u, u) of a quarter of a ring under the inner pressure 1, plane strain."""
    shear, lame = young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    A = a * a / (b * b - a * a)
    return math.pi / 2 * a * (A * a / (2 * (lame + shear)) + A * b * b / (2 * shear * a))


def rings(inner, outer, exchanged=False):
    """Energy and guarantee of a quarter of a ring of two parts with `inner` and `outer` columns."""
    held = {"left": "Roller", "right": "Roller"}
    parts = [side_scenes.Block("inner", side_scenes.even(inner), max(2, inner // 4), sector(1, 1.5), "top", 1.0, 0.3,
                               held, "1"),
             side_scenes.Block("outer", side_scenes.even(outer), max(2, outer // 4), sector(1.5, 2), "bottom", 1.0, 0.3,
                               held)]
    with tempfile.TemporaryDirectory() as folder:
        deck = side_scenes.write_scene(folder, *(reversed(parts) if exchanged else parts))
        run = PROGRAM.run(deck, "Coupling/Type=Monolithic", "Output/Exodus=false", "Error Estimation/Estimators={Global}")
    return sum(body["energy"] for body in run.summary["bodies"]), run.summary["errors"]["global"]["guaranteed"]


class Drawn(unittest.TestCase):
    def test_targets_are_reached(self):
        for name in ("drawn-punch", "bearing"):
            run = PROGRAM.run(DECKS / f"{name}.xml", TARGET)
            self.assertEqual(run.code, 0, run.screen)
            self.assertTrue(run.accuracy["reached"])
            self.assertTrue(run.summary["errors"]["global"]["guaranteed"])

    def test_numbers_of_the_exact_solution_are_named_only_where_no_gap_does_work(self):
        for name, opens in (("hertz-drawn", True), ("bearing", True), ("rigid-cylinder", True), ("rings", False), ("automatic", False)):
            summary = PROGRAM.run(DECKS / f"{name}.xml", "Error Estimation/Estimators={Global}", "Strain Limit=1").summary
            bracket, error = summary["errors"]["energy_bracket"], summary["errors"]["global"]
            self.assertTrue(error["guaranteed"], name)
            self.assertEqual((bracket["work"] is None, bracket["drive"] is None or not opens), (opens, True), name)
            # a(u, u) = L(u) + int t g; without a gap the bracket of the work holds a(u, u), to the error of that of u_h
            if not opens:
                slack = 2.0 * error["absolute"] * summary["energy"] ** 0.5 + error["absolute"] ** 2 + 1e-12 * summary["energy"]
                self.assertLess(bracket["work"]["lower"] - slack, summary["energy"], name)
                self.assertGreater(bracket["work"]["upper"] + slack, summary["energy"], name)

    def test_bodies_of_one_script_share_one_run_of_gmsh(self):
        deck = DECKS / "hertz-drawn.xml"
        meshed = lambda *settings: PROGRAM.run(deck, *settings).summary["ledger"]["counts"]["scripts meshed"]
        self.assertEqual(meshed(), 1)
        self.assertEqual(meshed("Bodies/block/Mesh/Mesh Size Factor=1.5"), 2)
        self.assertEqual(meshed(*(f"Bodies/{body}/Mesh/Mesh Size Factor=1.5" for body in ("block", "cylinder"))), 1)

    def test_hertz_is_right_whichever_side_gives_the_normals(self):
        exchanged = ("Dirichlet Body=block", "Dirichlet Side=flat", "Neumann Body=cylinder", "Neumann Side=round")
        for settings in ((), exchanged):
            run = PROGRAM.run(DECKS / "hertz-drawn.xml", TARGET, *(f"Interfaces/contact/{one}" for one in settings))
            self.assertEqual(run.code, 0, run.screen)
            self.assertTrue(run.accuracy["reached"] and run.summary["errors"]["global"]["guaranteed"])
            contact = run.summary["interfaces"][0]
            self.assertAlmostEqual(contact["largest_pressure"] / 0.013736, 1.0, delta=0.01)
            self.assertAlmostEqual(contact["contact_length"] / 0.05, 1.0, delta=0.01)

    def test_rings_meshed_apart_are_one_ring_to_second_order(self):
        exact = lame_energy(1.0, 2.0, 1.0, 0.3)
        before = None
        for inner, outer in ((4, 6), (8, 12), (16, 24)):
            (energy, guaranteed), (exchanged, _) = rings(inner, outer), rings(inner, outer, True)
            self.assertTrue(guaranteed)
            self.assertAlmostEqual(energy / exchanged, 1.0, delta=1e-3)
            off = abs(energy / exact - 1.0)
            self.assertLess(off, 0.03 if before is None else 0.3 * before)
            before = off

    def test_overlaps_are_told(self):
        run = PROGRAM.run(DECKS / "punch.xml", "Bodies/punch/Mesh/Lower={0, -0.02}")
        self.assertEqual(run.code, 2)
        self.assertIn("the bodies overlap at the start: by 0.02 at (0, -0.02)", run.screen)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
