"""No bound of bodies that touch themselves lies below its error: certificate_self.py NDFRAME [--scenes N] [--seed FIRST].

Plates and bricks with a slit (closed, or a notch that closes), hairpins, blocks that are bonded along a part of their sides
and free along the rest (any columns on both, flat or curved), of random moduli, loads, gaps and supports, first and second
order, by any coupling. The error is that of a solution on cells half as large, twice in the plane. A guaranteed bound below it
is a violation; so are a bound that is not guaranteed, a stress out of balance, and a run that ends otherwise. Prints the
violations, and how sharp the bounds are.
"""

import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program, certified, judge_certificate, sweep_of_kinds, sweep_options
from self_scenes import contact, grid, hairpin, write_scene
from side_scenes import even, spread


def load(draw):
    return f"{10.0 ** draw.uniform(-4, -2)}*({draw.choice(('1', '1-2*x', '1+x', 'sin(4*x)', '0.3-x*x', '1+2*(x>0.6)'))})"


def gap(draw):
    return {"Gap": ("string", draw.choice(("0", "0", "0.0001", "0.001*x", "0.001*(1-cos(3*x))")))}


def material(draw, body):
    body.young, body.poisson = 10.0 ** draw.uniform(-1, 1), draw.uniform(0.0, 0.45)
    return body


def slit(draw, depth):
    """A plate or a brick with a slit in the middle, from the left to some column."""
    n, m = (draw.randint(2, 6), draw.choice((2, 4))) if not depth else (draw.randint(2, 3), 2)
    bow, opening = draw.choice((0.0, draw.uniform(-0.2, 0.2))), draw.choice((0.0, 0.0, draw.uniform(0.0, 0.01)))
    end = draw.randint(1, n - 1)
    columns = even(n) if depth else spread(draw, n, 0.2)
    tip = columns[end]
    # in space sides must have the same nodes
    notch = lambda s, a: a * opening * max(0.0, tip - s) if not depth else 0.0
    if depth:
        place = lambda s, t, r, a: (1.5 * s, t + bow * s * (t - 1) * t, r)
    else:
        place = lambda s, t, a: (1.5 * s, t + bow * s * s + notch(s, a))
    body = material(draw, grid("plate", columns, even(m), place, slit=(m // 2, end), depth=depth))
    body.supports = {"bottom": "Clamp"} if draw.random() < 0.6 else {"right": "Clamp"}
    body.pressures = {"top": load(draw)}
    if draw.random() < 0.4 and "bottom" not in body.supports:
        body.pressures["bottom"] = load(draw)
    pair = [("plate", "below"), ("plate", "above")]
    draw.shuffle(pair)
    return [body], {"crack": contact(*pair, **gap(draw))}


def folded(draw):
    """Legs of a hairpin; columns of their own at the two ends."""
    radius, bend = draw.uniform(0.02, 0.2), 0.5
    inner, n = draw.choice((4, 8)), draw.choice((2, 3, 6))
    legs = [0.25 * place for place in spread(draw, n, 0.3)]
    columns = legs + [0.25 + bend * k / inner for k in range(1, inner)] + [0.75 + 0.25 * p for p in spread(draw, draw.choice((2, 5)), 0.3)]
    body = material(draw, grid("pin", columns, even(draw.randint(1, 2)), hairpin(radius, draw.uniform(0.1, 0.4), 1.0, bend)))
    for side, name in (("bottom", "in"), ("top", "out")):
        on = lambda facet, sign: all(body.points[v][0] >= -1e-9 and sign * body.points[v][1] > 0 for v in facet)
        for which, sign in (("lower", -1), ("upper", 1)):
            body.sides[f"{name} {which}"] = [facet for facet in body.sides[side] if on(facet, sign)]
    body.supports, body.pressures = {"out lower": "Clamp"}, {"out upper": f"{10.0 ** draw.uniform(-3, -1)}*(1+x)"}
    pair = [("pin", "in lower"), ("pin", "in upper")]
    draw.shuffle(pair)
    return [body], {"legs": contact(*pair)}


def bonded(draw):
    """Two blocks, tied beyond a place and free before it."""
    bow, bond = draw.choice((0.0, draw.uniform(-0.1, 0.1))), draw.uniform(0.2, 0.8)
    curve = lambda x: bow * x * x

    def columns():
        left, right = draw.choice((1, 2, 3, 5)), draw.choice((1, 2, 4))
        return [bond * p for p in spread(draw, left, 0.2)] + [bond + (1 - bond) * p for p in spread(draw, right, 0.2)[1:]], left

    bodies = []
    for name, side, place in (("upper", "bottom", lambda s, t, a: (s, (1 - t) * curve(s) + 0.6 * t)),
                              ("lower", "top", lambda s, t, a: (s, t * curve(s) - 0.7 * (1 - t)))):
        at, end = columns()
        bodies.append(material(draw, grid(name, at, even(draw.randint(1, 3)), place, split=(side, end))))
    upper, lower = bodies
    upper.pressures, lower.supports = {"top": load(draw)}, {"bottom": "Clamp"}
    return bodies, {"bond": contact(("upper", "far"), ("lower", "far"), Tied=("bool", "true")),
                    "crack": contact(("upper", "near"), ("lower", "near"), **gap(draw))}


SCENES = {"slit": lambda draw: slit(draw, 0), "brick": lambda draw: slit(draw, draw.randint(1, 2)), "hairpin": folded,
          "bonded": bonded}


def judge(program, seed):
    """(what is wrong or None, bound / error of a run, what it is about)"""
    draw = random.Random(f"self {seed}")
    kind, order = draw.choice(("slit", "hairpin", "bonded", "slit", "hairpin", "bonded", "brick")), draw.choice((1, 2, 2))
    coupling = draw.choice(("Automatic", "Monolithic", "FETI", "Neumann-Neumann"))
    bodies, interfaces = SCENES[kind](draw)
    about = f"{seed}: {kind}, order {order}, {coupling}"
    refinements = 1 if kind == "brick" else 2
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, bodies, interfaces)
        solve = certified(program, deck, f"Discretization/Order={order}", f"Coupling/Type={coupling}")
        run = solve(refinements)
        told = ("overlap", "tied sides must lie on each other", "the tied mesh is not sound")
        if run.code == 2 and kind == "bonded" and any(text in run.screen for text in told):
            return None, None, about  # chords of a curve
        return *judge_certificate(run, solve, refinements), about


def main():
    options = sweep_options(__doc__)
    program = Program(options.ndframe)
    sweep_of_kinds(options, lambda seed: judge(program, seed), 1)


if __name__ == "__main__":
    main()
