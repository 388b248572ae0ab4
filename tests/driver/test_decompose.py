"""ndframe --decompose N: meshes in pieces, with which the deck has the same answer: test_decompose.py NDFRAME DECKS MPIEXEC."""

import json
import pathlib
import shlex
import subprocess
import sys
import tempfile
import unittest

import netCDF4
import numpy

NDFRAME, DECKS, MPIEXEC = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]


class Decompose(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def call(self, deck, *arguments, code=0, ranks=None):
        launcher = [MPIEXEC, "--oversubscribe", "-np", str(ranks)] if ranks else []
        done = subprocess.run([*launcher, NDFRAME, "-i", str(DECKS / f"{deck}.xml"), *arguments], cwd=self.folder,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def energies(self, deck, *arguments, **more):
        self.call(deck, *arguments, **more)
        summary = json.loads((self.folder / f"{deck}.summary.json").read_text())
        return [summary["energy"], *(body["energy"] for body in summary["bodies"]),
                *(region["energy"] for body in summary["bodies"] for region in body.get("regions") or [])]

    def the_same_answer(self, deck, pieces, *settings, ranks=None):
        whole = self.energies(deck, *settings)
        said = self.call(deck, *settings, "--decompose", str(pieces), ranks=ranks).stdout
        self.assertIn(f"wrote {pieces} piece", said)
        told = shlex.split(said.split("the deck reads them with", 1)[1].replace("\\\n", " "))
        again = self.energies(deck, *settings, *told, ranks=ranks)
        self.assertEqual(len(again), len(whole))
        for ours, theirs in zip(again, whole):
            self.assertAlmostEqual(ours, theirs, delta=1e-9 * abs(whole[0]))

    def test_boxes_that_are_refined(self):
        self.the_same_answer("punch", 4, "--set", "Bodies/punch/Mesh/Refine=1")

    def test_regions_of_a_script(self):
        self.the_same_answer("two-materials", 3)

    def test_an_exodus_file_of_several_bodies(self):
        self.the_same_answer("exodus", 1)

    def test_on_two_processes(self):
        self.the_same_answer("punch", 2, ranks=2)

    def test_sides_that_are_cut_and_a_rigid_body(self):
        self.the_same_answer("rigid-cylinder", 2)

    def test_a_body_alone(self):
        self.the_same_answer("beam-3d", 3)

    def places(self, body, pieces, piece, side):
        """The vertices that a piece has of a side, and the number of its elements."""
        with netCDF4.Dataset(self.folder / f"punch-3d.{body}.e.{pieces}.{piece}") as file:
            if "num_nodes" not in file.dimensions:
                return set(), 0
            points = numpy.array([file[f"coord{axis}"][:] for axis in "xyz"]).T
            names = [row.tobytes().split(b"\0")[0].decode() for row in file["ss_names"][:]]
            number = names.index(side) + 1
            if f"elem_ss{number}" not in file.variables:
                return set(), file.dimensions["num_elem"].size
            cells = file["connect1"][:][file[f"elem_ss{number}"][:] - 1]
            local = numpy.array([(0, 1, 3), (1, 2, 3), (0, 2, 3), (0, 1, 2)])[file[f"side_ss{number}"][:] - 1]
            return ({tuple(points[node - 1]) for node in numpy.take_along_axis(cells, local, 1).flat},
                    file.dimensions["num_elem"].size)

    def test_what_touches_is_in_one_piece(self):
        """Pieces with one number are one part of the scene, about as large as the others; of a body some are empty."""
        pieces, settings = 8, ["--set", "Bodies/punch/Mesh/Cells={6, 6, 6}", "--set", "Bodies/foundation/Mesh/Cells={12, 12, 6}"]
        self.call("punch-3d", *settings, "--decompose", str(pieces))
        sizes, above, below, common = [], [], [], 0
        for piece in range(pieces):
            (punch, ours), (foundation, theirs) = self.places("punch", pieces, piece, "bottom"), self.places("foundation", pieces, piece, "contact")
            sizes.append((ours, theirs))
            above.append(punch)
            below.append(foundation)
            common += len(punch & foundation)
        self.assertIn(0, [size for pair in sizes for size in pair])
        self.assertLess(max(map(sum, sizes)), 1.3 * sum(map(sum, sizes)) / pieces)
        self.assertEqual(set.union(*above), set.union(*below))
        self.assertGreater(common, 0.5 * sum(map(len, above)))  # a cell belongs to the piece of one of its vertices

    def test_vtk_opens_all_pieces_with_an_empty_one(self):
        try:
            from vtkmodules.vtkIOIOSS import vtkIOSSReader
        except ImportError:
            self.skipTest("VTK is not installed")
        self.call("punch-3d", "--set", "Bodies/punch/Mesh/Cells={6, 6, 6}", "--set", "Bodies/foundation/Mesh/Cells={12, 12, 6}",
                  "--decompose", "8")
        sizes = [self.places("punch", 8, piece, "bottom")[1] for piece in range(8)]
        reader = vtkIOSSReader()
        reader.SetScanForRelatedFiles(True)
        reader.SetFileName(str(self.folder / f"punch-3d.punch.e.8.{sizes.index(0)}"))
        reader.Update()
        block = reader.GetOutputDataObject(0).GetPartitionedDataSet(0)
        parts = [block.GetPartition(piece) for piece in range(block.GetNumberOfPartitions())]
        self.assertEqual(sum(part.GetNumberOfCells() for part in parts if part), sum(sizes))

    def test_too_many_pieces_are_refused(self):
        done = self.call("punch", "--decompose", "999999", code=2)
        self.assertRegex(done.stderr, r"Bodies:? have [\d ]+ cells together, too few for 999999 pieces\.")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_groups_that_overlap_are_refused(self):
        (self.folder / "two.geo").write_text(
            "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 1, 0.43}; Physical Surface(\"a\") = {1};\n"
            "Physical Surface(\"b\") = {1}; Physical Curve(\"bottom\") = {1}; Physical Curve(\"top\") = {3};\n")
        done = self.call("punch", "--set", "Bodies/punch/Mesh/Type=Gmsh", "--set", f"Bodies/punch/Mesh/File={self.folder}/two.geo",
                         "--decompose", "2", code=2)
        self.assertIn('cells of "punch" belong to several groups (a, b), which element blocks of a file cannot', done.stderr)

    def test_numbers_that_cannot_be(self):
        for number in ("0", "-1", "x", "2000000"):
            self.assertIn("--decompose", self.call("punch", "--decompose", number, code=2).stderr)

    def test_a_study_is_refused(self):
        done = self.call("study", "--decompose", "2", code=2)
        self.assertIn("--decompose reads one scene; run it without a study or load cases.", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
