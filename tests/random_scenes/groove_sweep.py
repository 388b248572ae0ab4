"""Wedges in grooves, supports that end at the contact side: groove_sweep.py NDFRAME [--scenes N] [--seed FIRST].

Two bodies that meet along two straight flanks with a corner between, meshed by hand (facets of random lengths, the
corner's two of different length); the wedge may float, supports of either body may end where contact does. The default
coupling to 1e-9 and Monolithic must agree in the energy and be guaranteed, or both say that the load pulls the wedge off. One line a scene that does not; exit code 1 if there is one.
"""

import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import random_scenes
from runs import Program

DIGITS = 1e-6  # of the energy
PULLED_OFF = ("no pressure on the interfaces balances the loads", "the load does not press the bodies together")


def write_mesh(path, xs, low, high, rows, top, bottom):
    """Columns of triangles between two curves, in gmsh's format 2.2."""
    points = [(x, low(x) + (high(x) - low(x)) * j / rows) for j in range(rows + 1) for x in xs]
    number = lambda i, j: j * len(xs) + i + 1
    edges, triangles = [], []
    for i in range(len(xs) - 1):
        edges += [(1, number(i, 0), number(i + 1, 0)), (2, number(i, rows), number(i + 1, rows))]
        for j in range(rows):
            a, b, c, d = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
            triangles += [(a, b, d), (b, c, d)] if xs[i] < 0 else [(a, b, c), (a, c, d)]
    for j in range(rows):
        edges += [(3, number(0, j), number(0, j + 1)), (4, number(len(xs) - 1, j), number(len(xs) - 1, j + 1))]
    elements = [(1, *edge) for edge in edges] + [(2, 5, *triangle) for triangle in triangles]
    names = [(1, 1, bottom), (1, 2, top), (1, 3, "left"), (1, 4, "right"), (2, 5, "body")]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", len(names)]
    lines += [f'{dim} {tag} "{name}"' for dim, tag, name in names] + ["$EndPhysicalNames", "$Nodes", len(points)]
    lines += [f"{k} {x!r} {y!r} 0" for k, (x, y) in enumerate(points, start=1)] + ["$EndNodes", "$Elements", len(elements)]
    for k, (kind, tag, *nodes) in enumerate(elements, start=1):
        lines.append(" ".join(map(str, (k, kind, 2, tag, tag, *nodes))))
    path.write_text("\n".join(map(str, lines + ["$EndElements", ""])))


def held(kind, side):
    return {"held": {"Type": kind, "Side": side}}


def groove(seed, folder):
    """Writes the meshes and the deck of a scene; returns the deck."""
    draw = random.Random(f"groove {seed}")
    slope = draw.choice((0.3, 0.8, 1.0, 1.7, -0.9, -1.5))
    xs = sorted({-1.0, 0.0, 1.0, *(round(draw.uniform(-0.95, 0.95), 2) for _ in range(draw.randint(2, 6)))})
    flank, top, bottom = (lambda x: slope * abs(x)), max(0.0, slope) + 1.0, min(0.0, slope) - 1.0
    write_mesh(folder / "upper.msh", xs, flank, lambda x: top, draw.randint(2, 4), "top", "contact")
    write_mesh(folder / "lower.msh", xs, lambda x: bottom, flank, draw.randint(2, 4), "contact", "bottom")

    def body(name, modulus, supports, loads):
        return {"Mesh": {"Type": "Gmsh", "File": f"{name}.msh"}, "Supports": supports, "Loads": loads,
                "Material": {"Young Modulus": modulus, "Poisson Ratio": 0.3}}

    press = {"press": {"Type": "Traction", "Side": "top", "X": f"{draw.uniform(-0.15, 0.15):.2f}", "Y": "-1"}}
    below = draw.choice((held("Clamp", "right"), held("Clamp", "bottom"),
                         {"wall": {"Type": "Roller", "Side": "right"}, "floor": {"Type": "Roller", "Side": "bottom"}}))
    above = draw.choice(({}, {}, held("Roller", "left"), held("Clamp", "left")))
    contact = {"Dirichlet Body": "upper", "Dirichlet Side": "contact", "Neumann Body": "lower",
               "Neumann Side": "contact", "Gap": draw.choice(("0", "0", "0.001*x^2", "0.0005*(1+x)"))}
    scene = {"Bodies": {"upper": body("upper", random_scenes.power_of_ten(draw, -2, 6), above, press),
                        "lower": body("lower", 100.0, below, {})},
             "Interfaces": {"flanks": contact}, "Discretization": {"Order": draw.choice((1, 2, 2))},
             "Error Estimation": {"Mode": "Strict"}}
    deck = folder / f"groove-{seed}.xml"
    deck.write_text(random_scenes.to_xml(f"groove-{seed}", scene))
    return deck


def complaint(program, deck):
    """What does not hold; empty when all does."""
    runs = [program.run(deck, "Coupling/Stopping/Tolerance=1e-9"), program.run(deck, "Coupling/Type=Monolithic")]
    if any(all(reason in run.screen for run in runs) for reason in PULLED_OFF):
        return ""
    if any(run.code != 0 for run in runs):
        return f"exits {[run.code for run in runs]}: {[run.screen.strip().splitlines()[-1] for run in runs]}"
    energies = [run.summary["energy"] for run in runs]
    if abs(energies[0] - energies[1]) > DIGITS * energies[1]:
        return f"energies {energies}"
    reasons = [run.summary["errors"]["global"].get("reason") for run in runs
               if not run.summary["errors"]["global"]["guaranteed"]]
    return f"not guaranteed: {reasons}" if reasons else ""


def main():
    given = random_scenes.sweep_parser(__doc__, 1000).parse_args()
    program, wrong = Program(given.ndframe), 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.seed, given.seed + given.scenes):
            deck = groove(seed, pathlib.Path(folder))
            if text := complaint(program, deck):
                wrong += 1
                print(f"{deck.stem}: {text}", flush=True)
    print(f"{wrong} of {given.scenes} scenes are wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
