"""ndstress's own solver against closed forms, identities and invariances."""

import dataclasses
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "apps/ndstress"))
import reference  # noqa: E402
import rows  # noqa: E402
import scenes  # noqa: E402


def difference(a, b):
    return float(np.abs(a - b).max() / np.abs(b).max())


class Reference(unittest.TestCase):
    def test_uniform_compression_is_exact_for_both_degrees(self):
        for order in (1, 2):
            scene = dataclasses.replace(rows.strip(5), order=order)
            found, closed = reference.solve(scene), rows.strip_answer(scene)
            vertices = slice(None, None, order)
            self.assertLess(difference(found.u_upper[vertices], closed.u_upper), 1e-15)
            self.assertLess(difference(found.u_lower[vertices], closed.u_lower), 1e-15)
            self.assertLess(difference(np.array(found.energies), np.array(closed.energies)), 1e-15)
            self.assertLess(abs(found.force.sum() - 4.0), 1e-16)

    def test_conditions_of_contact_hold_and_contact_is_lost_on_a_part(self):
        for scene in (scenes.lifting(), rows.with_gap(scenes.pressed(), 0.0, 0.0, 100.0)):
            answer = reference.solve(scene)
            gap = reference.polynomial(scene.gap, answer.points) + answer.u_upper - answer.u_lower
            self.assertGreaterEqual(gap.min(), -1e-16)
            self.assertGreaterEqual(answer.force.min(), 0.0)
            self.assertLess(np.abs(gap * answer.force).max(), 1e-16)
            self.assertGreater((answer.force > 0).sum(), 0)
            self.assertGreater((gap > 1e-3).sum(), 0)

    def test_the_contact_force_carries_the_load_of_a_floating_body(self):
        self.assertAlmostEqual(float(reference.solve(scenes.pressed(load=(1.0, 0.5))).force.sum()), 1.25, places=15)

    def test_energy_grows_with_the_square_of_the_load_without_gap(self):
        scene = scenes.lifting()
        double = reference.solve(scenes.loaded(scene, 2.0))
        once = reference.solve(scene)
        self.assertLess(abs(sum(double.energies) / sum(once.energies) - 4), 1e-15)

    def test_units_place_and_numbering_do_not_matter(self):
        once = reference.solve(scenes.lifting())
        shifted = reference.solve(scenes.shifted(scenes.lifting(), 1024.0))
        self.assertLess(difference(shifted.force, once.force), 1e-13)
        scaled = reference.solve(scenes.scaled(scenes.lifting(), 8.0, 0.25))
        self.assertLess(difference(scaled.u_upper, 8.0 * once.u_upper), 1e-14)
        self.assertLess(difference(scaled.force, 2.0 * once.force), 1e-14)
        permuted = reference.solve(scenes.renumbered(scenes.lifting(), 5))
        self.assertLess(difference(permuted.u_lower, once.u_lower), 1e-14)

    def test_a_body_that_nothing_holds_is_named_so(self):
        for scene in (scenes.loaded(scenes.pressed(), -1.0), rows.tipping(7.0)):
            with self.assertRaises(reference.Unheld):
                reference.solve(scene)


if __name__ == "__main__":
    unittest.main()
