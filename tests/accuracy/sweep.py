"""Runs with a target hold what they promise: sweep.py NDFRAME DECKS [--short] [--scenes NAME ...] [--no-references].

In full: all scenes of this folder and the decks `punch` and `contact-loss`, with 2, 1, 0.5 and 0.1 %, and every level
of a run to 1 % against a reference. `--short`: two scenes with 2 and 1 %. One line a run; exit code 1 if something does
not hold. Counts only, no seconds: the answer is the same on any machine.
"""

import argparse
import pathlib
import sys

import checks
from runs import Program

SCENES = pathlib.Path(__file__).parent / "scenes"
TARGETS = (0.02, 0.01, 0.005, 0.001)
# (dofs, sweeps a level after the first) at most, of the shipped decks.
LIMITS = {
    "punch": {0.01: (1600, 2), 0.00455: (3200, 2), 0.001: (14500, 2)},
    "contact-loss": {0.01: (1700, 3), 0.005: (3700, 3), 0.001: (17500, 3)},
}
SHORT_SCENES = ("inclined", "body-force")
SHORT_TARGETS = (0.02, 0.01)


def settings(target, *more):
    return [f"Accuracy/Target={target}", *more]


def missed_limits(run, limits):
    dofs, sweeps = limits
    missed = [f"{run.dofs} dofs, at most {dofs} allowed"] if run.dofs > dofs else []
    return missed + checks.too_many_sweeps(run, sweeps)


def run_to(program, deck, target):
    """A run and what it misses."""
    run = program.run(deck, *settings(target))
    if run.summary is None or run.summary["accuracy"] is None:
        return None, [f"exit {run.code}: {run.screen[-300:]}"]
    missed = checks.missed_target(run) + checks.wasted_work(run) + checks.lost_force(run)
    limits = LIMITS.get(deck.stem, {}).get(target)
    return run, missed + (missed_limits(run, limits) if limits else [])


def report(what, text, missed):
    print(f"{what:<28} {text}", flush=True)
    for sentence in missed:
        print(f"    MISSED: {sentence}", flush=True)
    return len(missed)


def numbers(run):
    sweeps = ", ".join(str(level["sweeps"]) for level in run.levels)
    return (f"{run.dofs:>7} dofs  {100 * run.levels[-1]['relative']:.4g} %  work {checks.work(run):.2f}"
            f"  sweeps {sweeps}")


def check_targets(program, deck, targets):
    runs, misses = [], 0
    for target in targets:
        run, missed = run_to(program, deck, target)
        misses += report(f"{deck.stem} {100 * target:g} %", numbers(run) if run else "no result", missed)
        runs += [run] if run else []
    return misses + report(f"{deck.stem} slope", f"{checks.slope_of(runs):.3f}", checks.missed_slope(runs))


def check_references(program, deck, target):
    """The bound of every level above its error against a mesh that is four times finer."""
    effectivities, missed, ended = [], [], False
    while not ended:
        level = len(effectivities) + 1
        run = program.run(deck, *settings(target, f"Accuracy/Maximum Levels={level}",
                                          "Error Estimation/Estimators={Global, Reference}",
                                          "Error Estimation/Reference/Refinements=2"))
        missed += checks.bound_below_error(run)
        effectivities.append(run.summary["errors"]["reference"]["effectivity"])
        ended = run.accuracy["reached"] or len(run.levels) < level  # by its target or by another limit
    return report(f"{deck.stem} effectivity", ", ".join(f"{e:.3f}" for e in effectivities), missed)


def options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ndframe", help="the built program")
    parser.add_argument("decks", type=pathlib.Path, help="folder of punch.xml and contact-loss.xml")
    parser.add_argument("--short", action="store_true", help="two scenes, mild targets")
    parser.add_argument("--scenes", nargs="+", default=(), help="only these")
    parser.add_argument("--no-references", action="store_true", help="leave out the comparison with finer meshes")
    return parser.parse_args()


def chosen_decks(given):
    decks = [*sorted(SCENES.glob("*.xml")), *(given.decks / f"{name}.xml" for name in LIMITS)]
    names = given.scenes or (SHORT_SCENES if given.short else [deck.stem for deck in decks])
    return [deck for deck in decks if deck.stem in names]


def main():
    given = options()
    program = Program(given.ndframe)
    misses = 0
    for deck in chosen_decks(given):
        targets = SHORT_TARGETS if given.short else sorted({*TARGETS, *LIMITS.get(deck.stem, ())}, reverse=True)
        misses += check_targets(program, deck, targets)
        if not given.no_references:
            misses += check_references(program, deck, targets[1])
    print(f"{misses} promises are not held" if misses else "all promises are held")
    return 1 if misses else 0


if __name__ == "__main__":
    sys.exit(main())
