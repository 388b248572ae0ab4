"""What contact is asked of: test_conditions.py NDFRAME DECKS CASES.

Under Bernstein conditions no point of a straight side penetrates and no coefficient pulls; the bodies are in equilibrium,
also where supports hold the end of a side; on bodies of first order both conditions are one.
"""

import csv
import io
import math
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program

PROGRAM, DECKS, CASES = Program(sys.argv[1]), *(pathlib.Path(path).resolve() for path in sys.argv[2:4])


EXPECTATION_MISSED = 4  # exit code


def solve(deck, conditions, *settings):
    run = PROGRAM.run(deck, "Coupling/Type=Monolithic", "Output/Exodus=false",
                      f"Discretization/Contact Conditions={conditions}", *settings)
    assert run.code in (0, EXPECTATION_MISSED), run.screen
    return run


def rows(run):
    return [{key: float(value) for key, value in row.items() if key != "interface"}
            for row in csv.DictReader(io.StringIO(run.contact))]


def deepest(run):
    """Of the gap along a straight side whose nodes are vertex, middle, vertex, ...: the least value anywhere."""
    gaps = [row["gap"] for row in rows(run)]
    least = math.inf
    for v, m, w in zip(gaps[::2], gaps[1::2], gaps[2::2]):
        for k in range(21):
            t = k / 20
            least = min(least, v * (1 - t) * (1 - 2 * t) + 4 * m * t * (1 - t) + w * t * (2 * t - 1))
    return least


class Conditions(unittest.TestCase):
    def test_no_point_penetrates(self):
        dips = 0
        for modulus in (0.1, 0.5, 1, 1.5, 2, 5, 20):
            nodal, bernstein = (solve(DECKS / "contact-loss.xml", kind, f"Bodies/lower/Material/Young Modulus={modulus}")
                                for kind in ("Nodal", "Bernstein"))
            largest = max(abs(row["gap"]) for row in rows(bernstein))
            dips += deepest(nodal) < -1e-6 * largest
            self.assertGreaterEqual(deepest(bernstein), -1e-12 * largest)
            self.assertLess(max(row["nodal_force"] for row in rows(bernstein)), 1e-12)
        self.assertGreater(dips, 0)  # or this test shows nothing

    def test_the_answer_is_the_same_in_the_limit(self):
        nodal, bernstein = (solve(DECKS / "contact-loss.xml", kind, "Error Estimation/Estimators={Global}")
                            for kind in ("Nodal", "Bernstein"))
        bounds = [run.summary["errors"]["global"]["absolute"] for run in (nodal, bernstein)]
        self.assertAlmostEqual(bounds[0] / bounds[1], 1.0, delta=0.05)
        brackets = [run.summary["errors"]["energy_bracket"] for run in (nodal, bernstein)]
        self.assertLess(max(bracket["lower"] for bracket in brackets), min(bracket["upper"] for bracket in brackets))

    def test_forces_balance_where_supports_hold_the_end_of_a_side(self):
        for case in ("clamped-end", "inclined", "gap-opens", "held-means"):
            run = solve(CASES / case / f"{case}.xml", "Bernstein")
            self.assertLess(run.summary["residuals"]["equilibrium"], 1e-12)
            contact, largest = [0.0, 0.0], 1.0
            for body in run.summary["bodies"]:
                reactions = [support["force"] for support in body["supports"]]
                contact = [sum(forces) for forces in zip(contact, body["load_force"], *reactions)]
                largest = max(largest, *(abs(force) for force in body["load_force"]))
            self.assertLess(max(map(abs, contact)), 1e-10 * largest)

    def test_a_gap_above_the_other_side_is_not_closed_before_anything_moves(self):
        load = "Bodies/punch/Loads/press/Value=0"
        gap = "Interfaces/contact/Gap=10*(x-0.5333)^2"
        run = solve(DECKS / "punch.xml", "Bernstein", load, gap, "Bodies/punch/Supports/hang/Type=Clamp",
                    "Bodies/punch/Supports/hang/Side=top")
        self.assertEqual(max(abs(row["nodal_force"]) for row in rows(run)), 0.0)

    def test_bodies_of_first_order_have_one_kind(self):
        nodal, bernstein = (solve(DECKS / "contact-loss.xml", kind, "Discretization/Order=1")
                            for kind in ("Nodal", "Bernstein"))
        self.assertEqual(nodal.contact, bernstein.contact)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
