"""ndframe --decompose N: meshes in pieces, with which the deck has the same answer: test_decompose.py NDFRAME DECKS MPIEXEC."""

import json
import pathlib
import shlex
import subprocess
import sys
import tempfile
import unittest

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

    def test_too_many_pieces_are_refused(self):
        done = self.call("punch", "--set", "Bodies/punch/Mesh/Cells={1, 1}", "--decompose", "9", code=2)
        self.assertRegex(done.stderr, r'"punch" has \d cells, too few for 9 pieces\.')
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
