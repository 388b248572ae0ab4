"""Targets of solids that are shared out: shared_targets.py NDFRAME [--scenes N] [--seed FIRST].

Random scenes with a target on one process and on 2 to 4 ranks that have shares of the meshes of all levels but the first ones, which are small:
the levels have as many dofs, bounds and brackets of the energy are the same, and what ends one run ends the other. Levels but the last are
solved loosely, so that marks, and with them meshes, may differ a little: then all brackets must have a common point. Prints what differs.
"""

import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import scene
from runs import Program, sweep, sweep_options
from solid_scenes import write_scene

NEAR = 0.1  # of the dofs of a level, where marks differ
LOOSE = 1e-2  # bounds of levels with as many cells, whose meshes may differ (the same mesh: shared_solids.py)


def brackets_differ(runs):
    ends = [level["energy_bracket"] for run in runs for level in run.levels if level.get("energy_bracket") and level["guaranteed"]]
    lower, upper = max((end["lower"] for end in ends), default=-1.0), min((end["upper"] for end in ends), default=1.0)
    return f"brackets have no common point: {lower!r} above {upper!r}" if lower > upper + 1e-9 * abs(upper) else None


def difference(one, shared):
    if one.code != shared.code:
        return f"exit codes {one.code} and {shared.code}: {one.screen[-400:]} / {shared.screen[-400:]}"
    if not one.answered:
        return None
    if not shared.answered or len(one.levels) != len(shared.levels):
        return f"{len(one.levels)} levels and {len(shared.levels) if shared.answered else 'none'}"
    if one.accuracy["reached"] != shared.accuracy["reached"]:
        return f"reached {one.accuracy['reached']} and {shared.accuracy['reached']}"
    for first, second in zip(one.levels, shared.levels):
        if abs(first["dofs"] - second["dofs"]) > NEAR * first["dofs"]:
            return f"level {first['level']}: {first['dofs']} and {second['dofs']} dofs"
        if first["dofs"] == second["dofs"] and first["elements"] == second["elements"]:
            if abs(first["bound"] - second["bound"]) > LOOSE * first["bound"]:
                return f"level {first['level']}: bounds {first['bound']!r} and {second['bound']!r}"
            if first["guaranteed"] != second["guaranteed"]:
                return f"level {first['level']}: {first['reason']!r} and {second['reason']!r}"
    bracket = shared.summary["errors"] and shared.summary["errors"]["energy_bracket"]
    if bracket and bracket["certificates"] < len(shared.levels):
        return f"{bracket['certificates']} certificates of {len(shared.levels)} levels are of one scene"
    return brackets_differ((one, shared))


def judge(program, seed):
    draw = random.Random(f"shared targets {seed}")
    kind, pair, settings = scene(draw, 2)
    ranks = draw.randint(2, 4)
    target = 10.0 ** draw.uniform(-1.4, -0.7)
    given = [f"Accuracy/Target={target}", f"Accuracy/Maximum Dofs={draw.choice((20000, 30000))}", "Linear Solver/Type=Multigrid",
             "Coupling/Type=Monolithic", "Error Estimation/Check Equilibrium=true", "Output/Exodus=false"]
    about = f"{seed}: {kind}, {ranks} ranks, {' '.join(given)}"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        one, shared = program.run(deck, *given), program.run(deck, *given, ranks=ranks)
    counts = shared.summary["ledger"]["counts"] if shared.summary else {}
    return difference(one, shared), counts.get("shared bodies", 0) > 0, about


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec, seconds=900)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    shared = sum(is_shared for is_shared, _ in found)
    print(f"{options.scenes} scenes, {wrong} wrong, {shared} with shared levels")
    sys.exit(1 if wrong or shared == 0 else 0)


if __name__ == "__main__":
    main()
