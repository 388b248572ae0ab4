"""Load cases: what they are equal to, and what they leave: test_load_cases.py PROGRAM DECKS."""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

sys.dont_write_bytecode = True
PROGRAM, DECKS = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(DECKS.parent / "python"))
from ndframe import Exodus  # noqa: E402

LIST = "Load Cases/Factors/"
PRESS, WEIGHT = "Bodies/upper/Loads/press", "Bodies/upper/Loads/weight"
# Solved exactly, so that answers may be compared to round-off.
EXACT = ("Coupling/Type=Monolithic",)
COARSE = ("Bodies/upper/Mesh/Cells={4, 4, 2}", "Bodies/lower/Mesh/Cells={8, 8, 4}")
TILT = ("Bodies/upper/Loads/tilt/Type=Pressure", "Bodies/upper/Loads/tilt/Side=right", "Bodies/upper/Loads/tilt/Value=0.1*(1+z)")


def names(*cases):
    return f"Load Cases/Names={{{', '.join(cases)}}}"


def factors(path, *values):
    return f"{LIST}{path}={{{', '.join(map(str, values))}}}"


def far(a, b):
    """Largest difference over the largest value; places that are no numbers are the same in both."""
    a, b = numpy.asarray(a, float), numpy.asarray(b, float)
    assert (numpy.isnan(a) == numpy.isnan(b)).all()
    scale = numpy.nanmax(numpy.abs(b), initial=0.0)
    return numpy.nanmax(numpy.abs(a - b), initial=0.0) / (scale if scale > 0.0 else 1.0)


class LoadCases(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, deck, *settings, code=0, folder=".", switches=()):
        (self.folder / folder).mkdir(exist_ok=True)
        command = [PROGRAM, "-i", DECKS / f"{deck}.xml", *switches, *(part for setting in settings for part in ("--set", setting))]
        done = subprocess.run(command, cwd=self.folder / folder, text=True, capture_output=True, timeout=300)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def plain(self, deck, *settings):
        """The settings and a copy of the deck without expectations and load cases, which tests change."""
        import xml.etree.ElementTree as xml

        root = xml.parse(DECKS / f"{deck}.xml").getroot()
        for entry in [e for e in root if e.get("name") in ("Expect", "Load Cases")]:
            root.remove(entry)
        xml.ElementTree(root).write(self.folder / f"{deck}.xml")
        return [self.folder / deck, *settings]

    def summary(self, name, folder="."):
        return json.loads((self.folder / folder / f"{name}.summary.json").read_text())

    def cases(self, name, folder="."):
        return {case["name"]: case for case in self.summary(name, folder)["cases"]}

    def rows(self, name, folder="."):
        return {row["name"]: row for row in self.table(f"{name}.cases.csv", folder)}

    def table(self, name, folder="."):
        with open(self.folder / folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def fields(self, name, folder="."):
        return Exodus(str(self.folder / folder / f"{name}.e"))

    def assert_same_step(self, file, step, other, tolerance, factor=1.0, other_step=0):
        """All displacements and stresses of a step are those of another one."""
        for kind, parts in (("nodal", [None]), ("element", range(1, len(file.blocks) + 1))):
            for name in file.variables(kind):
                if name.startswith("eta_"):
                    continue  # of stresses that are nearly best, which have no unique distribution
                for part in parts:
                    found, wanted = file.values(kind, name, part)[step], factor * other.values(kind, name, part)[other_step]
                    scale = numpy.abs(wanted).max()
                    largest = max(numpy.abs(factor * other.values(kind, entry, part)[other_step]).max()
                                  for entry in file.variables(kind) if entry[:4] == name[:4])
                    self.assertLessEqual(numpy.abs(found - wanted).max(), tolerance * max(scale, largest), (kind, name, step))

    def assert_equal_to_runs_alone(self, deck, settings, cases, tolerance=1e-9):
        """cases: name -> (factors by path, settings that multiply by hand)."""
        paths = list(next(iter(cases.values()))[0])
        self.call(*self.plain(deck, *settings, names(*cases), *(factors(p, *(c[0][p] for c in cases.values())) for p in paths)))
        file, found = self.fields(deck), self.cases(deck)
        for step, (name, (_, by_hand)) in enumerate(cases.items()):
            self.call(*self.plain(deck, *settings, *by_hand), folder="alone")
            alone, results = self.summary(deck, "alone"), found[name]["results"]
            self.assertAlmostEqual(results["energy"] / alone["energy"], 1.0, delta=tolerance, msg=name)
            if alone["errors"]:
                bound, wanted = results["errors"]["global"], alone["errors"]["global"]
                self.assertAlmostEqual(bound["absolute"] / wanted["absolute"], 1.0, delta=1e3 * tolerance, msg=name)
                self.assertEqual(bound["guaranteed"], wanted["guaranteed"])
            for one, other in zip(results["interfaces"], alone["interfaces"], strict=True):
                self.assertEqual(one["closed_nodes"], other["closed_nodes"], name)
            self.assert_same_step(file, step, self.fields(deck, "alone"), tolerance)
        return found

    def test_each_is_a_run_of_its_own(self):
        cases = {f"case {k}": ({PRESS: a, WEIGHT: b}, [f"{PRESS}/Value={a}", f"{WEIGHT}/Value={b}"])
                 for k, (a, b) in enumerate([(1.0, 0.0), (1.0, 0.2), (0.3, 0.4), (2.0, 0.0)])}
        found = self.assert_equal_to_runs_alone("load-cases", EXACT, cases)
        closed = {case["results"]["interfaces"][0]["closed_nodes"] for case in found.values()}
        self.assertGreater(len(closed), 1, "contact that is the same in all cases would show nothing")

    def test_in_space_too(self):
        tilt = "Bodies/upper/Loads/tilt"
        cases = {f"case {k}": ({"Bodies/upper/Loads/press": a, tilt: b},
                               [f"Bodies/upper/Loads/press/Value={a}*(x<=0.5)*(y<=0.5)", f"{tilt}/Value={b}*(1+z)*0.1"])
                 for k, (a, b) in enumerate([(1.0, 0.0), (1.0, 2.0), (0.5, -1.0)])}
        found = self.assert_equal_to_runs_alone("contact-loss-3d", (*COARSE, *TILT, "Error Estimation/Mode=Strict"), cases, 1e-8)
        self.assertTrue(all(case["results"]["errors"]["global"]["guaranteed"] for case in found.values()))

    def test_factors_multiply_expressions_supports_and_gaps(self):
        support = "Bodies/upper/Supports/top/"
        moved = [f"{support}Type=Displacement", f"{support}Side=loaded", f"{support}Y=-0.01*(1+x)", f"{support}X=1e-3*x",
                 "Interfaces/contact/Gap=0.002*x"]
        cases = {"all": ({"Bodies/upper/Supports/top": 1, "Interfaces/contact": 1, WEIGHT: 1}, [f"{WEIGHT}/Value=x"]),
                 "less": ({"Bodies/upper/Supports/top": 0.5, "Interfaces/contact": 3, WEIGHT: -0.01},
                          [f"{support}Y=-0.005*(1+x)", f"{support}X=0.0005*x", "Interfaces/contact/Gap=0.006*x", f"{WEIGHT}/Value=-0.01*x"]),
                 "none": ({"Bodies/upper/Supports/top": 2, "Interfaces/contact": 0, WEIGHT: 0},
                          [f"{support}Y=-0.02*(1+x)", f"{support}X=0.002*x", "Interfaces/contact/Gap=0*x", f"{WEIGHT}/Value=0"])}
        # The offsets that a gap gives are in all steps, in a run without a gap they are not: they are not compared there.
        deck, *settings = self.plain("load-cases", *EXACT, *moved, f"{WEIGHT}/Value=x", names(*cases),
                                     *(factors(p, *(c[0][p] for c in cases.values())) for p in cases["all"][0]))
        self.call(deck, *settings)
        found, file = self.cases("load-cases"), self.fields("load-cases")
        for step, (name, (_, by_hand)) in enumerate(cases.items()):
            self.call(*self.plain("load-cases", *EXACT, *moved, *by_hand), folder="alone")
            self.assertAlmostEqual(found[name]["results"]["energy"] / self.summary("load-cases", "alone")["energy"], 1.0, delta=1e-9)
            other = self.fields("load-cases", "alone")
            for axis in "xy":
                self.assertLess(far(file.values("nodal", f"disp_{axis}")[step], other.values("nodal", f"disp_{axis}")[0]), 1e-9)
        self.assertEqual(numpy.abs(file.values("nodal", "offset_y")[2]).max(), 0.0)
        self.assertGreater(numpy.abs(file.values("nodal", "offset_y")[1]).max(), 0.0)

    def test_scale_with_the_loads(self):
        """Without gaps contact is homogeneous: c times the loads is c times the displacement, c^2 times the energy."""
        scales = (1.0, 0.125, 1e3)
        self.call(*self.plain("load-cases", names("one", "small", "large"), factors(PRESS, *scales), factors(WEIGHT, 0, 0, 0)))
        file, found = self.fields("load-cases"), self.cases("load-cases")
        one = found["one"]["results"]
        for step, (case, c) in enumerate(zip(found.values(), scales)):
            results = case["results"]
            self.assertAlmostEqual(results["energy"] / (c**2 * one["energy"]), 1.0, delta=1e-12)
            self.assertAlmostEqual(results["errors"]["global"]["absolute"] / (c * one["errors"]["global"]["absolute"]), 1.0, delta=1e-7)
            self.assertEqual(results["coupling"]["sweeps"], one["coupling"]["sweeps"])
            self.assert_same_step(file, step, file, 1e-11, factor=c)

    def test_order_changes_nothing(self):
        loads = {"a": (1.0, 0.0), "b": (0.2, 0.3), "c": (2.0, 0.1), "d": (0.0, 0.5)}
        for folder, order in (("there", "abcd"), ("back", "dcba")):
            self.call(*self.plain("load-cases", *EXACT, names(*order), factors(PRESS, *(loads[c][0] for c in order)),
                                  factors(WEIGHT, *(loads[c][1] for c in order))), folder=folder)
        there, back = self.fields("load-cases", "there"), self.fields("load-cases", "back")
        for step in range(4):
            self.assert_same_step(there, step, back, 1e-9, other_step=3 - step)
        for name in loads:
            a, b = (self.cases("load-cases", folder)[name]["results"] for folder in ("there", "back"))
            self.assertAlmostEqual(a["energy"] / b["energy"], 1.0, delta=1e-10)

    def test_factor_every_body_once(self):
        for deck, settings, path in (("load-cases", (), PRESS), ("contact-loss-3d", COARSE, PRESS)):
            self.call(*self.plain(deck, *settings, names("a", "b", "c"), factors(path, 1, 2, 0.5)))
            counts = [case["results"]["ledger"]["counts"] for case in self.cases(deck).values()]
            self.assertEqual([count.get("factorisations", 0) for count in counts], [2, 0, 0], deck)
            self.assertEqual([count.get("meshes reused", 0) for count in counts], [0, 2, 2], deck)

    def test_contact_begins_with_that_of_the_case_before(self):
        """The same load again: its statuses are right at once, which from the deck's start they are not."""
        self.call(*self.plain("load-cases", *EXACT, names("first", "again"), factors(PRESS, 1, 1), factors(WEIGHT, 0, 0)))
        first, again = (case["results"]["coupling"]["history"][0] for case in self.cases("load-cases").values())
        self.assertGreater(first["status_changes"], 0)
        self.assertEqual((again["status_changes"], again["status_passes"]), (0, 1))

    def test_a_case_that_is_pulled_off_is_named_and_the_others_are_solved(self):
        done = self.call(*self.plain("load-cases", names("press", "lift", "press again"), factors(PRESS, 1, -1, 1),
                                     factors(WEIGHT, 0, 0, 0)), code=3)
        self.assertIn("2         lift", done.stdout)
        self.assertIn("pulls off upper along +y", done.stdout)
        found, rows = self.cases("load-cases"), self.rows("load-cases")
        self.assertEqual([case["exit_code"] for case in found.values()], [0, 3, 0])
        self.assertIn("pulls off upper", found["lift"]["reason"])
        self.assertIsNone(found["lift"]["results"]["energy"])
        self.assertEqual(rows["lift"]["energy"], "")
        self.assertEqual(list(self.fields("load-cases").times), [1.0, 3.0])
        self.assertEqual({row["case"] for row in self.table("load-cases.contact.csv")}, {"press", "press again"})
        self.assertEqual(found["press"]["results"]["energy"], found["press again"]["results"]["energy"])

    def test_files_of_an_earlier_run_do_not_stand_beside_cases_without_a_solution(self):
        self.call(*self.plain("load-cases", names("press"), factors(PRESS, 1), factors(WEIGHT, 0)))
        self.call(*self.plain("load-cases", names("lift"), factors(PRESS, -1), factors(WEIGHT, 0)), code=3)
        left = sorted(path.name for path in self.folder.iterdir() if path.suffix != ".xml")
        self.assertEqual(left, ["load-cases.cases.csv", "load-cases.summary.json"])

    def test_the_files_of_the_shipped_deck(self):
        done = self.call("load-cases", "Output/Probes/tip/Body=upper", "Output/Probes/tip/At={1, 0.8}")
        self.assertIn("4 cases: 2 factorisations; 6 factors and 6 meshes reused", done.stdout)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         [f"load-cases.{ending}" for ending in ("cases.csv", "contact.csv", "e", "probes.csv", "summary.json")])
        found, rows, file = self.cases("load-cases"), self.rows("load-cases"), self.fields("load-cases")
        self.assertEqual(list(found), ["assembly", "half", "full", "with weight"])
        self.assertEqual(found["with weight"]["factors"], {PRESS: 1.0, WEIGHT: 0.2})
        self.assertEqual(list(file.times), [1.0, 2.0, 3.0, 4.0])
        records = [row.tobytes().split(b"\0")[0].decode() for row in file.data["info_records"][:]]
        self.assertEqual(records[-4:], [f"case {k}: {name}" for k, name in enumerate(found, 1)])
        for step, (name, case) in enumerate(found.items()):
            results, row = case["results"], rows[name]
            self.assertEqual(float(row["energy"]), results["energy"])
            self.assertEqual(float(row[PRESS]), case["factors"][PRESS])
            self.assertEqual(float(row["largest_displacement"]), max(b["largest_displacement"]["value"] for b in results["bodies"]))
            self.assertEqual(float(row["interfaces/contact/contact_force"]), results["interfaces"][0]["contact_force"])
            self.assertEqual(float(row["bodies/lower/supports/ground/force/1"]), results["bodies"][1]["supports"][0]["force"][1])
            for variable, value in (("energy", results["energy"]), ("bound", results["errors"]["global"]["absolute"]), ("guaranteed", 1.0)):
                self.assertEqual(file.values("global", variable)[step][0], value)
            probe = next(p for p in self.table("load-cases.probes.csv") if p["case"] == name)
            self.assertEqual(float(probe["u_y"]), results["probes"][0]["displacement"][1])
        contact = self.table("load-cases.contact.csv")
        for name, case in found.items():
            of_case = [float(row["pressure"]) for row in contact if row["case"] == name]
            self.assertEqual(max(of_case), case["results"]["interfaces"][0]["largest_pressure"])

    def test_results_of_a_case_follow_the_schema_of_a_summary(self):
        import jsonschema

        schema = json.loads((DECKS.parent / "docs/summary.schema.json").read_text())
        self.call("load-cases")
        whole = self.summary("load-cases")
        self.assertEqual(list(whole), ["version", "title", "deck", "cases"])
        for case in whole["cases"]:
            self.assertEqual(list(case), ["name", "factors", "exit_code", "reason", "seconds", "results"])
            jsonschema.validate(case["results"], schema)

    def test_a_deck_of_a_case_runs_alone(self):
        """The summary of a case has its deck, with the loads multiplied."""
        from ndframe import deck_text

        self.call("load-cases")
        case = self.cases("load-cases")["half"]["results"]
        (self.folder / "one.xml").write_text(deck_text({**case["deck"], "Output": {}}))
        self.call(self.folder / "one")
        self.assertEqual(self.summary("one")["energy"], case["energy"])

    def test_expectations_hold_for_all_or_for_one(self):
        wanted = ["Expect/one/Quantity=cases/full/interfaces/contact/contact_force", "Expect/one/Value=0.4", "Expect/one/Tolerance=1e-6"]
        done = self.call("load-cases", *wanted, code=4)
        self.assertEqual(done.stdout.count("missed one: 0.5 instead of 0.4"), 1)
        self.assertEqual([case["exit_code"] for case in self.cases("load-cases").values()], [0, 0, 4, 0])

    def test_with_a_target_every_case_has_files_of_its_own(self):
        self.call(*self.plain("load-cases", "Accuracy/Target=0.03", names("one", "two"), factors(PRESS, 1, 1), factors(WEIGHT, 0, 0.2)))
        left = {path.name for path in self.folder.iterdir()}
        self.assertLessEqual({f"load-cases.{ending}" for ending in ("one.e", "one.summary.json", "two.e", "two.contact.csv", "cases.csv",
                                                                    "summary.json")}, left)
        self.assertNotIn("load-cases.e", left)
        for name, case in self.cases("load-cases").items():
            self.assertLessEqual(case["results"]["errors"]["global"]["relative"], 0.03)
            self.assertEqual(self.summary(f"load-cases.{name}")["energy"], case["results"]["energy"])

    def test_plan_and_check(self):
        plan = self.call("load-cases", switches=["--plan"]).stdout
        self.assertIn("4 cases: the first runs these stages, later ones reuse", plan)
        self.assertIn("supports and loads of upper", plan)
        self.assertIn("load-cases.cases.csv, one row per case; the other files hold all cases", plan)
        self.assertIn("all 4 cases are valid; nothing was solved.", self.call("load-cases", switches=["--check"]).stdout)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_columns_are_checked_and_written(self):
        self.call("load-cases", "Load Cases/Columns={interfaces/contact/contact_length}")
        lengths = [float(row["interfaces/contact/contact_length"]) for row in self.rows("load-cases").values()]
        self.assertTrue(all(math.isfinite(length) and 0.5 < length <= 1.0 for length in lengths), lengths)
        done = self.call("load-cases", "Load Cases/Columns={interfaces/contct/contact_length}", code=2)
        self.assertIn("Load Cases: Columns: \"interfaces/contct/contact_length\" is not a number in a case's summary", done.stderr)


if __name__ == "__main__":
    unittest.main()
