"""What must not matter to solids in contact: invariance_solids.py NDFRAME MPIEXEC.

Energy, contact force and bound of random scenes stay when the scene is turned, given in other units, numbered otherwise,
when the bodies change places in the interface, on 1, 2 and 3 ranks; all couplings agree. Uniform stress is found exactly.
"""

import math
import pathlib
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from solid_scenes import Solid, pressure, write_scene

SAME = 1e-8
STEPS = 1e-6  # of the recovery have single precision
ESTIMATE = ["Error Estimation/Estimators={Global}", "Error Estimation/Check Equilibrium=true", "Output/Exodus=false",
            "Output/Contact Table=false"]


def turned(angles, size):
    (a, b) = angles

    def place(x, y, z):
        x, z = math.cos(a) * x - math.sin(a) * z, math.sin(a) * x + math.cos(a) * z
        y, z = math.cos(b) * y - math.sin(b) * z, math.sin(b) * y + math.cos(b) * z
        return size * x, size * y, size * z

    return place


def solids(angles=(0.0, 0.0), length=1.0, stress=1.0, seed=1, uniform=False):
    place = turned(angles, length)
    load = "1" if uniform else "(1.5-r)"  # r: where on the top, seen in the turned axes
    c, s = math.cos(angles[0]), math.sin(angles[0])
    d, e = math.cos(angles[1]), math.sin(angles[1])
    # x of the unturned scene from the turned coordinates
    along = f"({c!r}*x + {s!r}*({-e!r}*y + {d!r}*z))/{length!r}"
    held = {"left": "Roller", "front": "Roller"}
    upper = Solid("upper", (3, 2, 2), lambda r, q, t: place(r, 0.8 * q, 0.5 * t), "bottom", 2.0 * stress, 0.3, held,
                  {"press": pressure("top", f"{stress!r}*({load.replace('r', along)})")}, 0.15, seed)
    lower = Solid("lower", (3, 2, 2), lambda r, q, t: place(r, 0.8 * q, 0.7 * t - 0.7), "top", 1.0 * stress, 0.3,
                  {"bottom": "Roller", "left": "Roller", "front": "Roller"} if uniform else {"bottom": "Clamp"}, {}, 0.15,
                  seed + 1)
    return upper, lower


class Check:
    def __init__(self, program):
        self.program, self.failures = program, []

    def numbers(self, pair, *settings, ranks=1, length=1.0, stress=1.0):
        with tempfile.TemporaryDirectory() as folder:
            run = self.program.run(write_scene(folder, *pair), *ESTIMATE, *settings, ranks=ranks)
        if run.code != 0:
            self.failures.append(f"exit code {run.code}: {run.screen[-300:]}")
            return None
        errors, contact = run.summary["errors"], run.summary["interfaces"][0]
        if not errors["global"]["guaranteed"] or errors["equilibrium"] > 1e-11:
            self.failures.append(f"not guaranteed or out of balance by {errors['equilibrium']}")
        energy = stress * length**3
        return {"energy": run.summary["energy"] / energy, "bound": errors["global"]["absolute"] / math.sqrt(energy),
                "force": contact["contact_force"] / (stress * length**2),
                "pressure": contact["largest_pressure"] / stress, "closed": contact["contact_area"] / length**2}

    def same(self, what, one, other, within=SAME):
        for key in one or {}:
            allowed = max(within, STEPS) if key == "bound" else within
            if other is not None and abs(one[key] - other[key]) > allowed * max(abs(one[key]), 1e-3):
                self.failures.append(f"{what}: {key} {one[key]!r} and {other[key]!r}")


def main():
    check = Check(Program(sys.argv[1], sys.argv[2]))
    for order in (1, 2):
        as_order = f"Discretization/Order={order}"
        first = check.numbers(solids(), as_order)
        about = f"order {order}"
        check.same(f"{about}, turned", first, check.numbers(solids(angles=(0.7, -0.4)), as_order))
        check.same(f"{about}, in millimetres and megapascals", first,
                   check.numbers(solids(length=1e3, stress=1e6), as_order, length=1e3, stress=1e6))
        check.same(f"{about}, bodies in the other order", first, check.numbers(solids()[::-1], as_order))
        for ranks in (2, 3):
            check.same(f"{about}, {ranks} ranks", first, check.numbers(solids(), as_order, ranks=ranks))
        for coupling in ("FETI", "Neumann-Neumann"):
            check.same(f"{about}, {coupling}", first, check.numbers(solids(), as_order, f"Coupling/Type={coupling}"))
        check.same(f"{about}, sweeps", first,
                   check.numbers(solids(), as_order, "Coupling/Type=Neumann-Dirichlet", "Coupling/Stopping/Tolerance=1e-12",
                                 "Coupling/Stopping/Maximum Sweeps=400"), 1e-6)
        exact = check.numbers(solids(uniform=True), as_order)
        if exact and (exact["bound"] > 1e-7 or abs(exact["pressure"] - 1.0) > 1e-9 or abs(exact["force"] - 0.8) > 1e-9):
            check.failures.append(f"{about}: uniform stress is not exact: {exact}")
    print("\n".join(check.failures) or "all the same")
    sys.exit(1 if check.failures else 0)


if __name__ == "__main__":
    main()
