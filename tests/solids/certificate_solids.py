"""No bound of solids in contact lies below its error: certificate_solids.py NDFRAME [--scenes N] [--seed FIRST].

Two solids with 12 to some hundred tetrahedra each, or one and a rigid body, flat, inclined or bent where they touch, stretched
up to ten to one, shaken inside and numbered at random, of random moduli, loads, gaps and supports, first and second order,
solved to the end or stopped anywhere. The error is that of a solution on cells half as large, once or twice; in every fourth
scene the linear solver stops anywhere, and its energy is compared with that of factors. A guaranteed bound below the error is a
violation; so are a bound that is not guaranteed although the run ended well, a stress out of balance, and
a mean stress that is further from the reference than its bound. What a reference contradicts is asked again with
references refined further: it may be the reference's own error. Prints the violations, and how sharp the bounds are.
"""

import math
import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import BALANCED, Program, certified, judge_certificate, sweep_of_kinds, sweep_options
from solid_scenes import Rigid, Solid, pressure, write_scene

NOTHING_TO_SOLVE = ("Every displacement of a body is prescribed", "contact has nothing to decide here")
# A curved gap has its largest polynomial below it, which a vertex that is held on both sides may not be above.
TOO_COARSE = "overlap by"


def maps(draw, kind):
    """Of the upper and of the lower solid; they agree where the side of contact is."""
    height, depth = draw.uniform(0.1, 1.0), draw.uniform(0.1, 1.0)
    wide, long = draw.uniform(0.3, 1.5), draw.uniform(0.3, 1.5)
    bow = draw.uniform(-0.3, 0.3) * min(height, depth) if kind == "bent" else 0.0
    a, b = (draw.uniform(-1, 1), draw.uniform(-0.7, 0.7)) if kind == "inclined" else (0.0, 0.0)
    c, s, d, e = math.cos(a), math.sin(a), math.cos(b), math.sin(b)

    def turned(x, y, z):
        x, z = c * x - s * z, s * x + c * z
        return x, d * y - e * z, e * y + d * z

    floor = lambda x, y: bow * (x * x + 0.5 * x * y)
    upper = lambda r, q, t: turned(wide * r, long * q, (1 - t) * floor(r, q) + t * height)
    lower = lambda r, q, t: turned(wide * r, long * q, t * floor(r, q) - (1 - t) * depth)
    return upper, lower


def load(draw):
    """A pressure that stresses carry, or one whose oscillation is bounded: smooth, or on a part of the side."""
    a, b, slope = draw.uniform(0.0, 1.0), draw.uniform(0.1, 1.0), draw.uniform(-1.0, 1.0)
    part = (f"(x<{a:.3f})*(y<{b:.3f})", f"(x+{slope:.3f}*y<{b:.3f})", f"10*(abs(x-{a:.3f})<0.02)")
    return draw.choice((*part, "1", "1", "2", "1+x", "2+x-y", "1.5+0.5*x*y", "exp(x-y)", "1.1+sin(9*x)", "1+(x>0.3)"))


def along(factor, v, *others):
    """factor v + others"""
    return tuple(factor * c + sum(other[k] for other in others) for k, c in enumerate(v))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return tuple(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3))


def unit(v):
    return along(1.0 / math.sqrt(dot(v, v)), v)


def ground(draw, kind, upper, columns, rows):
    """A rigid body that touches the upper solid's side or stands a little below it, perhaps moved towards it."""
    vertices = [upper(i / columns, j / rows, 0.0) for i in range(columns + 1) for j in range(rows + 1)]
    middle = upper(0.5, 0.5, 0.0)
    out = unit(cross(along(-1.0, upper(0.0, 0.0, 0.0), upper(0.0, 1.0, 0.0)),
                     along(-1.0, upper(0.0, 0.0, 0.0), upper(1.0, 0.0, 0.0))))
    across = unit(cross(out, draw.choice(((1.0, 0.2, 0.0), (0.1, 1.0, 0.3)))))
    gap = draw.choice((0.0, 0.0, 0.01))
    moved = {"Displacement": along(-draw.uniform(0.0, 0.02), out)} if kind == "flat" and draw.random() < 0.3 else {}
    shape = draw.choice(("Plane",) if kind == "bent" else ("Plane", "Sphere", "Cylinder", "Expression"))
    if shape == "Plane":
        normal = unit(along(-1.0, out, along(draw.choice((0.0, draw.uniform(-0.1, 0.1))), across)))
        lowest = min(dot(normal, v) for v in vertices)
        return Rigid(shape, {"Point": along(lowest - gap - dot(normal, middle), normal, middle),
                             "Normal": along(draw.uniform(0.5, 3.0), normal), **moved})
    if shape == "Expression":
        return Rigid(shape, {"Distance": f"{gap}+0.1*(x^2+y*z)^2", **moved})
    radius = 10.0 ** draw.uniform(-0.3, 1.3)
    touched = draw.choice((middle, vertices[0], upper(0.3, 0.6, 0.0)))
    axis = {"Axis": unit(along(draw.uniform(-0.3, 0.3), out, across))} if shape == "Cylinder" else {}
    height = radius  # of the centre over the side, along its normal; an axis that leans comes nearer at one end
    if axis:
        ahead = along(-dot(out, axis["Axis"]), axis["Axis"], out)
        height /= math.sqrt(dot(ahead, ahead))
        height += max(dot(ahead, along(-1.0, touched, v)) for v in vertices) / dot(ahead, ahead)
    if draw.random() < 0.25 and not axis:
        widest = max(dot(along(-1.0, touched, v), along(-1.0, touched, v)) for v in vertices)
        return Rigid(shape, {"Centre": along(-radius, out, touched), "Radius": math.sqrt(radius**2 + widest) + gap,
                             "Hollow": True, **moved})
    return Rigid(shape, {"Centre": along(height + gap, out, touched), "Radius": radius, **axis, **moved})


def scene(draw, order):
    kind = draw.choice(("flat", "flat", "inclined", "bent"))
    upper, lower = maps(draw, kind)
    columns, rows = draw.randint(1, 3), draw.randint(1, 3)
    value = load(draw)
    held = {"left": "Roller", "front": "Roller"} if kind == "flat" else {"left": "Clamp"}
    if draw.random() < 0.3:
        held["right"] = "Roller" if kind == "flat" else "Clamp"
    young = lambda: 10.0 ** draw.uniform(-1.5, 1.5)
    first = Solid("upper", (columns, rows, draw.randint(1, 2)), upper, "bottom", young(), draw.uniform(0.0, 0.45), held,
                  {"press": pressure("top", f"{10.0 ** draw.uniform(-2, 0)}*({value})")}, 0.2, draw.randint(0, 10**6))
    second = Solid("lower", (columns, rows, draw.randint(1, 2)), lower, "top", young(), draw.uniform(0.0, 0.45),
                   {"bottom": "Clamp"}, {}, 0.2, draw.randint(0, 10**6))
    if draw.random() < 0.3:
        second.loads["side"] = pressure("back", "0.1")
    if draw.random() < 0.3:
        first.loads["weight"] = [("Type", "string", "Body Force"),
                                 ("Z", "string", draw.choice(("-0.1", "-0.1*(1+x)", "-0.1*cos(y)")))]
    gap = draw.choice(("0", "0", "0.01", "0.02*x", "0.05*(x^2+y^2)", "0.03*(1-cos(x+y))", "0.1*(x>0.3)"))
    gap = gap if kind == "flat" else draw.choice(("0", "0.01"))
    pair = (first, second) if draw.random() < 0.5 else (second, first)
    if draw.random() < 0.3:
        return f"{kind} on rigid", (first, ground(draw, kind, upper, columns, rows)), []
    return kind, pair, [("Gap", "string", gap.replace(">", "&gt;"))]


def coupling(draw):
    """Settings, and whether it ends where it should."""
    if draw.random() < 0.7:
        return [f"Coupling/Type={draw.choice(('Monolithic', 'Automatic', 'FETI'))}"], True
    sweeps = draw.choice((1, 2, 5, 100))
    return ["Coupling/Type=Neumann-Dirichlet", f"Coupling/Stopping/Maximum Sweeps={sweeps}"], False


def judge_loose(program, deck, order, tolerance):
    """A linear solver that stops anywhere: the bound is guaranteed and the stress in balance all the same, and the energy
    is where factors say (a reference would be as wrong as the solution)."""
    solve = lambda *solver: program.run(
        deck, f"Discretization/Order={order}", "Coupling/Type=Monolithic", "Error Estimation/Estimators={Global}",
        "Error Estimation/Check Equilibrium=true", "Output/Exodus=false", "Output/Contact Table=false", *solver)
    exact = solve("Linear Solver/Type=Cholmod")
    loose = solve("Linear Solver/Type=Multigrid", f"Linear Solver/Tolerance={tolerance}")
    of_both = [run.summary and run.summary["errors"] for run in (exact, loose)]
    if not all(of_both):
        return f"exit code {loose.code}: {loose.screen[-300:]}" if loose.code not in (exact.code, 3) else None
    if of_both[1]["equilibrium"] > BALANCED:
        return f"the stress is out of balance by {of_both[1]['equilibrium']:.2e}"
    if of_both[0]["global"]["guaranteed"] and not of_both[1]["global"]["guaranteed"]:
        return f"not guaranteed: {of_both[1]['global']['reason']}"
    first, second = (errors["energy_bracket"] for errors in of_both)
    if first and second:
        slack = 1e-9 * max(abs(first["lower"]), abs(first["upper"]))
        if second["lower"] > first["upper"] + slack or second["upper"] < first["lower"] - slack:
            return f"energies {first['lower']!r} to {first['upper']!r} and {second['lower']!r} to {second['upper']!r}"
    return None


def judge(program, seed, refinements):
    """(what is wrong or None, bound / error of a run that ends where it should, what it is about)"""
    draw = random.Random(f"solids {seed}")
    order = draw.choice((1, 2, 2))
    kind, pair, settings = scene(draw, order)
    how, ends = coupling(draw)
    about = f"{seed}: {kind}, order {order}, {', '.join(how)}"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        if seed % 4 == 3:
            tolerance = 10.0 ** random.Random(f"loose {seed}").uniform(-9, -0.5)
            return judge_loose(program, deck, order, tolerance), None, f"{seed}: {kind}, order {order}, {tolerance:.1e}"
        solve = certified(program, deck, f"Discretization/Order={order}", *how)
        run = solve(refinements)
        if run.code == 2 and any(reason in run.screen for reason in NOTHING_TO_SOLVE):
            return None, None, about
        return *judge_certificate(run, solve, refinements, (0, 3), ends, True, (TOO_COARSE,) if "rigid" in kind else ()), about


def main():
    options = sweep_options(__doc__, refinements=(1, "of the reference"))
    program = Program(options.ndframe)
    sweep_of_kinds(options, lambda seed: judge(program, seed, options.refinements), 2)


if __name__ == "__main__":
    main()
