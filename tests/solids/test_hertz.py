"""A sphere on a block, to a guaranteed 1 %: test_hertz.py NDFRAME DECKS. Peak pressure and radius are Hertz's to 2 %."""

import math
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program

PROGRAM, DECK = Program(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve() / "hertz-3d.xml"
RADIUS, FORCE = 0.2, 0.0014652  # of contact, and of the whole sphere, a quarter of which is meshed


class Hertz(unittest.TestCase):
    def test_pressure_and_radius(self):
        run = PROGRAM.run(DECK, "Accuracy/Target=0.01", "Output/Exodus=false")
        self.assertEqual(run.code, 0, run.screen)
        bound = run.summary["errors"]["global"]
        self.assertTrue(bound["guaranteed"])
        self.assertLessEqual(bound["relative"], 0.01)
        contact = run.summary["interfaces"][0]
        self.assertAlmostEqual(4.0 * contact["contact_force"] / FORCE, 1.0, delta=1e-5)
        pressure = 1.5 * FORCE / (math.pi * RADIUS**2)
        self.assertAlmostEqual(contact["largest_pressure"] / pressure, 1.0, delta=0.02)
        radius = math.sqrt(4.0 * contact["contact_area"] / math.pi)
        self.assertAlmostEqual(radius / RADIUS, 1.0, delta=0.02)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
