"""No bound of sides that do not match lies below its error: certificate_sides.py NDFRAME [--scenes N] [--seed FIRST].

Two bodies with random columns on both sides (up to eight to one, facets of one next to the other's by chance), straight,
turned, curved, apart, one above a part of the other, tied, or one body and a rigid one, of random moduli and loads, first and second order, solved to the
end or stopped anywhere; contact at all nodes or in means. The error is that of a solution on cells half as large, three times. A guaranteed bound below it is a
violation; so is a run that ends otherwise than it may. Prints the violations, and how sharp the bounds are.
"""

import math
import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import side_scenes
from runs import Program, certified, judge_certificate, print_sharpness, sweep, sweep_options

REFINEMENTS = 3  # of the reference
BALANCED = 1e-9  # as the guarantee asks for: segments of a hundredth of an edge divide round-off by their length


def maps(draw, kind):
    """Of the upper and the lower body, and settings of the interface."""
    if kind == "straight":
        turn = draw.choice((0.0, draw.uniform(-0.7, 0.7)))
        return side_scenes.box(0, 0, 1, 0.5, turn), side_scenes.box(0, -0.5, 1, 0, turn), {}
    if kind == "part":
        x0, x1 = draw.uniform(0, 0.3), draw.uniform(0.5, 1.0)
        return side_scenes.box(x0, 0, x1, 0.5), side_scenes.box(0, -0.5, 1, 0), {}
    if kind == "curve":
        height = draw.uniform(-0.15, 0.15)
        curve = lambda x: height * math.cos(math.pi * x)
        return (side_scenes.under(curve, 0, 1, 0.6), side_scenes.under(curve, 0, 1, -0.6),
                {"Gap From Geometry": ("string", draw.choice(("No", "Automatic")))})
    if kind == "apart":
        gap, slope, bow = draw.uniform(0.001, 0.02), draw.uniform(0, 0.05), draw.uniform(0, 0.1)
        upper = lambda x: gap + slope * x + bow * x * x
        lower = draw.choice((lambda x: 0.0, lambda x: -0.5 * bow * x * x))
        return side_scenes.under(upper, 0, 1, 0.6), side_scenes.under(lower, 0, 1, -0.5), {}
    start, radius = draw.uniform(-0.2, 0.0), draw.uniform(0.7, 2.0)  # a round body on a flat one
    arc = lambda x: radius - math.sqrt(radius * radius - x * x)
    return side_scenes.under(arc, 0.0, 0.6, 0.8), side_scenes.box(0, -0.5, 1.0 + start, 0), {}


def obstacle(draw, load):
    """A body that a rigid one holds."""
    shape = draw.choice(("plane", "hole", "cylinder", "expression", "round on plane", "pin in hole"))
    above = side_scenes.box(0, 0, 1, 0.6)
    if shape == "plane":
        turn = draw.uniform(-0.05, 0.05)
        rigid = side_scenes.plane((draw.random(), -draw.uniform(0.05, 0.06)), (math.sin(turn), math.cos(turn)),
                                  Displacement=(draw.uniform(-0.1, 0.1), draw.uniform(0.0, 0.05)))
    elif shape == "hole":
        rigid = side_scenes.plane((0.0, 0.0), (0.0, 1.0), Extent=(draw.uniform(-0.2, 0.3), draw.uniform(0.5, 1.2)))
    elif shape == "cylinder":
        radius = draw.uniform(0.5, 3)
        rigid = side_scenes.cylinder((draw.choice((0.0, draw.random())), -radius - draw.choice((0, 0.01))), radius)
    elif shape == "expression":
        rigid = side_scenes.Rigid("floor", {"Type": ("string", "Expression"),
                                            "Distance": ("string", f"{draw.uniform(0, 0.1)}*x^2*(1+exp(x))")})
    elif shape == "round on plane":
        radius = draw.uniform(0.7, 2.0)
        above = side_scenes.under(lambda x: radius - math.sqrt(radius * radius - x * x), 0.0, 0.6, 0.8)
        rigid = side_scenes.plane((0.0, 0.0), (0.0, draw.uniform(0.1, 10)))
    else:
        radius, hole = draw.uniform(0.8, 1.2), draw.uniform(1.25, 3)
        above = side_scenes.under(lambda x: -math.sqrt(radius * radius - x * x), 0.0, 0.5 * radius, 0.0)
        rigid = side_scenes.cylinder((0.0, hole - radius), hole, True)
    body = side_scenes.Block("upper", side_scenes.spread(draw, draw.choice((2, 4, 8)), 0.05), draw.randint(1, 4), above,
                             "bottom", 10.0 ** draw.uniform(-1, 1), draw.uniform(0, 0.45), {"left": "Roller"},
                             f"{10.0 ** draw.uniform(-4, -1)}*({load})")
    if shape in ("plane", "hole", "expression") or draw.random() < 0.3:
        body.supports["right"] = "Roller"
    return "rigid", (body, rigid), {}


def scene(draw):
    kind = draw.choice(("straight", "part", "curve", "apart", "round", "rigid", "tied"))
    if kind == "rigid":
        return obstacle(draw, draw.choice(("1", "1+x", "0.3+x*x")))
    upper, lower, settings = maps(draw, draw.choice(("straight", "part", "curve")) if kind == "tied" else kind)
    if kind == "tied":
        settings = {"Tied": ("bool", "true")}
    many = lambda: draw.choice((1, 2, 3, 4, 6, 8))
    columns = lambda n: side_scenes.even(n) if draw.random() < 0.3 else side_scenes.spread(draw, n, 0.05)
    held = draw.random() < 0.5
    size = 10.0 ** draw.uniform(-3, 0) if kind in ("apart", "round") else 1.0
    load = draw.choice(("1", "1+x", "(x<0.5)", "0.3+x*x"))
    first = side_scenes.Block("upper", columns(many()), draw.randint(1, 3), upper, "bottom", 10.0 ** draw.uniform(-1, 1),
                              draw.uniform(0, 0.45), {"left": "Roller", "right": "Roller"} if held else {"left": "Roller"},
                              f"{size}*({load})")
    second = side_scenes.Block("lower", columns(many()), draw.randint(1, 3), lower, "top", 10.0 ** draw.uniform(-1, 1),
                               draw.uniform(0, 0.45), {"bottom": "Clamp", "left": "Roller"})
    pair = (second, first) if draw.random() < 0.5 else (first, second)
    return kind, pair, settings


def coupling(draw):
    """Settings, and whether it ends where it should."""
    if draw.random() < 0.6:
        return ["Coupling/Type=Monolithic"], True
    sweeps = draw.choice((1, 2, 5, 200))
    return ["Coupling/Type=Neumann-Dirichlet", f"Coupling/Stopping/Maximum Sweeps={sweeps}"], False


def mortar(draw):
    """The same for contact in means; no settings: not asked for."""
    if draw.random() < 0.6:
        return [], True
    return ["Interfaces/contact/Pairing/Type=Mortar",
            f"Coupling/Type={draw.choice(('Monolithic', 'Monolithic', 'FETI', 'Neumann-Neumann'))}"], True


def judge(program, seed):
    """(what is wrong or None, bound / error of a run that ends where it should, what it is about)"""
    draw = random.Random(f"sides {seed}")
    kind, pair, settings = scene(draw)
    order, (how, ends) = draw.choice((1, 2)), coupling(draw)
    means, settles = mortar(random.Random(f"means {seed}"))
    if means and kind not in ("rigid", "tied"):
        kind, how, ends = kind + ", means", means, settles
    how.append(f"Discretization/Contact Conditions={draw.choice(('Nodal', 'Bernstein'))}")
    about = f"{seed}: {kind}, order {order}, {', '.join(how)}"
    with tempfile.TemporaryDirectory() as folder:
        deck = side_scenes.write_scene(folder, *pair, settings)
        solve = certified(program, deck, f"Discretization/Order={order}", *how,
                          estimators="Global, Reference" if kind == "tied" else "Global, Discretization, Algorithm, Reference")
        run = solve(REFINEMENTS)
        if run.code == 2 and "overlap at the start" in run.screen and kind.split(",")[0] in ("apart", "curve"):
            return None, None, about  # chords that reach into the other body
        told = ("tied sides must lie on each other", "the tied mesh is not sound")
        if run.code == 2 and any(text in run.screen for text in told):
            return None, None, about  # one edge for a whole wave
        if run.code == 3 and not (run.summary and run.summary["errors"]):
            return None, None, about
        return *judge_certificate(run, solve, REFINEMENTS, (0, 3), ends, is_mean_bounded=False,
                                  balanced=BALANCED), about


def main():
    options = sweep_options(__doc__)
    program, sharpness = Program(options.ndframe), {}
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    for ratio, about in found:
        if ratio:
            sharpness.setdefault(about.split(": ")[1].split(", order")[0], []).append(ratio)
    for kind, ratios in sorted(sharpness.items()):
        print_sharpness(ratios, f", {kind}")
    print(f"{options.scenes} scenes, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
