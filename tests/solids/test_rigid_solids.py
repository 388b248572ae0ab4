"""Rigid bodies that solids touch (Signorini's problem in space): test_rigid_solids.py NDFRAME DECKS MPIEXEC.

A mirror is a rigid plane; one obstacle has many names; it is what a clamped body is; it presses when it is moved; turned
and on several ranks it is the same; without factors, too; a ball on a plane is Hertz; targets are reached; mistakes are told.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from solid_scenes import Rigid, Solid, pressure, write_scene

PROGRAM, DECKS = Program(sys.argv[1], sys.argv[3]), pathlib.Path(sys.argv[2]).resolve()
QUIET = ("Output/Exodus=false", "Output/Contact Table=false")
FLOOR = Rigid("Plane", {"Point": (0.3, 0.2, 0.0), "Normal": (0.0, 0.0, 2.0)})
ROLLERS = {"left": "Roller", "front": "Roller"}
EXACT = 1e-10


def block(cells=(4, 4, 3), load="1.5-x-y", supports=ROLLERS, place=lambda r, q, t: (r, q, 0.6 * t), name="block", foot="bottom",
          top="top"):
    return Solid(name, cells, place, foot, 1.0, 0.3, supports, {"press": pressure(top, load)} if load else {}, 0.15, 3)


def solve(body, other, *settings, ranks=1, gap=()):
    with tempfile.TemporaryDirectory() as folder:
        run = PROGRAM.run(write_scene(folder, body, other, gap), *QUIET, *settings, ranks=ranks)
    return run


def contact(run):
    return run.summary["interfaces"][0]


class RigidSolids(unittest.TestCase):
    def solved(self, *arguments, **options):
        run = solve(*arguments, **options)
        self.assertEqual(run.code, 0, run.screen)
        return run

    def same(self, one, other, key=lambda run: run.summary["energy"], tolerance=EXACT):
        self.assertAlmostEqual(key(one) / key(other), 1.0, delta=tolerance)

    def test_a_mirror_is_a_rigid_plane(self):
        def pressed(name, sign):  # it bulges where it is pressed, and draws back where it is pulled
            body = block(supports={**ROLLERS, "top": "Roller"}, load="0.2*y-0.05", top="right", name=name,
                         place=lambda r, q, t: (r, q, sign * 0.6 * t))
            body.poisson = 0.45
            return body

        for order in (1, 2):
            settings = (f"Discretization/Order={order}", "Error Estimation/Estimators={Global}")
            pair = self.solved(pressed("block", 1.0), pressed("image", -1.0), *settings)
            one = self.solved(pressed("block", 1.0), FLOOR, *settings)
            self.assertLess(contact(one)["contact_area"], 0.95)
            self.same(pair, one, lambda run: run.summary["energy"] * (1.0 if run is pair else 2.0))
            self.assertTrue(one.summary["errors"]["global"]["guaranteed"])
            self.assertEqual(one.summary["ledger"]["counts"]["factorisations"], 1)

    def test_it_is_what_a_clamped_body_is(self):
        slab = Solid("slab", (4, 4, 2), lambda r, q, t: (r, q, 0.1 * t - 0.1), "top", 1.0, 0.3,
                     {side: "Clamp" for side in ("bottom", "top")})
        for order in (1, 2):
            settings = (f"Discretization/Order={order}", "Error Estimation/Estimators={Global}",
                        "Error Estimation/Recovery/Type=Global", "Error Estimation/Recovery/Steps=50",
                        "Error Estimation/Recovery/Least Gain=0")
            runs = [self.solved(block(), other, *settings) for other in (slab, FLOOR)]
            self.same(*runs)
            self.same(*runs, lambda run: contact(run)["contact_area"])
            bounds = [run.summary["errors"]["global"]["absolute"] for run in runs]
            self.assertLess(bounds[1], bounds[0])  # at the clamp the traction stays, at the rigid body it changes

    def test_nearly_flat_ones_are_planes(self):
        settings = ("Error Estimation/Estimators={Global}",)
        key = lambda run: run.summary["errors"]["global"]["relative"]
        flat = self.solved(block(), FLOOR, *settings)
        centres = [(-radius, radius, False) for radius in (1e8, 1e11, 1e14)] + [(1e8 - 3e-8, 1e8, True)]  # clear of its edges
        for kind, axis in (("Sphere", {}), ("Cylinder", {"Axis": (0.6, 0.8, 0.0)})):
            for centre, radius, hollow in centres:
                bent = self.solved(block(), Rigid(kind, {"Centre": (0.3, 0.2, centre), "Radius": radius, "Hollow": hollow,
                                                         **axis}), *settings)
                self.assertTrue(bent.summary["errors"]["global"]["guaranteed"], (kind, radius, hollow))
                self.same(bent, flat, tolerance=1e-6)
                self.same(bent, flat, key, 1e-4)

    def test_mirrored_facets_stop_the_recovery_together_whatever_round_off_ranks_leave(self):
        settings = ("Bodies/upper/Mesh/Cells={4, 4, 2}", "Bodies/lower/Mesh/Cells={8, 8, 4}", "Linear Solver/Type=Multigrid",
                    "Expect/the energy of this mesh/Tolerance=10", "Expect/part of the sides touches/Tolerance=10")
        runs = [PROGRAM.run(DECKS / "contact-loss-3d.xml", *QUIET, *settings, ranks=ranks) for ranks in (1, 2)]
        self.assertEqual([run.code for run in runs], [0, 0], runs[0].screen + runs[1].screen)
        self.same(*runs, lambda run: run.summary["errors"]["global"]["absolute"], 1e-7)

    def test_one_obstacle_has_many_names(self):
        slanted = "0.1*x-0.05*y+0.06"
        ways = [
            (Rigid("Plane", {"Point": (0.0, 0.0, -0.02), "Normal": (-0.1, 0.05, -1.0)}), None),  # looks away
            (Rigid("Sphere", {"Centre": (0.1, 0.2, -5.0), "Radius": 4.99}),
             Rigid("Expression", {"Distance": "5-sqrt(4.99^2-(x-0.1)^2-(y-0.2)^2)"})),
            (Rigid("Sphere", {"Centre": (0.1, 0.2, 2.0), "Radius": 3.0, "Hollow": True}),
             Rigid("Expression", {"Distance": "sqrt(9-(x-0.1)^2-(y-0.2)^2)-2"})),
            (Rigid("Cylinder", {"Centre": (7.0, 0.2, -4.0), "Radius": 4.0, "Axis": (-2.0, 0.0, 0.0)}),
             Rigid("Expression", {"Distance": "4-sqrt(16-(y-0.2)^2)"})),
            (Rigid("Cylinder", {"Centre": (0.0, 0.2, -4.5), "Radius": 4.0, "Axis": (1.0, 0.0, 0.1)}),
             # across the axis the distance is R; along z it is divided by the axis' cosine
             Rigid("Expression", {"Distance": "4.5-0.1*x-sqrt((16-(y-0.2)^2)*1.01)"})),
        ]
        for one, other in ways:
            with self.subTest(one):
                run = solve(block(), one)
                if other is None:
                    self.assertEqual(run.code, 2)
                    self.assertIn("no part of side", run.screen)
                    continue
                self.assertEqual(run.code, 0, run.screen)
                self.same(run, self.solved(block(), other))
        # A plane that leans is asked along its own normal; for a small slope that is the distance along the side's.
        leaning = Rigid("Plane", {"Point": (0.0, 0.0, -0.06), "Normal": (0.1, -0.05, 1.0)})
        self.same(self.solved(block(), leaning), self.solved(block(), Rigid("Expression", {"Distance": slanted})),
                  tolerance=0.1)

    def test_it_presses_when_it_is_moved(self):
        held = {**ROLLERS, "top": "Roller"}
        run = self.solved(block(load=None, supports=held), Rigid("Plane", {
            "Point": (0.0, 0.0, -0.01), "Normal": (0.0, 0.0, 1.0), "Displacement": (0.3, -0.2, 0.022)}))
        self.assertAlmostEqual(contact(run)["contact_force"], 0.012 / 0.6, delta=1e-11)  # free sideways, E = 1
        self.assertAlmostEqual(run.summary["bodies"][1]["supports"][0]["force"][2], 0.02, delta=1e-11)

    def test_turned_in_other_units_and_on_ranks_it_is_the_same(self):
        floor = Rigid("Sphere", {"Centre": (0.2, 0.1, -3.0), "Radius": 3.0})
        estimate = ("Error Estimation/Estimators={Global}",)
        one = self.solved(block(), floor, *estimate)
        bound = lambda run: run.summary["errors"]["global"]["relative"]
        for settings in ("Linear Solver/Type=Mumps", "Linear Solver/Type=Multigrid"):
            for ranks in (1, 2, 3):
                other = self.solved(block(), floor, *estimate, settings, ranks=ranks)
                self.same(other, one, tolerance=1e-7)
                self.same(other, one, bound, 1e-4)
        a, size = 0.7, 1e3
        c, s = math.cos(a), math.sin(a)
        turn = lambda x, y, z: (size * (c * x - s * z), size * y, size * (s * x + c * z))
        body = block(place=lambda r, q, t: turn(r, q, 0.6 * t), load=f"1.5-({c!r}*x+{s!r}*z+y)/{size!r}")
        moved = self.solved(body, Rigid("Sphere", {"Centre": turn(0.2, 0.1, -3.0), "Radius": 3.0 * size}), *estimate)
        self.same(moved, one, lambda run: run.summary["energy"] / (size**3 if run is moved else 1.0))
        self.same(moved, one, bound, 1e-5)

    def test_a_ball_on_a_plane_is_hertz(self):
        run = PROGRAM.run(DECKS / "rigid-plane-3d.xml", *QUIET)
        self.assertEqual(run.code, 0, run.screen)
        self.assertTrue(run.summary["errors"]["global"]["guaranteed"])
        force = math.pi * 0.0004664
        a = (0.75 * force * 0.91) ** (1 / 3)
        self.assertAlmostEqual(contact(run)["largest_pressure"] / (1.5 * force / (math.pi * a * a)), 1.0, delta=0.02)

    def test_targets_are_reached(self):
        floor = Rigid("Sphere", {"Centre": (0.0, 0.0, -3.0), "Radius": 3.0})
        for other in (floor, FLOOR):
            run = solve(block(load="0.01*(1.5-x-y)"), other, "Accuracy/Target=0.1")
            self.assertEqual(run.code, 0, run.screen)
            self.assertTrue(run.summary["errors"]["global"]["guaranteed"])

    def refused(self, message, rigid, **options):
        run = solve(block(**options), rigid)
        self.assertEqual(run.code, 2, run.screen)
        self.assertIn(message, run.screen)

    def test_mistakes_are_told(self):
        up = (0.0, 0.0, 1.0)
        self.refused("has 2 coordinates, and what touches the body is 3-D: give three",
                     Rigid("Plane", {"Point": (0.0, 0.0), "Normal": up}))
        self.refused("is zero; it points out of the rigid body", Rigid("Plane", {"Point": up, "Normal": (0.0, 0.0, 0.0)}))
        self.refused("overlap at the start: the gap is -0.1", Rigid("Plane", {"Point": (0.0, 0.0, 0.1), "Normal": up}))
        self.refused("no part of side", Rigid("Sphere", {"Centre": (0.0, 0.0, 3.0), "Radius": 1.0}))
        self.refused("counts along a line", Rigid("Plane", {"Point": (0.0, 0.0, 0.0), "Normal": up, "Extent": (0.0, 1.0)}))
        self.refused("Displacement", Rigid("Plane", {"Point": (0.0, 0.0, 0.0), "Normal": up, "Displacement": (0.0, 0.1)}))
        self.refused("has 0 coordinates", Rigid("Cylinder", {"Centre": (0.0, 0.0, -1.0), "Radius": 1.0}))
        self.refused("no part of side", Rigid("Cylinder", {"Centre": (0.0, 0.0, -1.0), "Radius": 1.0, "Axis": up}))
        self.refused("faces a bent side", Rigid("Sphere", {"Centre": (0.0, 0.0, -3.0), "Radius": 3.0}),
                     place=lambda r, q, t: (r, q, 0.6 * t + 0.1 * (1 - t) * r * r))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
