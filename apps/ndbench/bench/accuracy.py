"""What a target costs: beside uniform meshes with the same true error, and beside its own last mesh alone.

Uniform runs have second order and no certificate; the faster one of `UNIFORM` counts. Their meshes are found first: the
coarsest whose true error, which a user would not know, is at most the bound of the run with the target, and at most its
true error.
"""

import dataclasses
import functools
import math

from bench.campaign import Case, row
from bench.last_mesh import REPEATED, least, pair
from bench.methods import ADAPTIVE, AITKEN, ALL_AT_ONCE
from bench.program import run
from bench.scenes import Scene
from bench.truth import true_error

UNIFORM = (ALL_AT_ONCE, AITKEN)
LARGEST = 1_500_000  # dofs: uniform meshes with more would take gigabytes and most of the time, and are not run
STEP = 2  # of the cells: the boxes are split in halves


class UniformMeshes:
    """True errors of a scene on uniform meshes; each is solved once."""

    def __init__(self, program, scene, exact):
        self.program, self.scene, self.exact = program, scene, exact

    @functools.cache
    def solved(self, cells):
        """(relative true error, dofs)"""
        done = run(self.program, self.scene.deck, ALL_AT_ONCE.on(self.scene, cells))
        return true_error(done, self.scene.gap, self.exact).best / self.exact.norm, done.dofs

    def dofs(self, cells):
        known = self.scene.sizes[2]
        return self.solved(known)[1] * (cells / known) ** self.scene.dim

    def cells_for(self, error):
        return cells_for(error, lambda cells: self.solved(cells)[0], self.scene.sizes[1:3],
                         lambda cells: self.dofs(cells) > LARGEST)


def cells_for(error, error_of, first, too_many):
    """The fewest cells with at most this error, by secants in logarithms; where that is too many, a prediction."""
    known = {cells: error_of(cells) for cells in first}
    while True:
        (a, at_a), (b, at_b) = sorted(known.items(), key=lambda point: abs(math.log(point[1] / error)))[:2]
        exponent = math.log(at_a / at_b) / math.log(a / b)
        cells = STEP * math.ceil(a * (error / at_a) ** (1 / exponent) / STEP)
        if cells in known or too_many(cells):
            break
        known[cells] = error_of(cells)
    while not too_many(cells) and error_of(cells) > error:
        cells += STEP
    return cells


@dataclasses.dataclass(frozen=True)
class Rival:
    """Uniform runs beside a run with a target; without cases where the mesh is too large."""

    what: str  # "its bound" or "its error": the limit of the true error
    dofs: float
    cases: tuple


@dataclasses.dataclass
class Contest:
    """A target, its rivals, and the pairs of runs: the whole one, its last mesh alone."""

    scene: Scene
    target: float
    rivals: tuple
    pairs: list = dataclasses.field(default_factory=list)


def contest(program, scene, target, meshes, exact):
    first = run(program, scene.deck, ADAPTIVE.on(scene, target))
    if first.bound is None:
        raise SystemExit(f"ndbench: the bound of {scene.name} to {target} is not guaranteed")
    errors = {"its bound": first.bound, "its error": true_error(first, scene.gap, exact).best}
    rivals = []
    for what, error in errors.items():
        cells = meshes.cells_for(error / exact.norm)
        dofs = meshes.dofs(cells)
        cases = () if dofs > LARGEST else tuple(Case(scene, method, cells) for method in UNIFORM if method.fits(scene))
        rivals.append(Rival(what, dofs, cases))
    return Contest(scene, target, tuple(rivals))


def measured(program, scenes, targets, repetitions, say, exact):
    """(contests, runs of every uniform case): every round runs everything once."""
    contests = []
    for scene in scenes:
        meshes = UniformMeshes(program, scene, exact[scene.name])
        for target in scene.targets[targets]:
            say(f"uniform meshes beside {scene.name}, {100 * target:g} %")
            contests.append(contest(program, scene, target, meshes, exact[scene.name]))
    runs = {case: [] for each in contests for rival in each.rivals for case in rival.cases}
    for repetition in range(repetitions):
        say(f"round {repetition + 1} of {repetitions}: {len(contests)} targets, {len(runs)} uniform runs")
        for each in REPEATED * contests:
            each.pairs.append(pair(program, each.scene, each.target))
        for case, done in runs.items():
            done.append(case.run(program))
    return contests, runs


def beside_uniform(contests, runs, exact):
    """One row of a run with a target and one of each of its rivals."""
    rows = []
    for each in contests:
        truth, key = exact[each.scene.name], {"target": each.target}
        case = Case(each.scene, ADAPTIVE, each.target)
        whole = row(case, [one for one, _ in each.pairs], [], None, truth)
        rows.append({**key, "beside": "", **whole, "times": 1.0})
        for rival in each.rivals:
            found = [row(case, runs[case], [], None, truth) for case in rival.cases]
            not_run = {**dict.fromkeys(whole), "scene": each.scene.name, "dofs": round(rival.dofs)}
            best = min(found, key=lambda one: one["wall"], default=not_run)
            times = best["wall"] / whole["wall"] if found else None
            rows.append({**key, "beside": rival.what, **best, "times": times})
    return rows


def beside_last_mesh(contests):
    """One row a target."""
    rows = []
    for each in contests:
        whole, alone = each.pairs[-1]
        accuracy = whole.summary["accuracy"]
        seconds, seconds_alone = least(each.pairs, lambda one: one.solving_seconds)
        wall, wall_alone = least(each.pairs, lambda one: one.cost.wall)
        rows.append({
            "scene": each.scene.name, "target": each.target, "levels": len(accuracy["levels"]), "sweeps": whole.sweeps,
            "dofs": whole.dofs, "work": accuracy["total_dofs"] / whole.dofs,
            "seconds": seconds, "alone": seconds_alone, "over": seconds / seconds_alone,
            "wall_over": wall / wall_alone, "same_bound": alone.bound / whole.bound,
        })
    return rows
