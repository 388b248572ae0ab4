"""Scenes of which ranks have shares although a part does not show all of them: test_shared_scenes.py NDFRAME DECKS MPIEXEC.

Regions, points and means that are held, sides that are cut, tied bodies: answers, bounds, tables and files are those of one process.
"""

import pathlib
import sys
import unittest
from xml.etree import ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "io"))
import exodus_pieces
import netCDF4
import numpy
from shares_test import PUNCH, SharesTest, add
from solid_scenes import AS_MANY_STEPS


STEPPED = 1e-5  # of fields of the certificate, whose steps are in single precision


class SharedScenes(SharesTest):
    def divided(self):
        """Regions, of which some ranks have no cell: one hexahedron of the punch as drawn, with a force, and half of the foundation."""
        root = self.bare("punch-3d")
        for name, part, lower, upper, young in (("punch", "tip", [0.5, 0.5, 0.5], [1.0, 1.0, 1.0], 5.0),
                                                ("foundation", "rock", [0.0, 0.0, -1.0], [2.0, 2.0, -0.5], 20.0)):
            body = root.find(f".//ParameterList[@name='{name}']")
            add(add(body.find("ParameterList[@name='Mesh']"), "Parts"), part, Lower=lower, Upper=upper)
            add(add(add(body, "Regions"), part), "Material", Young_Modulus=young, Poisson_Ratio=0.3, Hypothesis="Three Dimensional")
        force = add(root.find(".//ParameterList[@name='Loads']"), "weight", Type="Body Force", Z="-0.3*x")
        ElementTree.SubElement(force, "Parameter", name="Cells", type="Array(string)", value="{tip}")
        return root

    def test_regions_are_those_of_one_process(self):
        root = self.divided()
        one = self.right(root, 1, *PUNCH)
        self.assertEqual([region["elements"] for region in one["bodies"][0]["regions"]], [48, 336])
        for ranks, files in ((4, "Single"), (5, "Pieces")):
            shared = self.right(root, ranks, *PUNCH, f"Output/Exodus Files={files}")
            for whole, part in zip(one["bodies"], shared["bodies"]):
                self.compare(whole["regions"], part["regions"])
                self.compare(whole["load_force"], part["load_force"])
        self.compare_files("np1", "np4")
        pieces = exodus_pieces.Pieces(self.folder.glob("np5.e.5.*"))
        pieces.check_maps()
        with netCDF4.Dataset(self.folder / "np1.e") as file:
            counts = [len(file[f"connect{b + 1}"]) for b in range(4)]
            names = exodus_pieces.texts(file, "eb_names")
        self.assertEqual(names, ["punch:tip", "punch", "foundation:rock", "foundation"])
        for block, count in enumerate(counts):
            self.assertEqual({tuple(exodus_pieces.texts(piece.file, "eb_names")) for piece in pieces.pieces}, {tuple(names)})
            elements = [piece.elements[piece.elements_of(block)] for piece in pieces.pieces]
            first = sum(counts[:block])
            numpy.testing.assert_array_equal(numpy.sort(numpy.concatenate(elements)), numpy.arange(first, first + count))
        self.assertIn(0, [len(piece.elements_of(0)) for piece in pieces.pieces])

    def test_a_region_that_names_no_cells_is_refused_once(self):
        root = self.divided()
        region = add(root.find(".//ParameterList[@name='Regions']"), "top")
        add(region, "Material", Young_Modulus=1.0, Poisson_Ratio=0.3, Hypothesis="Three Dimensional")
        done, _ = self.run_deck(root, 3, *PUNCH, "Output/Exodus=false")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertEqual(done.stderr.count('the mesh has no group of cells "top"'), 1, done.stderr)

    POINTS = [("corner", dict(Type="Point", At=[0.0, 0.0, 1.0], X="0", Y="0")), ("edge", dict(Type="Point", At=[1.0, 0.0, 1.0], Y="1e-3*x"))]

    def held(self, supports, push=0.0):
        """The punch with these supports instead of its rollers."""
        root = self.bare("punch-3d")
        body = root.find(".//ParameterList[@name='punch']")
        body.remove(body.find("ParameterList[@name='Supports']"))
        lists = add(body, "Supports")
        for name, support in supports:
            add(lists, name, **support)
        if push:
            add(body.find("ParameterList[@name='Loads']"), "push", Type="Pressure", Side="right", Value=push)
        add(root, "Error Estimation", Check_Equilibrium="true")[0].set("type", "bool")
        return root

    def test_points_and_means_are_held_alike(self):
        for supports, push, guaranteed in ((self.POINTS, 0.0, True), (self.POINTS, 0.1, False), ([("mean", dict(Type="Hold"))], 0.0, True),
                                           ([("mean", dict(Type="Hold", Side="left"))], 0.0, True)):
            root = self.held(supports, push)
            one, shared = (self.right(root, ranks, *PUNCH, "Output/Exodus=false") for ranks in (1, 4))
            for whole, part in zip(one["bodies"], shared["bodies"]):
                for key in ("supports", "energy", "largest_displacement", "held_by"):
                    self.compare(whole[key], part[key], key)
            bounds = [summary["errors"]["global"] for summary in (one, shared)]
            self.assertEqual([bound["guaranteed"] for bound in bounds], [guaranteed] * 2, bounds)
            if guaranteed:
                self.assertAlmostEqual(bounds[0]["absolute"] / bounds[1]["absolute"], 1.0, delta=1e-6)
            else:
                self.assertIn("Bodies/punch/Supports/corner holds a point with a force of ", bounds[0]["reason"])
                self.assertEqual(bounds[0]["reason"], bounds[1]["reason"])

    def test_a_point_that_refinement_makes_is_held_by_whole_bodies(self):
        root = self.held([("corner", dict(Type="Point", At=[0.25, 0.25, 1.0], X="0", Y="0")), self.POINTS[1]])
        one = self.right(root, 1, *PUNCH, "Output/Exodus=false")
        done, summary = self.run_deck(root, 3, *PUNCH, "Output/Exodus=false")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("shared bodies", summary["ledger"]["counts"])
        self.compare(one["bodies"][0]["supports"], summary["bodies"][0]["supports"])

    def test_sides_that_do_not_match_are_cut_before_they_are_shared(self):
        root = self.bare("punch-3d")
        add(root, "Error Estimation", Check_Equilibrium="true")[0].set("type", "bool")
        for refine in (0, 1):
            cells = [f"Bodies/punch/Mesh/Cells={{{n}, {n}, {n}}}" for n in (5 - 2 * refine,)] + [
                "Bodies/foundation/Mesh/Cells={8, 8, 4}" if refine == 0 else "Bodies/foundation/Mesh/Cells={4, 4, 2}"]
            settings = [PUNCH[0], *AS_MANY_STEPS, *cells, *(f"Bodies/{body}/Mesh/Refine={refine}" for body in ("punch", "foundation"))]
            one, shared = (self.right(root, ranks, *settings, "Output/Exodus Files=Single", name=f"n{refine}{ranks}") for ranks in (1, 3))
            self.assertEqual(*(summary["interfaces"][0]["nodes"] for summary in (one, shared)))
            bounds = [summary["errors"]["global"] for summary in (one, shared)]
            self.assertTrue(bounds[0]["guaranteed"] and bounds[1]["guaranteed"], bounds)
            self.assertAlmostEqual(bounds[0]["absolute"] / bounds[1]["absolute"], 1.0, delta=1e-6)
            self.compare_files(f"n{refine}1", f"n{refine}3", STEPPED)

    def fork(self):
        """Two prongs tied to a base, which touch each other: a body that touches itself."""
        root = ElementTree.Element("ParameterList", name="fork")
        bodies, interfaces = add(root, "Bodies"), add(root, "Interfaces")
        for name, lower, upper, cells, load in (("base", [0.0, 0.0, -1.0], [2.0, 1.0, 0.0], (12, 6, 6), None),
                                                ("a", [0.0, 0.0, 0.0], [1.0, 1.0, 1.0], (6, 6, 6), ("left", "0.01*z")),
                                                ("b", [1.0, 0.0, 0.0], [2.0, 1.0, 1.0], (6, 6, 6), ("right", "0.002*(1-z)"))):
            body = add(bodies, name)
            mesh = add(body, "Mesh", Type="Box", Lower=lower, Upper=upper)
            ElementTree.SubElement(mesh, "Parameter", name="Cells", type="Array(int)", value="{" + ", ".join(map(str, cells)) + "}")
            add(body, "Material", Young_Modulus=2.0 if name == "b" else 1.0, Poisson_Ratio=0.3, Hypothesis="Three Dimensional")
            if load:
                add(add(body, "Loads"), "press", Type="Pressure", Side=load[0], Value=load[1])
                add(interfaces, f"tie {name}", Dirichlet_Body="base", Dirichlet_Side="top", Neumann_Body=name, Neumann_Side="bottom",
                    Tied="true")[-1].set("type", "bool")
            else:
                add(add(body, "Supports"), "held", Type="Clamp", Side="bottom")
        add(interfaces, "slit", Dirichlet_Body="a", Dirichlet_Side="right", Neumann_Body="b", Neumann_Side="left")
        add(root, "Error Estimation", Check_Equilibrium="true")[0].set("type", "bool")
        return root

    def test_a_body_that_is_tied_and_touches_itself(self):
        root = self.fork()
        settings = [PUNCH[0], "Coupling/Type=Monolithic", "Output/Exodus Files=Single"]
        one, shared = (self.right(root, ranks, *settings) for ranks in (1, 4))
        self.compare(one["bodies"][0]["regions"], shared["bodies"][0]["regions"])
        self.assertEqual(*(summary["interfaces"][0]["closed_nodes"] for summary in (one, shared)))
        self.assertAlmostEqual(*(summary["interfaces"][0]["contact_force"] for summary in (one, shared)), delta=1e-9)
        bounds = [summary["errors"]["global"] for summary in (one, shared)]
        self.assertTrue(bounds[0]["guaranteed"] and bounds[1]["guaranteed"], bounds)
        self.assertAlmostEqual(bounds[0]["absolute"] / bounds[1]["absolute"], 1.0, delta=1e-6)
        self.compare_files("np1", "np4", STEPPED)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
