"""What --plan says of boxes before there is a mesh: test_planned_size.py NDFRAME DECKS."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

NDFRAME, DECKS = sys.argv[1], pathlib.Path(sys.argv[2])


class PlannedSize(unittest.TestCase):
    def compare(self, deck, *settings):
        """The dofs of the plan are those of the run."""
        options = [part for setting in settings for part in ("--set", setting)]
        command = [NDFRAME, "-i", str(DECKS / f"{deck}.xml"), *options]
        plan = subprocess.run([*command, "--plan"], capture_output=True, text=True, check=True).stdout
        planned = re.search(r"for some ([\d ]+) dofs", plan)
        self.assertIsNotNone(planned, plan)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([*command, "--set", "Output/Exodus=false"], cwd=folder, capture_output=True)
            summary = json.loads((pathlib.Path(folder) / f"{deck}.summary.json").read_text())
        self.assertEqual(int(planned[1].replace(" ", "")), sum(body["dofs"] for body in summary["bodies"]), settings)

    def test_triangles(self):
        for pattern in ("Right", "Alternating", "Crossed"):
            for order in (1, 2):
                self.compare("punch", f"Bodies/punch/Mesh/Pattern={pattern}", f"Discretization/Order={order}",
                             "Bodies/punch/Mesh/Cells={4, 6}", "Bodies/foundation/Mesh/Cells={8, 3}", "Bodies/foundation/Mesh/Refine=1",
                             "Bodies/punch/Mesh/Refine=1")

    def test_flat_tetrahedra(self):
        for pattern in ("Right", "Alternating"):
            self.compare("beam-3d", f"Bodies/beam/Mesh/Pattern={pattern}", "Bodies/beam/Mesh/Cells={7, 5, 1}")
        self.compare("punch-3d", "Bodies/punch/Mesh/Cells={4, 4, 2}", "Bodies/foundation/Mesh/Cells={8, 8, 1}",
                     "Bodies/punch/Mesh/Refine=1", "Bodies/foundation/Mesh/Refine=1")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
