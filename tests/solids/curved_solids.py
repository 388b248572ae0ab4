"""No bound of solids that touch along curved sides lies below its error: curved_solids.py NDFRAME [--scenes N] [--seed FIRST].

A shell or a part of one presses on what it surrounds, along a part of a cylinder, of a sphere or of a saddle that stands for
either, of 2 to 4 by 1 to 4 squares that turn by 4 to 34 degrees each (below the Corner Angle) and are of different sizes, of
random moduli, loads and gaps, first and second order, solved to the end or stopped anywhere, with either body first. The error
is that of a solution of the same polyhedron and the same normals on cells half as large. A guaranteed bound below the error is
a violation, as is one of the mean stress, one that is not guaranteed although the run ended well, or a stress out of balance.
Prints the violations, and how sharp the bounds are; --corner-angle 0 asks the same with the triangles' own normals.
"""

import math
import random
import sys
import tempfile

import pathlib
sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program, certified, judge_certificate, sweep_of_kinds, sweep_options
from solid_scenes import Solid, pressure, write_scene


def uneven(s, by):
    """[0, 1] onto itself, with squares of different sizes."""
    return s + by * math.sin(2.0 * math.pi * s) / (2.0 * math.pi)


def cylinder(angle, length, by):
    """(r, q, radius) -> point; at r = 0 the plane x = 0, at q = 0 the plane y = 0."""
    def place(r, q, radius):
        turned = angle * uneven(r, by)
        return radius * math.sin(turned), length * uneven(q, by), radius * math.cos(turned)
    return place


def sphere(angle, length, by):
    """The same of a part of a sphere that planes through the centre cut out."""
    def place(r, q, radius):
        x, y = math.tan(angle * uneven(r, by)), math.tan(length * uneven(q, by))
        size = radius / math.sqrt(1.0 + x * x + y * y)
        return size * x, size * y, size
    return place


def saddle(angle, length, by):
    """z = radius + the curvatures of either sign."""
    def place(r, q, radius):
        x, y = uneven(r, by), uneven(q, by)
        return x, length * y, radius + 0.5 * angle * (x * x - y * y - 0.3 * x * y)
    return place


def between(place, inner, outer):
    return lambda r, q, t: place(r, q, inner + t * (outer - inner))


def scene(draw, order):
    kind = draw.choice(("cylinder", "cylinder", "sphere", "saddle"))
    columns, rows = draw.randint(2, 4 if order == 1 else 3), draw.randint(1, 3 if order == 1 else 2)
    turn = math.radians(draw.uniform(4.0, 27.0))  # unequal squares turn by more
    if kind == "cylinder":
        place = cylinder(columns * turn, rows * turn * draw.uniform(0.6, 2.0), draw.uniform(-0.3, 0.3))
    elif kind == "sphere":
        turn = min(turn, math.radians(70.0 / max(columns, rows)))
        place = sphere(columns * turn, rows * turn, draw.uniform(-0.3, 0.3))
    else:
        place = saddle(min(1.0, columns * turn), draw.uniform(0.5, 1.5), draw.uniform(-0.3, 0.3))
    layers, size = (draw.randint(1, 2), draw.randint(1, 2)), turn if kind != "saddle" else 1.0 / columns
    inner, outer = 1.0 - min(0.8, layers[0] * size * draw.uniform(0.6, 2.0)), 1.0 + layers[1] * size * draw.uniform(0.6, 2.0)
    young = lambda: 10.0 ** draw.uniform(-1.0, 1.0)
    load = draw.choice(("1", "1", "1+x", "1.2-0.5*x+0.3*y"))
    shell = Solid("shell", (columns, rows, layers[1]), between(place, 1.0, outer), "bottom", young(), draw.uniform(0.0, 0.45),
                  {"left": "Roller", "front": "Roller"} if kind != "saddle" else {"left": "Roller"},
                  {"press": pressure("top", f"{10.0 ** draw.uniform(-2.5, -1)}*({load})")}, 0.15, draw.randint(0, 10**6))
    if kind == "saddle":
        shell.supports["back"] = "Roller"
    core = Solid("core", (columns, rows, layers[0]), between(place, inner, 1.0), "top", young(), draw.uniform(0.0, 0.45),
                 {"bottom": "Clamp"}, {}, 0.15, draw.randint(0, 10**6))
    if draw.random() < 0.3:
        shell.loads["side"] = pressure("right", draw.choice(("0.01", "-0.005")))
    pair = (shell, core) if draw.random() < 0.5 else (core, shell)
    return kind, pair, [("Gap", "string", draw.choice(("0", "0", "0.002", "0.01*x")))]


def coupling(draw):
    """Settings, and whether it ends where it should."""
    if draw.random() < 0.75:
        return [f"Coupling/Type={draw.choice(('Monolithic', 'Automatic', 'FETI'))}"], True
    return ["Coupling/Type=Neumann-Dirichlet", f"Coupling/Stopping/Maximum Sweeps={draw.choice((2, 5, 100))}"], False


def judge(program, seed, refinements, more):
    """(what is wrong or None, bound / error of a run that ends where it should, what it is about)"""
    draw = random.Random(f"curved {seed}")
    order = draw.choice((1, 2, 2))
    kind, pair, settings = scene(draw, order)
    how, ends = coupling(draw)
    about = f"{seed}: {kind}, order {order}, {', '.join(how)}"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings + more)
        solve = certified(program, deck, f"Discretization/Order={order}", *how)
        return *judge_certificate(solve(refinements), solve, refinements, (0, 3), ends), about


def main():
    options = sweep_options(__doc__, refinements=(1, "of the reference"), corner_angle=(35.0, "of the interface, in degrees"))
    program = Program(options.ndframe)
    more = [("Corner Angle", "double", repr(options.corner_angle))]
    sweep_of_kinds(options, lambda seed: judge(program, seed, options.refinements, more), 2)


if __name__ == "__main__":
    main()
