"""Solids whose sides are meshed apart: cut_solids.py NDFRAME [--scenes N] [--seed FIRST].

Two solids with any columns on their sides, these shaken and twisted, one solid turned and shifted on the other one, so that it
stands within it or over its edge, all of it turned in space. Half of the scenes are patches: both sides are the same square and
pressure makes the stress uniform, which has to be met to round-off. In the others the bound is judged by a reference, as in
certificate_solids.py. A run that ends otherwise is wrong, too. Prints what is wrong, and how sharp the bounds are.
"""

import math
import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program, certified, judge_certificate, print_sharpness, sweep, sweep_options
from solid_scenes import Solid, pressure, write_scene

UNIFORM = 1e-10  # of the exact energy and pressure


def rotation(draw):
    """Of space, as a function."""
    a, b = draw.uniform(-1, 1), draw.uniform(-0.7, 0.7)
    c, s, d, e = math.cos(a), math.sin(a), math.cos(b), math.sin(b)

    def turned(x, y, z):
        x, z = c * x - s * z, s * x + c * z
        return x, d * y - e * z, e * y + d * z

    return draw.choice((turned, lambda x, y, z: (x, y, z)))


def twist(draw):
    """The unit square onto itself, its rim kept."""
    angle = draw.uniform(-0.8, 0.8)

    def twisted(r, q):
        x, y = 2 * r - 1, 2 * q - 1
        by = angle * (1 - x * x) * (1 - y * y)
        c, s = math.cos(by), math.sin(by)
        return 0.5 + 0.5 * (c * x - s * y), 0.5 + 0.5 * (s * x + c * y)

    return draw.choice((twisted, lambda r, q: (r, q)))


def solid(draw, name, foot, place, **more):
    cells = (draw.randint(1, 4), draw.randint(1, 4), draw.randint(1, 2))
    return Solid(name, cells, place, foot, 10.0 ** draw.uniform(-1, 1), draw.uniform(0.0, 0.45), shake=0.1,
                 seed=draw.randint(0, 10**6), foot_shake=draw.choice((0.0, 0.3)), **more)


def grounds(draw, x0=0.0, y0=0.0, size=1.0, angle=0.0):
    """Places of the upper and of the lower solid: unit squares, the upper one moved along the side."""
    turned, mine, theirs = rotation(draw), twist(draw), twist(draw)
    c, s = size * math.cos(angle), size * math.sin(angle)

    def upper(r, q, t):
        x, y = mine(r, q)
        return turned(x0 + c * x - s * y, y0 + s * x + c * y, 0.6 * t)

    return upper, lambda r, q, t: turned(*theirs(r, q), 0.7 * (t - 1))


def patch(draw):
    """Both sides the same square; everything held along its normal but the top."""
    upper, lower = grounds(draw)
    rollers = {side: "Roller" for side in ("left", "right", "front", "back")}
    load = {"press": pressure("top", "0.5")}
    pair = [solid(draw, "upper", "bottom", upper, supports=dict(rollers), loads=load),
            solid(draw, "lower", "top", lower, supports={**rollers, "bottom": "Roller"})]
    energy = sum(0.25 * height * (1 + body.poisson) * (1 - 2 * body.poisson) / (1 - body.poisson) / body.young
                 for body, height in zip(pair, (0.6, 0.7)))
    return pair, energy


def partial(draw):
    """A block on, or over the edge of, another one."""
    upper, lower = grounds(draw, draw.uniform(-0.3, 0.5), draw.uniform(-0.3, 0.5), draw.uniform(0.4, 1.2), draw.uniform(-1.5, 1.5))
    load = draw.choice(("1", "1+r2", "2")).replace("r2", "x*x+y*y")
    return [solid(draw, "upper", "bottom", upper, supports={draw.choice(("left", "back")): "Clamp"},
                  loads={"press": pressure("top", f"0.1*({load})")}),
            solid(draw, "lower", "top", lower, supports={"bottom": "Clamp"})], None


def uniform_or_not(run, energy):
    found = sum(body["energy"] for body in run.summary["bodies"])
    largest = run.summary["interfaces"][0]["largest_pressure"]
    if abs(found - energy) > UNIFORM * energy or abs(largest - 0.5) > 1e3 * UNIFORM:
        return f"energy {found:.15g} for {energy:.15g}, pressure {largest:.15g}"
    bound = run.summary["errors"]["global"]["absolute"]
    return f"bound {bound:.2e} of an exact solution" if bound > 1e-6 * math.sqrt(energy) else None


def judge(program, seed):
    """(what is wrong or None, bound / error, what it is about)"""
    draw = random.Random(f"cut {seed}")
    pair, energy = draw.choice((patch, partial))(draw)
    order, coupling = draw.choice((1, 2, 2)), draw.choice(("Automatic", "Monolithic", "FETI", "Neumann-Neumann"))
    if draw.random() < 0.5:
        pair.reverse()
    about = f"{seed}: {'patch' if energy else 'partial'}, order {order}, {coupling}"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair)
        solve = certified(program, deck, f"Discretization/Order={order}", f"Coupling/Type={coupling}",
                          estimators="Global" if energy else "Global, Reference")
        run = solve(1)
        if run.code == 2 and not energy and ("no part of one side lies on the other" in run.screen or "inverted" in run.screen):
            return None, None, about
        wrong, ratio = judge_certificate(run, solve, None if energy else 1)
    return wrong or (uniform_or_not(run, energy) if energy else None), ratio, about


def main():
    options = sweep_options(__doc__)
    program, of_orders = Program(options.ndframe), {}
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    for ratio, about in found:
        if ratio:
            of_orders.setdefault(about.split(", ")[1], []).append(ratio)
    for order, ratios in sorted(of_orders.items()):
        print_sharpness(ratios, f", {order}")
    print(f"{options.scenes} scenes, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
