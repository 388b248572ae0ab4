"""nddiff on files altered on purpose: test_nddiff.py REGRESSION."""

import json
import pathlib
import sys
import unittest

import netCDF4
import numpy

REGRESSION = pathlib.Path(sys.argv[1]).resolve()
sys.path[:0] = [str(REGRESSION), str(pathlib.Path(__file__).parent)]

from called import Called  # noqa: E402
from harness.nddiff import main  # noqa: E402
from small_exodus import SmallExodus  # noqa: E402

NAN = float("nan")
PERMUTED = {"nodes": (7, 2, 5, 0, 8, 4, 1, 6, 3), "elements": ((2, 0, 1), (1, 0))}


class Comparison(Called):
    program = staticmethod(main)


class ExodusFiles(Comparison):
    def setUp(self):
        super().setUp()
        self.gold_file, self.new_file = SmallExodus(), SmallExodus()

    def files(self):
        return self.gold_file.write(self.folder / "gold.e"), self.new_file.write(self.folder / "new.e")

    def same(self, *options):
        self.assert_success(*self.files(), *options)

    def different(self, words, *options):
        self.assert_failure(words, *self.files(), *options)

    def test_the_same_file_is_the_same(self):
        self.same()

    def test_one_ulp_passes(self):
        for values in [*self.new_file.nodal.values(), *self.new_file.element["stress_xx"].values()]:
            values[:] = numpy.nextafter(values, numpy.inf)
        self.same()

    def test_one_ulp_is_seen_when_asked_for(self):
        self.new_file.nodal["disp_x"][1, 2] = numpy.nextafter(self.new_file.nodal["disp_x"][1, 2], 9)
        self.different("disp_x", "--set", "default=absolute 0")

    def test_one_wrong_node_fails_and_is_shown(self):
        self.new_file.nodal["disp_x"][1, 3] += 1e-6
        self.different(["disp_x", "step 2  node 4 at (1, 1)", "1 of 18"])

    def test_the_worst_place_is_shown(self):
        self.new_file.nodal["disp_x"][0, 3] += 1e-6
        self.new_file.nodal["disp_x"][1, 4] -= 1e-3
        self.different(["step 2  node 5 at (2, 0.5)", "2 of 18"])

    def test_components_of_a_vector_share_their_scale(self):
        self.new_file.nodal["disp_y"][:] = 3e-16
        self.same()
        self.different("disp_y", "--set", "disp_y=relative 1e-9")

    def test_values_below_the_floor_are_equal(self):
        self.new_file.nodal["disp_y"][:] = 3e-16
        self.same("--set", "disp_y=relative 1e-9 floor 1e-12")
        self.new_file.nodal["disp_y"][0, 0] = 2e-12
        self.different("disp_y", "--set", "disp_y=relative 1e-9 floor 1e-12")

    def test_wrong_element_side_and_global_values_fail(self):
        for change, word in ((lambda f: f.element["stress_xx"]["lower"], "lower, element 5"),
                             (lambda f: f.side["pressure"]["upper:right"], "upper:right, side 2 of element 3")):
            self.new_file = SmallExodus()
            change(self.new_file)[0, 1] += 0.1
            self.different(word)
        self.new_file = SmallExodus()
        self.new_file.globals["energy"][1] += 0.1
        self.different(["energy", "step 2"])

    def test_missing_and_extra_side_sets_fail(self):
        del self.new_file.side_sets["contact:lower"]
        self.different("side set contact:lower is missing in NEW")
        self.gold_file, self.new_file = self.new_file, SmallExodus()
        self.different("side set contact:lower is extra in NEW")

    def test_a_side_set_with_another_facet_fails(self):
        self.new_file.side_sets["contact:lower"] = [(5, 2)]
        self.different("side set contact:lower has 1 members in GOLD, 1 in NEW; 1 are missing, 1 extra")

    def test_a_node_set_with_another_node_fails(self):
        self.new_file.node_sets["corner"] = [1, 4]
        self.different("node set corner")

    def test_missing_and_extra_variables_fail(self):
        self.new_file.nodal["temperature"] = self.new_file.nodal["disp_x"]
        self.different("nodal variable temperature is extra in NEW")
        self.same("--set", "temperature=ignore")
        self.gold_file, self.new_file = self.new_file, SmallExodus()
        self.different("nodal variable temperature is missing in NEW")

    def test_missing_and_extra_steps_fail(self):
        self.new_file = SmallExodus(times=(1.0,))
        self.different("step 2 (time 2) is missing in NEW")
        self.new_file = SmallExodus(times=(1.0, 2.0, 3.0))
        self.different("step 3 (time 3) is extra in NEW")

    def test_another_time_fails(self):
        self.new_file.times = (1.0, 2.5)
        self.different(["time", "step 2"])

    def test_nan_equals_nan_and_nothing_else(self):
        for file in (self.gold_file, self.new_file):
            file.element["stress_xx"]["upper"][0] = NAN
        self.same()
        self.new_file.element["stress_xx"]["upper"][1, 0] = NAN
        self.different("nan")
        self.new_file.element["stress_xx"]["upper"][:] = 0.0
        self.different("nan")
        self.new_file = SmallExodus()
        self.new_file.nodal["disp_x"][0, 0] = numpy.inf
        self.different("inf")
        self.different("inf", "--set", "default=relative 1e-9")

    def test_another_numbering_is_the_same(self):
        self.new_file = SmallExodus(**PERMUTED)
        self.same()

    def test_a_wrong_node_is_found_in_another_numbering(self):
        self.new_file = SmallExodus(**PERMUTED)
        self.new_file.nodal["disp_x"][0, 5] += 0.1
        self.different("step 1  node 5 at (2, 0.5)")

    def test_values_of_touching_bodies_are_not_mixed(self):
        self.new_file = SmallExodus(**PERMUTED)
        below = self.new_file.nodes.index(5)
        self.new_file.nodal["disp_x"][0, below] += 0.1
        self.different("node 6 at (0, 0)")

    def test_order_within_a_set_does_not_matter(self):
        self.new_file.side_sets["upper:right"].reverse()
        values = self.new_file.side["pressure"]
        values["upper:right"] = values["upper:right"][:, ::-1]
        self.same()

    def test_a_moved_node_fails(self):
        self.new_file.points[4, 0] += 1e-3
        self.different(["coordinates", "node 5 at (2, 0.5)"])
        self.different("coordinates", "--set", "default=scaled 1e-9 floor 1e-12")
        self.same("--set", "coordinates=absolute 0.01")
        self.same("--set", "coordinates=ignore")
        self.new_file = SmallExodus(**PERMUTED)
        self.new_file.points[0, 0] += 1e-3
        self.different(["nodes are missing in NEW", "nodes of NEW are not in GOLD"])

    def test_other_elements_fail(self):
        self.new_file.blocks["upper"][:2] = [[1, 2, 3], [2, 4, 3]]
        self.different("block upper has other elements")

    def test_a_missing_block_fails(self):
        self.new_file.blocks["other"] = self.new_file.blocks.pop("lower")
        values = self.new_file.element["stress_xx"]
        values["other"] = values["lower"]
        self.different(["block lower is missing in NEW", "block other is extra in NEW"])

    def test_rules_come_from_a_file_and_the_last_one_holds(self):
        self.new_file.nodal["disp_x"] *= 1.001
        rules = self.folder / "rules.toml"
        rules.write_text('[exodus]\ndefault = { relative = 1e-2 }\n')
        self.same("--tolerances", rules)
        self.different("disp_x", "--tolerances", rules, "--set", "disp_*=relative 1e-5")

    def test_files_that_cannot_be_read_are_refused(self):
        gold, _ = self.files()
        (self.folder / "text.e").write_text("no netCDF")
        self.assert_refused("cannot be read as Exodus", gold, self.folder / "text.e")
        self.assert_refused("cannot be read as Exodus", self.folder / "nowhere.e", gold)
        with netCDF4.Dataset(self.folder / "part.e", "w", format="NETCDF3_CLASSIC") as data:
            data.createDimension("num_dim", 2)
            data.createVariable("coordx", "f8", ())
        self.assert_refused("is no whole Exodus file: coordy", gold, self.folder / "part.e")

    def test_rules_that_make_no_sense_are_refused(self):
        gold, new = self.files()
        for rule, words in (("disp_x", "is not a rule"), ("disp_x=near 1", "a rule is one of"),
                            ("disp_x=relative -1", "is not a number >= 0"),
                            ("disp_x=relative", "followed by a number")):
            self.assert_refused(words, gold, new, "--set", rule)
        (self.folder / "rules.toml").write_text("[fields]\n")
        self.assert_refused("exodus and summary", gold, new, "--tolerances", self.folder / "rules.toml")


SUMMARY = {
    "version": "0.1.0", "ranks": 1, "deck": {"Title": "t", "Order": 2},
    "bodies": [{"name": "punch", "energy": 0.9, "solver": "Cholmod"}], "coupling": None,
    "errors": {"guaranteed": True, "absolute": 0.08},
    "ledger": {"counts": {"sweeps": 6, "bytes written": 10}, "total_seconds": 0.5, "peak_bytes": 7,
               "stages": [{"name": "read", "seconds": 0.1, "peak_bytes": 5}]},
}


class Summaries(Comparison):
    def pair(self, change):
        """The summary and its copy after `change(copy)`."""
        gold, new = self.folder / "gold.json", self.folder / "new.json"
        copy = json.loads(json.dumps(SUMMARY))
        change(copy)
        gold.write_text(json.dumps(SUMMARY))
        new.write_text(json.dumps(copy))
        return gold, new

    def test_what_differs_from_run_to_run_is_ignored(self):
        def change(new):
            new.update(version="0.2.0", ranks=3)
            new["ledger"].update(total_seconds=1.0, peak_bytes=9)
            new["ledger"]["counts"]["bytes written"] = 11
            new["ledger"]["stages"][0].update(seconds=0.2, peak_bytes=6)
        self.assert_success(*self.pair(change))

    def test_a_number_differs_by_its_path(self):
        pair = self.pair(lambda new: new["bodies"][0].update(energy=0.9 + 1e-8))
        self.assert_failure("bodies/punch/energy", *pair)
        self.assert_success(*pair, "--set", "bodies/*/energy=relative 1e-7")
        self.assert_success(*self.pair(lambda new: new["bodies"][0].update(energy=numpy.nextafter(0.9, 1))))

    def test_counts_are_exact_unless_a_rule_names_them(self):
        pair = self.pair(lambda new: new["ledger"]["counts"].update(sweeps=7))
        self.assert_failure(["ledger/counts/sweeps", "6", "7"], *pair)
        self.assert_failure("ledger/counts/sweeps", *pair, "--set", "default=relative 0.5")
        self.assert_success(*pair, "--set", "ledger/counts/*=absolute 1")

    def test_words_and_verdicts_are_exact(self):
        self.assert_failure("Mumps", *self.pair(lambda new: new["bodies"][0].update(solver="Mumps")))
        self.assert_failure("errors/guaranteed", *self.pair(lambda new: new["errors"].update(guaranteed=False)))
        self.assert_failure("errors/guaranteed", *self.pair(lambda new: new["errors"].update(guaranteed=1)))

    def test_missing_and_extra_entries_fail(self):
        self.assert_failure("entry errors/absolute is missing", *self.pair(lambda new: new["errors"].pop("absolute")))
        self.assert_failure("entry errors/more is extra", *self.pair(lambda new: new["errors"].update(more=1)))
        self.assert_failure("entry ledger/stages/read/name is missing",
                              *self.pair(lambda new: new["ledger"].pop("stages")))

    def test_a_number_instead_of_null_fails(self):
        self.assert_failure("coupling", *self.pair(lambda new: new.update(coupling=1.0)))

    def test_a_new_parameter_is_no_difference_but_a_changed_one_is(self):
        self.assert_success(*self.pair(lambda new: new["deck"].update(New=1)))
        self.assert_failure("deck/Order", *self.pair(lambda new: new["deck"].update(Order=1)))
        self.assert_failure("deck/Order is missing", *self.pair(lambda new: new["deck"].pop("Order")))

    def test_files_that_cannot_be_read_are_refused(self):
        gold, new = self.pair(lambda _: None)
        new.write_text("{")
        self.assert_refused("is not JSON", gold, new)
        new.write_text("[]")
        self.assert_refused("not a summary", gold, new)
        self.assert_refused("No such file", gold, self.folder / "nowhere.json")
        (self.folder / "new.csv").write_bytes(b"case\n\xff\n")
        self.assert_refused("is not a table", gold, self.folder / "new.csv")


class StudyTables(Comparison):
    def pair(self, old, new):
        text = 'case,Cells,energy,seconds,reason\n1,"{4, 4}",0.9,0.1,\n2,"{8, 8}",,0.2,"no side ""a"""\n'
        for name, content in (("gold.study.csv", text), ("new.study.csv", text.replace(old, new))):
            (self.folder / name).write_text(content)
        return self.folder / "gold.study.csv", self.folder / "new.study.csv"

    def test_numbers_by_case_and_column_the_rest_as_text(self):
        self.assert_success(*self.pair("0.9,0.1", "0.90000000001,0.3"))
        for old, new, words in (
            ("0.9", "0.91", "1/energy"), (",,0.2", ",0.5,0.2", "2/energy"), ("{8, 8}", "{9, 9}", "2/Cells"),
            ('""a""', '""b""', "2/reason"), ("energy", "E", "1/energy is missing"), ("\n2", "\n3", "3/energy is extra"),
        ):
            self.assert_failure(words, *self.pair(old, new))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
