"""NAME.e in pieces, one from each process: test_pieces.py NDFRAME DECKS MPIEXEC.

The pieces together are the file that one process writes, up to what solvers on several processes differ from run to run (tests/io
compares the pieces of the same values bit by bit); all of them appear, or none.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "io"))
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "python"))
import exodus_pieces  # noqa: E402
import ndframe  # noqa: E402
import numpy  # noqa: E402

NDFRAME, DECKS, MPIEXEC = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]


def run(folder, ranks, deck, *settings, before=(), after=()):
    options = [part for setting in settings for part in ("--set", setting)]
    command = [MPIEXEC, "--oversubscribe", "-np", str(ranks), *before, NDFRAME, "-i", str(DECKS / f"{deck}.xml"), *options, *after]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


class PiecesOfExodus(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def names(self, pattern="*.e*"):
        return sorted(path.name for path in self.folder.glob(pattern))

    def right(self, *arguments, **options):
        done = run(self.folder, *arguments, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def compare(self, deck, ranks, *settings, written=None):
        """Runs the deck with one file and with pieces."""
        written = written or f"{deck}.e"
        self.right(ranks, deck, *settings, "Output/Exodus Files=Single")
        self.assertEqual(self.names(f"{written}*"), [written])
        whole = self.folder / "whole" / written
        whole.parent.mkdir(exist_ok=True)
        (self.folder / written).rename(whole)
        self.right(ranks, deck, *settings, "Output/Exodus Files=Pieces")
        pieces = [f"{written}.{ranks}.{rank}" for rank in range(ranks)]
        self.assertEqual(self.names(f"{written}*"), pieces)
        exodus_pieces.Join(whole, [self.folder / piece for piece in pieces], tolerance=1e-7).compare()

    def test_pieces_are_the_whole_in_the_plane(self):
        self.compare("certificate", 2, "Error Estimation/Reference/Refinements=1",
                     "Expect/the bound is above the error, and near it/Tolerance=10", "Output/Steps=All Sweeps",
                     "Output/Equilibrated Stress=true")

    def test_pieces_are_the_whole_in_space(self):
        self.compare("contact-loss-3d", 3, "Bodies/upper/Mesh/Cells={4, 4, 2}", "Bodies/lower/Mesh/Cells={8, 8, 4}",
                     "Error Estimation/Mode=Strict", "Expect/the upper block is in equilibrium/Tolerance=10",
                     "Expect/part of the sides touches/Tolerance=10", "Expect/the energy of this mesh/Tolerance=10")

    def test_pieces_have_the_regions(self):
        self.compare("two-materials", 2)

    def test_pieces_have_all_load_cases(self):
        self.compare("load-cases", 2)

    def test_levels_are_in_pieces_too(self):
        settings = ["Accuracy/Target=0.2", "Output/All Levels=true"]
        self.compare("punch", 2, *settings, written="punch.level-01.e")

    def test_the_python_module_reads_pieces_as_one(self):
        settings = ["Error Estimation/Mode=Strict"]
        self.right(3, "punch", *settings, "Output/Name=whole")
        self.right(3, "punch", *settings, "Output/Exodus Files=Pieces")
        whole, pieces = (ndframe.read(str(self.folder / name)).fields for name in ("whole", "punch.e.3.1"))
        numpy.testing.assert_array_equal(pieces.points, whole.points)
        numpy.testing.assert_allclose(pieces.displacement, whole.displacement, atol=1e-9)
        self.assertEqual((pieces.blocks, pieces.sides, pieces.names("element")), (whole.blocks, whole.sides, whole.names("element")))
        for block in whole.blocks:
            numpy.testing.assert_array_equal(pieces.nodes(block), whole.nodes(block))
            numpy.testing.assert_allclose(pieces.stress(block), whole.stress(block), atol=1e-8)
        for side in whole.sides:
            ours, theirs = (fields.facets(side) for fields in (pieces, whole))
            order, other = (numpy.lexsort(facets.T) for facets in (ours, theirs))
            numpy.testing.assert_array_equal(ours[order], theirs[other])
            if side.startswith("contact:"):
                ours, theirs = (fields.on_facets("contact_pressure", side) for fields in (pieces, whole))
                numpy.testing.assert_allclose(ours[order], theirs[other], atol=1e-8)

    def test_shares_of_solids_are_read_as_one_and_shown(self):
        tree = ElementTree.parse(DECKS / "punch-3d.xml")
        for part in list(tree.getroot()):
            if part.get("name") in ("Error Estimation", "Expect"):  # with them all processes have the whole
                tree.getroot().remove(part)
        tree.write(self.folder / "solids.xml")
        settings = ["Linear Solver/Type=Multigrid", "Output/Exodus Files=Pieces", "Bodies/punch/Mesh/Cells={2, 2, 2}",
                    "Bodies/foundation/Mesh/Cells={4, 4, 2}", "Bodies/punch/Mesh/Refine=1", "Bodies/foundation/Mesh/Refine=1"]
        deck = str(self.folder / "solids")  # takes the place of DECKS
        self.right(1, deck, *settings, "Output/Name=whole")
        done = self.right(4, deck, *settings, "Output/Report=true")  # one piece at least has nothing of the punch
        self.assertIn("made by the 4 processes in shares of 0 to ", done.stdout)
        exodus_pieces.Pieces(self.folder.glob("solids.e.4.*")).check_maps()
        self.assertNotIn("pictures of the bodies", (self.folder / "solids.report.html").read_text())
        whole, shares = (ndframe.read(str(self.folder / name)).fields for name in ("whole", "solids"))
        for block in whole.blocks:
            orders = [numpy.lexsort(fields.points[fields.nodes(block)].mean(axis=1).round(9).T) for fields in (whole, shares)]
            for name in whole.names("element"):
                values, others = (fields.element(name, block)[order] for fields, order in zip((whole, shares), orders))
                numpy.testing.assert_allclose(others, values, atol=1e-8)
            for name in whole.names("nodal"):
                means, others = (fields.nodal(name)[fields.nodes(block)].mean(axis=1)[order]
                                 for fields, order in zip((whole, shares), orders))
                numpy.testing.assert_allclose(others, means, atol=1e-8)
        for side in whole.sides:
            self.assertEqual(len(shares.facets(side)), len(whole.facets(side)))

    def test_the_report_shows_pieces(self):
        self.right(2, "punch", "Output/Exodus Files=Pieces", "Output/Report=true")
        self.assertNotIn("pictures of the bodies", (self.folder / "punch.report.html").read_text())

    def test_a_missing_piece_is_named(self):
        self.right(3, "punch", "Output/Exodus Files=Pieces")
        (self.folder / "punch.e.3.1").unlink()
        with self.assertRaisesRegex(ndframe.ReadError, "punch.e: piece 1 of 3 is missing"):
            ndframe.read(str(self.folder / "punch")).fields

    def test_more_processes_than_cells(self):
        few = ["Bodies/lower/Mesh/Cells={1, 1}", "Bodies/upper/Mesh/Cells={1, 1}"]
        self.compare("patch", 4, *few)
        self.right(9, "patch", *few, "Output/Exodus Files=Pieces")
        self.assertEqual(self.names(), ["patch.e"])

    def test_one_process_and_small_scenes_write_one_file(self):
        self.right(1, "patch", "Output/Exodus Files=Pieces")
        self.assertEqual(self.names(), ["patch.e"])
        self.right(2, "patch")
        self.assertEqual(self.names(), ["patch.e"])

    def test_what_an_earlier_run_left_is_removed(self):
        mine = self.folder / "patch.e.2.5"  # nobody's piece
        mine.write_text("mine")
        for ranks, files, left in ((3, "Pieces", 3), (2, "Pieces", 2), (2, "Single", 0)):
            self.right(ranks, "patch", f"Output/Exodus Files={files}")
            pieces = [f"patch.e.{left}.{rank}" for rank in range(left)] or ["patch.e"]
            self.assertEqual(self.names("patch.e*"), sorted([*pieces, mine.name]))
        self.assertEqual(mine.read_text(), "mine")

    def test_the_screen_names_first_and_last_piece(self):
        done = self.right(3, "patch", "Output/Exodus Files=Pieces")
        self.assertIn("wrote patch.e.3.0, ..., patch.e.3.2, patch.contact.csv, ", done.stdout)

    def test_the_plan_says_how_many(self):
        for files, said in (("Pieces", ", in 2 pieces\n"), ("Automatic", ", in 2 pieces from 1 000 000 nodes on\n"), ("Single", "\n")):
            done = run(self.folder, 2, "patch", f"Output/Exodus Files={files}", after=["--plan"])
            self.assertIn("for the Exodus file" + said, done.stdout)

    def test_where_one_cannot_write_none_does(self):
        (self.folder / "patch.e.3.1").mkdir()
        done = run(self.folder, 3, "patch", "Output/Exodus Files=Pieces")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stderr.count('cannot write "patch.e.3.1": it is a folder; name a file in it'), 1, done.stderr)
        self.assertEqual(self.names("*.e*") + self.names(".*"), ["patch.e.3.1"])

    def test_results_do_not_replace_the_meshes_that_they_come_from(self):
        deck = (DECKS / "exodus.xml").read_text()
        mesh = (DECKS / "meshes/punch-foundation.e").read_bytes()
        for file, piece in (("exodus.e", "exodus.e"), ("exodus.e.1", "exodus.e.1.0"), ("./exodus.e.1.0", "exodus.e.1.0")):
            (self.folder / piece).write_bytes(mesh)
            (self.folder / "exodus.xml").write_text(deck.replace("meshes/punch-foundation.e", file))
            for more in ([], ["--study", "Bodies/punch/Material/Young Modulus=1; 2", "--set", "Output/Exodus=true"]):
                done = subprocess.run([NDFRAME, "-i", "exodus.xml", *more], cwd=self.folder, capture_output=True, text=True)
                if not more:
                    self.assertEqual(done.returncode, 2, done.stdout)
                    self.assertIn(f"File: {file} would be replaced by the results, which are called exodus.e; give another "
                                  "Output/Name or Output/Directory.", done.stderr.replace("Mesh: ", "File: "))
                self.assertEqual((self.folder / piece).read_bytes(), mesh)
            (self.folder / piece).unlink()

    def test_a_full_disk_of_one_process_leaves_nothing(self):
        limited = ["sh", "-c", 'test "$OMPI_COMM_WORLD_RANK" = 1 && ulimit -f 8; exec "$0" "$@"']
        done = run(self.folder, 2, "punch", "Output/Exodus Files=Pieces", before=limited)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stderr.count('cannot write "punch.e.2.1": '), 1, done.stderr)
        self.assertEqual(self.names("*") + self.names(".*"), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
