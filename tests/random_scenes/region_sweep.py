"""Bounds hold where bodies have several materials: region_sweep.py NDFRAME [--scenes N] [--seed FIRST].

Random scenes of two bodies (random_scenes.py) with parts up to a thousand times as stiff or as soft, of either order.
No bound may be below the error against a reference eight times finer (32 times where one seems to be: the reference
penetrates between its nodes), the recovered stress has to be in equilibrium, every bound guaranteed. One line a scene
that misses; exit code 1 if there is one. 200 scenes take some minutes.
"""

import pathlib
import statistics
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import random_scenes
from runs import Program

CERTIFIED = ("Error Estimation/Estimators={Global, Reference}", "Error Estimation/Check Equilibrium=true")
ROUND_OFF = 1e-7  # relative to the bound
BALANCE = 1e-8  # of the recovered stress: round-off of a solution with such contrasts


def violations(errors):
    bound, reference = errors["global"], errors["reference"]
    found = [f"{name}: error {error} above {limit}" for name, error, limit in
             (("displacement", reference["displacement"], bound["absolute"]), ("stress", reference["stress"], bound["absolute"]),
              ("mean stress", reference["mean_stress"], errors["mean_stress"]["absolute"]))
             if not error <= limit * (1 + ROUND_OFF)]
    if errors["equilibrium"] > BALANCE:
        found.append(f"out of balance by {errors['equilibrium']}")
    return found if bound["guaranteed"] else [*found, f"not guaranteed: {bound['reason']}"]


def misses(program, deck):
    """([what does not hold], bound over error)"""
    run = program.run(deck, *CERTIFIED)
    if run.code != 0:
        return [f"exit {run.code}: {run.screen.strip().splitlines()[-1]}"], None
    errors = run.summary["errors"]
    found = violations(errors)
    if any("above" in text for text in found):
        found = violations(program.run(deck, *CERTIFIED, "Error Estimation/Reference/Refinements=5").summary["errors"])
    error = errors["reference"]["displacement"]
    return found, errors["global"]["absolute"] / error if error > 0.0 else None  # none where nothing moves


def main():
    given = random_scenes.sweep_parser(__doc__, 200).parse_args()
    program, missed, ratios = Program(given.ndframe), 0, []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.seed, given.seed + given.scenes):
            scene = random_scenes.bodies_of_regions(seed)
            missing, ratio = misses(program, scene.write(pathlib.Path(folder)))
            ratios += [ratio] if ratio else []
            missed += bool(missing)
            for text in missing:
                print(f"{scene.name} ({scene.title}): {text}", flush=True)
    print(f"{missed} of {given.scenes} scenes miss; bound over error: median {statistics.median(ratios):.2f}, "
          f"least {min(ratios):.4f}, most {max(ratios):.2f}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
