"""Bodies held by Hold and by points, through the program: test_holds.py PROGRAM DECKS MPIEXEC."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import netCDF4
import numpy

sys.dont_write_bytecode = True
PROGRAM, DECKS, MPIEXEC = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1)), sys.argv.pop(1)
sys.path.insert(0, str(DECKS.parent / "python"))
from ndframe import deck_text  # noqa: E402

E, NU = 2.0, 0.3
COMPLIANCE = (1 + NU) * (1 - 2 * NU) / E  # plane strain, equal pressure from all sides: strain = - COMPLIANCE p
UNEVEN = "1+0.5*cos(3*x)"
SQUEEZED = {"above": {"Type": "Traction", "Side": "top", "Y": f"-({UNEVEN})"},
            "below": {"Type": "Traction", "Side": "bottom", "Y": UNEVEN}}
HOLD = {"Type": "Hold"}
PINS = {"corner": {"Type": "Point", "At": [0.0, 0.0], "X": 0.0, "Y": 0.0},
        "foot": {"Type": "Point", "At": [1.0, 0.0], "Y": 0.0}}


def block(supports, loads, low=(0.0, 0.0), high=(1.0, 1.0), cells=(4, 4)):
    return {"Mesh": {"Type": "Box", "Lower": list(low), "Upper": list(high), "Cells": list(cells)},
            "Material": {"Young Modulus": E, "Poisson Ratio": NU}, "Supports": supports, "Loads": loads}


def pressures(sides, value=1.0):
    return {side: {"Type": "Pressure", "Side": side, "Value": value} for side in sides}


def pressed_blocks(upper, lower):
    """Two blocks that an equal pressure on all outer sides holds together."""
    return {"Bodies": {"upper": block(upper, pressures(("left", "right", "top")), (0.0, 1.0), (1.0, 2.0), (3, 3)),
                       "lower": block(lower, pressures(("left", "right", "bottom")), cells=(3, 3))},
            "Interfaces": {"contact": {"Dirichlet Body": "upper", "Dirichlet Side": "bottom",
                                       "Neumann Body": "lower", "Neumann Side": "top"}},
            "Coupling": {"Type": "Monolithic"}}


class Holds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, scene, *arguments, ranks=1):
        (self.folder / "scene.xml").write_text(deck_text(scene, "scene"))
        command = [PROGRAM, "-i", "scene.xml", *arguments]
        if ranks > 1:
            command = [MPIEXEC, "--oversubscribe", "-np", str(ranks), *command]
        return subprocess.run(command, cwd=self.folder, text=True, capture_output=True, timeout=120)

    def run_scene(self, scene, code=0, **options):
        done = self.call({**scene, "Error Estimation": {"Mode": "Strict"}}, **options)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return json.loads((self.folder / "scene.summary.json").read_text())

    def one(self, supports, loads=None, **options):
        return self.run_scene({"Bodies": {"block": block(supports, SQUEEZED if loads is None else loads)}}, **options)

    def fields(self):
        with netCDF4.Dataset(self.folder / "scene.e") as file:
            names = [str(name) for name in netCDF4.chartostring(file["name_nod_var"][:])]
            displacement = [file[f"vals_nod_var{names.index(n) + 1}"][-1] for n in ("disp_x", "disp_y")]
            cells = [str(name) for name in netCDF4.chartostring(file["name_elem_var"][:])]
            stress = [file[f"vals_elem_var{i + 1}eb1"][-1] for i, n in enumerate(cells) if n.startswith("stress")]
            self.assertTrue(stress, cells)
            return numpy.array(displacement), numpy.array(stress), numpy.array([file["coordx"][:], file["coordy"][:]])

    def refused(self, scene, *words):
        done = self.call(scene)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertIn("nothing was computed", done.stderr)

    def reaction(self, summary, body, support):
        (found,) = [s for b in summary["bodies"] if b["name"] == body for s in b["supports"] if s["name"] == support]
        return found

    def test_a_patch_in_pure_traction_is_exact_and_its_mean_does_not_move(self):
        summary = self.one({"hold": HOLD}, pressures(("left", "right", "top", "bottom")))
        self.assertAlmostEqual(summary["energy"], 2 * COMPLIANCE, delta=1e-12)
        self.assertTrue(summary["errors"]["global"]["guaranteed"], summary["errors"]["global"])
        self.assertLess(summary["errors"]["global"]["relative"], 1e-7)
        u, _, x = self.fields()
        self.assertLess(numpy.abs(u + COMPLIANCE * (x - 0.5)).max(), 1e-12)

    def test_the_mean_may_be_that_of_a_side(self):
        self.one({"hold": {"Type": "Hold", "Side": "right"}}, pressures(("left", "right", "top", "bottom")))
        u, _, x = self.fields()
        centre = numpy.array([[1.0], [0.5]])
        self.assertLess(numpy.abs(u + COMPLIANCE * (x - centre)).max(), 1e-12)

    def test_stress_and_bound_do_not_depend_on_how_a_balanced_body_is_held(self):
        found = []
        for supports in ({"hold": HOLD}, {"hold": {"Type": "Hold", "Side": "left"}}, PINS,
                         {"a": {"Type": "Point", "At": [0.5, 0.5], "X": 0.2, "Y": -0.1},
                          "b": {"Type": "Point", "At": [0.0, 1.0], "X": 0.2}}):
            summary = self.one(supports)
            bound = summary["errors"]["global"]
            self.assertTrue(bound["guaranteed"], (supports, bound))
            for body in summary["bodies"]:
                for support in body["supports"]:
                    self.assertLess(numpy.abs(support["force"]).max(), 1e-11, support)
            found.append((summary["energy"], bound["absolute"], self.fields()[1]))
        for energy, bound, stress in found[1:]:
            self.assertAlmostEqual(energy, found[0][0], delta=1e-10)
            self.assertAlmostEqual(bound, found[0][1], delta=1e-9)
            self.assertLess(numpy.abs(stress - found[0][2]).max(), 1e-10)

    def test_a_point_that_carries_a_force_takes_the_guarantee(self):
        loads = {"drag": {"Type": "Traction", "Side": "top", "X": 1.0}}
        summary = self.one({"floor": {"Type": "Roller", "Side": "bottom"}, "pin": PINS["corner"]}, loads)
        bound = summary["errors"]["global"]
        self.assertFalse(bound["guaranteed"])
        self.assertIn("Bodies/block/Supports/pin holds a point with a force of", summary["errors"]["global"]["reason"])
        self.assertAlmostEqual(self.reaction(summary, "block", "pin")["force"][0], -1.0, delta=1e-9)

    def test_contact_that_holds_what_a_hold_does_not(self):
        ground = {"ground": {"Type": "Clamp", "Side": "bottom"}}
        energies = []
        for upper in ({"hold": HOLD}, {"pin": {"Type": "Point", "At": [0.0, 2.0], "X": 0.0}}):
            scene = pressed_blocks(upper, ground)
            scene["Bodies"]["upper"]["Loads"] = {"press": {"Type": "Pressure", "Side": "top", "Value": UNEVEN}}
            scene["Bodies"]["lower"]["Loads"] = {}
            for coupling in ("Monolithic", "Neumann-Dirichlet"):
                scene["Coupling"] = {"Type": coupling}
                if coupling == "Neumann-Dirichlet":
                    scene["Coupling"]["Stopping"] = {"Tolerance": 1e-10}
                summary = self.run_scene(scene)
                self.assertTrue(summary["errors"]["global"]["guaranteed"], summary["errors"]["global"])
                energies.append(summary["energy"])
            if "hold" in upper:
                held_by = summary["bodies"][0]["held_by"]
                self.assertTrue(held_by.startswith("hold: translation along x; by contact: "), held_by)
        for energy in energies[1:]:
            self.assertAlmostEqual(energy / energies[0], 1.0, delta=1e-8)

    def test_two_floating_bodies_are_held_together(self):
        for roles in ((HOLD, HOLD), ):
            scene = pressed_blocks({"hold": roles[0]}, {"hold": roles[1]})
            summary = self.run_scene(scene)
            self.assertAlmostEqual(summary["energy"], 4 * COMPLIANCE, delta=1e-11)
            self.assertTrue(summary["errors"]["global"]["guaranteed"], summary["errors"]["global"])
            for ranks in (2, 3):
                again = self.run_scene(scene, ranks=ranks)
                self.assertAlmostEqual(again["energy"], summary["energy"], delta=1e-11)
                self.assertTrue(again["errors"]["global"]["guaranteed"])

    def test_loads_out_of_equilibrium_are_refused_with_what_is_left(self):
        drag = {"drag": {"Type": "Traction", "Side": "top", "X": 0.5}}
        self.refused({"Bodies": {"block": block({"keep": HOLD}, drag)}}, "Bodies/block/Supports/keep",
                     "the loads are not in equilibrium along what it holds (translation along x, translation along y, "
                     "rotation about (0.5, 0.5)): a force (0.5, ", "about (0.5, 0.5) are left, and a Hold carries none")
        scene = pressed_blocks({"keep": HOLD}, {"ground": {"Type": "Clamp", "Side": "bottom"}})
        scene["Bodies"]["upper"]["Loads"]["drag"] = drag["drag"]
        self.refused(scene, "Bodies/upper/Supports/keep", "(translation along x): a force (0.5, 0)")

    def test_wrong_use_is_refused(self):
        clamp = {"clamp": {"Type": "Clamp", "Side": "bottom"}}
        self.refused({"Bodies": {"block": block({**clamp, "hold": HOLD}, {})}}, "Bodies/block/Supports/hold",
                     "supports and contact hold all motions of this body already; remove it.")
        self.refused({"Bodies": {"block": block({}, SQUEEZED)}}, "where the loads are in equilibrium along it, Hold does")
        for at, words in (([0.1, 0.0], "no vertex of the mesh lies within 1.41e-06 of (0.1, 0); the nearest one is (0, 0), "
                           "0.1 away"), ([0.0], "At has 1 coordinates and the body 2 dimensions")):
            pin = {"Type": "Point", "At": at, "X": 0.0}
            self.refused({"Bodies": {"block": block({**clamp, "pin": pin}, {})}}, "Bodies/block/Supports/pin", words)
        self.refused({"Bodies": {"block": block({**clamp, "pin": {"Type": "Point", "At": [0.0, 1.0]}}, {})}},
                     "prescribes no component")
        self.refused({"Bodies": {"block": block({"hold": {"Type": "Hold", "Side": "roof"}}, SQUEEZED)}},
                     'there is no side "roof"')


if __name__ == "__main__":
    unittest.main(verbosity=2)
