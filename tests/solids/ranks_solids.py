"""The certificate of solids that ranks share is that of one process: ranks_solids.py NDFRAME [--scenes N] [--seed FIRST].

The random scenes of certificate_solids.py on one process and on 2 to 5 ranks, with all estimators, both the bound's tractions
chosen by the recovery and (every third scene) as they are: all numbers of the errors are the same to round-off, the stresses
are in balance, and no rank holds the matrices of all cells. Prints what differs.
"""

import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import scene
from runs import Program, sweep, sweep_options
from solid_scenes import write_scene

SAME = 1e-7  # of the bound, or of a third of the solution: parts that vanish are roots of round-off
BALANCED = 1e-9


def numbers(errors, path=""):
    if isinstance(errors, dict):
        for name, value in errors.items():
            yield from numbers(value, f"{path}/{name}")
    elif isinstance(errors, (int, float)) and not isinstance(errors, bool) and "equilibrium" not in path:
        yield path, errors


def difference(one, shared):
    if one.code != shared.code:
        return f"exit codes {one.code} and {shared.code}: {one.screen[-300:]} / {shared.screen[-300:]}"
    if one.code != 0:
        return None
    first, second = one.summary["errors"], shared.summary["errors"]
    if first["global"]["guaranteed"] != second["global"]["guaranteed"]:
        return f"guaranteed: {first['global']['guaranteed']} and {second['global']['guaranteed']}"
    least = max(first["global"]["absolute"], 0.3 * one.summary["energy"] ** 0.5)
    for (path, value), (_, other) in zip(numbers(first), numbers(second)):
        size = least if "relative" not in path else 1.0
        if "advice" not in path and abs(value - other) > SAME * max(abs(value), abs(other), size):
            return f"{path} {value!r} and {other!r}"
    for name in ("equilibrium", "equilibrium_discretization"):
        if second.get(name) is not None and second[name] > max(BALANCED, 10.0 * first[name]):
            return f"{name} {first[name]} and {second[name]}"
    counts = shared.summary["ledger"]["counts"]
    if counts["cell matrices"] != one.summary["ledger"]["counts"]["cell matrices"]:
        return "cell matrices"
    return None


def judge(program, seed):
    draw = random.Random(f"ranks {seed}")
    kind, pair, settings = scene(draw, draw.choice((1, 2)))
    ranks = draw.randint(2, 5)
    given = ["Discretization/Order=" + str(draw.choice((1, 2))), "Error Estimation/Check Equilibrium=true",
             "Error Estimation/Estimators=" + draw.choice(("{Global}", "{Global, Discretization, Algorithm, Split}")),
             "Coupling/Type=" + draw.choice(("Monolithic", "Automatic")), "Output/Exodus=false", "Output/Contact Table=false"]
    if seed % 3 == 0:
        given.append("Error Estimation/Interface Traction/Type=Projected")
    about = f"{seed}: {kind}, {ranks} ranks, {' '.join(given)}"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        one, shared = program.run(deck, *given), program.run(deck, *given, ranks=ranks)
    return difference(one, shared), one.code, about


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec, seconds=600)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    print(f"{options.scenes} scenes, {wrong} wrong, {sum(code == 0 for code, _ in found)} certified")
    sys.exit(1 if wrong or not any(code == 0 for code, _ in found) else 0)


if __name__ == "__main__":
    main()
