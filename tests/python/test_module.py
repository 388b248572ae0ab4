"""import ndframe: test_module.py NDFRAME SOURCES. Compared with the files as JSON, CSV and netCDF show them."""

import csv
import dataclasses
import inspect
import json
import pathlib
import shutil
import sys
import tempfile
import typing
import unittest

import netCDF4
import numpy

sys.dont_write_bytecode = True
PROGRAM, SOURCES = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
sys.path.insert(0, str(SOURCES / "python"))
import ndframe  # noqa: E402

DECKS = SOURCES / "decks"
COARSE = {"Bodies/punch/Mesh/Cells": [4, 4], "Bodies/foundation/Mesh/Cells": (8, 4)}
BLOCK = {"Bodies": {"block": {
    "Mesh": {"Type": "Box", "Lower": [0.0, 0.0], "Upper": [1.0, 1.0], "Cells": [2, 2]},
    "Material": {"Young Modulus": 2.0, "Poisson Ratio": 0.0},
    "Supports": {"below": {"Type": "Roller", "Side": "bottom"}, "beside": {"Type": "Roller", "Side": "left"}},
    "Loads": {"above": {"Type": "Pressure", "Side": "top", "Value": 0.1}}}}, "Strain Limit": 1}


def setUpModule():
    global FOLDER, PUNCH
    holder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(holder.cleanup)
    FOLDER = pathlib.Path(holder.name)
    PUNCH = run("punch", {**COARSE, "Error Estimation/Mode": "Strict"})


def run(deck, settings=None, **more):
    return ndframe.run(DECKS / f"{deck}.xml", settings, **{"folder": FOLDER, "program": PROGRAM, **more})


class Reads(unittest.TestCase):
    def setUp(self):
        self.data = netCDF4.Dataset(FOLDER / "punch.e")
        self.addCleanup(self.data.close)
        self.data.set_auto_mask(False)

    def number(self, kind, name):
        return [row.tobytes().split(b"\0")[0].decode() for row in self.data[kind][:]].index(name) + 1

    def test_the_summary(self):
        summary = json.loads((FOLDER / "punch.summary.json").read_text())
        self.assertEqual(PUNCH.summary, summary)
        self.assertEqual(PUNCH.energy, summary["energy"])
        self.assertEqual(PUNCH.dofs, sum(body["dofs"] for body in summary["bodies"]))
        self.assertEqual(dataclasses.asdict(PUNCH.bound), {key: summary["errors"]["global"][key] for key in
                                                           ("absolute", "relative", "guaranteed", "reason")})
        self.assertLess(*PUNCH.energy_bracket)
        self.assertEqual(PUNCH.interfaces["contact"], summary["interfaces"][0])
        self.assertEqual(list(PUNCH.bodies), ["punch", "foundation"])
        eps = [record["eps_tau"] for record in summary["coupling"]["history"]]
        numpy.testing.assert_array_equal(PUNCH.sweeps["eps_tau"], eps)
        self.assertEqual((PUNCH.code, PUNCH.solved, PUNCH.levels), (0, True, {}))
        self.assertIn("wrote punch.e", PUNCH.screen)

    def test_the_same_later_by_any_of_the_names(self):
        for name in ("punch", "punch.e", "punch.summary.json", "punch.xml"):
            self.assertEqual(ndframe.read(FOLDER / name).summary, PUNCH.summary)

    def test_levels(self):
        levels = run("punch", {"Accuracy/Target": 0.1, "Output/Name": "levels"}, codes=(0, 4)).levels
        with open(FOLDER / "levels.levels.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        for column in ("dofs", "bound", "relative", "iteration"):
            numpy.testing.assert_allclose(levels[column], [float(row[column]) for row in rows], rtol=1e-12)
        self.assertTrue(numpy.isnan(levels["dofs_to_target"][-1]))
        self.assertEqual(levels["dofs"].dtype, int)

    def test_a_run_that_a_limit_ended_goes_on(self):
        settings = {"Accuracy/Target": 0.02, "Accuracy/Maximum Levels": 2, "Output/Name": "again", "Output/Checkpoint": True}
        first = run("punch", settings, codes=(5,))
        whole = run("punch", {**settings, "Accuracy/Maximum Levels": 20, "Output/Name": "whole"}, codes=(0, 4))
        rest = run("punch", {**settings, "Accuracy/Maximum Levels": 20}, codes=(0, 4), restart=True)
        self.assertEqual((len(first.levels["dofs"]), rest.bound.absolute), (2, whole.bound.absolute))
        self.assertEqual(list(rest.levels["bound"]), list(whole.levels["bound"]))
        self.assertIn("continues from again.checkpoint", rest.screen)

    def test_the_contact_table(self):
        with open(FOLDER / "punch.contact.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        for column in set(rows[0]) - {"interface"}:
            numpy.testing.assert_array_equal(PUNCH.contact["contact"][column], [float(row[column]) for row in rows])

    def test_points_and_nodal_fields(self):
        fields = PUNCH.fields
        numpy.testing.assert_array_equal(fields.points[:, 1], self.data["coordy"][:])
        numpy.testing.assert_array_equal(fields.displacement[:, 1],
                                         self.data[f"vals_nod_var{self.number('name_nod_var', 'disp_y')}"][-1])
        largest = numpy.linalg.norm(fields.displacement, axis=1).max()
        self.assertAlmostEqual(largest, PUNCH.bodies["punch"]["largest_displacement"]["value"], delta=1e-12)

    def test_elements(self):
        fields, number = PUNCH.fields, self.number("name_elem_var", "stress_xy")
        self.assertEqual(fields.blocks, ("punch", "foundation"))
        for block, name in enumerate(fields.blocks, 1):
            stress = self.data[f"vals_elem_var{number}eb{block}"][-1]
            numpy.testing.assert_array_equal(fields.element("stress_xy", name), stress)
            tensor = fields.stress(name)
            numpy.testing.assert_array_equal(tensor[:, 0, 1], stress)
            numpy.testing.assert_array_equal(tensor, tensor.transpose(0, 2, 1))
            deviator = tensor - numpy.trace(tensor, axis1=1, axis2=2)[:, None, None] / 3.0 * numpy.eye(3)
            numpy.testing.assert_allclose(fields.element("von_mises", name), numpy.sqrt(1.5 * (deviator**2).sum(axis=(1, 2))), rtol=1e-9)
            numpy.testing.assert_array_equal(fields.nodes(name), self.data[f"connect{block}"][:] - 1)
            self.assertEqual(fields.triangles(name).shape, (PUNCH.bodies[name]["elements"], 3))

    def test_the_force_on_a_side_is_that_of_the_summary(self):
        fields = PUNCH.fields
        ends = fields.points[fields.facets("contact:dirichlet")]
        lengths = numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        self.assertAlmostEqual(lengths.sum(), 1.0, delta=1e-12)
        force = fields.on_facets("contact_pressure", "contact:dirichlet") @ lengths
        self.assertAlmostEqual(force, PUNCH.interfaces["contact"]["contact_force"], delta=1e-9)

    def test_solids(self):
        fields = run("beam-3d", {"Bodies/beam/Mesh/Cells": [4, 2, 1]}, codes=(0, 4)).fields
        self.assertEqual((fields.dimension, fields.nodes("beam").shape[1], fields.facets("beam:left").shape[1]), (3, 10, 3))

    def test_steps(self):
        fields = run("punch", {**COARSE, "Output/Steps": "All Sweeps", "Output/Name": "steps"}).fields
        numpy.testing.assert_array_equal(fields.steps, numpy.arange(1, 7))
        self.assertGreater(abs(fields.vector("disp", 0) - fields.displacement).max(), 1e-3)
        with self.assertRaisesRegex(ndframe.ReadError, r"steps.e: there is no step 6; there are 6, from 0, and -1 is the last"):
            fields.nodal("disp_x", 6)


class Runs(unittest.TestCase):
    def test_a_deck_of_mappings(self):
        block = ndframe.run(BLOCK, folder=FOLDER / "new", program=PROGRAM)
        self.assertAlmostEqual(block.energy, 0.1**2 / 2.0, delta=1e-12)
        self.assertIsNone(block.bound)
        self.assertTrue((FOLDER / "new/deck.e").exists())

    def test_the_effective_deck_runs_again(self):
        again = ndframe.run(PUNCH.deck, {"Output/Name": "again"}, folder=FOLDER, program=PROGRAM)
        self.assertEqual(again.energy, PUNCH.energy)

    def test_names_of_the_deck_and_of_the_settings(self):
        named = {**BLOCK, "Output": {"Name": "mine", "Directory": "results"}}
        (FOLDER / "results").mkdir()
        self.assertEqual(ndframe.run(named, folder=FOLDER, program=PROGRAM).stem, str(FOLDER / "results/mine"))
        self.assertEqual(ndframe.run(named, {"Output/Name": "yours"}, folder=FOLDER, program=PROGRAM).name, "yours")

    def test_values_of_settings_keep_their_digits(self):
        third = ndframe.run(BLOCK, {"Bodies/block/Loads/above/Value": 0.1 / 3.0}, folder=FOLDER, program=PROGRAM)
        self.assertAlmostEqual(third.energy, (0.1 / 3.0) ** 2 / 2.0, delta=1e-16)

    def test_a_study(self):
        study = ndframe.run_study(DECKS / "punch.xml", {"Coupling/Stopping/Tolerance": [0.1, 0.01]}, COARSE, folder=FOLDER,
                                  program=PROGRAM)
        numpy.testing.assert_array_equal(study.column("case"), [1, 2])
        self.assertEqual(study.column("energy")[0], float(f"{PUNCH.energy:.17g}"))
        self.assertTrue(study.complete)
        self.assertEqual(ndframe.read(FOLDER / "punch.study.csv").rows, study.rows)
        with self.assertRaisesRegex(ndframe.ReadError, 'there is no column "energi".*Did you mean "energy"'):
            study.column("energi")

    def test_load_cases(self):
        press, folder = "Bodies/punch/Loads/press", FOLDER / "cases"
        cases = ndframe.run_cases(DECKS / "punch.xml", {"half": {press: 0.5}, "lift": {press: -1}, "all": {}}, COARSE | {"Expect/the punch "
                                  "is in equilibrium/Quantity": "cases/all/interfaces/contact/contact_force"}, folder=folder,
                                  program=PROGRAM, codes=(0, 3))
        self.assertEqual((cases.names, cases.code), (["half", "lift", "all"], 3))
        self.assertEqual(cases.entry("half")["factors"], {press: 0.5})
        numpy.testing.assert_array_equal(cases.column(press), [0.5, -1.0, 1.0])
        half, whole = cases["half"], cases["all"]
        self.assertEqual((half.name, half.code, cases["lift"].solved), ("punch.half", 0, False))
        numpy.testing.assert_allclose(cases.column("energy"), [half.energy, numpy.nan, whole.energy])
        self.assertEqual(whole.energy, PUNCH.energy)
        # Contact is homogeneous: each has its own rows and its own step of the files that they share.
        for name in ("pressure", "u_dirichlet"):
            numpy.testing.assert_allclose(2.0 * half.contact["contact"][name], whole.contact["contact"][name], atol=1e-12)
        numpy.testing.assert_array_equal(whole.contact["contact"]["pressure"], PUNCH.contact["contact"]["pressure"])
        numpy.testing.assert_allclose(2.0 * half.fields.displacement, whole.fields.displacement, atol=1e-11)
        numpy.testing.assert_allclose(2.0 * half.fields.element("von_mises", "punch"), PUNCH.fields.element("von_mises", "punch"), rtol=1e-9)
        numpy.testing.assert_array_equal(half.fields.steps, [1.0, 3.0])
        with self.assertRaisesRegex(ndframe.ReadError, 'has no step of the case "lift"'):
            cases["lift"].fields
        with self.assertRaisesRegex(ndframe.ReadError, 'there is no load case "hlf".*Did you mean "half"'):
            cases["hlf"]
        for name in ("punch", "punch.cases.csv", "punch.e"):
            self.assertEqual(ndframe.read(folder / name).summary, cases.summary)

    def test_load_cases_to_a_target_have_files_of_their_own(self):
        cases = ndframe.run_cases(DECKS / "load-cases.xml", None, {"Accuracy/Target": 0.05}, folder=FOLDER / "target", program=PROGRAM)
        full = cases["full"]
        self.assertEqual(full.stem, str(FOLDER / "target/load-cases.full"))
        self.assertEqual(full.energy, ndframe.read(full.stem).energy)
        self.assertLess(full.bound.relative, 0.05)
        self.assertGreater(full.fields.displacement.size, 0)

    def test_every_function_is_typed_and_explained(self):
        for name in ndframe.__all__:
            thing = getattr(ndframe, name)
            self.assertTrue(thing.__doc__, name)
            if inspect.isfunction(thing):
                self.assertIn("return", typing.get_type_hints(thing), name)


class Refuses(unittest.TestCase):
    def assert_says(self, words, call, *arguments, kind=ndframe.ReadError, **more):
        with self.assertRaises(kind) as caught:
            call(*arguments, **more)
        self.assertIn(words, str(caught.exception))
        return caught.exception

    def test_unknown_names(self):
        fields = PUNCH.fields
        self.assert_says('punch.e: there is no variable on nodes "dispx"; there are disp_x, disp_y', fields.nodal, "dispx")
        self.assert_says('there is no block "punh"; there are punch, foundation. Did you mean "punch"?', fields.element, "eta_glob", "punh")
        self.assert_says('there is no side "contact"; there are', fields.facets, "contact")
        self.assert_says('"contact_pressure" is not defined on punch:top', fields.on_facets, "contact_pressure", "punch:top")

    def test_missing_files(self):
        self.assert_says("there is no nowhere.summary.json and no nowhere.study.csv; run the deck first", ndframe.read, "nowhere")
        hidden = run("patch", {"Output/Exodus": False, "Output/Contact Table": False})
        self.assert_says("there is no patch.e (Output/Exodus is false)", lambda: hidden.fields)
        self.assert_says("there is no patch.contact.csv", lambda: hidden.contact)
        self.assert_says("no-such.xml: the deck cannot be read: No such file", run, "no-such")

    def test_damaged_files(self):
        shutil.copy(FOLDER / "punch.summary.json", FOLDER / "torn.summary.json")
        (FOLDER / "torn.contact.csv").write_text("interface,x\ncontact,one\n")
        (FOLDER / "torn.e").write_bytes(b"CDF")
        torn = ndframe.read(FOLDER / "torn")
        self.assert_says("torn.contact.csv is damaged; run the deck again", lambda: torn.contact)
        self.assert_says("torn.e: cannot be read as Exodus", lambda: torn.fields)
        (FOLDER / "torn.summary.json").write_text("{}")
        self.assert_says("cannot be read as an ndframe summary (KeyError: 'version'); run the deck again", ndframe.read, FOLDER / "torn")
        (FOLDER / "torn.xml").write_text("<ParameterList")
        self.assert_says("torn.xml: the deck is not XML", ndframe.run, FOLDER / "torn.xml", program=PROGRAM)

    def test_fields_of_another_run(self):
        run("patch", {"Output/Name": "other", "Output/Contact Table": False})
        shutil.copy(FOLDER / "punch.e", FOLDER / "other.e")
        self.assert_says("other.e belongs to another run", lambda: ndframe.read(FOLDER / "other").fields)

    def test_mistakes_of_a_deck(self):
        error = self.assert_says('"Cels" is not a parameter here; did you mean "Cells"?', run, "punch", {"Bodies/punch/Mesh/Cels": [3, 3]},
                                 kind=ndframe.RunError)
        self.assertEqual((error.code, error.results), (2, None))

    def test_an_answer_that_is_not_wanted_is_still_there(self):
        settings = {**COARSE, "Output/Name": "few", "Coupling/Stopping/Maximum Sweeps": 2}
        error = self.assert_says("ndframe ended with exit code 3", run, "punch", settings, kind=ndframe.RunError)
        self.assertFalse(error.results.summary["coupling"]["converged"])
        self.assertEqual(run("punch", settings, codes=(0, 3)).code, 3)

    def test_studies_and_runs_are_told_apart(self):
        self.assert_says("the deck has a list Study, which run_study() runs", run, "study")
        for call in (ndframe.run_study, ndframe.run_cases):
            self.assert_says("neither the deck nor the call has load cases or an axis of a study; use run()", call, DECKS / "patch.xml",
                             folder=FOLDER, program=PROGRAM)
        self.assert_says("the deck has a list Load Cases, which run_cases() runs", run, "load-cases")

    def test_values_that_no_deck_has(self):
        self.assert_says("is not allowed in a deck", ndframe.deck_text, {"Title": {1, 2}}, kind=ndframe.Error)

    def test_a_program_that_is_not_there(self):
        self.assert_says("cannot be started", run, "punch", program="/no/ndframe", kind=ndframe.Error)


if __name__ == "__main__":
    unittest.main()
