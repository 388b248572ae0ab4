"""nddiff on Exodus files altered on purpose: test_nddiff.py REGRESSION."""

import pathlib
import sys
import unittest

import netCDF4
import numpy

REGRESSION = pathlib.Path(sys.argv[1]).resolve()
sys.path[:0] = [str(REGRESSION), str(pathlib.Path(__file__).parent)]

from called import Comparison  # noqa: E402
from harness import elements  # noqa: E402
from small_exodus import SmallExodus  # noqa: E402

NAN = float("nan")
PERMUTED = {"nodes": (7, 2, 5, 0, 8, 4, 1, 6, 3), "elements": ((2, 0, 1), (1, 0))}

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

    def test_nodes_of_an_element_in_another_order_fail(self):
        orders = {"middles exchanged": (0, 1, 2, 4, 3, 5), "middles turned": (0, 1, 2, 4, 5, 3),
                  "inside out": (0, 2, 1, 5, 4, 3), "corners turned": (1, 2, 0, 3, 4, 5)}
        for what, order in orders.items():
            for rows in (slice(0, 1), slice(None)):
                with self.subTest(what, rows=rows):
                    self.gold_file, self.new_file = SmallExodus().add_middles(), SmallExodus().add_middles()
                    block = self.new_file.blocks["upper"]
                    block[rows] = [[row[i] for i in order] for row in block[rows]]
                    self.different("block upper has elements with their nodes in another order")

    def test_an_element_begun_at_another_corner_is_the_same(self):
        self.gold_file, self.new_file = SmallExodus().add_middles(), SmallExodus(**PERMUTED).add_middles()
        self.same()
        for rows in self.new_file.blocks.values():
            rows[:] = [[row[i] for i in (1, 2, 0, 4, 5, 3)] for row in rows]
        sides = {"contact:upper": [(2, 3)], "contact:lower": [(4, 2)], "upper:right": [(1, 3), (1, 1)]}
        self.new_file.side_sets = sides  # the same facets by the new corners
        self.same()

    def test_ids_statuses_and_truth_tables_are_compared(self):
        for change, words in (
            (lambda file: file.side_set_ids.__setitem__(1, 7), "side set contact:lower has id 2 in GOLD, 7 in NEW"),
            (lambda file: file.side_set_status.__setitem__(0, 0), "contact:upper has status 1 in GOLD, 0 in NEW"),
            (lambda file: file.truth_table[1].__setitem__(0, 0), "stress_xx in the truth table on lower is missing"),
        ):
            self.new_file = SmallExodus()
            change(self.new_file)
            self.different(words)

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
        self.assert_refused("is not a complete Exodus file: coordy", gold, self.folder / "part.e")

    def test_rules_that_make_no_sense_are_refused(self):
        gold, new = self.files()
        for rule, words in (("disp_x", "is not a rule"), ("disp_x=near 1", "a rule is one of"),
                            ("disp_x=relative -1", "is not a number >= 0"),
                            ("disp_x=relative", "followed by a number")):
            self.assert_refused(words, gold, new, "--set", rule)
        (self.folder / "rules.toml").write_text("[fields]\n")
        self.assert_refused("exodus and summary", gold, new, "--tolerances", self.folder / "rules.toml")


CORNERS = {
    "TRI": [(0, 0), (1, 0), (0, 1)],
    "TETRA": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "QUAD": [(0, 0), (1, 0), (1, 1), (0, 1)],
    "HEX": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
}


class ElementTypes(unittest.TestCase):
    def test_rotations_keep_shape_and_orientation_and_there_are_no_others(self):
        for (kind, corners), count, edges in zip(CORNERS.items(), (3, 12, 4, 24), (3, 6, 4, 12)):
            corners = numpy.array(corners, float)
            middles = [corners[list(ends)].mean(axis=0) for ends in elements.EDGES[kind[:3]]]
            points = numpy.vstack([corners, middles, [corners.mean(axis=0)]])
            orders = elements.rotations(kind, len(points))
            self.assertEqual((len(set(orders)), len(middles)), (count, edges))
            extended = numpy.column_stack([points, numpy.ones(len(points))])
            for order in orders:  # an affine map without reflection takes every node to that in its place
                affine = numpy.linalg.lstsq(extended, points[list(order)], rcond=None)[0]
                self.assertLess(numpy.abs(extended @ affine - points[list(order)]).max(), 1e-14)
                self.assertGreater(numpy.linalg.det(affine[:-1]), 0.5)

    def test_elements_of_unknown_types_are_not_turned(self):
        self.assertEqual(elements.rotations("WEDGE15", 15), [tuple(range(15))])
        self.assertEqual(elements.rotations("TRI", 9), [tuple(range(9))])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
