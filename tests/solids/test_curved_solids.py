"""Solids that touch along curved sides: test_curved_solids.py NDFRAME MPIEXEC.

What turns in a hole slips freely; the pressure is Lame's; bodies, couplings and processes may be exchanged; finer meshes of a
polyhedron keep its normals.
"""

import dataclasses
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from curved_solids import between, cylinder, sphere
from runs import Program
from solid_scenes import Solid, pressure, write_scene

PROGRAM = Program(sys.argv[1], sys.argv[2])
CERTIFIED = ("Error Estimation/Estimators={Global}", "Error Estimation/Check Equilibrium=true", "Output/Exodus=false")
OWN_NORMALS = [("Corner Angle", "double", "0")]
GAP = [("Gap", "string", "0.2*x^2")]
PLANES = ("left", "right", "front", "back")


def solve(first, second, *settings, interface=(), ranks=1):
    with tempfile.TemporaryDirectory() as folder:
        return PROGRAM.run(write_scene(folder, first, second, interface), *CERTIFIED, *settings, ranks=ranks)


def pin_in_ring(kind, cells, by, turn="0.01", shake=0.0):
    """A pin that is turned about the y axis in a ring that is held; by: how unequal the squares of their side are."""
    place = cylinder(math.pi / 2, 1.0, by) if kind == "cylinder" else sphere(math.pi / 3, math.pi / 3, by)
    ring = Solid("ring", (cells, cells, 2), between(place, 1.0, 2.0), "bottom", 1.0, 0.3, {"top": "Clamp"}, {}, shake, 1)
    motion = [("Type", "string", "Displacement"), ("Side", "string", "bottom"), ("X", "string", f"{turn}*z"),
              ("Y", "string", "0"), ("Z", "string", f"-{turn}*x")]
    return ring, Solid("pin", (cells, cells, 2), between(place, 0.4, 1.0), "top", 2.0, 0.2, {"turned": motion}, {}, shake, 2)


def lame(kind, cells, by, inner=0.5, outer=2.0):
    """A part of a hollow cylinder or sphere in a part of another one, pressed from outside by 1; their strain energy, and the
    pressure between them (E = 1, nu = 0.3)."""
    angle, length, nu = math.pi / 4, 0.8, 0.3
    place = cylinder(angle, length, by) if kind == "cylinder" else sphere(angle, angle, by)
    rollers = {side: "Roller" for side in PLANES}
    shell = Solid("shell", (cells, cells, cells), between(place, 1.0, outer), "bottom", 1.0, nu, rollers,
                  {"press": pressure("top", "1")}, 0.0, 1)
    core = Solid("core", (cells, cells, max(1, cells // 2)), between(place, inner, 1.0), "top", 1.0, nu, rollers, {}, 0.0, 2)
    n = 2 if kind == "cylinder" else 3
    factor = outer**n / (outer**n - inner**n)
    if kind == "cylinder":
        inward = factor * outer * (1 + nu) * ((1 - 2 * nu) + (inner / outer)**2)
        energy = inward * angle * outer * length
    else:
        inward = factor * outer * ((1 - 2 * nu) + 0.5 * (1 + nu) * (inner / outer)**3)
        energy = inward * 4 * math.pi * outer**2 / 24
    return shell, core, energy, factor * (1 - inner**n)


def pressed(kind="cylinder", by=0.3):
    """A shell pressed unevenly on a core, on GAP: contact that slips and ends inside the side."""
    place = cylinder(1.2, 1.0, by) if kind == "cylinder" else sphere(0.9, 0.9, by)
    shell = Solid("shell", (4, 3, 2), between(place, 1.0, 1.5), "bottom", 1.0, 0.3, {"left": "Roller", "front": "Roller"},
                  {"press": pressure("top", "0.05*(1.5-x)"), "side": pressure("right", "0.01")}, 0.1, 3)
    core = Solid("core", (4, 3, 2), between(place, 0.5, 1.0), "top", 3.0, 0.2, {"bottom": "Clamp"}, {}, 0.1, 4)
    return shell, core


LUG = """h = 0.3; H = 0.6; R = 1;
Point(1) = {0, 0, 0, h}; Point(2) = {R, 0, 0, h}; Point(3) = {0, R, 0, h}; Point(4) = {-R, 0, 0, h}; Point(5) = {0, -R, 0, h};
Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 4}; Circle(3) = {4, 1, 5}; Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Point(11) = {2, -2, 0, H}; Point(12) = {2, 2, 0, H}; Point(13) = {-2, 2, 0, H}; Point(14) = {-2, -2, 0, H};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 11};
Curve Loop(2) = {11, 12, 13, 14}; Plane Surface(2) = {2, 1};
p[] = Extrude {0, 0, 1} { Surface{1}; }; q[] = Extrude {0, 0, 1} { Surface{2}; };
Physical Volume("pin") = {p[1]}; Physical Volume("lug") = {q[1]};
Physical Surface("hole") = {p[2], p[3], p[4], p[5]}; Physical Surface("end") = {1};
Physical Surface("right") = {q[2]}; Physical Surface("left") = {q[4]};
"""


@dataclasses.dataclass
class FromLug(Solid):
    """A body of the script with a whole pin in a hole, one common face, unstructured."""
    def write(self, folder):
        (pathlib.Path(folder) / "lug.geo").write_text(LUG)

    def deck(self):
        return (super().deck().replace(f"{self.name}.msh", "lug.geo")
                .replace('value="lug.geo"/>', f'value="lug.geo"/><Parameter name="Regions" type="Array(string)" value="{{{self.name}}}"/>', 1))


def lug(held):
    """The lug is pulled at its ends; the pin has no load, and turns freely unless it is held."""
    supports = {"end": "Roller", **({"turn": [("Type", "string", "Hold")]} if held else {})}
    pin = FromLug("pin", (), None, "hole", 5.0, 0.3, supports)
    return FromLug("lug", (), None, "hole", 1.0, 0.3, {"left": "Clamp"}, {"pull": pressure("right", "-0.01")}), pin


def numbers(run):
    errors = run.summary["errors"]
    return {"energy": run.summary["energy"], "bound": errors["global"]["absolute"], "mean": errors["mean_stress"]["absolute"],
            "contact": errors["global"]["contact"], "oscillation": errors["global"]["oscillation"]}


class CurvedSolids(unittest.TestCase):
    def solved(self, *arguments, **options):
        run = solve(*arguments, **options)
        self.assertEqual(run.code, 0, run.screen)
        self.assertTrue(run.summary["errors"]["global"]["guaranteed"], run.summary["errors"]["global"]["reason"])
        self.assertLess(run.summary["errors"]["equilibrium"], 1e-10)
        return run

    def same(self, one, other, tolerance, of_bounds=None):
        """of_bounds: where the nodes are visited in another order, u^ ends elsewhere in the set of admissible ones."""
        first, second = numbers(one), numbers(other)
        for key, value in first.items():
            scale = tolerance * value if key == "energy" else (of_bounds or tolerance) * first["bound"]
            self.assertAlmostEqual(value, second[key], delta=scale, msg=key)

    def test_what_turns_in_a_hole_slips_freely(self):
        for kind, by in (("cylinder", 0.0), ("cylinder", 0.4), ("sphere", 0.0), ("sphere", 0.4)):
            for order in (1, 2):
                run = self.solved(*pin_in_ring(kind, 4, by), f"Discretization/Order={order}")
                locked = self.solved(*pin_in_ring(kind, 4, by), f"Discretization/Order={order}", interface=OWN_NORMALS)
                self.assertLess(run.summary["energy"], 1e-18 * locked.summary["energy"], (kind, by, order))
                self.assertLess(numbers(run)["bound"], 1e-8 * numbers(locked)["bound"], (kind, by, order))

    def test_a_pin_turns_freely_in_an_unstructured_hole(self):
        run = solve(*lug(False))
        self.assertEqual(run.code, 2)
        self.assertIn("free rigid motions: rotation about the axis (0, 0, 1)", run.screen)
        held, locked = self.solved(*lug(True)), self.solved(*lug(False), interface=OWN_NORMALS)
        self.assertLess(numbers(held)["bound"], 0.7 * numbers(locked)["bound"])

    def test_the_pressure_is_that_of_lame(self):
        for kind in ("cylinder", "sphere"):
            for by in (0.0, 0.3):
                wrong = []
                for cells in (2, 4):
                    shell, core, energy, between_them = lame(kind, cells, by)
                    run = self.solved(shell, core)
                    pressures = [float(line.split(",")[4]) for line in run.contact.splitlines()[1:]]
                    wrong.append((abs(run.summary["energy"] / energy - 1.0),
                                  max(abs(p / between_them - 1.0) for p in pressures)))
                self.assertLess(wrong[1][0], wrong[0][0] / 3.0, (kind, by, wrong))  # the polyhedron's own error
                self.assertLess(wrong[1][1], 0.03, (kind, by, wrong))

    def test_either_body_may_be_first(self):
        for kind in ("cylinder", "sphere"):
            for order in (1, 2):
                first, second = pressed(kind)
                settings = (f"Discretization/Order={order}", "Coupling/Type=Monolithic")
                run = self.solved(first, second, *settings, interface=GAP)
                closed = [line.split(",")[-1] == "1" for line in run.contact.splitlines()[1:]]
                self.assertTrue(0.2 * len(closed) < sum(closed) < len(closed), (sum(closed), len(closed)))
                self.same(run, self.solved(second, first, *settings, interface=GAP), 1e-10, 0.02)

    def test_couplings_agree(self):
        runs = [self.solved(*pressed(), f"Coupling/Type={kind}", "Coupling/Stopping/Tolerance=1e-9" if kind == "Neumann-Dirichlet"
                            else "Discretization/Order=2", interface=GAP) for kind in ("Monolithic", "FETI", "Neumann-Dirichlet")]
        for run in runs[1:]:
            self.same(runs[0], run, 1e-5)

    def test_processes_and_solvers_agree(self):
        one = self.solved(*pressed(), interface=GAP)
        for ranks in (2, 3):
            self.same(one, self.solved(*pressed(), interface=GAP, ranks=ranks), 1e-8)
        self.same(one, self.solved(*pressed(), "Linear Solver/Type=Multigrid", "Coupling/Type=Monolithic", interface=GAP), 1e-4)

    def test_finer_meshes_keep_the_normals(self):
        run = self.solved(*pressed("sphere"), "Accuracy/Target=0.05", "Accuracy/Of=Displacement", interface=GAP)
        levels = run.levels
        self.assertGreater(len(levels), 1)
        self.assertTrue(run.accuracy["reached"])
        self.assertFalse(run.summary["errors"].get("contradiction"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
