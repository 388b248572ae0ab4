"""Runs with a target hold what they promise: sweep.py NDFRAME DECKS [--short] [--scenes NAME ...] [--no-references].

In full: all plane scenes of this folder (solids: ../solids/target_solids.py) and the decks `punch` and `contact-loss`, with 2, 1, 0.5 and 0.1 %, and every level
of a run to 1 % against a reference; scenes from gmsh scripts also with `Remesh`; the two decks also from other first
meshes and with other stiffnesses and relaxations.
`--short`: two scenes with 2 and 0.5 %. One line a run; exit code 1 if something does not hold. Counts only, no seconds:
the answer is the same on any machine.
"""

import argparse
import dataclasses
import pathlib
import sys
import tempfile

import checks
import starts
from runs import Program

SCENES = pathlib.Path(__file__).parent / "scenes"
TARGETS = (0.02, 0.01, 0.005, 0.001)
MILD_TARGET = 0.01
STRICT_TARGET = 0.001
# (dofs, sweeps a level after the first) at most, of the shipped decks.
LIMITS = {
    "punch": {0.01: (1600, 2), 0.00455: (3200, 2), 0.001: (14500, 2)},
    "contact-loss": {0.01: (1700, 3), 0.005: (3700, 3), 0.001: (17500, 3)},
}
# Width of the bracket of where contact ends, at most.
BRACKETS = {"contact-loss": {0.01: 0.03, 0.005: 0.015, 0.001: 0.003}}
REMESHED = ("hole", "l-on-block")
STIFFNESS_RATIOS = (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3)
RELAXATIONS = {f"{kind} {theta}": (f"Coupling/Relaxation/Type={kind}", f"Coupling/Relaxation/{name}={theta}")
               for kind, name in (("Constant", "Theta"), ("Aitken", "Initial Theta")) for theta in (0.2, 0.5, 0.9)}
RELAXATIONS["Automatic"] = ("Coupling/Dirichlet Body=Automatic", "Coupling/Relaxation/Type=Automatic")
SHORT_SCENES = ("inclined", "body-force")
SHORT_TARGETS = (0.02, 0.005)


@dataclasses.dataclass(frozen=True)
class Scene:
    """A deck, with settings that hold for all of its runs."""

    name: str
    deck: pathlib.Path
    settings: tuple = ()

    def run(self, program, target, *more):
        return program.run(self.deck, f"Accuracy/Target={target}", *self.settings, *more)


def missed_limits(run, limits):
    dofs, sweeps = limits
    missed = [f"{run.dofs} dofs, at most {dofs} allowed"] if run.dofs > dofs else []
    return missed + checks.too_many_sweeps(run, sweeps)


def run_to(program, scene, target):
    """A run and what it misses."""
    run = scene.run(program, target)
    if not run.answered:
        return run, checks.no_answer(run)
    missed = checks.missed_target(run) + checks.wasted_work(run) + checks.lost_force(run)
    limits = LIMITS.get(scene.name, {}).get(target)
    bracket = BRACKETS.get(scene.name, {}).get(target)
    missed += missed_limits(run, limits) if limits else []
    return run, missed + (checks.wide_brackets(run, bracket) if bracket else [])


def report(what, text, missed):
    print(f"{what:<28} {text}", flush=True)
    for sentence in missed:
        print(f"    MISSED: {sentence}", flush=True)
    return len(missed)


def numbers(run):
    if not run.answered:
        return "no result"
    sweeps = ", ".join(str(level["sweeps"]) for level in run.levels)
    return (f"{run.dofs:>7} dofs  {100 * run.levels[-1]['relative']:.4g} %  work {checks.work(run):.2f}"
            f"  sweeps {sweeps}")


def check_targets(program, scene, targets):
    runs, misses = [], 0
    for target in targets:
        run, missed = run_to(program, scene, target)
        misses += report(f"{scene.name} {100 * target:g} %", numbers(run), missed)
        runs += [run] if run.answered else []
    return misses + report(f"{scene.name} slope", f"{checks.slope_of(runs):.3f}", checks.missed_slope(runs))


def check_references(program, scene):
    """The bound of every level above its error against a mesh that is four times finer."""
    effectivities, missed, ended = [], [], False
    while not ended:
        level = len(effectivities) + 1
        run = scene.run(program, MILD_TARGET, f"Accuracy/Maximum Levels={level}",
                        "Error Estimation/Estimators={Global, Reference}", "Error Estimation/Reference/Refinements=2")
        missed += checks.bound_below_error(run)
        effectivities.append(run.summary["errors"]["reference"]["effectivity"])
        ended = run.accuracy["reached"] or len(run.levels) < level  # by its target or by another limit
    return report(f"{scene.name} effectivity", ", ".join(f"{e:.3f}" for e in effectivities), missed)


def check_starts(program, scene):
    """The dofs that a target takes do not depend on the first mesh."""
    coarsest, misses = scene.run(program, STRICT_TARGET).dofs, 0
    with tempfile.TemporaryDirectory() as folder:
        for what, settings in starts.starts(scene.deck, pathlib.Path(folder)).items():
            run = scene.run(program, STRICT_TARGET, *settings)
            missed = checks.no_answer(run) or checks.missed_target(run) + checks.dofs_apart(run, coarsest)
            misses += report(f"{scene.name} from {what}", numbers(run), missed)
    return misses


def check_stiffness(program, scene, ratio):
    """The first body `ratio` times as stiff as the second: the target is met, or the best answer is written and why."""
    one, other = starts.boxes_of(scene.deck)
    stiffness = (f"Bodies/{one.body}/Material/Young Modulus={ratio}", f"Bodies/{other.body}/Material/Young Modulus=1")
    reached, missed = [], []
    for what, settings in RELAXATIONS.items():
        run = scene.run(program, MILD_TARGET, "Accuracy/Maximum Dofs=20000", *stiffness, *settings)
        reached += [what] if run.answered and run.accuracy["reached"] else []
        misses = checks.no_answer(run) or checks.missed_without_reason(run) + checks.worse_than_before(run)
        missed += [f"{what}: {miss}" for miss in misses]
    return report(f"{scene.name} stiffness {ratio:g}", f"reached with {', '.join(reached) or 'none'}", missed)


def options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ndframe", help="the built program")
    parser.add_argument("decks", type=pathlib.Path, help="folder of punch.xml and contact-loss.xml")
    parser.add_argument("--short", action="store_true", help="two scenes, two targets")
    parser.add_argument("--scenes", nargs="+", default=(), help="only these")
    parser.add_argument("--no-references", action="store_true", help="leave out the comparison with finer meshes")
    return parser.parse_args()


def chosen_scenes(given):
    decks = [*sorted(SCENES.glob("*.xml")), *(given.decks / f"{name}.xml" for name in LIMITS)]
    scenes = [Scene(deck.stem, deck) for deck in decks if "Three Dimensional" not in deck.read_text()]
    scenes += [Scene(f"{name} remeshed", SCENES / f"{name}.xml", ("Accuracy/Refinement/Type=Remesh",))
               for name in REMESHED]
    names = given.scenes or (SHORT_SCENES if given.short else [scene.name for scene in scenes])
    return [scene for scene in scenes if scene.name in names]


def main():
    given = options()
    program = Program(given.ndframe)
    misses = 0
    for scene in chosen_scenes(given):
        targets = SHORT_TARGETS if given.short else sorted({*TARGETS, *LIMITS.get(scene.name, ())}, reverse=True)
        misses += check_targets(program, scene, targets)
        if not given.no_references:
            misses += check_references(program, scene)
        if scene.name in LIMITS and not given.short:
            misses += check_starts(program, scene)
            misses += sum(check_stiffness(program, scene, ratio) for ratio in STIFFNESS_RATIOS)
    print(f"{misses} promises are not held" if misses else "all promises are held")
    return 1 if misses else 0


if __name__ == "__main__":
    sys.exit(main())
