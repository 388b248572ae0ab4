"""The table of targets: what each must be, what it is, and how it was measured.

Ratios are of processor seconds on one thread, each to a run of the same round, and of them the median; seconds are on
the wall where the target names seconds or threads.
"""

import dataclasses
import functools
import pathlib
import tempfile
import typing

from bench.analysis import exponents, median
from bench.last_mesh import REPEATED, least, pair
from bench.methods import AITKEN
from bench.program import run
from bench.scenes import SCENES
from bench.square_mesh import write_punch
from bench.yardstick import processor_seconds

PUNCH, CONTACT_LOSS = SCENES[:2]
CERTIFICATE = ("Error Estimation/Estimators={Global, Algorithm, Discretization}",)
TWO_THREADS = {"OMP_NUM_THREADS": "2", "OPENBLAS_NUM_THREADS": "2"}


@dataclasses.dataclass(frozen=True)
class Sizes:
    """Cells along the punch: 250 000 and 1 000 000 dofs, a ladder for the exponent; contact-loss of 250 000 dofs; the
    errors that are asked for."""

    quarter_million: int = 102
    million: int = 204
    contact_loss: int = 80
    ladder: tuple = (20, 44, 98, 204)
    interface_cells: int = 500  # 1001 nodes of second order
    sweeps: int = 1000
    errors: tuple = (0.00455, 0.001, 1e-4)  # the first is that of 250 000 dofs


SHORT = Sizes(quarter_million=10, million=14, contact_loss=6, ladder=(20, 44), interface_cells=20, sweeps=50,
              errors=(0.05, 0.04, 0.03))


@dataclasses.dataclass(frozen=True)
class Target:
    """One figure: what it must be at most (at least, if `least`), what it should be, and how one round measures it."""

    scene: str
    figure: str
    must: float
    aim: float
    measure: typing.Callable  # Round -> number
    least: bool = False

    def verdict(self, value):
        reached = [value >= limit if self.least else value <= limit for limit in (self.aim, self.must)]
        return "aim" if reached[0] else "must" if reached[1] else "no"


class Round:
    """The runs of one round; each is made when first asked for and then shared by all targets of the round."""

    def __init__(self, program, sizes):
        self.program, self.sizes = program, sizes

    @functools.cache
    def run(self, scene, cells, settings=(), threads=1, ranks=1):
        environment = TWO_THREADS if threads == 2 else None
        return run(self.program, scene.deck, (*scene.on(cells), *settings), environment, ranks)

    @functools.cache
    def yardstick(self, scene, cells):
        return processor_seconds(self.program, scene.deck, scene.on(cells))

    @functools.cache
    def to(self, scene, error):
        """Pairs of a run with a target and its last mesh alone."""
        return [pair(self.program, scene, error) for _ in range(REPEATED)]

    def punch_to(self, number):
        whole, _ = self.to(PUNCH, self.sizes.errors[number])[0]
        return whole

    def punch(self, *settings, **how):
        return self.run(PUNCH, self.sizes.quarter_million, settings, **how)

    def over_yardstick(self, seconds):
        return seconds / self.yardstick(PUNCH, self.sizes.quarter_million)


def punch_over_yardstick(each, *settings):
    return each.over_yardstick(each.punch(*settings).cost.cpu)


def contact_loss_over_punch(each):
    return each.run(CONTACT_LOSS, each.sizes.contact_loss).cost.cpu / each.punch().cost.cpu


def million(each):
    return each.run(PUNCH, each.sizes.million, CERTIFICATE).cost


def smallest(each):
    """A deck with 100 dofs."""
    return each.run(PUNCH, 1).cost


def exponent(each):
    """Of processor seconds without the start of the process, which would make it smaller."""
    runs = [each.run(PUNCH, cells, CERTIFICATE) for cells in each.sizes.ladder]
    _, without_start = exponents([(one.dofs, one.cost.cpu) for one in runs], smallest(each).cpu)
    if without_start is None:
        raise SystemExit(f"ndbench: the runs of {each.sizes.ladder} cells take no longer than one with 100 dofs")
    return without_start


def sweeps(each):
    """The stage `couple`: its factors are given. A small theta keeps the sweeps from converging."""
    cells = each.sizes.interface_cells
    settings = (
        f"Bodies/punch/Mesh/Cells={{{cells}, 4}}", f"Bodies/foundation/Mesh/Cells={{{2 * cells}, 4}}",
        "Coupling/Relaxation/Type=Constant", "Coupling/Relaxation/Theta=1e-3", "Coupling/Stopping/Tolerance=1e-12",
        f"Coupling/Stopping/Maximum Sweeps={each.sizes.sweeps}",
    )
    done = each.run(PUNCH, cells, settings)
    if done.summary["coupling"]["sweeps"] != each.sizes.sweeps:
        raise SystemExit(f"ndbench: {done.summary['coupling']['sweeps']} sweeps instead of {each.sizes.sweeps}")
    return done.stages["couple"]


def speedup(each):
    """The better of two threads and two ranks."""
    one = each.punch(*CERTIFICATE).cost.wall
    return one / min(each.punch(*CERTIFICATE, threads=2).cost.wall, each.punch(*CERTIFICATE, ranks=2).cost.wall)


def reading(each):
    """A gmsh file of the same meshes as the boxes of `punch`: the stages before ordering."""
    with tempfile.TemporaryDirectory(prefix="ndbench-") as folder:
        path = pathlib.Path(folder) / "punch.msh"
        write_punch(path, each.sizes.quarter_million)
        settings = [f"Bodies/{body}/Mesh/{entry}" for body in ("punch", "foundation")
                    for entry in ("Type=Gmsh", f"File={path}", f"Regions={{{body}}}")]
        sides = ("Interfaces/contact/Dirichlet Side=contact", "Interfaces/contact/Neumann Side=contact")
        stages = run(each.program, PUNCH.deck, (*settings, *sides)).stages
    return each.over_yardstick(sum(stages[name] for name in ("read", "check", "assemble")))


def over_uniform(each):
    """How many times faster than uniform meshes with the same true error, which have no certificate."""
    return each.punch(*AITKEN.settings).cost.wall / each.punch_to(0).cost.wall


def over_last_mesh(each):
    """The largest ratio of both scenes and all errors: seconds in the program, without reading and writing."""
    asked = [(scene, error) for scene in (PUNCH, CONTACT_LOSS) for error in each.sizes.errors]
    seconds = [least(each.to(*one), lambda done: done.solving_seconds) for one in asked]
    return max(whole / alone for whole, alone in seconds)


TARGETS = (
    Target("`punch`, 250 000 dofs, no certificate", "over yardstick", 1.6, 1.35, punch_over_yardstick),
    Target("the same", "GB", 0.7, 0.7, lambda r: r.punch().cost.peak / 1e9),
    Target("the same, certified", "over yardstick", 2.0, 1.7, lambda r: punch_over_yardstick(r, *CERTIFICATE)),
    Target("`contact-loss`, 250 000 dofs", "over `punch`", 1.3, 1.1, contact_loss_over_punch),
    Target("`punch`, 1 000 000 dofs, certified", "seconds", 15, 15, lambda r: million(r).wall),
    Target("the same", "GB", 3, 3, lambda r: million(r).peak / 1e9),
    Target("`punch`, certified, 1e4 to 1e6 dofs", "exponent of time without start", 1.25, 1.15, exponent),
    Target("100 dofs, whole process", "seconds", 0.15, 0.08, lambda r: smallest(r).wall),
    Target("1000 sweeps, 1000 interface nodes", "seconds", 3, 1, sweeps),
    Target("2 threads or ranks, certified, 250 000 dofs", "times faster", 1.4, 1.7, speedup, least=True),
    Target("gmsh file, dofs and assembly, 250 000 dofs", "over yardstick", 0.35, 0.2, reading),
    Target("`punch` to 0.455 %, certified", "seconds", 0.25, 0.15, lambda r: r.punch_to(0).cost.wall),
    Target("the same, in the program", "seconds", 0.1, 0.1, lambda r: r.punch_to(0).total_seconds),
    Target("the same, beside 250 000 dofs uncertified", "times faster", 10, 10, over_uniform, least=True),
    Target("`punch` to 0.1 %, certified", "seconds", 0.6, 0.6, lambda r: r.punch_to(1).cost.wall),
    Target("`punch` to 0.01 %, certified", "seconds", 6, 6, lambda r: r.punch_to(2).cost.wall),
    Target("`punch` and `contact-loss` to these", "largest, over last mesh alone", 3, 2, over_last_mesh),
)


def rows(program, sizes, repetitions, say, wanted=TARGETS):
    """One row a target: the median over rounds, and the verdict `aim`, `must` or `no`."""
    values = {target: [] for target in wanted}
    for repetition in range(repetitions):
        each = Round(program, sizes)
        for target in wanted:
            say(f"round {repetition + 1} of {repetitions}: {target.scene}, {target.figure}")
            values[target].append(target.measure(each))
    return [
        {"scene": target.scene, "figure": target.figure, "must": target.must, "aim": target.aim,
         "measured": median(values[target]), "least": min(values[target]), "most": max(values[target]),
         "met": target.verdict(median(values[target]))}
        for target in wanted
    ]


def lines(found):
    """The rows as texts of a table."""
    return [
        [row["scene"], row["figure"], f"{row['must']:g}", f"{row['aim']:g}", f"{row['measured']:.3g}",
         f"{row['least']:.3g} to {row['most']:.3g}", row["met"]]
        for row in found
    ]


HEAD = ["scene", "figure", "must", "aim", "measured", "rounds", "met"]
