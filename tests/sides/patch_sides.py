"""Sides that do not match carry a uniform stress exactly: patch_sides.py NDFRAME.

Two rectangles of one material on rollers, pressed evenly: uniaxial stress, whatever the meshes. The certificate of a
state without error is round-off, and so are its contact pressures' distances from the load's. Ratios, random columns, a
side that ends inside a facet, first and second order, upright and turned, with the roles of the sides exchanged, and
with contact asked at all nodes or in means.
"""

import argparse
import csv
import itertools
import json
import math
import pathlib
import random
import sys
import tempfile

TESTS = pathlib.Path(__file__).parent.parent
sys.path += [str(TESTS / "accuracy"), str(TESTS.parent / "python")]
import numpy
import side_scenes
from ndframe import Fields
from runs import Program

ALLOWED = 1e-12  # relative; pressures come from nodal forces, which short facets divide by their length
ROUNDING = 150.0 * numpy.finfo(float).eps  # of stresses times the narrowest facet's width: measured 72 eps in 500 scenes
DRAW = random.Random("patch")
COLUMNS = {"1:1": (side_scenes.even(4), side_scenes.even(4)), "2:3": (side_scenes.even(4), side_scenes.even(6)),
           "1:4": (side_scenes.even(3), side_scenes.even(12)), "4:1": (side_scenes.even(12), side_scenes.even(3)),
           "random": (side_scenes.spread(DRAW, 7, 0.1), side_scenes.spread(DRAW, 5, 0.1)),
           "almost 1:1": (side_scenes.even(8), [x + 0.004 * (0 < x < 1) for x in side_scenes.even(8)]),
           "narrow": (side_scenes.even(8), [x + 0.0125 * (0 < x < 1) for x in side_scenes.even(8)])}
WIDTHS = {"whole": (1.0, 1.0), "ends inside": (0.8, 0.98)}  # the last column of both bodies is cut there


def stress_error(path, turn):
    """Largest distance of a component from those of a unit pressure along the turned second axis."""
    normal = numpy.array([-math.sin(turn), math.cos(turn)])
    with_fields = Fields(path)
    return max(numpy.abs(with_fields.stress(block)[:, :2, :2] + numpy.outer(normal, normal)).max()
               for block in with_fields.blocks)


def written(folder, ending):
    return next(pathlib.Path(folder).glob("*" + ending))


def judge(program, columns, width, order, turn, exchanged, pairing):
    upper = side_scenes.Block("upper", columns[0], 3, side_scenes.box(0, 0, width, 0.5, turn), "bottom",
                              supports={"left": "Roller"}, pressure="1")
    lower = side_scenes.Block("lower", columns[1], 3, side_scenes.box(0, -0.5, width, 0, turn), "top",
                              supports={"left": "Roller", "bottom": "Roller"})
    with tempfile.TemporaryDirectory() as folder:
        if width != 1.0:  # the lower body's columns are laid out over the wider side and cut off
            wide = [x / width for x in columns[1] if x < width * (1 - 1e-9)] + [1.0]
            lower.columns = wide
        narrowest = width * min(numpy.diff(body.columns).min() for body in (upper, lower))
        pair = (lower, upper) if exchanged else (upper, lower)
        deck = side_scenes.write_scene(folder, *pair)
        run = program.run(deck, f"Discretization/Order={order}", "Coupling/Type=Monolithic", f"Output/Directory={folder}",
                          f"Interfaces/contact/Pairing/Type={pairing}",
                          "Error Estimation/Check Equilibrium=true", "Error Estimation/Estimators={Global}")
        if run.code != 0:
            return f"exit code {run.code}: {run.screen[-400:]}"
        stress = stress_error(written(folder, ".e"), turn)
        errors = json.loads(written(folder, ".summary.json").read_text())["errors"]["global"]
        with written(folder, ".contact.csv").open() as table:
            pressures = [float(row["pressure"]) for row in csv.DictReader(table)]
    off = max(abs(p - 1.0) for p in pressures)
    if not errors["guaranteed"]:
        return f"not guaranteed: {errors['reason']}"
    if errors["relative"] > math.sqrt(ALLOWED):  # the contact part is the square root of round-off in [u] - g
        return f"bound {errors['relative']:.2g}"
    if stress * narrowest > ROUNDING:
        return f"stresses are off by {stress:.2g}"
    return f"pressures are off by {off:.2g}" if off > 10 * ALLOWED else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ndframe")
    program, wrong, count = Program(parser.parse_args().ndframe), 0, 0
    for ratio, width, order, turn, exchanged, pairing in itertools.product(COLUMNS, WIDTHS, (1, 2), (0.0, 0.4), (False, True),
                                                                           ("Cut", "Mortar")):
        count += 1
        drawn = DRAW.uniform(*WIDTHS[width])
        if found := judge(program, COLUMNS[ratio], drawn, order, turn, exchanged, pairing):
            wrong += 1
            print(f"{ratio}, {width}, width {drawn}, order {order}, turned by {turn}, exchanged {exchanged}, {pairing}: {found}", flush=True)
    print(f"{count} scenes, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
