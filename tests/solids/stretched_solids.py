"""How sharp bounds are on stretched tetrahedra: stretched_solids.py NDFRAME [--scenes N] [--seed FIRST] [--steps N] [--stretch N].

One solid each of 2 to 4 bricks along its edges: cubes; or plates, rods and blades, bricks that are `stretch` times as long along two axes,
along one, or along one and its root along another. Half of the meshes are shaken inside and numbered at random. Clamped on one side,
perhaps a roller on another, loaded by pressures and a weight that stresses of the second degree carry. The error is that against cells a
quarter as large. Something is wrong where a bound is below it, or a median is above its limit. Prints the medians.
"""

import collections
import math
import pathlib
import random
import statistics
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program, certified, judge_certificate, print_sharpness, sweep, sweep_options
from solid_scenes import SIDES, Solid, pressure

SHAPES = {"cubes": (0.0, 0.0, 0.0), "plates": (1.0, 1.0, 0.0), "rods": (1.0, 0.0, 0.0), "blades": (1.0, 0.5, 0.0)}  # powers of the stretch
# At most, of bound over error; the others five to one. Measured: docs/performance.md, "Stretched tetrahedra".
MEDIANS = {"cubes": 1.3}
STRETCHED = 2.0


def scene(draw, shape, stretch):
    powers = list(SHAPES[shape])
    draw.shuffle(powers)
    cells = tuple(draw.randint(2, 4) for _ in powers)
    sizes = [n * stretch**power for n, power in zip(cells, powers)]
    held = draw.choice(SIDES)
    across = SIDES[SIDES.index(held) ^ 1]
    beside = [side for side in SIDES if side not in (held, across)]
    supports = {held: "Clamp"}
    if draw.random() < 0.5:
        supports[draw.choice(beside)] = "Roller"
    x, y, z = (f"({c}/{size})" for c, size in zip("xyz", sizes))
    number = lambda: f"{draw.uniform(-1, 1):.3f}"
    loads = {f"press {side}": pressure(side, f"{draw.uniform(0.2, 1):.3f}+{number()}*{x}+{number()}*{y}*{z}+{number()}*{z}")
             for side in draw.sample([side for side in SIDES if side not in supports], 2)}
    if draw.random() < 0.5:
        loads["weight"] = [("Type", "string", "Body Force"), ("Z", "string", f"{number()}/{max(sizes)}")]
    place = lambda r, s, t: (r * sizes[0], s * sizes[1], t * sizes[2])
    return Solid("body", cells, place, "bottom", 1.0, draw.uniform(0.0, 0.45), supports, loads, draw.choice((0.0, 0.2)), draw.randint(0, 10**6))


def judge(program, seed, steps, stretch):
    """(what is wrong or None, bound / error, the shape)"""
    draw = random.Random(f"stretched {seed}")
    shape = list(SHAPES)[seed % len(SHAPES)]
    with tempfile.TemporaryDirectory() as folder:
        solid = scene(draw, shape, stretch)
        solid.write(folder)
        deck = pathlib.Path(folder) / "stretched.xml"
        deck.write_text(f'<ParameterList name="stretched"><ParameterList name="Bodies">{solid.deck()}</ParameterList></ParameterList>')
        number = (f"Error Estimation/Recovery/Steps={steps}", "Error Estimation/Recovery/Least Gain=0") if steps else ()
        solve = certified(program, deck, "Error Estimation/Recovery/Type=Global", *number)
        return *judge_certificate(solve(2), solve, 2, is_mean_bounded=False), f"{seed}: {shape}"


def main():
    options = sweep_options(__doc__, steps=(0, "of conjugate gradients; 0: as long as they lower the bound"), stretch=(5, "of bricks"))
    program = Program(options.ndframe)
    wrong, found = sweep(options, lambda seed: judge(program, seed, options.steps, options.stretch))
    of_shapes = collections.defaultdict(list)
    for ratio, about in found:
        if ratio:
            of_shapes[about.split(": ")[1]].append(ratio)
    for shape, ratios in of_shapes.items():
        print_sharpness(ratios, f", {shape}")
        limit = MEDIANS.get(shape, STRETCHED if options.stretch <= 5 else math.inf)
        if not options.steps and statistics.median(ratios) > limit:
            wrong += 1
            print(f"{shape}: the median is above {limit}")
    print(f"{options.scenes} scenes, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
