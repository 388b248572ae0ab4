"""Solids in contact in extreme situations, against closed forms: right, refused (exit code 2) or stopped (3).

Two blocks on each other, on rollers at the planes x = 0, y = 0 and below, so that they may widen: a pressure p on the
top gives the uniform stress sigma_zz = -p in both, whatever their materials, and each lowers by p c / E. Driven by a
displacement d of the top beyond a gap, the pressure is p = (d - gap) / (c_1 / E_1 + c_2 / E_2). Every answer must have
six digits, every bound called guaranteed must be round-off of the solution; only the values of MAY_STOP may have none.
"""

import argparse
import dataclasses
import pathlib
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from solid_scenes import Solid, pressure, write_scene

COUPLINGS = {"Monolithic": (), "FETI": (), "Neumann-Dirichlet": ("Coupling/Stopping/Tolerance=1e-9",)}
QUIET = ("Output/Exodus=false", "Output/Contact Table=false", "Error Estimation/Estimators={Global}")
REFUSED, STOPPED = 2, 3
MAY_STOP = {("aspect", "0.001"), ("aspect", "0.01"), ("stiffness ratio", "1e-08"), ("stiffness ratio", "1e+08")}


@dataclasses.dataclass
class Blocks:
    height: float = 0.5  # of each, their width is 1
    young: tuple = (1.0, 1.0)  # upper, lower
    poisson: float = 0.3
    length: float = 1.0  # unit
    stress: float = 1.0  # unit
    excess: float = None  # the top is moved down through a gap of 0.25 and by this part of it more
    cells: tuple = (2, 2, 2)
    order: int = 2

    def pair(self):
        height, gap = self.height * self.length, 0.0 if self.excess is None else 0.25 * self.length
        wide = lambda r, s: (r * self.length, s * self.length)
        held = {"left": "Roller", "front": "Roller"}
        solid = lambda name, foot, index, bottom: Solid(
            name, self.cells, lambda r, s, t: (*wide(r, s), bottom + height * t), foot,
            self.young[index] * self.stress, self.poisson, dict(held), {}, 0.0, index + 1)
        upper, lower = solid("upper", "bottom", 0, 0.0), solid("lower", "top", 1, -height)
        lower.supports["bottom"] = "Roller"
        if self.excess is None:
            upper.loads["press"] = pressure("top", repr(self.stress))
        else:
            upper.supports["top"] = [("Type", "string", "Displacement"), ("Side", "string", "top"),
                                     ("Z", "string", repr(-0.25 * self.length * (1 + self.excess)))]
        return upper, lower, gap

    def expected(self):
        """Pressure, and a(u, u) of each body."""
        height, area = self.height * self.length, self.length ** 2
        p = self.stress
        if self.excess is not None:
            p = 0.25 * self.length * self.excess / sum(height / (young * self.stress) for young in self.young)
        return p * area, [p * p * height * area / (young * self.stress) for young in self.young]


def powers(*exponents):
    return [float(f"1e{k}") for k in exponents]


ROWS = {
    "aspect": [(f"{a:g}", Blocks(height=0.5 * a)) for a in powers(-3, -2, -1, 0, 1, 2, 3)],
    "stiffness ratio": [(f"{a:g}", Blocks(young=(1.0, a) if a < 1 else (a, 1.0)))
                        for a in powers(-8, -4, -2, -1, 0, 1, 2, 4, 8)],
    "poisson": [(f"{nu:g}", Blocks(poisson=nu)) for nu in (0.0, 0.3, 0.45, 0.49, 0.499, 0.4999, 0.49999)],
    "length": [(f"{a:g}", Blocks(length=a)) for a in powers(-9, -6, -3, 0, 3, 6, 9)],
    "stress": [(f"{a:g}", Blocks(stress=a)) for a in powers(-12, -6, 0, 6, 12)],
    "just touching": [(f"{a:g}", Blocks(excess=a)) for a in (-1e-1, -1e-6, 1e-6, 1e-3, 1e-1)],
    "one cell": [(f"order {order}", Blocks(cells=(1, 1, 1), order=order)) for order in (1, 2)],
    "first order": [(f"{a:g}", Blocks(height=0.5 * a, order=1)) for a in powers(-2, 0, 2)],
}
SHORT = {"aspect": 3, "stiffness ratio": 4, "poisson": 3, "length": 6, "stress": 4, "just touching": 2, "one cell": 1,
         "first order": 1}  # every so many


def judged(run, blocks, may_stop):
    """Nothing, or what is wrong."""
    force, energies = blocks.expected()
    if may_stop and run.code in (REFUSED, STOPPED):
        return None if "not converged" in run.screen or "no certificate" in run.screen else "no reason"
    if run.code != 0:
        return f"exit code {run.code}"
    opened = blocks.excess is not None and blocks.excess < 0
    found = run.summary["interfaces"][0]["contact_force"]
    digits = 1e-6 * (abs(force) if not opened else blocks.stress * blocks.length ** 2)
    if not abs(found - (0.0 if opened else force)) <= digits:
        return f"contact force {found}, should be {0.0 if opened else force}"
    bodies = {body["name"]: body["energy"] for body in run.summary["bodies"]}
    scale = sum(energies)
    for name, energy in zip(("upper", "lower"), energies):
        if not abs(bodies[name] - (0.0 if opened else energy)) <= 1e-6 * (energy if not opened else scale):
            return f"energy of {name} {bodies[name]}, should be {energy}"
    bound = run.summary["errors"]["global"]
    # the contact term is the root of what round-off leaves of the jump
    round_off = (1e-15 * abs(force) * 0.25 * blocks.length) ** 0.5 if blocks.excess is not None else 0.0
    if bound["guaranteed"] and not opened and not bound["absolute"] <= 1e-5 * scale ** 0.5 + round_off:
        return f"a bound of {bound['absolute']} for an exact solution of norm {scale ** 0.5}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ndframe")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--verbose", action="store_true", help="what was refused or stopped, too")
    options = parser.parse_args()
    program, findings, counts = Program(options.ndframe), [], {}
    for row, values in ROWS.items():
        for value, blocks in values[::SHORT[row]] if options.short else values:
            for coupling, extra in COUPLINGS.items():
                upper, lower, gap = blocks.pair()
                with tempfile.TemporaryDirectory() as folder:
                    deck = write_scene(folder, upper, lower, [("Gap", "string", repr(gap))])
                    run = program.run(deck, *QUIET, f"Discretization/Order={blocks.order}",
                                      f"Coupling/Type={coupling}", *extra)
                counts[run.code] = counts.get(run.code, 0) + 1
                wrong = judged(run, blocks, (row, value) in MAY_STOP)
                if options.verbose and run.code:
                    print(row, value, coupling, run.code, run.screen[-400:], flush=True)
                if wrong:
                    findings.append(f"{row} {value}, {coupling}: {wrong}")
                    print(findings[-1], run.screen[-600:], flush=True)
    print(f"{sum(counts.values())} runs, exit codes {counts}, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
