"""Pieces of meshes that each rank reads for itself: test_read_pieces.py NDFRAME DECKS MPIEXEC.

What `--decompose` writes has the answer of the whole, with a share of the cells on each rank; where a rank cannot know from its pieces what
the scene needs, rank 0 joins them; pieces that do not belong together are refused in the words of one process. Random scenes:
shared_solids.py.
"""

import pathlib
import re
import sys
import unittest
from xml.etree import ElementTree

import netCDF4
import numpy

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from shared_solids import EXACT, difference, in_pieces
from shares_test import DECKS, MPIEXEC, NDFRAME, SharesTest, add

CELLS = ["Bodies/punch/Mesh/Cells={5, 5, 5}", "Bodies/foundation/Mesh/Cells={10, 10, 5}"]  # 942 vertices: enough for 4 ranks
COARSE = ["Bodies/punch/Mesh/Cells={4, 4, 4}", "Bodies/foundation/Mesh/Cells={8, 8, 4}"]  # 530: for 2
REFINED = ["Bodies/punch/Mesh/Refine=1", "Bodies/foundation/Mesh/Refine=1"]
GIVEN = ["Linear Solver/Type=Multigrid", "Output/Exodus=false"]
CERTIFIED = ["Error Estimation/Estimators={Global}", "Error Estimation/Check Equilibrium=true"]


class Pieces(SharesTest):
    def setUp(self):
        super().setUp()
        self.program = Program(NDFRAME, MPIEXEC)

    def deck(self, root):
        path = self.folder / "scene.xml"
        path.write_bytes(ElementTree.tostring(root))
        return path

    def decomposed(self, deck, pieces, *settings):
        """The settings that make the deck read its meshes in pieces."""
        read = in_pieces(self.program, deck, pieces, *settings)
        self.assertIsNotNone(read)
        return read

    def compare(self, root, pieces, ranks, *settings, bodies=2, drawn=(), areRead=True):
        """drawn: what the meshes are before they are in pieces."""
        deck = self.deck(root)
        read = self.decomposed(deck, pieces, *drawn)
        one = self.program.run(deck, *drawn, *settings, *GIVEN)
        shared = self.program.run(deck, *settings, *GIVEN, *read, ranks=ranks)
        self.assertIsNone(difference(one, shared), shared.screen)
        self.assertAlmostEqual(shared.summary["energy"] / one.summary["energy"], 1.0, delta=1e-10)
        if one.summary["errors"] is not None:
            bounds = [run.summary["errors"]["global"]["relative"] for run in (one, shared)]
            self.assertAlmostEqual(*bounds, delta=1e-8 * bounds[0] + EXACT)
        self.assertEqual(self.piecesOf(shared), bodies * pieces // ranks if areRead else 0, shared.screen)
        self.assertEqual(len(re.findall(f"(read|made) [a-z ]*by the {ranks} processes", shared.screen)), bodies if areRead else 0, shared.screen)
        return shared

    @staticmethod
    def piecesOf(run):
        return run.summary["ledger"]["counts"].get("pieces read", 0)

    def test_each_rank_reads_its_own(self):
        shared = self.compare(self.bare("punch-3d"), 4, 4, drawn=CELLS)
        shares = re.findall(r"([\d ]+) cells, read in pieces by the 4 processes in shares of ([\d ]+) to ([\d ]+)\.", shared.screen)
        self.assertEqual(len(shares), 2)
        cells, _, most = (int(number.replace(" ", "")) for number in shares[1])  # of the larger body
        self.assertLess(most, 0.5 * cells)

    def test_empty_pieces(self):
        """A part of the scene need not have cells of both bodies."""
        shared = self.compare(self.bare("punch-3d"), 8, 4, *CERTIFIED, drawn=CELLS)
        self.assertIn(0, self.cellsOfPieces("punch", 8))
        self.assertIn(0, self.cellsOfPieces("foundation", 8))
        self.assertIn("read in pieces by the 4 processes in shares of 0 to", shared.screen)
        joined = self.program.run(self.deck(self.bare("punch-3d")), *CERTIFIED, *GIVEN, *self.decomposed(self.folder / "scene.xml", 8, *CELLS))
        self.assertIsNone(difference(joined, shared))

    def cellsOfPieces(self, body, pieces):
        cells = []
        for piece in range(pieces):
            with netCDF4.Dataset(self.folder / f"scene.{body}.e.{pieces}.{piece}") as file:
                cells.append(file.dimensions["num_elem"].size if "num_elem" in file.dimensions else 0)
        return cells

    def test_several_pieces_a_rank(self):
        self.compare(self.bare("contact-loss-3d"), 6, 3, "Coupling/Type=Monolithic",
                     drawn=["Bodies/upper/Mesh/Cells={6, 6, 3}", "Bodies/lower/Mesh/Cells={12, 12, 6}"])

    def test_certified(self):
        self.compare(self.bare("punch-3d"), 3, 3, *CERTIFIED, drawn=CELLS)

    def test_refined(self):
        self.compare(self.bare("punch-3d"), 2, 2, *REFINED, *CERTIFIED, drawn=COARSE)

    def test_one_body_alone(self):
        self.compare(self.bare("beam-3d"), 2, 2, *CERTIFIED, bodies=1, drawn=["Bodies/beam/Mesh/Cells={12, 6, 6}"])

    def test_on_a_rigid_plane(self):
        root = self.bare("punch-3d")
        foundation = root.find("*[@name='Bodies']/*[@name='foundation']")
        for part in list(foundation):
            foundation.remove(part)
        add(foundation, "Rigid", Type="Plane", Point=[0.0, 0.0, 0.0], Normal=[0.0, 0.0, 1.0])
        for part in list(root.iter("ParameterList")):
            for parameter in part.findall("*[@name='Neumann Side']"):
                part.remove(parameter)
        self.compare(root, 2, 2, *CERTIFIED, bodies=1, drawn=["Bodies/punch/Mesh/Cells={7, 7, 7}"])

    def test_bodies_and_regions_in_one_file(self):
        """What a run has written, with a piece of the beam of another material, in pieces of both bodies."""
        root = self.bare("punch-3d")
        mesh = root.find("*[@name='Bodies']/*[@name='punch']/*[@name='Mesh']")
        add(mesh, "Parts", lambda parts: add(parts, "core", Lower=[0.0, 0.0, 0.0], Upper=[0.5, 0.5, 0.5]))
        add(root.find("*[@name='Bodies']/*[@name='punch']"), "Regions",
            lambda regions: add(regions, "core", lambda core: add(core, "Material", Young_Modulus=10.0, Poisson_Ratio=0.2,
                                                                  Hypothesis="Three Dimensional")))
        self.compare(root, 2, 2, *CERTIFIED, drawn=COARSE)
        whole = self.program.run(self.deck(root), *COARSE, *GIVEN)
        done, _ = self.run_deck(root, 2, *COARSE, *GIVEN[:1], "Output/Exodus Files=Pieces", name="drawn")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        sides = {"punch": ("left", "front", "top", "bottom"), "foundation": ("left", "front", "bottom", "contact")}
        for body, blocks in (("punch", "{punch, punch:core}"), ("foundation", "{foundation}")):
            holder = root.find(f"*[@name='Bodies']/*[@name='{body}']")
            holder.remove(holder.find("*[@name='Mesh']"))
            mesh = add(holder, "Mesh", Type="Exodus", File=str(self.folder / "drawn.e.2"))
            ElementTree.SubElement(mesh, "Parameter", name="Blocks", type="Array(string)", value=blocks)
            for part in holder.iter("Parameter"):
                if part.get("name") == "Side" and part.get("value") in sides[body]:
                    part.set("value", f"{body}:{part.get('value')}")
        for part in root.iter("Parameter"):
            if part.get("name") == "Dirichlet Side":
                part.set("value", "punch:bottom")
        interface = next(part for part in root.find("*[@name='Interfaces']"))
        for part in interface.findall("*[@name='Neumann Side']"):
            interface.remove(part)
        ElementTree.SubElement(interface, "Parameter", name="Neumann Side", type="string", value="foundation:contact")
        for part in root.iter("ParameterList"):
            if part.get("name") == "core" and part.find("*[@name='Material']") is not None:
                ElementTree.SubElement(part, "Parameter", name="Cells", type="Array(string)", value="{punch:core}")
        shared = self.program.run(self.deck(root), *GIVEN, ranks=2)
        self.assertEqual(shared.code, 0, shared.screen)
        self.assertEqual(self.piecesOf(shared), 2, shared.screen)
        self.assertAlmostEqual(shared.summary["energy"], whole.summary["energy"], delta=1e-8)

    def weighted(self, root, **components):
        """A body force on the punch, which contact alone holds along z."""
        loads = root.find("*[@name='Bodies']/*[@name='punch']/*[@name='Loads']")
        add(loads, "weight", Type="Body Force", **components)
        return root

    def test_a_body_force(self):
        root = self.weighted(self.bare("punch-3d"), Z="-0.1*(1+x)")
        self.compare(root, 2, 2, drawn=COARSE)
        self.compare(root, 3, 3, *CERTIFIED, drawn=CELLS)
        self.compare(root, 2, 2, *REFINED, drawn=COARSE)
        supports = next(part for part in root.iter("ParameterList") if part.get("name") == "Supports")
        add(supports, "foot", Type="Clamp", Side="back")
        self.compare(root, 2, 2, *CERTIFIED, drawn=COARSE)

    def test_a_body_force_that_lifts(self):
        """The pressure on the top pushes down with 1: what the whole body is pulled with decides, not what its outer cells are."""
        self.compare(self.weighted(self.bare("punch-3d"), Z="0.9"), 2, 2, drawn=COARSE)
        self.stopped_alike(self.weighted(self.bare("punch-3d"), Z="1.1"), "NOT CONVERGED")
        self.refused_alike(self.weighted(self.bare("punch-3d"), Z="sqrt(abs(x-0.5)+abs(y-0.5)+abs(z-0.5)-0.3)"), " is nan at (")

    def stopped_alike(self, root, message):
        """Without an answer, in the words of one process."""
        read = self.decomposed(self.deck(self.bare("punch-3d")), 2, *COARSE)
        runs = [self.program.run(self.deck(root), *GIVEN, *read, ranks=ranks) for ranks in (1, 2)]
        self.assertEqual(len({run.code for run in runs}), 1)
        self.assertNotEqual(runs[0].code, 0)
        said = [re.findall(f"(?m)^.*{message}.*$", run.screen) for run in runs]
        self.assertEqual(len(said[0]), 1, runs[0].screen)
        self.assertEqual(*said)
        self.assertIn("read in pieces by the 2 processes", runs[1].screen)

    def held(self, **support):
        """The mean motion of the punch is held instead of its rollers."""
        root = self.bare("punch-3d")
        supports = root.find("*[@name='Bodies']/*[@name='punch']/*[@name='Supports']")
        for part in list(supports):
            supports.remove(part)
        add(supports, "mean", Type="Hold", **support)
        return root

    def test_mean_motions(self):
        for root in (self.held(), self.held(Side="top")):
            self.compare(root, 2, 2, drawn=COARSE)
        self.compare(self.weighted(self.held(), Z="-0.1"), 3, 3, *CERTIFIED, drawn=CELLS)
        self.compare(self.held(), 2, 2, *REFINED, *CERTIFIED, drawn=COARSE)

    def test_mean_motions_out_of_balance(self):
        self.refused_alike(self.weighted(self.held(), X="0.25", Z="-0.1"), "a force (0.25, 0, 0)")
        self.refused_alike(self.weighted(self.held(), Y="x-0.5"), "the loads are not in equilibrium")
        self.compare(self.weighted(self.held(), X="sin(2*pi*z)"), 2, 2, drawn=COARSE)

    def test_mean_motions_without_a_free_vertex(self):
        """Only middles of edges can be pinned, which rank 0 does not know of outer cells."""
        root = self.held()
        thin = ["Bodies/punch/Mesh/Cells={6, 6, 1}", "Bodies/foundation/Mesh/Cells={12, 12, 4}"]
        self.compare(root, 2, 2, drawn=thin)  # there are enough vertices
        bodies = root.find("*[@name='Bodies']/*[@name='punch']")
        bodies.remove(bodies.find("*[@name='Loads']"))
        add(bodies.find("*[@name='Supports']"), "down", Type="Displacement", Side="top", Z="-0.01*(1+x)")
        self.compare(root, 2, 2, drawn=thin, areRead=False)

    def test_where_rank_0_has_to_know_more(self):
        root = self.bare("punch-3d")
        self.compare(root, 4, 3, drawn=CELLS, areRead=False)  # not as many for each
        self.compare(root, 2, 2, drawn=["Bodies/punch/Mesh/Cells={2, 2, 2}", "Bodies/foundation/Mesh/Cells={4, 4, 2}"], areRead=False)

    @staticmethod
    def probed(root, *places):
        """Points and lines (From, To) of the bodies."""
        probes = add(add(root, "Output"), "Probes")
        for k, (body, *ends) in enumerate(places):
            add(probes, f"probe {k}", Body=body, **({"At": ends[0]} if len(ends) == 1 else {"From": ends[0], "To": ends[1], "Points": 41}))
        return root

    def test_probes(self):
        """At a vertex, in a cell, on a facet and an edge inside, at contact, and along lines through both bodies."""
        inside = [("punch", [0.5, 0.5, 0.5]), ("punch", [0.41, 0.37, 0.43]), ("foundation", [1.0, 1.0, -0.5]), ("foundation", [0.7, 0.75, -0.61])]
        border = [("punch", [0.3, 0.3, 0.0]), ("foundation", [0.3, 0.3, 0.0])]
        lines = [("punch", [0.01, 0.02, 0.0], [0.9, 1.0, 0.97]), ("foundation", [0.1, 0.1, 0.0], [2.0, 2.0, -1.0])]
        root = self.probed(self.bare("punch-3d"), *inside, *border, *lines)
        shared = self.compare(root, 6, 3, drawn=CELLS)
        self.assertEqual(len(shared.summary["probes"]), 8)
        self.compare(root, 2, 2, *REFINED, *CERTIFIED, drawn=COARSE)

    def test_probes_outside(self):
        for wrong in ([("punch", [0.5, 0.5, 1.5])], [("foundation", [0.5, 0.5, -0.5], [0.5, 0.5, 0.5])], [("punch", [0.5, 0.5, -1e-3])]):
            self.refused_alike(self.probed(self.bare("punch-3d"), *wrong), "outside of")
        self.refused_alike(self.probed(self.bare("punch-3d"), ("punch", [0.5, 0.5])), "At has 2 coordinates and the body 3 dimensions")

    def pinned(self, *points):
        """The punch stands on points (place, and the displacements there) instead of its rollers."""
        root = self.bare("punch-3d")
        supports = root.find("*[@name='Bodies']/*[@name='punch']/*[@name='Supports']")
        for support in list(supports):
            supports.remove(support)
        for k, (place, values) in enumerate(points):
            add(supports, f"point {k}", Type="Point", At=place, **values)
        return root

    def test_supports_of_points(self):
        root = self.pinned(([0.0, 0.0, 1.0], {"X": "0", "Y": "0"}), ([1.0, 0.0, 1.0], {"Y": "1e-3*x"}))
        inside = self.pinned(([0.5, 0.5, 0.5], {"X": "0", "Y": "0"}), ([0.5, 1.0 / 3.0, 0.5], {"X": "0"}))
        sixths = ["Bodies/punch/Mesh/Cells={6, 6, 6}", "Bodies/foundation/Mesh/Cells={12, 12, 6}"]
        self.compare(root, 3, 3, *CERTIFIED, drawn=sixths)
        self.compare(inside, 2, 2, drawn=sixths)
        self.compare(self.pinned(([0.5, 0.5, 0.5], {"X": "0", "Y": "0"}), ([0.5, 0.25, 0.5], {"X": "0"})), 2, 2, *REFINED, drawn=COARSE)

    def test_points_where_no_vertex_is(self):
        held = ([0.0, 0.0, 1.0], {"X": "0", "Y": "0"})
        self.refused_alike(self.pinned(held, ([0.51, 0.5, 0.5], {"Y": "0"})), "no vertex of the mesh lies within")
        self.refused_alike(self.pinned(held, ([0.5, 0.5], {"Y": "0"})), "At has 2 coordinates and the body 3 dimensions")
        self.refused_alike(self.pinned(held, ([0.0, 0.0, 0.5], {"X": "0"})), "")  # turns about z: a rigid motion is free

    def refused_alike(self, root, message):
        """In the words of one process."""
        read = self.decomposed(self.deck(self.bare("punch-3d")), 2, *COARSE)
        deck = self.deck(root)
        one, several = (self.program.run(deck, *GIVEN, *read, ranks=ranks) for ranks in (1, 2))
        said = [re.findall(r"(?m)^.*scene\.xml:\d+: .*$", run.screen) for run in (one, several)]
        self.assertEqual(one.code, 2, one.screen)
        self.assertEqual(several.code, 2, several.screen)
        self.assertEqual(*said)
        self.assertEqual(len(said[0]), 1, one.screen)
        self.assertIn(message, said[0][0])

    def refused(self, message, damage):
        """What is wrong with pieces is said as it is where they are read as a whole."""
        deck = self.deck(self.bare("punch-3d"))
        read = self.decomposed(deck, 2, *COARSE)
        damage(self.folder)
        one, several = (self.program.run(deck, *GIVEN, *read, ranks=ranks) for ranks in (1, 2))
        for run in (one, several):
            self.assertEqual(run.code, 2, run.screen)
            self.assertEqual(run.screen.count(message), 1, run.screen)

    def test_pieces_that_do_not_belong_together(self):
        piece = "scene.foundation.e.2.1"
        self.refused("is missing", lambda folder: (folder / piece).unlink())
        self.refused("the file is shorter than its header says", lambda folder: (folder / piece).write_bytes((folder / piece).read_bytes()[:3000]))

        def move(folder):
            with netCDF4.Dataset(folder / piece, "r+") as file:
                file["coordz"][:] += 1e-9

        def repeat(folder):
            with netCDF4.Dataset(folder / piece, "r+") as file:
                file["elem_num_map"][:] = 1 + numpy.arange(len(file["elem_num_map"]))

        self.refused("is at another place in", move)
        self.refused("they are no pieces of one mesh", repeat)

    def test_a_side_inside(self):
        def add_facets(folder):  # all facets of the first cells
            for piece in (0, 1):
                with netCDF4.Dataset(folder / f"scene.foundation.e.2.{piece}", "r+") as file:
                    names = [row.tobytes().split(b"\0")[0].decode() for row in file["ss_names"][:]]
                    side = names.index("right") + 1
                    if f"elem_ss{side}" in file.variables:
                        file[f"elem_ss{side}"][:] = 1
        self.refused("are not on the boundary", add_facets)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
