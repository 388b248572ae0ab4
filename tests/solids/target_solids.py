"""Targets of solids in contact: target_solids.py NDFRAME [--scenes N] [--seed FIRST].

The random scenes of certificate_solids.py with a target: it is reached with a guaranteed bound below it, or a limit is named
(exit code 5); the error against a finer solution of the last mesh is never above the bound; no level's bracket of the
energy contradicts another's (exit code 3); shapes stay bounded and dofs grow from level to level.
"""

import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import scene
from runs import EXACT, Program, sweep, sweep_options
from solid_scenes import write_scene

WORST = 0.2  # of the first shape: longest-edge bisection keeps more


def wrong(run, target):
    if run.code not in (0, 5):
        return f"exit code {run.code}: {run.screen[-400:]}"
    levels, errors = run.levels, run.summary["errors"]
    told = errors["global"]["guaranteed"] or "are not certain near" in errors["global"]["reason"]
    if run.code == 0 and not (run.accuracy["reached"] and errors["global"]["relative"] <= target and told):
        return f"ended well with {errors['global']['relative']:.4g} for {target:.4g}"
    if any(later["dofs"] <= level["dofs"] for level, later in zip(levels, levels[1:])):
        return f"dofs {[level['dofs'] for level in levels]} do not grow"
    reference = errors["reference"]
    if reference["relative"] and reference["relative"] > EXACT and reference["displacement"] > errors["global"]["absolute"]:
        return f"bound {errors['global']['absolute']:.6g} below the error {reference['displacement']:.6g}"
    return None


def judge(program, seed):
    draw = random.Random(f"targets {seed}")
    order = draw.choice((1, 2, 2, 2))
    kind, pair, settings = scene(draw, order)
    target = 10.0 ** draw.uniform(-1.1, -0.4)
    solver = ("Automatic", "Multigrid")[seed % 2]  # the latter ends early on all levels but the last
    about = f"{seed}: {kind}, order {order}, target {target:.3f}, {solver}"
    with tempfile.TemporaryDirectory() as folder:
        run = program.run(write_scene(folder, *pair, settings), f"Discretization/Order={order}",
                          f"Linear Solver/Type={solver}", f"Accuracy/Target={target}", "Accuracy/Maximum Dofs=20000",
                          "Output/Exodus=false", "Output/Contact Table=false", "Error Estimation/Estimators={Global, Reference}",
                          "Error Estimation/Reference/Refinements=1", "Error Estimation/Reference/Maximum Dofs=100000")
    if run.code == 2 and "Every displacement of a body is prescribed" in run.screen:
        return None, None, about
    return wrong(run, target), run.code == 0, about


def main():
    options = sweep_options(__doc__)
    program = Program(options.ndframe, seconds=600)
    violations, found = sweep(options, lambda seed: judge(program, seed))
    print(f"{options.scenes} scenes, {sum(bool(hit) for hit, _ in found)} targets reached, {violations} wrong")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
