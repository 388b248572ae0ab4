"""Runs scenes x methods x sizes, repetitions interleaved, and makes one row of each case."""

import csv
import dataclasses

from bench.analysis import median
from bench.methods import METHODS, Method
from bench.program import run
from bench.scenes import SCENES, Scene
from bench.truth import true_error
from bench.yardstick import processor_seconds

OUTSIDE = "start and exit"  # of the process
BETWEEN = "between stages"  # what no stage counts; with a target also prediction and refinement

COLUMNS = (
    "scene", "method", "size", "order", "dofs", "sweeps", "exit", "wall", "wall_least", "wall_most", "seconds",
    "seconds_least", "seconds_most", "start", "peak_bytes", "yardstick", "ratio", "error", "error_low", "error_high",
    "error_sharp", "bound", "effectivity",
)


@dataclasses.dataclass(frozen=True)
class Case:
    """One scene, method and size (cells or target: methods.py)."""

    scene: Scene
    method: Method
    size: float

    def run(self, program):
        return run(program, self.scene.deck, self.method.on(self.scene, self.size))

    @property
    def alone(self):
        """Deck and settings of the libraries' run alone; None where no mesh is given."""
        settings = self.method.yardstick(self.scene, self.size)
        return settings and (self.scene.deck, settings)

    @property
    def key(self):
        return {"scene": self.scene.name, "method": self.method.name, "size": self.method.words(self.size)}

    def __str__(self):
        return ", ".join(self.key.values())


def cases(levels, scenes=SCENES, methods=METHODS):
    """All cases on the first `levels` sizes of each scene."""
    return [
        Case(scene, method, size)
        for scene in scenes for method in methods if method.fits(scene) for size in method.sizes(scene)[:levels]
    ]


def start_seconds(program):
    """Processor seconds of a run with 100 dofs: starting the program, and next to nothing else."""
    return run(program, SCENES[0].deck, SCENES[0].on(1)).cost.cpu


def measured(program, wanted, repetitions, say):
    """[(case, its runs, the yardstick's processor seconds in the same rounds)], processor seconds of a start.

    Every round runs everything once, so that a slow minute of the machine falls on all cases alike.
    """
    runs, yardsticks, starts = {case: [] for case in wanted}, {case: [] for case in wanted}, []
    for repetition in range(repetitions):
        starts.append(start_seconds(program))
        known = {}
        for number, case in enumerate(wanted):
            say(f"round {repetition + 1} of {repetitions}, {number + 1} of {len(wanted)}: {case}")
            alone = case.alone
            if alone and alone not in known:
                known[alone] = processor_seconds(program, *alone)
            yardsticks[case].append(known.get(alone))
            runs[case].append(case.run(program))
    return [(case, runs[case], yardsticks[case]) for case in wanted], median(starts)


def row(case, runs, yardsticks, start, exact):
    """One row of the table; errors and bounds relative to the norm of the exact solution."""
    last = runs[-1]
    error = true_error(last, case.scene.gap, exact)
    walls, seconds = ([getattr(each.cost, what) for each in runs] for what in ("wall", "cpu"))
    bound = None if last.bound is None else last.bound / exact.norm
    return {
        **case.key, "order": last.order, "dofs": last.dofs, "sweeps": last.sweeps, "exit": last.cost.exit,
        "wall": median(walls), "wall_least": min(walls), "wall_most": max(walls), "seconds": median(seconds),
        "seconds_least": min(seconds), "seconds_most": max(seconds), "start": start,
        "peak_bytes": median([each.cost.peak for each in runs]),
        "yardstick": median(yardsticks),
        "ratio": median([one / other for one, other in zip(seconds, yardsticks) if other is not None]),
        "error": error.best / exact.norm, "error_low": error.low / exact.norm, "error_high": error.high / exact.norm,
        "error_sharp": int(error.sharp), "bound": bound, "effectivity": bound and bound * exact.norm / error.best,
    }


def stage_rows(case, runs):
    """Median seconds of every stage of a case, and what the process needs beside them."""
    stages = {name: median([each.stages.get(name) for each in runs]) for name in runs[-1].stages}
    inside = median([each.total_seconds for each in runs])
    stages[BETWEEN] = max(inside - sum(stages.values()), 0.0)
    stages[OUTSIDE] = max(median([each.cost.wall for each in runs]) - inside, 0.0)
    return [{**case.key, "dofs": runs[-1].dofs, "stage": name, "wall": seconds} for name, seconds in stages.items()]


def tables(results, start, exact):
    """(rows of the cases, rows of their stages)."""
    rows = [row(case, runs, yardsticks, start, exact[case.scene.name]) for case, runs, yardsticks in results]
    return rows, [stage for case, runs, _ in results for stage in stage_rows(case, runs)]


def write_csv(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
