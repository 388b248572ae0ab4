"""Meshes of other programs, read by meshio: test_meshio.py PROGRAM DECKS."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import meshio
import numpy

sys.dont_write_bytecode = True
PROGRAM, DECKS = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
sys.path.insert(0, str(DECKS.parent / "python"))
from ndframe import deck_text  # noqa: E402

# A bar of 2 by 1 in series: E = 1 in the left half, 4 in the right, pulled by 1.
ENERGY = 1.0 + 0.25
INP = """** a bar
*NODE, NSET=ALL
1, 0, 0
2, 1, 0
3, 2, 0
14, 0, 1
15, 1, 1
16, 2, 1
*ELEMENT, TYPE=CPS4, ELSET=SOFT
7, 1, 2, 15, 14
*ELEMENT, TYPE=CPS3, ELSET=STIFF
8, 2, 3, 16
9, 2, 16, 15
*ELSET, ELSET=LAST
8
*NSET, NSET=BOTTOM
1, 2, 3
*NSET, NSET=WEST
1, 14
*SURFACE, NAME=EAST, TYPE=ELEMENT
%s
*STEP
"""


def material(young):
    return {"Material": {"Young Modulus": young, "Poisson Ratio": 0.0, "Hypothesis": "Plane Stress"}}


def solid(young):
    return {"Material": {"Young Modulus": young, "Poisson Ratio": 0.0, "Hypothesis": "Three Dimensional"}}


def bar(file, sides, groups, of=material, **mesh):
    west, south, east = sides[:3]
    supports = {"west": {"Type": "Roller", "Side": west}, "south": {"Type": "Roller", "Side": south}}
    if len(sides) > 3:
        supports["front"] = {"Type": "Roller", "Side": sides[3]}
    regions = {"soft": {"Cells": [groups[0]], **of(1.0)}, "stiff": {"Cells": [groups[1]], **of(4.0)}}
    return {"Bodies": {"bar": {"Mesh": {"Type": "Meshio", "File": file, **mesh}, "Regions": regions, "Supports": supports,
                               "Loads": {"pull": {"Type": "Traction", "Side": east, "X": 1.0}}}},
            "Error Estimation": {"Check Equilibrium": True}, "Strain Limit": 10.0}


class Meshio(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, scene, **options):
        (self.folder / "scene.xml").write_text(deck_text(scene, "scene"))
        return subprocess.run([PROGRAM, "-i", "scene.xml"], cwd=self.folder, text=True, capture_output=True, timeout=120,
                              **options)

    def expect_bar(self, scene, triangles):
        done = self.call(scene)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        summary = json.loads((self.folder / "scene.summary.json").read_text())
        self.assertAlmostEqual(summary["energy"], ENERGY, 11)
        self.assertLess(summary["errors"]["global"]["relative"], 1e-6)
        self.assertEqual(summary["bodies"][0]["elements"], triangles)
        return done.stdout

    def complaint(self, text, sides=("WEST", "BOTTOM", "EAST"), name="bar.inp"):
        (self.folder / name).write_text(text)
        done = self.call(bar(name, sides, ("SOFT", "STIFF")))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def test_abaqus_sets_are_regions_and_sides(self):
        (self.folder / "bar.inp").write_text(INP % "LAST, S2")
        screen = self.expect_bar(bar("bar.inp", ("WEST", "BOTTOM", "EAST"), ("SOFT", "STIFF")), 4)
        self.assertIn("1 quadrilaterals have been cut into triangles", screen)

    def write(self, name, dim=2):
        """By meshio: two cells, facets as cells with integer data (VTU) or groups (MED)."""
        points = numpy.array([[x, y] for y in (0, 1) for x in (0, 1, 2)], dtype=float)
        cells = [("quad", numpy.array([[0, 1, 4, 3], [1, 2, 5, 4]])),
                 ("line", numpy.array([[0, 3], [0, 1], [1, 2], [2, 5]]))]
        data = [[1, 2], [11, 12, 12, 13]]
        if dim == 3:
            points = numpy.array([[*point, z] for z in (0.0, 1.0) for point in points])
            cells = [("hexahedron", numpy.array([[0, 1, 4, 3, 6, 7, 10, 9], [1, 2, 5, 4, 7, 8, 11, 10]])),
                     ("quad", numpy.array([[0, 3, 9, 6], [0, 1, 7, 6], [1, 2, 8, 7], [2, 5, 11, 8],
                                           [0, 1, 4, 3], [1, 2, 5, 4]]))]
            data = [[1, 2], [11, 12, 12, 13, 14, 14]]
        data = [numpy.array(values) for values in data]
        if name.endswith(".med"):
            mesh = meshio.Mesh(points, cells, cell_data={"cell_tags": [-values for values in data]})
            mesh.cell_tags = {-1: ["soft cells"], -2: ["stiff cells"], -11: ["west"], -12: ["south"], -13: ["east"],
                              -14: ["front"]}
            mesh.point_tags = {}
        else:
            points = numpy.hstack([points, numpy.zeros((len(points), 3 - points.shape[1]))])
            mesh = meshio.Mesh(points, cells, cell_data={"part": data})
        mesh.write(self.folder / name)

    def test_integer_cell_data_of_vtu_are_groups(self):
        self.write("bar.vtu")
        self.expect_bar(bar("bar.vtu", ("part 11", "part 12", "part 13"), ("part 1", "part 2")), 4)
        self.write("bar.vtu", 3)
        sides = ("part 11", "part 12", "part 13", "part 14")
        self.expect_bar(bar("bar.vtu", sides, ("part 1", "part 2"), solid), 12)

    def test_groups_of_med(self):
        self.write("bar.med", 3)
        self.expect_bar(bar("bar.med", ("west", "south", "east", "front"), ("soft cells", "stiff cells"), solid), 12)

    def test_mistakes_are_told(self):
        self.assertIn("does not end in .inp, .vtu, .med", self.complaint("", name="bar.stl"))
        self.assertIn("meshio cannot read it", self.complaint("<VTKFile", name="bar.vtu"))
        self.assertIn("meshio cannot read it", self.complaint("not HDF5", name="bar.med"))
        self.assertIn("meshio cannot read it: Element type not available: C1",
                      self.complaint((INP % "STIFF, S2").replace("CPS4", "C1")))
        self.assertIn("its surface EAST names elements by their numbers", self.complaint(INP % "8, S2"))
        self.assertIn('its surface EAST names "OTHER, S2"', self.complaint(INP % "OTHER, S2"))
        self.assertIn('no side "EAST"', self.complaint(INP % "SOFT, S2"))  # inside the body
        self.assertIn("bar.inp", self.complaint(""))

    def test_without_meshio_it_says_what_to_install(self):
        source = (DECKS.parent / "packages/meshing/src/meshio_script.cpp").read_text()
        script = source.split('R"python(', 1)[1].split(')python"', 1)[0]
        (self.folder / "script.py").write_text(script)
        message = self.folder / "message"
        # -S: without the packages of the system
        done = subprocess.run(["/usr/bin/python3", "-I", "-S", "script.py", "bar.inp", "bar.msh", message], cwd=self.folder)
        self.assertEqual(done.returncode, 3)
        self.assertIn("apt-get install python3-meshio", message.read_text())


if __name__ == "__main__":
    unittest.main()
