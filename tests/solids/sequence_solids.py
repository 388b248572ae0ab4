"""Cases of a study are the runs that they stand for: sequence_solids.py NDFRAME [--scenes N] [--seed FIRST].

Random scenes of solids in contact whose cases change moduli, loads, halvings, orders, solvers and estimators, one or two of them from
case to case, on one to three ranks. What a case takes from the one before - meshes, matrices that were given back, fields - changes
nothing: energies, reactions, contact and bounds of every case are those of a run of its own. Prints what differs, and how many cases there were.
"""

import json
import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import scene
from runs import Program, Run, sweep, sweep_options
from shared_solids import difference
from solid_scenes import AS_MANY_STEPS, write_scene

CASES = 5
BOUNDS = 1e-3  # of themselves, where another solver has left another field in equilibrium but for its tolerance


def variations(draw, solids):
    """Groups of parameters that change together: [{path: value}, ...] for each."""
    halvings = lambda n: {f"Bodies/{solid.name}/Mesh/Refine": str(n) for solid in solids}
    yield [halvings(0), halvings(1)]
    yield [{"Discretization/Order": "2"}, {"Discretization/Order": "1"}]
    yield [{"Linear Solver/Type": kind} for kind in ("Multigrid", "Multigrid", "Cholmod", "Automatic")]
    yield [{"Error Estimation/Estimators": chosen} for chosen in ("{Global}", "{Global}", "{Global, Algorithm, Discretization}")]
    for solid in solids:
        yield [{f"Bodies/{solid.name}/Material/Young Modulus": repr(solid.young * factor)} for factor in (1.0, draw.uniform(0.3, 3.0), 7.0)]
        for name, entries in solid.loads.items():
            for key, kind, value in entries:
                if key == "Value" and kind == "string":
                    yield [{f"Bodies/{solid.name}/Loads/{name}/Value": f"{factor}*({value})"} for factor in (1.0, 0.5, 2.0)]


def sequence(draw, solids):
    """The settings of each case: all paths in each."""
    groups = list(variations(draw, solids))
    chosen = [draw.choice(group) for group in groups]
    cases = []
    for _ in range(CASES):
        cases.append({path: value for part in chosen for path, value in part.items()})
        for group in draw.sample(range(len(groups)), draw.choice((1, 1, 2))):
            chosen[group] = draw.choice(groups[group])
    return cases


def summaries(folder):
    """By the number of the case; a case without an answer has none."""
    return {int(path.name.split(".")[-3]): json.loads(path.read_text()) for path in folder.glob("*.summary.json")}


def judge(program, seed):
    draw = random.Random(f"sequences {seed}")
    kind, pair, settings = scene(draw, 2)
    ranks = draw.choice((1, 1, 2, 3))
    solids = [solid for solid in pair if solid.foot]
    cases = sequence(draw, solids)
    given = ["Coupling/Type=Monolithic", "Output/Exodus=false", "Output/Contact Table=false", *AS_MANY_STEPS]
    axis = " && ".join(f"{path}={'; '.join(case[path] for case in cases)}" for path in cases[0])
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        study = program.run(deck, *given, "Study/Files=true", ranks=ranks, look=summaries, options=("--study", axis))
        about = f"{seed}: {kind}, {ranks} ranks"
        for number, case in enumerate(cases, 1):
            own = program.run(deck, *given, *(f"{path}={value}" for path, value in case.items()), ranks=ranks)
            found = study.found.get(number)
            if (own.summary is None) != (found is None):
                return f"case {number} {case}: {own.screen[-300:]} / {study.screen[-600:]}", 0, about
            if own.summary is None:
                continue
            wrong = difference(own, Run(own.code, study.screen, found), same=BOUNDS)
            if wrong:
                return f"case {number} {case}: {wrong}", 0, about
    return None, len(study.found), about


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec, seconds=600)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    answered = sum(number for number, _ in found)
    print(f"{options.scenes} studies, {wrong} wrong, {answered} cases with an answer")
    sys.exit(1 if wrong or answered == 0 else 0)


if __name__ == "__main__":
    main()
