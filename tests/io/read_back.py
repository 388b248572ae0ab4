"""Reads Exodus files with netCDF alone and checks them against the format's own numbering: read_back.py WRITE_SAMPLES.

Geometry is the judge: mid-side nodes lie half-way along Exodus's edges, the facets of a side set lie on that side, and all
values are the known function of position that write_samples.cpp wrote.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import exodus_pieces
import netCDF4
import numpy

WRITE_SAMPLES = sys.argv[1]
BODIES = ["punch", "a foundation whose name is longer than 32 characters"]
SIDES = [f"{body}:{side}" for body in BODIES for side in ("low", "high", "all", "none")]
CONTACTS = ["contact", "contact, seen from below", "lost contact"]
TIMES = [1.0, 2.0]

# From the Exodus II manual, counted from 1: vertices of each side, and the two ends of each mid-side node.
SIDE_VERTICES = {2: [(1, 2), (2, 3), (3, 1)], 3: [(1, 2, 4), (2, 3, 4), (1, 4, 3), (1, 3, 2)]}
EDGES = {2: [(1, 2), (2, 3), (3, 1)], 3: [(1, 2), (2, 3), (3, 1), (1, 4), (2, 4), (3, 4)]}
ELEMENTS = {(2, 1): "TRI3", (2, 2): "TRI6", (3, 1): "TETRA4", (3, 2): "TETRA10"}


def expected(point, body, time):
    return point[..., 0] + 10 * point[..., 1] + 100 * body + 1000 * time


class Sample:
    """One file, read as plain arrays."""

    def __init__(self, path, dim, order):
        self.dim, self.order = dim, order
        self.file = netCDF4.Dataset(path)
        self.points = numpy.stack([self.file[f"coord{axis}"][:] for axis in "xyz"[:dim]], axis=1)
        self.blocks = [self.file[f"connect{b + 1}"][:].data - 1 for b in range(len(BODIES))]
        self.cells = numpy.concatenate(self.blocks)

    def names(self, variable):
        return [b"".join(row.compressed()).decode() for row in self.file[variable][:]]

    def side_set(self, number):
        """Coordinates of the vertices of each facet."""
        if f"elem_ss{number}" not in self.file.variables:
            return numpy.empty((0, self.dim, self.dim))
        elements, sides = self.file[f"elem_ss{number}"][:] - 1, self.file[f"side_ss{number}"][:] - 1
        locals_ = numpy.array(SIDE_VERTICES[self.dim])[sides] - 1
        return self.points[numpy.take_along_axis(self.cells[elements], locals_, axis=1)]


def each_sample(test):
    """Runs a test on every file."""

    def run(self):
        for sample in self.samples:
            with self.subTest(element=ELEMENTS[sample.dim, sample.order]):
                test(self, sample)

    return run


class ExodusReadsBack(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run([WRITE_SAMPLES, cls.folder.name], check=True)
        cls.samples = [
            Sample(pathlib.Path(cls.folder.name) / f"sample-{dim}-{order}.e", dim, order) for dim, order in ELEMENTS
        ]

    @classmethod
    def tearDownClass(cls):
        for sample in cls.samples:
            sample.file.close()
        cls.folder.cleanup()

    def test_pieces_are_the_whole_bit_by_bit(self):
        folder = pathlib.Path(self.folder.name)
        for dim, order in ELEMENTS:
            whole = folder / f"pieces-{dim}-{order}.e"
            cells = {2: 8, 3: 12}[dim]
            for count in (1, 2, 3, cells):
                with self.subTest(dim=dim, order=order, pieces=count):
                    digits = len(str(count))
                    pieces = [f"{whole}.{count}.{piece:0{digits}}" for piece in range(count)]
                    exodus_pieces.Join(whole, pieces).compare()

    @each_sample
    def test_format_is_netcdf3_with_large_offsets(self, sample):
        self.assertEqual(sample.file.data_model, "NETCDF3_64BIT_OFFSET")
        self.assertEqual(sample.file.floating_point_word_size, 8)

    @each_sample
    def test_names(self, sample):
        self.assertEqual(sample.file.title, "Sample of two bodies")
        self.assertEqual(sample.names("eb_names"), BODIES)
        self.assertEqual(sample.names("ss_names"), SIDES + CONTACTS)
        self.assertEqual(sample.names("coor_names"), list("xyz")[: sample.dim])
        self.assertEqual(sample.names("name_nod_var"), ["disp_x", "disp_y"])
        self.assertEqual(sample.names("name_elem_var"), ["von_mises"])
        self.assertEqual(sample.names("name_sset_var"), ["contact_pressure"])
        self.assertEqual(sample.names("name_glo_var"), ["energy", "contact_force"])

    @each_sample
    def test_blocks_are_the_bodies(self, sample):
        cells = {2: 4, 3: 6}[sample.dim]
        nodes = 0
        for number, block in enumerate(sample.blocks, start=1):
            self.assertEqual(sample.file[f"connect{number}"].elem_type, ELEMENTS[sample.dim, sample.order])
            self.assertEqual(len(block), cells)
            self.assertEqual(block.min(), nodes)
            nodes = block.max() + 1
        self.assertEqual(nodes, len(sample.points))

    @each_sample
    def test_elements_are_positive_and_fill_the_bodies(self, sample):
        for body, block in enumerate(sample.blocks):
            corners = sample.points[block[:, : sample.dim + 1]]
            volumes = numpy.linalg.det(corners[:, 1:] - corners[:, :1]) / {2: 2, 3: 6}[sample.dim]
            self.assertGreater(volumes.min(), 0)
            self.assertAlmostEqual(volumes.sum(), {2: 2.0, 3: 1.0}[sample.dim])
            self.assertEqual(corners[..., -1].min(), 1.0 - body)

    @each_sample
    def test_mid_side_nodes_lie_half_way(self, sample):
        if sample.order == 2:
            ends = numpy.array(EDGES[sample.dim]) - 1
            halves = sample.points[sample.cells[:, ends]].mean(axis=2)
            numpy.testing.assert_array_equal(sample.points[sample.cells[:, sample.dim + 1 :]], halves)

    @each_sample
    def test_side_sets_lie_on_their_sides(self, sample):
        on_side = {2: 2, 3: 2}[sample.dim]
        for number, name in enumerate(SIDES, start=1):
            body, side = name.split(":")
            facets = sample.side_set(number)
            bottom = 1.0 - BODIES.index(body)
            around = {2: 6, 3: 12}[sample.dim]
            self.assertEqual(len(facets), {"low": on_side, "high": on_side, "all": around, "none": 0}[side])
            if side in ("low", "high"):
                self.assertTrue((facets[..., -1] == bottom + (side == "high")).all())
            if side == "all":
                self.assertTrue(all(self.on_boundary(facet, bottom) for facet in facets))

    @staticmethod
    def on_boundary(facet, bottom):
        flat = numpy.ptp(facet, axis=0) == 0
        low, high = numpy.zeros(facet.shape[1]), numpy.ones(facet.shape[1])
        low[-1], high[-1] = bottom, bottom + 1
        if facet.shape[1] == 2:
            high[0] = 2
        return (flat & ((facet[0] == low) | (facet[0] == high))).any()

    @each_sample
    def test_contact_sides_lie_on_the_interface(self, sample):
        for number in (len(SIDES) + 1, len(SIDES) + 2):
            facets = sample.side_set(number)
            self.assertEqual(len(facets), 2)
            self.assertTrue((facets[..., -1] == 1.0).all())

    @each_sample
    def test_steps(self, sample):
        numpy.testing.assert_array_equal(sample.file["time_whole"][:], TIMES)
        numpy.testing.assert_array_equal(sample.file["vals_glo_var"][:], [[t / 4, -t] for t in TIMES])

    @each_sample
    def test_nodal_values(self, sample):
        body = (numpy.arange(len(sample.points)) >= sample.blocks[1].min()).astype(float)
        for step, time in enumerate(TIMES):
            values = expected(sample.points, body, time)
            numpy.testing.assert_array_equal(sample.file["vals_nod_var1"][step], values)
            numpy.testing.assert_array_equal(sample.file["vals_nod_var2"][step], -values)

    @each_sample
    def test_element_values(self, sample):
        for body, block in enumerate(sample.blocks):
            centers = sample.points[block[:, : sample.dim + 1]].mean(axis=1)
            for step, time in enumerate(TIMES):
                values = sample.file[f"vals_elem_var1eb{body + 1}"][step]
                numpy.testing.assert_allclose(values, expected(centers, body, time), rtol=1e-14)

    @each_sample
    def test_contact_values(self, sample):
        for body in (0, 1):
            number = len(SIDES) + 1 + body
            centers = sample.side_set(number).mean(axis=1)
            for step, time in enumerate(TIMES):
                values = sample.file[f"vals_sset_var1ss{number}"][step]
                numpy.testing.assert_allclose(values, expected(centers, body, time), rtol=1e-14)

    @each_sample
    def test_only_contact_sides_carry_variables(self, sample):
        table = sample.file["sset_var_tab"][:, 0]
        numpy.testing.assert_array_equal(table, [0] * len(SIDES) + [1, 1, 0])
        numpy.testing.assert_array_equal(sample.file["elem_var_tab"][:], 1)

    @each_sample
    def test_information_records(self, sample):
        records = sample.names("info_records")
        self.assertEqual(records[0], "first line")
        self.assertEqual(records[-1], "last")
        rejoined = "".join(line[:-1] if line.endswith("\\") else line for line in records[1:-1])
        self.assertEqual(rejoined, "a" * 78 + "\u00e9" + "b" * 100)

    @each_sample
    def test_quality_record_names_the_program(self, sample):
        record = [b"".join(field.compressed()).decode() for field in sample.file["qa_records"][0]]
        self.assertEqual(record[0], "ndframe")
        self.assertRegex(" ".join(record[1:]), r"^\d+\.\d+\.\d+ \d{4}-\d\d-\d\d \d\d:\d\d:\d\dZ$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
