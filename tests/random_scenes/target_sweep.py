"""Random scenes reach their target or say why: target_sweep.py NDFRAME [--scenes N] [--seed FIRST] [--share S].

Scenes of two bodies (random_scenes.py) with a target of 5, 2 or 1 %, at most 60 000 dofs. A run that reaches its target
must be guaranteed and end with exit code 0, any other must end with exit code 5 or 3, name its limit and write the best
answer that it had. One line a scene that does not reach its target; exit code 1 if one breaks these rules, or if fewer
than the share reach it. 100 scenes take some minutes.
"""

import collections
import pathlib
import random
import statistics
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import checks
import random_scenes
from runs import Program

TARGETS = (0.05, 0.02, 0.01)
LIMIT = "Accuracy/Maximum Dofs=60000"


def broken_rules(run):
    """What must hold whether the target is reached or not."""
    if run.answered and run.accuracy["reached"]:
        return checks.missed_target(run)
    if run.code not in (3, 5):
        return [f"exit {run.code}"]
    if not run.answered:
        return ["no answer"]
    missed = [] if run.accuracy["limit"] else ["names no limit"]
    return missed + (checks.worse_than_before(run) if run.code == 5 else [])


def main():
    parser = random_scenes.sweep_parser(__doc__, 100)
    parser.add_argument("--share", type=float, default=0.9, help="of the scenes that must reach their target")
    given = parser.parse_args()
    program, counts, works = Program(given.ndframe), collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.seed, given.seed + given.scenes):
            scene = random_scenes.two_bodies(seed, -3.0, 3.0)
            target = random.Random(seed).choice(TARGETS)
            run = program.run(scene.write(pathlib.Path(folder)), f"Accuracy/Target={target}", LIMIT)
            broken, reached = broken_rules(run), run.answered and run.accuracy["reached"]
            counts.update(reached=bool(reached), broken=bool(broken))
            if reached:
                works.append(checks.work(run))
            if broken or not reached:
                why = run.screen.strip().splitlines()[-1]
                print(f"{scene.name} to {target} ({scene.title}): {'; '.join(broken) or 'not reached'}: {why}", flush=True)
    print(f"{counts['reached']} of {given.scenes} scenes reach their target, {counts['broken']} break a rule" +
          (f"; work: median {statistics.median(works):.2f}, most {max(works):.2f}" if works else ""))
    return 1 if counts["broken"] or counts["reached"] < given.share * given.scenes else 0


if __name__ == "__main__":
    sys.exit(main())
