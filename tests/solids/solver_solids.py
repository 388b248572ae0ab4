"""Solids in contact solved whole are what their factors say: solver_solids.py NDFRAME [--scenes N] [--seed FIRST].

The random scenes of certificate_solids.py solved by one status method on all dofs (Multigrid) and by factors: energy, contact
force, contact area, peak pressure and bound are the same, or both end with the same exit code. Every third scene is solved on
2 or 3 ranks. Prints what differs, and the iterations.
"""

import math
import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import NOTHING_TO_SOLVE, scene
from runs import Program, sweep, sweep_options
from solid_scenes import AS_MANY_STEPS, write_scene

SAME = 1e-6  # of the largest: forces stop at 1e-10 of the loads
NEAR = 1e-3  # of the bound: bodies that are solved whole have no second solve for it (theory, section 4), so it is another one


def numbers(run):
    interface, errors = run.summary["interfaces"][0], run.summary["errors"]
    return {"energy": run.summary["energy"], "force": interface["contact_force"], "area": interface["contact_area"],
            "pressure": interface["largest_pressure"], "bound": errors["global"]["absolute"],
            "guaranteed": errors["global"]["guaranteed"]}


def difference(one, other):
    if one.code != other.code:
        return f"exit codes {one.code} and {other.code}: {one.screen[-300:]} / {other.screen[-300:]}"
    if one.code != 0:
        return None
    first, second = numbers(one), numbers(other)
    for key, value in first.items():
        allowed = NEAR if key == "bound" else SAME
        least = 1e-6 * math.sqrt(first["energy"]) if key == "bound" else 1e-12  # of uniform stress nothing is left but round-off
        if abs(value - second[key]) > allowed * max(abs(value), abs(second[key]), least):
            return f"{key} {value!r} and {second[key]!r}"
    return None


def judge(program, seed):
    draw = random.Random(f"solvers {seed}")
    kind, pair, settings = scene(draw, 2)
    ranks = draw.choice((2, 3)) if seed % 3 == 0 else 1
    about = f"{seed}: {kind}, {ranks} ranks"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        given = ["Discretization/Order=2", "Coupling/Type=Monolithic", "Error Estimation/Estimators={Global}",
                 "Output/Exodus=false", "Output/Contact Table=false", *AS_MANY_STEPS]
        factored = program.run(deck, *given, "Linear Solver/Type=Cholmod")
        whole = program.run(deck, *given, "Linear Solver/Type=Multigrid", "Linear Solver/Tolerance=1e-12", ranks=ranks)
    if factored.code == 2 and any(reason in factored.screen for reason in NOTHING_TO_SOLVE):
        return None, None, about
    counts = whole.summary["ledger"]["counts"] if whole.code == 0 else {}
    if whole.code == 0 and counts.get("factorisations"):
        return "something was factored", None, about
    return difference(whole, factored), counts.get("Krylov iterations"), about


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec, seconds=600)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    counts = sorted(hit for hit, _ in found if hit)
    print(f"{options.scenes} scenes, {wrong} wrong; iterations {counts[0]} to {counts[-1]}, median {counts[len(counts) // 2]}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
