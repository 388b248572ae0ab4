"""A body touches itself: test_self.py NDFRAME MPIEXEC.

A plate with a slit is what two plates are that are tied beyond the slit and touch along it; which side is named first does not
matter; every coupling that can, any number of ranks, a target and Automatic give the same answer.
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from self_scenes import contact, grid, hairpin, parameter, write_scene, listed
from side_scenes import even

SAME = 1e-10
COLUMNS, SLIT = 6, 3


def energy(run):
    return sum(body["energy"] for body in run.summary["bodies"])


def force(run):
    return abs(run.summary["interfaces"][-1]["contact_force"])


def plate(load="0.01*(1-2*x)"):
    body = grid("plate", even(COLUMNS), even(4), lambda s, t, above: (1.5 * s, t), slit=(2, SLIT))
    body.supports, body.pressures = {"bottom": "Clamp"}, {"top": load}
    return body


def halves(load="0.01*(1-2*x)"):
    """The same plate as two bodies with a common line."""
    upper = grid("upper", even(COLUMNS), even(2), lambda s, t, above: (1.5 * s, 0.5 + 0.5 * t), split=("bottom", SLIT))
    lower = grid("lower", even(COLUMNS), even(2), lambda s, t, above: (1.5 * s, 0.5 * t), split=("top", SLIT))
    lower.supports, upper.pressures = {"bottom": "Clamp"}, {"top": load}
    return [upper, lower]


def pin():
    body = grid("pin", [0.25 * k / 3 for k in range(4)] + [0.25 + k / 16 for k in range(1, 9)] + [0.75 + 0.05 * k for k in range(1, 6)],
                even(2), hairpin(0.1, 0.2, 1.0, 0.5))
    for side, name in (("bottom", "in"), ("top", "out")):
        for which, sign in (("lower", -1), ("upper", 1)):
            body.sides[f"{name} {which}"] = [facet for facet in body.sides[side]
                                             if all(body.points[v][0] >= -1e-9 and sign * body.points[v][1] > 0 for v in facet)]
    for whole in ("bottom", "top"):
        del body.sides[whole]
    body.supports, body.pressures = {"out lower": "Clamp"}, {"out upper": "0.05*x"}
    return body


LEGS = contact(("pin", "in lower"), ("pin", "in upper"))
CRACK = contact(("plate", "below"), ("plate", "above"))


class Self(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def solve(self, bodies, interfaces, *settings, code=0, ranks=1):
        run = Program(NDFRAME, MPIEXEC).run(write_scene(self.folder, bodies, interfaces), *settings, ranks=ranks)
        self.assertEqual(run.code, code, run.screen)
        return run

    def assert_same(self, one, other, what=energy, tolerance=SAME):
        self.assertGreater(abs(what(one)), 1e-9)
        self.assertLess(abs(what(one) - what(other)), tolerance * abs(what(one)))

    def test_a_slit_is_two_bodies_that_are_tied_beyond_it(self):
        whole = self.solve([plate()], {"crack": CRACK})
        parts = self.solve(halves(), {"bond": contact(("upper", "far"), ("lower", "far"), Tied=("bool", "true")),
                                      "crack": contact(("upper", "near"), ("lower", "near"))})
        self.assert_same(whole, parts)
        self.assert_same(whole, parts, force)
        self.assertGreater(force(whole), 1e-3)

    def test_a_slit_that_is_pressed_shut_is_none(self):
        """Even pressure on a plate that slides along its lower side: uniform stress, no matter the slit."""
        body = plate("0.02")
        body.supports = {"bottom": "Roller", "right": "Roller"}
        run = self.solve([body], {"crack": CRACK}, "Error Estimation/Estimators={Global}")
        exact = 1.5 * 0.02**2 * (1 - 0.3**2)
        self.assertLess(abs(energy(run) - exact), 1e-12 * exact)
        self.assertLess(run.summary["errors"]["global"]["absolute"], 1e-10)

    def test_couplings_sides_and_ranks(self):
        one = self.solve([pin()], {"legs": LEGS}, "Error Estimation/Estimators={Global}")
        self.assertGreater(force(one), 0.01)
        self.assertTrue(one.summary["errors"]["global"]["guaranteed"])
        for coupling in ("FETI", "Neumann-Neumann"):
            self.assert_same(one, self.solve([pin()], {"legs": LEGS}, f"Coupling/Type={coupling}"), tolerance=1e-8)
        for ranks in (2, 3):
            other = self.solve([pin()], {"legs": LEGS}, "Error Estimation/Estimators={Global}", ranks=ranks)
            self.assert_same(one, other, lambda run: run.summary["errors"]["global"]["absolute"], 1e-8)
        exchanged = {"legs": contact(("plate", "above"), ("plate", "below"))}
        self.assert_same(self.solve([plate()], {"crack": CRACK}), self.solve([plate()], exchanged), force)

    def test_targets(self):
        run = self.solve([pin()], {"legs": LEGS}, "Accuracy/Target=0.05")
        self.assertTrue(run.accuracy["reached"], run.screen)
        self.assertLessEqual(run.summary["errors"]["global"]["relative"], 0.05)

    def test_automatic_finds_the_two_sides(self):
        written = self.solve([pin()], {"legs": LEGS})
        deck = write_scene(self.folder, [pin()], {})
        found = listed("Interfaces", listed("Automatic", parameter("Distance", "double", "0.3")))
        deck.write_text(deck.read_text().replace(listed("Interfaces"), found))
        run = Program(NDFRAME).run(deck)
        self.assertEqual(run.code, 0, run.screen)
        self.assert_same(written, run, force, 1e-6)

    def test_messages(self):
        alone = {"crack": contact(("plate", "below"), ("plate", "below"))}
        self.assertIn('Interfaces/crack: a side cannot touch itself; name two sides of "plate".',
                      self.solve([plate()], alone, code=2).screen)
        self.assertIn('"plate" touches itself and would have both roles, which Neumann-Dirichlet cannot solve; use Coupling/Type = ',
                      self.solve([plate()], {"crack": CRACK}, "Coupling/Type=Neumann-Dirichlet", code=2).screen)


if __name__ == "__main__":
    NDFRAME, MPIEXEC = sys.argv[1], sys.argv[2]
    unittest.main(argv=sys.argv[:1])
