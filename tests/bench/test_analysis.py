"""ndbench on made-up numbers: fits, medians, the fastest settings, tables, brackets, costs of a child.

Usage: test_analysis.py SOURCE_FOLDER
"""

import math
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv.pop(1)) / "apps/ndbench"))

from bench import accuracy, analysis, campaign, last_mesh, methods, overlap, page, program, references, targets, truth
from bench.child import cost_of
from bench.program import Run
from bench.scenes import SCENES


def timed(method, seconds, error, spread=0.0):
    return {"scene": "s", "method": method, "size": "1 cells", "dofs": 10, "seconds": seconds, "error_high": error,
            "seconds_least": seconds - spread, "seconds_most": seconds + spread}


class Analysis(unittest.TestCase):
    def test_fit_finds_the_exponent_of_a_power_law(self):
        exponent, factor = analysis.power_law([(x, 3e-6 * x**1.25) for x in (1e3, 7e3, 4e4, 1e6)])
        self.assertAlmostEqual(exponent, 1.25, 12)
        self.assertAlmostEqual(factor, 3e-6, 15)

    def test_fit_is_least_squares(self):
        """Residuals of the logarithms are orthogonal to 1 and log x."""
        points = [(1, 1), (2, 5), (8, 9), (16, 100)]
        exponent, factor = analysis.power_law(points)
        residuals = [math.log(y / (factor * x**exponent)) for x, y in points]
        self.assertAlmostEqual(sum(residuals), 0, 12)
        self.assertAlmostEqual(sum(r * math.log(x) for r, (x, _) in zip(residuals, points)), 0, 12)

    def test_the_start_does_not_flatter_the_exponent(self):
        points = [(x, 0.08 + 3e-6 * x**1.25) for x in (1e3, 1e4, 1e5)]
        whole, without_start = analysis.exponents(points, 0.08)
        self.assertLess(whole, 1.0)
        self.assertAlmostEqual(without_start, 1.25, 12)
        self.assertEqual(analysis.exponents([(1, 0.01), (2, 0.02), (3, 0.09)], 0.08)[1], None)

    def test_settings_within_the_spread_of_the_repetitions_are_a_tie(self):
        for spread, is_tie in ((0.02, False), (0.06, True)):
            rows = [timed("a", 1.0, 0.3, spread), timed("b", 1.1, 0.3, spread)]
            self.assertEqual([analysis.tied(*rows), analysis.tied(*rows[::-1])], [is_tie] * 2)
            self.assertEqual("b, 1 cells: 1.1 s (tie) |" in page.fastest_table(rows), is_tie)

    def test_median_ignores_what_does_not_exist(self):
        self.assertEqual(analysis.median([3, None, 1, 10]), 3)
        self.assertIsNone(analysis.median([None]))

    def test_fastest_setting_of_each_error(self):
        rows = [timed("a", 1, 0.3), timed("b", 2, 0.09), timed("a", 3, 0.04), timed("b", 9, 0.001)]
        found = [(level, row["seconds"], other and other["seconds"]) for level, row, other in analysis.fastest(rows)]
        self.assertEqual(found, [(0.5, 1, 2), (0.1, 2, 3), (0.05, 3, 9), (0.001, 9, None)])

    def test_a_slow_exact_run_never_beats_a_fast_good_one(self):
        rows = [timed("slow", 100, 1e-9), timed("fast", 1, 0.01)]
        self.assertEqual(analysis.fastest(rows, (0.1, 0.05))[-1][1]["method"], "fast")

    def test_page_replaces_only_its_place(self):
        text = "above\n<!-- ndbench t -->\nold\n<!-- end -->\nbelow <!-- end -->\n"
        replaced = "above\n<!-- ndbench t -->\n\nnew\n<!-- end -->\nbelow <!-- end -->\n"
        self.assertEqual(page.between(text, "t", "new"), replaced)
        with self.assertRaises(SystemExit):
            page.between(text, "other", "new")

    def test_verdicts(self):
        below, above = targets.Target("", "", 1.6, 1.3, None), targets.Target("", "", 1.4, 1.7, None, least=True)
        self.assertEqual([below.verdict(v) for v in (1.3, 1.5, 1.7)], ["aim", "must", "no"])
        self.assertEqual([above.verdict(v) for v in (1.7, 1.5, 1.3)], ["aim", "must", "no"])


class Accuracy(unittest.TestCase):
    """Uniform meshes beside a run with a target."""

    def found(self, wanted, error_of):
        looked_at = []

        def error(cells):
            looked_at.append(cells)
            return error_of(cells)

        return accuracy.cells_for(wanted, error, (8, 16), lambda cells: cells > 500), looked_at

    def test_cells_are_the_fewest_for_the_error(self):
        """Of even numbers, whether the error is a power of the cells or bends."""
        for error_of in (lambda n: 0.7 * n**-0.76, lambda n: 0.7 * n**-0.76 + 3 / n**2, lambda n: 40 * n**-2.0):
            for wanted in (0.02, 0.05, 0.2):
                cells, looked_at = self.found(wanted, error_of)
                self.assertLessEqual(error_of(cells), wanted)
                self.assertGreater(error_of(cells - accuracy.STEP), wanted)
                self.assertLess(len(looked_at), 12)

    def test_meshes_that_are_too_large_are_predicted_only(self):
        cells, looked_at = self.found(0.001, lambda n: n**-0.75)
        self.assertAlmostEqual(cells / 0.001 ** (-1 / 0.75), 1, 2)
        self.assertEqual(looked_at, [8, 16])

    def test_a_target_replaces_the_meshes_and_keeps_the_scene(self):
        case = campaign.Case(SCENES[0], methods.ADAPTIVE, 0.00455)
        self.assertEqual(case.method.on(case.scene, case.size), ("Accuracy/Target=0.00455",))
        self.assertEqual((str(case), case.alone), ("punch, adaptive, certified, target 0.455 %", None))
        self.assertNotIn("beam-3d", [case.scene.name for case in campaign.cases(9, methods=(methods.ADAPTIVE,))])

    def test_the_last_mesh_has_the_sides_of_its_bodies(self):
        press, ground, weight = {"Type": "Pressure", "Side": "top"}, {"Side": "bottom"}, {"Type": "Body Force"}
        bodies = {"a": {"Supports": {}, "Loads": {"press": press, "weight": weight}},
                  "b": {"Supports": {"ground": ground}, "Loads": {}}}
        contact = {"Dirichlet Body": "a", "Dirichlet Side": "bottom", "Neumann Body": "b", "Neumann Side": "top"}
        settings = list(last_mesh.on_its_mesh({"deck": {"Bodies": bodies, "Interfaces": {"c": contact}}}, "/m.e"))
        self.assertEqual(settings[:3], [f"Bodies/a/Mesh/{text}" for text in ("Type=Exodus", "File=/m.e", "Blocks={a}")])
        self.assertEqual([text for text in settings if "Side=" in text], [
            "Bodies/a/Loads/press/Side=a:top", "Bodies/b/Supports/ground/Side=b:bottom",
            "Interfaces/c/Dirichlet Side=a:bottom", "Interfaces/c/Neumann Side=b:top"])

    def test_seconds_of_short_runs_are_the_least_without_their_files(self):
        def done(total):
            seconds = {"read": 1, "factor": 2, "write": 4}
            stages = [{"name": name, "seconds": value} for name, value in seconds.items()]
            return Run(None, {"ledger": {"total_seconds": total, "stages": stages}}, [])

        pairs = [(done(20), done(11)), (done(17), done(12))]
        self.assertEqual(last_mesh.least(pairs, lambda one: one.solving_seconds), [12, 6])

    def test_a_mesh_that_is_not_run_shows_its_size(self):
        row = {"scene": "s", "target": 0.001, "beside": "its bound", "dofs": 12_345_678, "wall": None}
        self.assertIn("| some 12,000,000 | ", page.accuracy_table([row]))


class Truth(unittest.TestCase):
    def test_bracket_is_exact_for_bounds_of_one_effectivity(self):
        exact, effectivity = -1.6, 1.07
        meshes = [(exact + error**2, effectivity * error) for error in (1e-2, 3e-3)]
        best, low, high = references.bracket(*meshes)
        self.assertAlmostEqual(best, exact, 14)
        self.assertTrue(low <= exact <= high)

    def test_bracket_holds_the_best_value_whatever_the_meshes_say(self):
        for coarse in (-1.7, -1.0, 5.0):
            best, low, high = references.bracket((coarse, 1e-2), (-1.5, 1e-3))
            self.assertTrue(low <= best <= high)

    def test_work_on_an_edge_is_exact(self):
        """int t u dS for t = 1 + x and u = x^2 on [0, 2] in two edges: 4/3 * 2 + 4."""
        nodes = [{"x": x, "t": 1 + x, "u": x * x} for x in (2.0, 0.0, 0.75, 1.5, 1.75)]
        self.assertAlmostEqual(truth.work(nodes, 2, "t", "u"), 8 / 3 + 4, 13)

    def test_points_of_a_facet_integrate_linear_functions(self):
        found = list(overlap.points())
        self.assertEqual(len(found), overlap.PARTS**2)
        for place in range(2):
            self.assertAlmostEqual(sum(point[place] for point in found) / len(found), 1 / 3, 14)

    def test_functions_of_a_facet_are_those_of_its_nodes(self):
        nodes = ((1, 0), (0, 1), (0, 0), (0.5, 0.5), (0, 0.5), (0.5, 0))  # of a and b: corners, middles of 01, 12, 20
        for i, node in enumerate(nodes):
            self.assertEqual(overlap.quadratic(*node), [float(i == j) for j in range(6)])

    def test_solids_with_a_gap_have_the_energy_of_their_load_and_lose_what_overlaps(self):
        run = Run(None, {"energy": 3.0}, [], {"work": 5.0, "points": [[3.0, 4.0, 0.5], [60.0, 80.0, 0.5]]})
        self.assertEqual(truth.twice_potential(run), -7.0)
        exact = truth.Exact(0.0, 0.0, 0.0, 0.0, ((0.0, -4.0), (10.0, 0.0)))
        self.assertAlmostEqual(truth.contact_term(run, None, exact), 2 * 0.5 * -2.0, 14)

    def test_pressures_round_an_axis_are_means_of_rings(self):
        rows = [{"x": x, "y": y, "pressure": p} for x, y, p in ((0, 0, 4), (0.3, 0, 1), (0, 0.3, 2), (0.5, 0, 0), (0.9, 0, 0))]
        found = references.pressures(Run(None, None, rows, {"work": 0.0, "points": []}))
        self.assertEqual([round(x, 12) for x, _ in found], [0.0, 0.3, 0.5])
        self.assertEqual([t for _, t in found], [-4.0, -1.5, 0.0])

    def test_an_error_the_reference_cannot_resolve_is_not_sharp(self):
        self.assertFalse(truth.TrueError(1.0, 0.8, 1.1).sharp)
        self.assertTrue(truth.TrueError(1.0, 0.9, 1.1).sharp)

    def test_stored_brackets_resolve_a_thousandth_in_the_plane(self):
        for name, exact in references.load().items():
            self.assertTrue(exact.low <= exact.best <= exact.high < 0, name)
            self.assertLess(exact.high - exact.low, (1e-2 if name.endswith("-3d") else 1e-3) ** 2 * exact.norm**2, name)


class Decks(unittest.TestCase):
    def test_a_bare_deck_lacks_two_lists_and_nothing_else(self):
        deck = next(scene for scene in SCENES if scene.joins_solids).deck
        with tempfile.TemporaryDirectory() as folder:
            lists = [xml.etree.ElementTree.parse(path).getroot() for path in (deck, program.bare(deck, folder))]
        whole, left = ({entry.get("name"): xml.etree.ElementTree.tostring(entry) for entry in one} for one in lists)
        self.assertEqual(set(whole) - set(left), {"Error Estimation", "Expect"})
        self.assertLessEqual(left.items(), whole.items())


class Child(unittest.TestCase):
    def test_cost_is_the_childs_own(self):
        heavy = "x = bytearray(200_000_000)\nfor i in range(10**6): pass\nprint('said'); raise SystemExit(4)"
        with tempfile.TemporaryDirectory() as folder:
            light, _ = cost_of(["true"], folder)
            cost, text = cost_of([sys.executable, "-c", heavy], folder)
        self.assertEqual((light.exit, cost.exit, text), (0, 4, "said\n"))
        self.assertGreater(cost.peak, 200_000_000)
        self.assertGreater(cost.cpu, 0)
        self.assertLess(light.peak, 40_000_000, "a child starts with the resident size of this process: keep it small")

    def test_measuring_imports_nothing_large(self):
        self.assertTrue(campaign and not {"numpy", "matplotlib"} & set(sys.modules))


if __name__ == "__main__":
    unittest.main()
