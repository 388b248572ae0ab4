"""Decks of networks of boxes: network_decks.py SCENE [SIZES] [options] > NAME.xml

Sides are cut where interfaces end, and all cells have the same size, so that nodes match. The same options give the
same deck on every machine.
"""

import argparse
import dataclasses
import random
import sys
import xml.sax.saxutils

OPPOSITE = {"left": "right", "right": "left", "bottom": "top", "top": "bottom"}


@dataclasses.dataclass
class Box:
    name: str
    lower: tuple
    upper: tuple
    supports: dict = dataclasses.field(default_factory=dict)  # side -> Type
    loads: list = dataclasses.field(default_factory=list)  # (side, from, to, pressure)
    young: float = 1.0

    def along(self, side):
        """Interval of the coordinate along a side."""
        axis = 1 if side in ("left", "right") else 0
        return self.lower[axis], self.upper[axis]

    def height(self, side):
        """The coordinate that is constant on a side."""
        axis = 0 if side in ("left", "right") else 1
        return (self.upper if side in ("right", "top") else self.lower)[axis]

    def press(self, side, pressure, start=None, end=None):
        first, last = self.along(side)
        self.loads.append((side, first if start is None else start, last if end is None else end, pressure))


@dataclasses.dataclass
class Contact:
    one: Box  # the Dirichlet body: the one above or on the right
    side: str
    other: Box
    start: float
    end: float


def stack(options):
    """Three boxes on each other, the upper one pressed on the left half of its top: on the right contact opens.

    The symmetry plane x = 0 is a roller on all of them; the middle and the upper one are held by contact vertically."""
    boxes = [Box(name, (0.0, 0.5 * k), (1.0, 0.5 * (k + 1)), {"left": "Roller"})
             for k, name in enumerate(("lower", "middle", "upper"))]
    boxes[0].supports["bottom"] = "Clamp"
    boxes[2].press("top", 1.0, 0.0, 0.5)
    return boxes, {"the load": ("interfaces/upper on middle/contact_force", 0.5, 0.005)}


def chain(options, number):
    """Blocks in a row, pressed against a wall on the left by a load on the right, above the middle of the last one.

    They stand on rollers, and every other one is pressed from above: a block between two others bends easily, which
    makes sweeps from body to body slow."""
    boxes = [Box(f"block {k + 1}", (float(k), 0.0), (k + 1.0, 0.5), {"bottom": "Roller"}) for k in range(number)]
    boxes[0].supports["left"] = "Roller"
    for box in boxes[1::2]:
        box.press("top", 0.2)
    boxes[-1].press("right", 1.0, 0.25, 0.5)
    return boxes, {"the load": ("interfaces/block 2 on block 1/contact_force", 0.25, 0.0025)} if number > 1 else {}


def tjunction(options):
    """A bridge on two blocks that touch each other below it: the node where all three meet belongs to two interfaces of
    the bridge and to one between the blocks."""
    boxes = [Box("left", (0.0, 0.0), (1.0, 1.0), {"bottom": "Clamp"}),
             Box("right", (1.0, 0.0), (2.0, 1.0), {"bottom": "Roller", "right": "Roller"}),
             Box("bridge", (0.0, 1.0), (2.0, 1.5), {"left": "Roller"})]
    boxes[2].press("top", 1.0, 0.5, 1.5)
    return boxes, {}


def ring(options):
    """Four blocks round a square core, like the sails of a mill: each lies along a side of the core and on the end of the
    next block. Pressed from outside.

    Rollers below and on the left; the core and the two other blocks are held by contact alone. The free ends are pressed
    too: without that the blocks could slide away from each other, which the program would say."""
    core = Box("core", (0.0, 0.0), (1.0, 1.0))
    lower = Box("lower", (0.0, -0.5), (1.5, 0.0), {"bottom": "Roller"})
    right = Box("right", (1.0, 0.0), (1.5, 1.5))
    upper = Box("upper", (-0.5, 1.0), (1.0, 1.5))
    left = Box("left", (-0.5, -0.5), (0.0, 1.0), {"left": "Roller"})
    right.press("right", 1.0)
    upper.press("top", 1.0)
    for box, side in ((lower, "right"), (right, "top"), (upper, "left"), (left, "bottom")):
        box.press(side, 0.5)
    return [core, lower, right, upper, left], {"the free end": ("interfaces/right on upper/contact_force", 0.25, 0.0025)}


def wall(options, rows, columns):
    """A wall of bricks of 2 x 1 in running bond between rollers, pressed on top.

    Bricks touch along bed joints and head joints: the middle of a brick's lower side belongs to two interfaces, its
    corners to a bed and a head joint. Equal bricks pressed evenly are in uniform compression, exact on any mesh. Where
    only a part is pressed contact opens, and bricks that nothing presses are named as not unique."""
    width, boxes = 2 * columns, []
    loaded = round(options.load * width / options.cell) * options.cell
    for row in range(rows):
        cuts = [0, *range(1, width, 2), width] if row % 2 else list(range(0, width + 1, 2))
        for k, (start, end) in enumerate(zip(cuts, cuts[1:])):
            box = Box(f"brick {row + 1}.{k + 1}", (float(start), float(row)), (float(end), row + 1.0))
            if row == 0:
                box.supports["bottom"] = options.base
            if start == 0:
                box.supports["left"] = "Roller"
            if end == width:
                box.supports["right"] = "Roller"
            if row == rows - 1 and loaded > start:
                box.press("top", 1.0, float(start), min(float(end), loaded))
            boxes.append(box)
    even = loaded == width and options.young == "uniform"
    strain = 1.3 * 0.4 / 0.7  # of uniaxial compression under a pressure of 1, Young modulus 1, Poisson ratio 0.3
    return boxes, {"uniform compression": ("energy", round(strain * rows * width, 9), 1e-7)} if even else {}


SCENES = {"stack": (stack, "Three boxes on each other"), "chain": (chain, "A chain of {} blocks"),
          "tjunction": (tjunction, "A bridge on two blocks that touch"), "ring": (ring, "A ring round a core"),
          "wall": (wall, "A wall of {} x {} bricks")}


def contacts(boxes):
    """Where the left or bottom side of a box lies on the right or top side of another one."""
    at = {}
    for box in boxes:
        for side in ("right", "top"):
            at.setdefault((side, box.height(side)), []).append(box)
    found = []
    for one in boxes:
        for side in ("left", "bottom"):
            for other in at.get((OPPOSITE[side], one.height(side)), []):
                start, end = (pick(pair) for pick, pair in
                              zip((max, min), zip(one.along(side), other.along(side))))
                if end > start:
                    found.append(Contact(one, side, other, start, end))
    return found


def free_sides(boxes):
    """(box, side) where nothing touches and nothing holds."""
    touched = {end for contact in contacts(boxes)
               for end in ((contact.one.name, contact.side), (contact.other.name, OPPOSITE[contact.side]))}
    return [(box, side) for box in boxes for side in OPPOSITE
            if side not in box.supports and (box.name, side) not in touched]


class Cuts:
    """The parts of the sides of all boxes."""

    def __init__(self, boxes, touching):
        self.ends = {}
        for contact in touching:
            self.add(contact.one, contact.side, contact.start, contact.end)
            self.add(contact.other, OPPOSITE[contact.side], contact.start, contact.end)
        for box in boxes:
            for side, start, end, _ in box.loads:
                self.add(box, side, start, end)

    def add(self, box, side, start, end):
        first, last = box.along(side)
        self.ends.setdefault((box.name, side), set()).update(x for x in (start, end) if first < x < last)

    def at(self, box, side):
        return sorted(self.ends.get((box.name, side), ()))

    def part(self, box, side, start):
        """Name of the part of a side that begins at `start`."""
        at = self.at(box, side)
        return f"{side} {1 + sum(x <= start for x in at)}" if at else side

    def splits(self, box):
        lists = {}
        for side in OPPOSITE:
            if at := self.at(box, side):
                names = tuple(f"{side} {k + 1}" for k in range(len(at) + 1))
                lists[side] = {"Side": side, "At": tuple(at), "Names": names}
        return lists


def body(box, cuts, options):
    cells = tuple(round((high - low) / options.cell) for low, high in zip(box.lower, box.upper))
    mesh = {"Type": "Box", "Lower": box.lower, "Upper": box.upper, "Cells": cells, "Pattern": "Crossed"}
    loads = {}
    for k, (side, start, end, pressure) in enumerate(box.loads, start=1):
        at = [x for x in cuts.at(box, side) if start < x < end]
        for j, first in enumerate([start, *at], start=1):
            name = f"press {k}" + (f".{j}" if at else "")
            loads[name] = {"Type": "Pressure", "Side": cuts.part(box, side, first), "Value": f"{pressure:g}"}
    entries = {"Mesh": mesh | ({"Splits": cuts.splits(box)} if cuts.splits(box) else {}),
               "Material": {"Young Modulus": box.young, "Poisson Ratio": 0.3}}
    if box.supports:
        entries["Supports"] = {side: {"Type": kind, "Side": side} for side, kind in box.supports.items()}
    return entries | ({"Loads": loads} if loads else {})


def interface(contact, cuts):
    return {"Dirichlet Body": contact.one.name, "Dirichlet Side": cuts.part(contact.one, contact.side, contact.start),
            "Neumann Body": contact.other.name,
            "Neumann Side": cuts.part(contact.other, OPPOSITE[contact.side], contact.start)}


def stiffen(boxes, options):
    """uniform, alternating:FACTOR or random:DECADES (a power of ten between -DECADES and DECADES)."""
    kind, _, value = options.young.partition(":")
    draw = random.Random(f"young {options.seed}")
    for k, box in enumerate(boxes):
        if kind == "alternating":
            box.young = float(value) if k % 2 else 1.0
        elif kind == "random":
            box.young = float(f"{10 ** draw.uniform(-float(value), float(value)):.4g}")
        elif kind != "uniform":
            raise SystemExit(f'--young {options.young}: one of uniform, alternating:FACTOR, random:DECADES')


def deck(options, change=None):
    """{name: value or {...}} of a scene. change(boxes): other loads and supports."""
    scene, title = SCENES[options.scene]
    if len(options.sizes) != title.count("{}") or min(options.sizes, default=1) < 1:
        raise SystemExit(f"{options.scene} takes {title.count('{}')} whole numbers above 0")
    boxes, expected = scene(options, *options.sizes)
    if change:
        change(boxes)
        expected = {}
    stiffen(boxes, options)
    touching = contacts(boxes)
    cuts = Cuts(boxes, touching)
    if options.shuffle is not None:
        random.Random(f"order {options.shuffle}").shuffle(boxes)
    entries = {"Title": title.format(*options.sizes),
               "Bodies": {box.name: body(box, cuts, options) for box in boxes},
               "Interfaces": {f"{contact.one.name} on {contact.other.name}": interface(contact, cuts)
                              for contact in touching}}
    if options.coupling:
        entries["Coupling"] = {"Type": options.coupling}
    if expected:
        entries["Expect"] = {name: {"Quantity": quantity, "Value": value, "Tolerance": tolerance}
                             for name, (quantity, value, tolerance) in expected.items()}
    return entries | {"Strain Limit": 1000.0}  # loads and moduli of 1: only proportions count


def comment(options, arguments):
    """What stands above a deck: the scene's own words, and how it was made."""
    lines = [line.strip() for line in SCENES[options.scene][0].__doc__.splitlines()]
    indented = "\n".join(5 * " " + line if line else "" for line in lines).strip()
    made_by = " ".join(arguments).replace("--", "")  # which comments of XML may not have
    return f"<!-- {indented}\n\n     Made by tests/networks/network_decks.py {made_by} -->\n"


def entry(name, value):
    kinds = {str: "string", int: "int", float: "double"}
    kind = f"Array({kinds[type(value[0])]})" if isinstance(value, tuple) else kinds[type(value)]
    text = "{" + ", ".join(map(str, value)) + "}" if isinstance(value, tuple) else str(value)
    return f'<Parameter name="{name}" type="{kind}" value={xml.sax.saxutils.quoteattr(text)}/>\n'


def to_xml(name, entries, indent=""):
    inside = "".join(to_xml(key, value, indent + "  ") if isinstance(value, dict) else indent + "  " + entry(key, value)
                     for key, value in entries.items())
    return f'{indent}<ParameterList name="{name}">\n{inside}{indent}</ParameterList>\n'


def options_of(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", choices=SCENES)
    parser.add_argument("sizes", nargs="*", type=int, help="chain: blocks; wall: rows, bricks in a row")
    parser.add_argument("--cell", type=float, default=0.25, help="side of a cell: a whole number of them in 0.25 or 0.5")
    parser.add_argument("--young", default="uniform", help="uniform, alternating:FACTOR or random:DECADES")
    parser.add_argument("--seed", type=int, default=1, help="of random moduli")
    parser.add_argument("--shuffle", type=int, metavar="SEED", help="order of the bodies in the deck")
    parser.add_argument("--load", type=float, default=1.0, help="of a wall: the part of its width that is pressed")
    parser.add_argument("--base", default="Clamp", choices=("Clamp", "Roller"), help="of a wall")
    parser.add_argument("--coupling", help="Coupling/Type; without it the deck names none")
    return parser.parse_args(arguments)


def text(arguments):
    options = options_of(arguments)
    return comment(options, arguments) + to_xml(options.scene, deck(options))


if __name__ == "__main__":
    sys.stdout.write(text(sys.argv[1:]))
