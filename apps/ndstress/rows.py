"""The rows of the stability matrix: what is made extreme, and by how much."""

import dataclasses

import numpy as np

import reference
import scenes
from scenes import lifting, pressed


@dataclasses.dataclass(frozen=True)
class Row:
    """make(value) is the scene; `settings(value)` what the deck gets beside the method's; short: values of the short
    form; must: outcome demanded of some values; floor: see judge.compare; methods: names, all when empty; variants:
    values that also run with the methods VARIANTS; in the short form the first that is in `short`, with few."""
    name: str
    values: tuple
    make: object
    short: tuple = ()
    must: dict = dataclasses.field(default_factory=dict)
    settings: object = lambda value: {}
    ranks: object = lambda value: 1
    methods: tuple = ()
    floor: float = 0.0
    answer: object = reference.solve
    variants: tuple = ()


def powers(*exponents):
    return tuple(float(f"1e{k}") for k in exponents)


def with_ratio(scene, ratio):
    """Young's modulus of the lower body is `ratio`; the load follows the softer body."""
    scene = dataclasses.replace(scene, lower=dataclasses.replace(scene.lower, young=ratio))
    return scenes.loaded(scene, min(1.0, ratio))


def with_poisson(scene, nu):
    return scene.with_bodies(lambda body: dataclasses.replace(body, poisson=nu))


def with_sliver(scene, area):
    """One triangle of the upper body gets this part of its area; negative: inverted."""
    mesh = scene.upper.mesh
    h = mesh.points[1][0] - mesh.points[0][0]
    points = tuple((2 * h - area * h, 1.5 * h) if abs(x - h) < h / 9 and abs(y - h) < h / 9 else (x, y)
                   for x, y in mesh.points)
    upper = dataclasses.replace(scene.upper, mesh=dataclasses.replace(mesh, points=points))
    return dataclasses.replace(scene, upper=upper)


def with_sizes(size):
    """An upper body of this size on a lower one of size 1, whose cells grow away from the contact."""
    scene = pressed()
    grow = lambda t: size * ((1 + 1 / size) ** t - 1)
    down = scene.lower.mesh.moved(lambda x, y: (x * size if x <= 1 else size + grow(x - 1), -grow(-y)))
    up = scene.upper.mesh.moved(lambda x, y: (x * size, y * size))
    return dataclasses.replace(scene, upper=dataclasses.replace(scene.upper, mesh=up, pressures={"top": (1.0,)}),
                               lower=dataclasses.replace(scene.lower, mesh=down))


def with_gap(scene, *coefficients):
    return dataclasses.replace(scene, gap=coefficients)


def tipping(slope):
    """A block held sideways at one edge of its top: contact alone stops it from sinking and turning. Its load acts
    at 1/2 + slope / 12: beyond 1 it tips over."""
    scene = pressed(load=(1.0 - slope / 2, slope))
    mesh = scene.upper.mesh
    mesh = dataclasses.replace(mesh, sides={**mesh.sides, "edge": mesh.sides["top"][:1]})
    return dataclasses.replace(scene, upper=dataclasses.replace(scene.upper, mesh=mesh, supports={"edge": {0: 0.0}}))


def touching(excess):
    """The upper body is moved down by the gap and this part more: at 0 it touches without any pressure."""
    scene = with_gap(pressed(), 0.25)
    upper = dataclasses.replace(scene.upper, pressures={}, supports={"top": {0: 0.0, 1: -0.25 * (1 + excess)}})
    return dataclasses.replace(scene, upper=upper)


def idle(gap):
    """A block that nothing but contact would hold, without any load."""
    return with_gap(scenes.loaded(pressed(), 0.0), gap)


def idle_answer(scene):
    """Bodies that touch may rest; how far a block without load is from the other one, nothing decides."""
    if any(scene.gap):
        raise reference.Unheld
    return reference.solve(scene)


def sideways(cells):
    """A block that nothing but contact would hold vertically, pressed only sideways: no force presses it on the lower
    body, so any height at which it does not penetrate is as good as another."""
    scene = pressed(cells)
    return dataclasses.replace(scene, upper=dataclasses.replace(scene.upper, pressures={"right": (1.0,)}))


def undecided(scene):
    raise reference.Unheld


def strip(nodes):
    """Two strips of square cells in uniform compression with so many contact nodes."""
    n = nodes - 1
    upper = scenes.Body(scenes.box((0, 0), (n, 1), (n, 1)), supports={"left": {0: 0.0}}, pressures={"top": (1.0,)})
    lower = scenes.Body(scenes.box((0, -1), (n, 0), (n, 1), n), supports={"left": {0: 0.0}, "bottom": {1: 0.0}})
    return scenes.Scene(upper, lower, order=1)


def strip_answer(scene):
    """Closed form: the vertical stress is -1, the others in the plane are zero."""
    body = scene.upper
    n = int(body.mesh.points[-1][0])
    flat = (1 - body.poisson ** 2) / body.young
    force = np.ones(n + 1)
    force[[0, -1]] = 0.5
    u = np.full(n + 1, -flat)
    return reference.Answer(np.arange(n + 1.0), u, u, force, (flat * n, flat * n), 1.0, n * flat)


def one_node():
    """Two cells of degree 1, the upper one held at its left: a single node can touch."""
    scene = strip(2)
    upper = dataclasses.replace(scene.upper, supports={"left": {0: 0.0, 1: 0.0}})
    return dataclasses.replace(scene, upper=upper)


def theta(value):
    return {"Coupling": {"Dirichlet Body": "As Given", "Relaxation": {"Type": "Constant", "Theta": value},
                         "Stopping": {"Tolerance": 1e-8, "Maximum Sweeps": 2000}}}


def solver(value):
    return {"Linear Solver": {"Type": value.split()[0]}}


def processes(value):
    return int(value.split()[1])


FORCE_FLOOR = 1e-7  # docs/stability.md says why
RATIOS = powers(-8, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 8)
UNITS = powers(-12, -9, -6, -3, 0, 3, 6, 9, 12)
ASPECTS = powers(-4, -3, -2, -1, 0, 1, 2, 3, 4)
SLIVERS = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0.0, -1e-14, -1e-6)
FLAT = {0.0: "refused", -1e-14: "refused", -1e-6: "refused"}
LOADS = (0.0,) + powers(-300, -200, -150, -100, -30, 0, 30, 100, 150, 200, 300)
GAPS = (-1.0, -1e-12, 0.0) + powers(-12, -6, -3, -1, 0, 1)
OVERLAP = {-1.0: "refused", -1e-12: "refused"}
SLOPES = (0.0, 3.0, 5.0, 5.9, 5.999999, 6.0, 6.000001, 6.1, 12.0)
EXCESSES = (-1e-6, -1e-12, 0.0, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6)
SIDEWAYS = tuple(range(4, 14))
THETAS = (1e-3, 1e-2, 0.1, 0.5, 0.9, 1.1, 1.5, 1.9, 1.99)

ROWS = [
    Row("stiffness ratio, all closed", RATIOS, lambda v: with_ratio(pressed(), v), (1e-8, 1e-1, 1e8),
        variants=powers(-1, -8, -2, 3, 8)),
    Row("stiffness ratio, opening", RATIOS, lambda v: with_ratio(lifting(), v), (1e-8, 1e3)),
    Row("unit of length", UNITS, lambda v: scenes.scaled(lifting(), v, 1.0), (1e-12, 1e12),
        variants=powers(12, -12)),
    Row("unit of stress", UNITS, lambda v: scenes.scaled(lifting(), 1.0, v), (1e-12, 1e12),
        variants=powers(-9, 9)),
    Row("Poisson ratio", (-0.99, -0.5, 0.0, 0.3, 0.49, 0.499, 0.4999, 0.49999, 0.499999),
        lambda v: with_poisson(lifting(), v), (-0.99, 0.499999),
        variants=(0.499999, 0.49, -0.99)),
    Row("aspect ratio", ASPECTS, lambda v: pressed().moved(lambda x, y: (x, y * v)), (1e-4, 1e4),
        variants=powers(-3, -2, 2, 3)),
    Row("aspect ratio, opening", ASPECTS, lambda v: lifting().moved(lambda x, y: (x, y * v)), (1e-3,)),
    Row("area of a sliver", SLIVERS, lambda v: with_sliver(pressed(), v), (1e-6, 1e-14, 0.0, -1e-14), FLAT),
    Row("size of the upper body", powers(-3, -2, -1, 0), with_sizes, (1e-3,)),
    Row("coordinates + ...", powers(0, 2, 4, 6, 8, 10, 12, 15), lambda v: scenes.shifted(lifting(), v), (1e6, 1e15)),
    Row("starting gap, opening", GAPS, lambda v: with_gap(lifting(), v), (-1e-12, 1e-3, 1e1), OVERLAP,
        variants=(1e-3, -1.0, 1e-12, 1e1)),
    Row("starting gap, floating", GAPS, lambda v: with_gap(pressed(), v), (1e-12, 1e1), OVERLAP,
        variants=(0.0, 1e-3)),
    Row("one point of contact: gap v x^2", powers(-6, -3, -1, 0, 2, 4), lambda v: with_gap(pressed(), 0.0, 0.0, v),
        (1e0, 1e4)),
    Row("held by contact alone: slope", SLOPES, tipping, (3.0, 6.0, 6.1), {6.1: "stopped", 12.0: "stopped"}),
    Row("load times", LOADS, lambda v: scenes.loaded(lifting(), v), (0.0, 1e-300, 1e-30, 1e30, 1e300)),
    Row("load times, floating", LOADS, lambda v: scenes.loaded(pressed(), v), (0.0, 1e-300, 1e300)),
    Row("zero load, floating: gap", (0.0, 1e-6, 1.0), idle, (0.0, 1.0), {1e-6: "stopped", 1.0: "stopped"},
        answer=idle_answer),
    Row("sideways load, floating: cells", SIDEWAYS, sideways, (5,), {cells: "stopped" for cells in SIDEWAYS},
        answer=undecided),
    Row("pulled off: load times", (-1.0, -1e-6), lambda v: scenes.loaded(pressed(), v), (-1.0,),
        {-1.0: "stopped", -1e-6: "stopped"}),
    Row("numbering", tuple(range(1, 9)), lambda v: scenes.renumbered(lifting(), v), (1,)),
    Row("just touching: excess", EXCESSES, touching, (0.0, 1e-6), floor=FORCE_FLOOR),
    Row("interface nodes", (2, 11, 101, 1001, 10001, 100001), strip, (2, 101), answer=strip_answer,
        methods=("Aitken", "Monolithic")),
    Row("one interface node", (1,), lambda v: one_node(), (1,)),
    Row("theta", THETAS, lambda v: lifting(), (1e-3, 1.99), settings=theta, methods=("Constant",)),
    Row("theta, floating", THETAS, lambda v: pressed(), (1.99,), settings=theta, methods=("Constant",)),
    Row("solver and ranks", tuple(f"{s} {r}" for s in ("Cholmod", "Mumps", "Krylov") for r in (1, 2, 3)
                                  if r == 1 or s != "Cholmod"), lambda v: lifting(), ("Mumps 1",),
        settings=solver, ranks=processes, methods=("Aitken", "Monolithic", "degree 1", "certified")),
]
