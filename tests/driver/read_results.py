"""Reads what the program writes with other people's tools: read_results.py NDFRAME DECKS SCHEMA.

The Exodus file by netCDF, the summary by a JSON schema validator; the effective deck of the summary runs again.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema
import netCDF4
import numpy

NDFRAME, DECKS, SCHEMA = sys.argv[1:4]
sys.path.insert(0, str(pathlib.Path(DECKS).parent / "python"))
from ndframe import deck_text  # noqa: E402

SIDE_VERTICES = numpy.array([(0, 1), (1, 2), (2, 0)])


class Run:
    """What one run of the program leaves."""

    def __init__(self, deck, *settings):
        arguments = [part for setting in settings for part in ("--set", setting)]
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([NDFRAME, "-q", "-i", deck, *arguments], cwd=folder, check=True)
            files = pathlib.Path(folder)
            self.summary = json.loads(next(files.glob("*.summary.json")).read_text())
            self.exodus = netCDF4.Dataset("memory", memory=next(files.glob("*.e")).read_bytes())
            self.table = [line.split(",") for path in files.glob("*.csv") for line in path.read_text().splitlines()]

    def names(self, variable):
        return [b"".join(row.compressed()).decode() for row in self.exodus[variable][:]]

    def points(self):
        return numpy.stack([self.exodus[f"coord{axis}"][:] for axis in "xyz"[: self.exodus.dimensions["num_dim"].size]], 1)

    def nodal(self, name, step=-1):
        return self.exodus[f"vals_nod_var{self.names('name_nod_var').index(name) + 1}"][step].data

    def element(self, name, block, step=-1):
        return self.exodus[f"vals_elem_var{self.names('name_elem_var').index(name) + 1}eb{block + 1}"][step].data

    def side(self, name, side_set, step=-1):
        number = self.names("ss_names").index(side_set) + 1
        return self.exodus[f"vals_sset_var{self.names('name_sset_var').index(name) + 1}ss{number}"][step].data

    def side_middles(self, side_set):
        number = self.names("ss_names").index(side_set) + 1
        blocks = [self.exodus[f"connect{b + 1}"][:].data for b in range(len(self.names("eb_names")))]
        cells = numpy.concatenate([block[:, :3] for block in blocks]) - 1
        elements, sides = self.exodus[f"elem_ss{number}"][:] - 1, self.exodus[f"side_ss{number}"][:] - 1
        return self.points()[numpy.take_along_axis(cells[elements], SIDE_VERTICES[sides], axis=1)].mean(axis=1)


def shipped(name):
    return str(pathlib.Path(DECKS) / f"{name}.xml")


def results(summary):
    """A summary without what differs from run to run."""
    kept = {key: value for key, value in summary.items() if key != "ledger"}
    return kept | {"counts": {k: n for k, n in summary["ledger"]["counts"].items() if k != "bytes written"}}


class ExodusFile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.loss = Run(shipped("contact-loss"))
        cls.sweeps = Run(shipped("contact-loss"), "Output/Steps=All Sweeps")
        cls.patch = Run(shipped("patch"), "Coupling/Type=Monolithic", "Expect/sweeps by the closed form/Value=1")
        cls.beam = Run(shipped("beam-3d"))

    def test_bodies_are_blocks(self):
        self.assertEqual(self.loss.names("eb_names"), ["upper", "lower"])
        for block, body in enumerate(self.loss.summary["bodies"]):
            connectivity = self.loss.exodus[f"connect{block + 1}"]
            self.assertEqual(connectivity.elem_type, "TRI6")
            self.assertEqual(len(connectivity), body["elements"])
        self.assertEqual(2 * len(self.loss.points()), sum(body["dofs"] for body in self.loss.summary["bodies"]))

    def test_order_one_gives_linear_elements(self):
        linear = Run(shipped("punch"), "Discretization/Order=1")
        self.assertEqual(linear.exodus["connect1"].elem_type, "TRI3")

    def test_one_step_or_one_per_sweep(self):
        count = self.sweeps.summary["coupling"]["sweeps"]
        self.assertGreater(count, 2)
        numpy.testing.assert_array_equal(self.loss.exodus["time_whole"][:], [count])
        numpy.testing.assert_array_equal(self.sweeps.exodus["time_whole"][:], numpy.arange(1, count + 1))
        for name in ("disp_x", "disp_y"):
            numpy.testing.assert_allclose(self.sweeps.nodal(name), self.loss.nodal(name), atol=1e-12)
        globals_ = self.sweeps.exodus["vals_glo_var"][:]
        eps = [record["eps_tau"] for record in self.sweeps.summary["coupling"]["history"]]
        numpy.testing.assert_allclose(globals_[:, self.sweeps.names("name_glo_var").index("eps_tau")], eps)
        converged = globals_[:, self.sweeps.names("name_glo_var").index("converged")]
        numpy.testing.assert_array_equal(converged, [0] * (count - 1) + [1])

    def test_displacement_of_the_patch(self):
        x, y = self.patch.points().T
        upper = numpy.arange(len(x)) < self.patch.summary["bodies"][0]["dofs"] // 2
        numpy.testing.assert_allclose(self.patch.nodal("disp_x"), numpy.where(upper, 0.39, 0.195) * x, atol=1e-11)
        exact = numpy.where(upper, -0.455 - 0.91 * y, -0.455 * (y + 1))
        numpy.testing.assert_allclose(self.patch.nodal("disp_y"), exact, atol=1e-11)

    def test_stress_and_von_mises_of_the_patch(self):
        exact = {"stress_xx": 0, "stress_yy": -1, "stress_zz": -0.3, "stress_xy": 0, "von_mises": numpy.sqrt(0.79)}
        for block in (0, 1):
            for name, value in exact.items():
                numpy.testing.assert_allclose(self.patch.element(name, block), value, atol=1e-10, err_msg=name)
        for name, value in (exact | {"stress_yz": 0, "stress_zx": 0}).items():
            numpy.testing.assert_allclose(self.patch.nodal(name), value, atol=1e-10, err_msg=name)

    def test_offset_draws_bodies_with_a_gap_apart(self):
        hertz = Run(shipped("hertz"), "Coupling/Dirichlet Body=As Given")  # offsets move the Dirichlet body
        header, *rows = hertz.table
        closed = {float(row[1]): row[header.index("closed")] == "1" for row in rows}
        first = hertz.summary["bodies"][0]["dofs"] // 2
        heights = [{}, {}]
        for node, ((x, y), moved) in enumerate(zip(hertz.points(), hertz.nodal("disp_y") + hertz.nodal("offset_y"))):
            if y == 0:
                heights[node >= first][x] = moved
        for x, is_closed in closed.items():
            opening = heights[0][x] - heights[1][x]
            self.assertAlmostEqual(opening, 0, places=12) if is_closed else self.assertGreater(opening, 0)
        upper = hertz.points()[:first]
        numpy.testing.assert_allclose(hertz.nodal("offset_y")[:first], upper[:, 0] ** 2 / 2, atol=2e-2)
        self.assertEqual(abs(hertz.nodal("offset_y")[first:]).max(), 0)
        self.assertNotIn("offset_x", self.loss.names("name_nod_var"), "no gap, no offset")

    def test_a_solid_has_six_stresses_and_no_contact(self):
        self.assertEqual(self.beam.exodus["connect1"].elem_type, "TETRA10")
        # ParaView joins a tensor's components by these names in this order.
        names = ["stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx", "von_mises"]
        self.assertEqual(self.beam.names("name_nod_var"), ["disp_x", "disp_y", "disp_z", *names])
        self.assertEqual(self.beam.names("name_elem_var"), names)
        self.assertNotIn("num_sset_var", self.beam.exodus.dimensions)
        middles = self.beam.points()[self.beam.exodus["connect1"][:, :4] - 1].mean(axis=1)
        numpy.testing.assert_allclose(self.beam.element("stress_xx", 0), middles[:, 1], atol=1e-10)
        numpy.testing.assert_allclose(self.beam.nodal("stress_xx"), self.beam.points()[:, 1], atol=1e-10)

    def test_contact_stands_on_both_side_sets(self):
        for body in ("dirichlet", "neumann"):
            side_set = f"contact:{body}"
            middles = self.loss.side_middles(side_set)
            numpy.testing.assert_allclose(middles[:, 1], 0, atol=1e-14)
            status, gap = (self.loss.side(f"contact_{name}", side_set) for name in ("status", "gap"))
            pressure = self.loss.side("contact_pressure", side_set)
            numpy.testing.assert_array_equal(status[middles[:, 0] < 0.9], 1)
            self.assertEqual(status[middles[:, 0] > 0.97].max(), 0)
            numpy.testing.assert_allclose(gap[status == 1], 0, atol=1e-12)
            self.assertGreater(gap[status == 0].max(), 1e-4)
            self.assertGreater(pressure[middles[:, 0] < 0.5].min(), 0.3)
            # Facets of equal length, 1 in all: their mean pressure carries the resultant of this side's traction.
            resultant = self.loss.summary["coupling"]["history"][-1][f"force_on_{body}"]
            self.assertAlmostEqual(pressure.mean(), -resultant, places=12)

    def test_nodal_pressure_is_that_of_the_table(self):
        header, *rows = self.loss.table
        pressure = {float(row[1]): float(row[header.index("pressure")]) for row in rows}
        upper = self.loss.summary["bodies"][0]["dofs"] // 2
        points, values = self.loss.points()[:upper], self.loss.nodal("contact_pressure")[:upper]
        for (x, y), value in zip(points, values):
            self.assertAlmostEqual(value, pressure[x] if y == 0 else 0.0, places=12)


class Certificate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = Run(shipped("certificate"))
        cls.errors = cls.run_.summary["errors"]
        cls.loss = Run(shipped("contact-loss"), "Error Estimation/Mode=Strict", "Interfaces/contact/Gap=1e-3 * x^2")

    def areas(self, block):
        corners = self.run_.points()[self.run_.exodus[f"connect{block + 1}"][:, :3] - 1]
        (ax, ay), (bx, by) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
        return (ax * by - ay * bx) / 2

    def test_contributions_of_the_elements_add_up(self):
        for run in (self.run_, self.loss):
            for name, key in (("eta_glob", "global"), ("eta_dis", "discretization"), ("eta_nda", "algorithm")):
                squares = sum((run.element(name, block) ** 2).sum() for block in (0, 1))
                measure = run.summary["errors"][key]
                total = measure["elements"] ** 2 + measure["contact"] ** 2
                self.assertAlmostEqual(squares / total, 1, places=10, msg=name)
        self.assertGreater(self.loss.summary["errors"]["global"]["contact"], 0)

    def test_parts_add_up_to_the_measure(self):
        for run in (self.run_, self.loss):
            for key in ("global", "discretization", "algorithm"):
                part = run.summary["errors"][key]
                total = numpy.hypot(part["elements"], part["contact"]) + part["projection"] + part["oscillation"]
                if key == "algorithm" or part["contact"] == part["projection"] == part["oscillation"] == 0:
                    self.assertAlmostEqual(part["absolute"] / total, 1, places=12, msg=key)
                self.assertLess(part["absolute"], total * (1 + 1e-12), msg=key)
                self.assertGreater(part["absolute"], part["elements"] * (1 - 1e-12), msg=key)
                self.assertAlmostEqual(part["absolute"] / run.summary["energy"] ** 0.5, part["relative"], places=12)

    def test_admissible_pressure_is_nothing_where_the_gap_is_open(self):
        pressure, status = (self.loss.side(name, "contact:dirichlet") for name in ("admissible_pressure", "contact_status"))
        self.assertGreaterEqual(pressure.min(), -1e-12)
        self.assertAlmostEqual(pressure.mean(), 0.5, places=10)  # half of the top is under pressure 1
        self.assertLess(pressure[status == 0].max(), 0.1)
        self.assertGreater((status == 0).sum(), 0)

    def test_admissible_pressure_presses_and_carries_the_load(self):
        pressure, other = (self.run_.side("admissible_pressure", f"contact:{body}") for body in ("dirichlet", "neumann"))
        numpy.testing.assert_array_equal(pressure, other)
        self.assertGreater(pressure.min(), 0)
        self.assertAlmostEqual(pressure.mean(), 1, places=10)  # facets of equal length, 1 in all

    def test_equilibrated_stress_of_the_punch_has_the_means_of_its_loads(self):
        # int sigma = int (sigma n) x: pressure 1 at y = 1, nothing along x, no friction.
        areas = self.areas(0)
        for name, mean in (("xx", 0), ("yy", -1)):
            values = self.run_.element(f"sigma_hat_{name}", 0)
            self.assertAlmostEqual((areas * values).sum() / areas.sum(), mean, places=9, msg=name)

    def test_mean_stress_lies_between_the_two(self):
        self.assertLess(self.errors["global"]["projection"], 1e-12)
        for block in (0, 1):
            for name in ("xx", "yy", "xy"):
                computed, equilibrated = (self.run_.element(f"{kind}_{name}", block) for kind in ("stress", "sigma_hat"))
                mean = self.run_.element(f"mean_stress_{name}", block)
                numpy.testing.assert_allclose(mean, (computed + equilibrated) / 2, atol=1e-11)

    def test_is_of_the_last_step_only(self):
        sweeps = Run(shipped("certificate"), "Output/Steps=All Sweeps", "Error Estimation/Estimators={Global}",
                     "Expect/the bound is above the error, and near it/Quantity=errors/global/guaranteed")
        for value in (sweeps.element("eta_glob", 0, 0), sweeps.side("admissible_pressure", "contact:dirichlet", 0)):
            self.assertTrue(numpy.isnan(value).all())
        self.assertFalse(numpy.isnan(sweeps.element("eta_glob", 0)).any())

    def test_writes_only_what_was_estimated(self):
        algorithm = Run(shipped("punch"), "Error Estimation/Estimators={Algorithm}")
        added = set(algorithm.names("name_elem_var")) - set(Run(shipped("punch")).names("name_elem_var"))
        self.assertEqual(added, {"eta_nda"})


class Summary(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.runs = {name: Run(shipped(name)) for name in ("punch", "contact-loss", "beam-3d", "patch", "certificate")}

    def test_follows_the_schema(self):
        validator = jsonschema.Draft7Validator(json.loads(pathlib.Path(SCHEMA).read_text()))
        for run in self.runs.values():
            validator.validate(run.summary)

    def test_effective_deck_gives_the_same_run(self):
        for name, run in self.runs.items():
            with self.subTest(deck=name), tempfile.TemporaryDirectory() as folder:
                deck = pathlib.Path(folder) / f"{name}.xml"
                deck.write_text(deck_text(run.summary["deck"], name))
                self.assertEqual(results(Run(str(deck)).summary), results(run.summary))

    def test_has_every_number_of_the_certificate(self):
        errors = self.runs["certificate"].summary["errors"]
        measure = {"absolute", "relative", "elements", "contact", "projection", "oscillation"}
        self.assertEqual(errors["global"].keys(), measure | {"guaranteed", "reason"})
        for key in ("algorithm", "discretization"):
            self.assertEqual(errors[key].keys(), measure)
        self.assertEqual(errors["mean_stress"].keys(), {"absolute", "relative"})
        self.assertIs(errors["global"]["guaranteed"], True)
        self.assertEqual(errors["global"]["reason"], "")
        self.assertEqual([key for key, value in errors.items() if value is None], [])
        self.assertEqual([key for key, value in errors["reference"].items() if value is None], [])

    def test_says_nothing_of_errors_without_the_list(self):
        for name in ("punch", "contact-loss", "beam-3d", "patch"):
            run = self.runs[name]
            self.assertIsNone(run.summary["errors"])
            stages = [stage["name"] for stage in run.summary["ledger"]["stages"]]
            self.assertEqual([stage for stage in stages if stage.startswith("certify")], [])
            self.assertEqual([count for count in run.summary["ledger"]["counts"] if "star" in count], [])
            fields = run.names("name_elem_var") + (run.names("name_sset_var") if run.summary["interfaces"] else [])
            self.assertEqual([name for name in fields if name.startswith(("eta", "sigma", "mean", "adm"))], [])

    def test_energies_add_up(self):
        for run in self.runs.values():
            self.assertAlmostEqual(run.summary["energy"], sum(body["energy"] for body in run.summary["bodies"]), places=12)

    def test_forces_balance(self):
        contact = self.runs["contact-loss"].summary["interfaces"][0]
        numpy.testing.assert_allclose(contact["force_on_dirichlet"], [0, 0.5], atol=1e-10)
        last = self.runs["contact-loss"].summary["coupling"]["history"][-1]
        numpy.testing.assert_allclose(contact["force_on_neumann"], [0, last["force_on_neumann"]], atol=1e-12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
