"""ndstress must see every kind of wrong answer: results altered on purpose, and right ones left alone."""

import csv
import dataclasses
import json
import math
import pathlib
import sys
import tempfile
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "apps/ndstress"))
import cells  # noqa: E402
import judge  # noqa: E402
import picture  # noqa: E402
import reference  # noqa: E402
import rows  # noqa: E402
import scenes  # noqa: E402

SCENE = scenes.lifting()
ANSWER = reference.solve(SCENE)
NAMES = ("interface", "x", "y", "u_dirichlet", "u_neumann", "gap", "traction_dirichlet", "nodal_force", "closed")


def run(code, err=""):
    return types.SimpleNamespace(returncode=code, stdout="", stderr=err)


class Judge(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)
        self.table = [dict(zip(NAMES, ("contact", *map(float, (x, 0, -up, -low, 0, 0, -force, 0)))))
                      for x, up, low, force in zip(ANSWER.points, ANSWER.u_upper, ANSWER.u_lower, ANSWER.force)]
        energies = [float(e) for e in ANSWER.energies]
        self.summary = {"bodies": [{"name": name, "energy": e} for name, e in zip(("upper", "lower"), energies)],
                        "interfaces": [{"dirichlet_body": "upper"}], "coupling": {"converged": True}, "errors": None,
                        "energy": sum(energies), "residuals": {"equilibrium": 1e-15}}

    def verdict(self, process, answer=lambda: ANSWER):
        with (self.folder / "deck.contact.csv").open("w") as file:
            writer = csv.DictWriter(file, NAMES)
            writer.writeheader()
            writer.writerows(self.table)
        (self.folder / "deck.summary.json").write_text(json.dumps(self.summary))
        return judge.judge(process, SCENE, answer, self.folder)

    def test_the_right_answer_is_right(self):
        self.assertEqual(self.verdict(run(0)).outcome, judge.RIGHT)
        self.assertGreater(self.verdict(run(0)).digits, 15)

    def test_any_quantity_that_is_off_is_seen(self):
        for name in ("u_dirichlet", "u_neumann", "nodal_force"):
            with self.subTest(name):
                self.setUp()
                max(self.table, key=lambda row: abs(row[name]))[name] *= 1 + 1e-4
                self.assertEqual(self.verdict(run(0)).outcome, judge.FINDING)
        self.setUp()
        self.summary["bodies"][1]["energy"] *= 1 + 1e-5
        self.assertIn("energy of lower has 5.0 digits", self.verdict(run(0)).text)

    def test_a_body_at_rest_is_measured_against_the_one_that_moves(self):
        for expected, found, digits in ((0.0, 1e-10, 10), (1e-9, 2e-9, 9), (1e-6, 1e-6 + 1e-10, 4), (2.0, 2.0002, 4)):
            self.assertAlmostEqual(judge.digits_of([found], [expected], 1.0, judge.SMALL_MOVE), digits, places=5)

    def test_numbers_that_are_none_are_seen(self):
        self.table[3]["gap"] = math.nan
        for code in (0, 3):
            self.assertIn("not a number: gap in deck.contact.csv", self.verdict(run(code, "not converged: x")).text)
        self.setUp()
        self.summary["energy"] = None
        self.assertIn("not a number", self.verdict(run(0)).text)

    def test_a_run_without_solution_may_leave_out_its_numbers_but_all_of_them(self):
        stop = run(3, "not converged: the load pulls the bodies apart")
        self.summary |= {"energy": None, "residuals": {"equilibrium": None}}
        self.summary["coupling"]["converged"] = False
        self.assertIn("not a number", self.verdict(stop).text)  # the energies of the bodies are there
        for body in self.summary["bodies"]:
            body["energy"] = None
        self.assertIn("not a number", self.verdict(stop).text)  # so is the contact table
        (self.folder / "deck.contact.csv").unlink()
        self.assertEqual(judge.judge(stop, SCENE, None, self.folder).outcome, judge.STOPPED)
        self.assertIn("not a number", judge.judge(run(0), SCENE, None, self.folder).text)

    def test_what_is_measured_against_a_floor_is_marked(self):
        self.assertFalse(self.verdict(run(0)).floored)
        resting = dataclasses.replace(ANSWER, u_lower=1e-9 * ANSWER.u_lower)
        for row in self.table:
            row["u_neumann"] *= 1e-9
        marked = self.verdict(run(0), lambda: resting)
        self.assertEqual((marked.outcome, marked.floored), (judge.RIGHT, True))

    def test_a_force_below_the_floor_counts_from_it_and_above_it_does_not(self):
        scene = rows.touching(1e-6)
        answer = reference.solve(scene)
        table = [{"x": x, "u_dirichlet": -up, "u_neumann": -low, "nodal_force": -1.001 * force}
                 for x, up, low, force in zip(answer.points, answer.u_upper, answer.u_lower, answer.force)]
        energies = [{"name": name, "energy": float(e)} for name, e in zip(("upper", "lower"), answer.energies)]
        summary = {"bodies": energies, "interfaces": [{"dirichlet_body": "upper"}]}
        digits, floored = judge.compare(answer, scene, table, summary, 1e-9)
        self.assertAlmostEqual(digits["contact force"], 3.0, places=5)
        self.assertFalse(floored)
        largest = float(answer.force.max()) / (scene.upper.young * float(answer.move))
        digits, floored = judge.compare(answer, scene, table, summary, 1e3 * largest)
        self.assertAlmostEqual(digits["contact force"], 6.0, places=5)
        self.assertTrue(floored)

    def test_a_guaranteed_bound_below_the_error_is_seen(self):
        for guaranteed, bound, outcome in ((True, 0.9, judge.FINDING), (False, 0.9, judge.RIGHT),
                                           (True, 1.1, judge.RIGHT)):
            self.summary["errors"] = {"global": {"guaranteed": guaranteed, "absolute": bound},
                                      "reference": {"displacement": 1.0}}
            self.assertEqual(self.verdict(run(0)).outcome, outcome)

    def test_an_answer_where_nothing_holds_the_body_is_wrong(self):
        def unheld():
            raise reference.Unheld
        self.assertEqual(self.verdict(run(0), unheld).outcome, judge.FINDING)

    def test_crash_and_hang_are_findings(self):
        for process in (run(1, "a bug"), run(-11), None):
            self.assertEqual(self.verdict(process).outcome, judge.FINDING)

    def test_stopping_needs_a_reason_and_a_mark(self):
        self.assertEqual(self.verdict(run(3, "not converged: why")).text,
                         "stopped without saying so")  # marked as converged
        self.summary["coupling"]["converged"] = False
        self.assertEqual(self.verdict(run(3, "not converged: why")).outcome, judge.STOPPED)
        self.assertEqual(self.verdict(run(3)).outcome, judge.FINDING)

    def test_a_missing_certificate_is_a_stop_unless_there_is_one(self):
        self.summary["errors"] = None
        self.assertEqual(self.verdict(run(3, "no certificate: why")).outcome, judge.STOPPED)
        self.summary["errors"] = {"global": {}}
        self.assertEqual(self.verdict(run(3, "no certificate: why")).outcome, judge.FINDING)

    def test_refusing_needs_a_message_and_leaves_no_results(self):
        refusal = run(2, "deck.xml:3: wrong\n1 error; nothing was computed.")
        self.assertEqual(self.verdict(refusal).text, "refused, yet results written")
        (self.folder / "deck.summary.json").unlink()
        self.assertEqual(judge.judge(refusal, SCENE, None, self.folder).outcome, judge.REFUSED)
        self.assertEqual(judge.judge(run(2), SCENE, None, self.folder).outcome, judge.FINDING)

    def test_an_outcome_other_than_the_demanded_one_is_a_finding(self):
        row = next(i for i, r in enumerate(cells.ROWS) if 12.0 in r.must)
        result = cells.Result(cells.Cell(row, 12.0, "Aitken"), judge.Verdict(judge.RIGHT, 9.0), 0.1)
        self.assertIn("right instead of stopped", result.finding)
        self.assertEqual(dataclasses.replace(result, verdict=judge.Verdict(judge.STOPPED)).finding, "")

    def test_the_other_degree_and_several_ranks_run_where_a_row_asks_for_them(self):
        for short, least, methods in ((False, 20, cells.VARIANTS), (True, 4, cells.SHORT_VARIANTS)):
            found = [cell for cell in cells.cells(short, "") if cell.method in cells.VARIANTS]
            self.assertGreaterEqual(len(found), least * len(methods))
            self.assertEqual({cell.method for cell in found}, set(methods))
            for cell in found:
                row = cells.ROWS[cell.row]
                self.assertIn(cell.value, row.short if short else row.values)

    def test_labels_of_the_picture_tell_all_values_apart(self):
        for row in cells.ROWS:
            self.assertEqual(len(set(picture.labels(row.values))), len(row.values), row.name)
        self.assertEqual(picture.labels((5.999999, 6.0, 1e-12, 0.0)), ["5.999999", "6", "1e-12", "0"])


if __name__ == "__main__":
    unittest.main()
