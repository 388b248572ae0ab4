"""Meshes that ranks share out as they are drawn: test_shared_meshes.py NDFRAME DECKS MPIEXEC.

Boxes and an Exodus file without Refine on 2 to 5 ranks give the answer of one, and no rank has all cells; small meshes stay
whole; what rank 0 finds wrong ends all ranks with one message. Random scenes from gmsh's files: shared_solids.py.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from shared_solids import difference

NDFRAME, DECKS, MPIEXEC = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
CELLS = ["Bodies/punch/Mesh/Cells={6, 6, 6}", "Bodies/foundation/Mesh/Cells={12, 12, 6}"]  # 1526 vertices
SIDES = {"punch": {"Supports/symmetry x": "left", "Supports/symmetry y": "front", "Loads/press": "top"},
         "foundation": {"Supports/ground": "bottom", "Supports/symmetry x": "left", "Supports/symmetry y": "front"}}
MULTIGRID, NO_EXODUS = "Linear Solver/Type=Multigrid", "Output/Exodus=false"


def lists(root, path):
    """The list of this path, and the one that it is in."""
    holder = None
    for name in path.split("/"):
        holder, root = root, next(part for part in root if part.get("name") == name)
    return root, holder


class MeshesAsDrawn(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.tree = ElementTree.parse(DECKS / "punch-3d.xml")
        for name in ("Error Estimation", "Expect"):
            self.remove(name)
        self.boxes = self.written("boxes")
        self.program = Program(NDFRAME, MPIEXEC)

    def remove(self, path):
        part, holder = lists(self.tree.getroot(), path)
        holder.remove(part)

    def written(self, name):
        path = self.folder / f"{name}.xml"
        self.tree.write(path)
        return path

    def exodus(self):
        """The same bodies from one Exodus file; a deck."""
        done = subprocess.run([NDFRAME, "-q", "-i", str(self.boxes), *(f"--set={setting}" for setting in CELLS)],
                              cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        shutil.move(self.folder / "boxes.e", self.folder / "drawn.e")
        for body in ("punch", "foundation"):
            self.remove(f"Bodies/{body}/Mesh")
            bodies, _ = lists(self.tree.getroot(), f"Bodies/{body}")
            mesh = ElementTree.SubElement(bodies, "ParameterList", name="Mesh")
            for key, kind, value in (("Type", "string", "Exodus"), ("File", "string", "drawn.e"),
                                     ("Blocks", "Array(string)", f"{{{body}}}")):
                ElementTree.SubElement(mesh, "Parameter", name=key, type=kind, value=value)
            for path, side in SIDES[body].items():  # the file has sides of several bodies
                self.name(f"Bodies/{body}/{path}", "Side", f"{body}:{side}")
        self.name("Interfaces/contact", "Dirichlet Side", "punch:bottom")
        self.name("Interfaces/contact", "Neumann Side", "foundation:contact")
        return self.written("file")

    def name(self, path, parameter, value):
        part, _ = lists(self.tree.getroot(), f"{path}/{parameter}")
        part.set("value", value)

    def compare(self, deck, *settings, several):
        one = self.program.run(deck, *settings, MULTIGRID, NO_EXODUS)
        self.assertEqual(one.code, 0, one.screen)
        for ranks in several:
            shared = self.program.run(deck, *settings, MULTIGRID, NO_EXODUS, ranks=ranks)
            self.assertIsNone(difference(one, shared))
            self.assertEqual(shared.summary["ledger"]["counts"]["shared bodies"], 2)
            self.assertIn(f"1 296 cells, shared out among the {ranks} processes in shares of ", shared.screen)
            self.assertIn(f"5 184 cells, shared out among the {ranks} processes in shares of ", shared.screen)

    def test_boxes(self):
        self.compare(self.boxes, *CELLS, several=(2, 3, 5))

    def test_certified_boxes(self):
        self.compare(self.boxes, *CELLS, "Error Estimation/Estimators={Global}", "Error Estimation/Check Equilibrium=true",
                     several=(2, 3))

    def test_no_reduction_grows_with_the_bodies(self):
        """From one mesh to one with eight times the cells and four times the facets of contact."""
        largest, dofs, tables = [], [], []
        for halvings in (0, 1):
            refined = [f"Bodies/{body}/Mesh/Refine={halvings}" for body in ("punch", "foundation")]
            run = self.program.run(self.boxes, *CELLS, *refined, "Error Estimation/Estimators={Global}", MULTIGRID, NO_EXODUS, ranks=2)
            self.assertEqual(run.code, 0, run.screen)
            counts = run.summary["ledger"]["counts"]
            self.assertGreater(counts["shared bodies"], 0)
            self.assertGreater(counts["reduction bytes"], counts["largest reduction"])
            largest.append(counts["largest reduction"])
            dofs.append(sum(body["dofs"] for body in run.summary["bodies"]))
            tables.append(run.summary["interfaces"][0]["nodes"])
        self.assertGreater(dofs[1], 7 * dofs[0])
        self.assertLess(largest[1] / largest[0], 1.2 * tables[1] / tables[0], largest)

    def test_stars_want_whole_bodies(self):
        self.assertEqual(self.shares(MULTIGRID, "Error Estimation/Estimators={Global}", ranks=3), 2)
        self.assertEqual(self.shares(MULTIGRID, "Error Estimation/Estimators={Global}", "Error Estimation/Recovery/Type=Star",
                                     ranks=3), 0)

    def test_an_exodus_file(self):
        self.compare(self.exodus(), several=(3,))

    def test_one_body_is_drawn_and_one_refined(self):
        settings = [*CELLS, "Bodies/punch/Mesh/Cells={3, 3, 3}", "Bodies/punch/Mesh/Refine=1", MULTIGRID, NO_EXODUS]
        one, shared = (self.program.run(self.boxes, *settings, ranks=ranks) for ranks in (1, 3))
        self.assertIsNone(difference(one, shared))
        self.assertIn("5 184 cells, shared out among the 3 processes", shared.screen)
        self.assertIn("162 cells became 1 296, made by the 3 processes", shared.screen)

    def test_sides_that_will_not_match_are_cut(self):  # as drawn they do
        settings = [*CELLS, "Bodies/punch/Mesh/Refine=1", MULTIGRID, NO_EXODUS]
        one, shared = (self.program.run(self.boxes, *settings, ranks=ranks) for ranks in (1, 3))
        self.assertIsNone(difference(one, shared))
        self.assertEqual(shared.summary["ledger"]["counts"]["shared bodies"], 2)
        self.assertIn("processes in shares of ", shared.screen)

    def shares(self, *settings, ranks, deck=None):
        run = self.program.run(deck or self.boxes, *settings, NO_EXODUS, ranks=ranks)
        self.assertEqual(run.code, 0, run.screen)
        return run.summary["ledger"]["counts"].get("shared bodies", 0)

    def test_few_vertices_stay_whole(self):  # 942
        self.assertEqual(self.shares(MULTIGRID, ranks=4), 2)
        self.assertEqual(self.shares(MULTIGRID, ranks=5), 0)

    def test_what_may_need_a_factor_stays_whole(self):  # 66 000 dofs, and 300 000
        for n, shared in ((8, 0), (14, 2)):
            cells = [f"Bodies/punch/Mesh/Cells={{{n}, {n}, {n}}}", f"Bodies/foundation/Mesh/Cells={{{2 * n}, {2 * n}, {n}}}"]
            self.assertEqual(self.shares(*cells, ranks=2), shared)

    def test_a_script_is_meshed_once_where_bodies_stay_whole(self):  # few vertices
        self.tree = ElementTree.parse(DECKS / "blocks-3d.xml")
        for name in ("Error Estimation", "Expect"):
            self.remove(name)
        for part in self.tree.getroot().iter("Parameter"):
            if part.get("name") == "File":
                part.set("value", str(DECKS / part.get("value")))
        settings = [MULTIGRID, NO_EXODUS, "Coupling/Type=Monolithic"]
        one, whole = (self.program.run(self.written("blocks"), *settings, ranks=ranks) for ranks in (1, 2))
        self.assertEqual(whole.code, 0, whole.screen)
        self.assertIsNone(difference(one, whole))
        counts = whole.summary["ledger"]["counts"]
        self.assertNotIn("shared bodies", counts)
        self.assertEqual(counts["scripts meshed"], one.summary["ledger"]["counts"]["scripts meshed"])

    def refused(self, code, message, *settings, deck=None):
        run = self.program.run(deck or self.boxes, *CELLS, *settings, MULTIGRID, NO_EXODUS, ranks=3)
        self.assertEqual(run.code, code, run.screen)
        self.assertEqual(run.screen.count(message), 1, run.screen)

    def test_mistakes_end_all_ranks_with_one_message(self):
        self.refused(2, 'has no side "roof"', "Interfaces/contact/Neumann Side=roof")
        self.refused(2, "it must be finite", "Bodies/punch/Loads/press/Value=1/(x-x)")
        self.refused(2, "nothing was computed", "Strict Input=true", "Bodies/punch/Material/Young Modulus=1e9")
        self.refused(3, "\nnot converged: the load does not press the bodies together", "Bodies/punch/Loads/press/Value=-1")
        self.remove("Bodies/punch/Supports/symmetry x")
        self.refused(2, "nothing holds this body", deck=self.written("free"))

    def test_all_files_that_are_missing_are_named(self):
        deck = self.exodus()
        (self.folder / "drawn.e").unlink()
        run = self.program.run(deck, MULTIGRID, NO_EXODUS, ranks=3)
        self.assertEqual(run.code, 2, run.screen)
        for body in ("punch", "foundation"):
            self.assertEqual(run.screen.count(f"Bodies/{body}/Mesh"), 1, run.screen)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
