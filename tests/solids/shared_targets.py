"""Targets of solids that are shared out: shared_targets.py NDFRAME [--scenes N] [--seed FIRST].

Random scenes with a target on one process and on 2 to 4 ranks that have shares of the meshes of all levels but the first ones, which are small:
levels on the same cells have the same bound and bracket of the energy, and what ends one run ends the other. Levels but the last are
solved loosely, so that marks, and with them meshes, may differ a little: then bounds are near, and all brackets have a common point.
Both runs write the meshes of their levels, which say which are the same. Prints what differs, and how much bounds on the same cells do.

Where the traction between bodies is found with the stresses (Optimal), steps of the recovery end where a pressure vanishes, and conjugate
gradients begin anew. That takes differences of the fields that it begins with, which iterations end at 1e-7, to some 250 times as much.
On bent sides the displacement that does not penetrate is chosen patch by patch. Elsewhere the same cells have the same bound.
"""

import hashlib
import pathlib
import random
import sys
import tempfile

import netCDF4
import numpy

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import scene
from runs import Program, sweep, sweep_options
from solid_scenes import AS_MANY_STEPS, write_scene

NEAR = 0.1  # of the dofs of a level and of its bound, where marks differ
TRACTIONS = ("Projected", "Optimal")
SAME = 1e-4, 1e-6  # of bounds on the same cells: before the last level, which is solved to the end, and on it
CHOSEN = 1e-4, 1e-5  # likewise, where the certificate chooses: measured 3.5e-7
SAME_END = 1e-5  # of the upper end of the bracket, the energy of the displacement that does not penetrate: measured 5e-7
SAME_ENERGY = 1e-9  # of the solution on the last level: measured 1e-12


def brackets_differ(runs):
    ends = [level["energy_bracket"] for run in runs for level in run.levels if level.get("energy_bracket") and level["guaranteed"]]
    lower, upper = max((end["lower"] for end in ends), default=-1.0), min((end["upper"] for end in ends), default=1.0)
    return f"brackets have no common point: {lower!r} above {upper!r}" if lower > upper + 1e-9 * abs(upper) else None


def cells_of(path):
    """A hash of the cells of an Exodus file by the coordinates of their vertices, bit by bit, in whatever order they are."""
    hashed = hashlib.sha256()
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        points = numpy.stack([file[f"coord{axis}"][:] for axis in "xyz"], axis=1)
        for block in range(len(file.dimensions["num_el_blk"])):
            cells = points[file[f"connect{block + 1}"][:, :4] - 1]
            rows = numpy.array([cell[numpy.lexsort(cell.T)].ravel() for cell in cells])
            hashed.update(rows[numpy.lexsort(rows.T)].tobytes())
    return hashed.hexdigest()


def levels_in(folder):
    """The cells of each level."""
    return {int(path.stem.rpartition("-")[2]): cells_of(path) for path in folder.glob("*.level-*.e")}


def difference_of_bounds(first, second):
    return abs(first["bound"] - second["bound"]) / first["bound"]


def difference_of_ends(first, second):
    ends = [level["energy_bracket"] and level["energy_bracket"]["upper"] for level in (first, second)]
    return abs(ends[0] - ends[1]) / abs(ends[0]) if all(ends) else 0.0


def same_bounds(one, shared):
    """(levels on the same cells, all levels, the largest difference of bounds of the first but the last, that of the last)"""
    if not (one.answered and shared.answered):
        return 0, 0, 0.0, 0.0
    pairs = list(zip(one.levels, shared.levels))
    is_same = [one.found[first["level"]] == shared.found.get(second["level"]) for first, second in pairs]
    bounds = [difference_of_bounds(*pair) for pair in pairs]
    before = [bound for bound, holds in zip(bounds[:-1], is_same) if holds]
    return sum(is_same), len(pairs), max(before, default=0.0), bounds[-1] if is_same and is_same[-1] else 0.0


def difference(one, shared, same):
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
        is_same = one.found[first["level"]] == shared.found[first["level"]]
        if difference_of_bounds(first, second) > (same[first is one.levels[-1]] if is_same else NEAR):
            return f"level {first['level']}: bounds {first['bound']!r} and {second['bound']!r} on {'the same' if is_same else 'other'} cells"
        if is_same and first["guaranteed"] != second["guaranteed"]:
            return f"level {first['level']}: {first['reason']!r} and {second['reason']!r}"
        if is_same and difference_of_ends(first, second) > SAME_END:
            return f"level {first['level']}: energies {first['energy_bracket']} and {second['energy_bracket']} on the same cells"
    energies = [run.summary["energy"] for run in (one, shared)]
    if one.code == 0 and is_same and one.accuracy["level"] == len(one.levels) and abs(energies[0] - energies[1]) > SAME_ENERGY * energies[0]:
        return f"energies {energies[0]!r} and {energies[1]!r} on the same cells"
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
             "Coupling/Type=Monolithic", "Error Estimation/Check Equilibrium=true", *AS_MANY_STEPS]
    traction = draw.choice(TRACTIONS)
    same = SAME if traction == "Projected" and "bent" not in kind else CHOSEN
    given.append(f"Error Estimation/Interface Traction/Type={traction}")
    about = f"{seed}: {kind}, {ranks} ranks, {' '.join(given)}"
    written = ["Output/All Levels=true", "Output/Exodus Files=Single"]
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        one, shared = (program.run(deck, *given, *written, ranks=count, look=levels_in) for count in (1, ranks))
    counts = shared.summary["ledger"]["counts"] if shared.summary else {}
    return difference(one, shared, same), (counts.get("shared bodies", 0) > 0, same, same_bounds(one, shared)), about


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec, seconds=900)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    shared = sum(is_shared for (is_shared, _, _), _ in found)
    for what, same in (("nothing chosen", SAME), ("tractions or displacements chosen", CHOSEN)):
        of_all = list(zip(*(bounds for (_, allowed, bounds), _ in found if allowed == same)))
        if of_all:
            print(f"{what}: {sum(of_all[0])} of {sum(of_all[1])} levels on the same cells, bounds differ there by "
                  f"{max(of_all[2]):.1e} before the last and by {max(of_all[3]):.1e} on it")
    print(f"{options.scenes} scenes, {wrong} wrong, {shared} with shared levels")
    sys.exit(1 if wrong or shared == 0 else 0)


if __name__ == "__main__":
    main()
