"""Bodies of several materials, through the program: test_regions.py PROGRAM DECKS MPIEXEC."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import netCDF4
import numpy

sys.dont_write_bytecode = True
PROGRAM, DECKS, MPIEXEC = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
sys.path.insert(0, str(DECKS.parent / "python"))
from ndframe import deck_text  # noqa: E402

STRESS = {"Hypothesis": "Plane Stress"}
ROLLERS = {"west": {"Type": "Roller", "Side": "left"}, "south": {"Type": "Roller", "Side": "bottom"}}
PULL = {"pull": {"Type": "Traction", "Side": "right", "X": 1.0}}
CERTIFICATE = {"Error Estimation": {"Check Equilibrium": True}}


def material(young, poisson=0.0):
    return {"Material": {"Young Modulus": young, "Poisson Ratio": poisson, **STRESS}}


def part(lower, upper):
    return {"Lower": list(lower), "Upper": list(upper)}


def body(parts, regions, rest=None, supports=ROLLERS, loads=PULL, cells=(8, 4), pattern="Crossed"):
    """A box of 2 by 1."""
    mesh = {"Type": "Box", "Lower": [0.0, 0.0], "Upper": [2.0, 1.0], "Cells": list(cells), "Pattern": pattern,
            "Parts": parts}
    return {"Mesh": mesh, **(rest or {}), **({"Regions": regions} if regions else {}), "Supports": supports,
            "Loads": loads}


LEFT, RIGHT = part((0.0, 0.0), (1.0, 1.0)), part((1.0, 0.0), (2.0, 1.0))
BELOW, ABOVE = part((0.0, 0.0), (2.0, 0.25)), part((0.0, 0.25), (2.0, 1.0))


class Regions(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, scene, *settings, ranks=1):
        (self.folder / "scene.xml").write_text(deck_text(scene, "scene"))
        command = [PROGRAM, "-i", "scene.xml", *(part for setting in settings for part in ("--set", setting))]
        if ranks > 1:
            command = [MPIEXEC, "--oversubscribe", "-np", str(ranks), *command]
        return subprocess.run(command, cwd=self.folder, text=True, capture_output=True, timeout=120)

    def solve(self, scene, *settings, code=0, ranks=1):
        done = self.call(scene, *settings, ranks=ranks)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return json.loads((self.folder / "scene.summary.json").read_text())

    def fields(self):
        """Of scene.e: displacements, stress per element in the order of their middles, names of the blocks."""
        with netCDF4.Dataset(self.folder / "scene.e") as file:
            blocks = len(file.dimensions["num_el_blk"])
            names = [bytes(name.compressed()).decode().rstrip("\0") for name in file["eb_names"][:]]
            x, y = file["coordx"][:].data, file["coordy"][:].data
            middles, stress = [], []
            for b in range(1, blocks + 1):
                corners = file[f"connect{b}"][:].data[:, :3] - 1
                middles.append(numpy.stack([x[corners].mean(axis=1), y[corners].mean(axis=1)], axis=1))
                stress.append(file[f"vals_elem_var1eb{b}"][-1].data)
            u = numpy.stack([file[f"vals_nod_var{k}"][-1].data for k in (1, 2)], axis=1)
        return u, numpy.concatenate(middles), stress, names

    def complaint(self, *arguments, **options):
        done = self.call({"Bodies": {"bar": body(*arguments, **options)}})
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def test_one_material_in_two_regions_is_one_material(self):
        loads = {"press": {"Type": "Pressure", "Side": "top", "Value": "1+x"}}
        for order in (1, 2):
            whole, parts = ({"Bodies": {"bar": body({"a": LEFT}, regions, rest, loads=loads)}, **CERTIFICATE,
                             "Discretization": {"Order": order}}
                            for regions, rest in ((None, material(2.0, 0.3)),
                                                  ({"a": material(2.0, 0.3)}, material(2.0, 0.3))))
            one = self.solve(whole)
            u = self.fields()[0]
            two = self.solve(parts)
            self.assertTrue(numpy.array_equal(self.fields()[0], u))
            self.assertEqual(one["errors"], two["errors"])
            self.assertEqual(one["energy"], two["energy"])
            regions = sum(region["energy"] for region in two["bodies"][0]["regions"])
            self.assertAlmostEqual(regions / two["energy"], 1.0, 13)

    def test_a_bar_in_series_is_exact(self):
        for pattern in ("Right", "Crossed"):
            for order in (1, 2):
                bar = body({"a": LEFT, "b": RIGHT}, {"a": material(1.0), "b": material(1000.0)}, pattern=pattern)
                found = self.solve({"Bodies": {"bar": bar}, **CERTIFICATE, "Discretization": {"Order": order}})
                self.assertAlmostEqual(found["energy"] / (1.0 + 1e-3), 1.0, 9)  # round-off times the contrast
                self.assertLess(found["errors"]["global"]["relative"], 1e-6)
                self.assertTrue(found["errors"]["global"]["guaranteed"])
                regions = {region["name"]: region["energy"] for region in found["bodies"][0]["regions"]}
                self.assertAlmostEqual(regions["a"], 1.0, 8)
                self.assertAlmostEqual(regions["b"], 1e-3, 10)

    def test_a_laminate_pulled_evenly_is_exact(self):
        # Equal strains; with nu = 0 layers carry in proportion to their stiffness.
        supports = {**ROLLERS, "end": {"Type": "Displacement", "Side": "right", "X": 0.01}}
        layers = body({"a": BELOW, "b": ABOVE}, {"b": material(1000.0)}, material(1.0), supports=supports, loads={})
        found = self.solve({"Bodies": {"bar": layers}, **CERTIFICATE})
        strain = 0.01 / 2.0
        self.assertAlmostEqual(found["energy"] / (strain**2 * (0.5 * 1.0 + 1.5 * 1000.0)), 1.0, 11)
        self.assertLess(found["errors"]["global"]["relative"], 1e-6)
        u, middles, stress, names = self.fields()
        self.assertEqual(names, ["bar:b", "bar"])
        self.assertEqual(sum(len(block) for block in stress), 128)
        self.assertLess(numpy.abs(stress[0] - 1000.0 * strain).max(), 1e-9)
        self.assertLess(numpy.abs(stress[1] - strain).max(), 1e-9)
        self.assertTrue((middles[:len(stress[0]), 1] > 0.25).all())

    def test_ranks_give_the_same_answer(self):
        parts = {"core": part((0.5, 0.25), (1.0, 0.75))}
        scene = {"Bodies": {"bar": body(parts, {"core": material(1000.0, 0.2)}, material(1.0, 0.3))}, **CERTIFICATE}
        one = self.solve(scene)
        for ranks in (2, 3):
            other = self.solve(scene, ranks=ranks)
            self.assertAlmostEqual(other["energy"] / one["energy"], 1.0, 10)
            bounds = [run["errors"]["global"]["absolute"] for run in (one, other)]
            self.assertAlmostEqual(bounds[1] / bounds[0], 1.0, 8)
            for a, b in zip(one["bodies"][0]["regions"], other["bodies"][0]["regions"], strict=True):
                self.assertEqual(a["elements"], b["elements"])
                self.assertAlmostEqual(a["energy"] / b["energy"], 1.0, 8)

    def test_a_target_is_reached_with_an_inclusion(self):
        parts = {"core": part((0.5, 0.25), (1.0, 0.75))}
        for contrast in (1e-3, 1e3):
            scene = {"Bodies": {"bar": body(parts, {"core": material(contrast, 0.3)}, material(1.0, 0.3))}}
            found = self.solve(scene, "Accuracy/Target=0.02")
            self.assertTrue(found["accuracy"]["reached"])
            self.assertTrue(found["errors"]["global"]["guaranteed"])
            _, middles, stress, _ = self.fields()  # cells of the inclusion stay inside it
            core = numpy.abs(middles[:len(stress[0])] - (0.75, 0.5)).max(axis=1)
            rest = numpy.abs(middles[len(stress[0]):] - (0.75, 0.5)).max(axis=1)
            self.assertLess(core.max(), 0.25)
            self.assertGreater(rest.min(), 0.25)

    def test_certificates_of_other_regions_are_of_other_scenes(self):
        parts = {"core": part((0.5, 0.25), (1.0, 0.75))}
        bar = body(parts, {"core": material(1000.0, 0.2)}, material(1.0, 0.3))
        (self.folder / "scene.xml").write_text(deck_text({"Bodies": {"bar": bar}, **CERTIFICATE}, "scene"))
        command = [PROGRAM, "-i", "scene.xml", "--study", "Bodies/bar/Mesh/Parts/core/Upper={1, 0.75}; {1.5, 0.75}"]
        done = subprocess.run(command, cwd=self.folder, text=True, capture_output=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)  # 3: they would contradict each other

    def test_mistakes_are_told_with_their_places(self):
        soft, stiff = material(1.0), material(2.0)
        self.assertIn('Bodies/bar: the list "Material" is missing.', self.complaint({}, None))
        self.assertIn('Bodies/bar/Regions/lft: the mesh has no group of cells "lft"; did you mean "left"?',
                      self.complaint({"left": LEFT}, {"lft": soft}, stiff))
        self.assertIn("it names no groups", self.complaint({}, {"a": soft}, stiff))
        self.assertIn('contains the cell at (', self.complaint({"a": LEFT, "b": BELOW}, {"a": soft, "b": stiff}, soft))
        self.assertIn('which region "a" contains, too; a cell has one material.',
                      self.complaint({"a": LEFT, "b": BELOW}, {"a": soft, "b": stiff}, soft))
        self.assertIn("64 of 128 cells are in no region, the first at (1.", self.complaint({"a": LEFT}, {"a": soft}))
        strain = {"Material": {**stiff["Material"], "Hypothesis": "Plane Strain"}}
        self.assertIn('"Plane Strain" here, "Plane Stress" in another region; a body has one hypothesis.',
                      self.complaint({"a": LEFT, "b": RIGHT}, {"a": soft, "b": strain}))
        self.assertIn("the part goes from 1 to 3 in direction X, the box from 0 to 2.",
                      self.complaint({"a": part((1.0, 0.0), (3.0, 1.0))}, {"a": soft}, stiff))


if __name__ == "__main__":
    unittest.main()
