"""Random scenes of two bodies in contact, as decks: the same for a seed on every machine.

A block above, a block below that may be wider, heights, cells, stiffnesses, loads and gaps at random; one of the two
may float, held by contact alone. All are well posed: what floats is pressed on what is held.
"""

import argparse
import dataclasses
import random
import xml.sax.saxutils


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    title: str
    deck: str  # XML

    def write(self, folder):
        path = folder / f"{self.name}.xml"
        path.write_text(self.deck)
        return path


def entry(name, value):
    kind = {bool: "bool", int: "int", float: "double", str: "string", tuple: "Array(double)"}[type(value)]
    if isinstance(value, tuple):
        kind = {int: "Array(int)", str: "Array(string)"}.get(type(value[0]), kind)
        value = "{" + ", ".join(map(str, value)) + "}"
    escaped = xml.sax.saxutils.quoteattr(str(value).lower() if isinstance(value, bool) else str(value))
    return f'<Parameter name="{name}" type="{kind}" value={escaped}/>\n'


def to_xml(name, entries):
    """A list of {name: value or {...}}."""
    inside = "".join(to_xml(key, value) if isinstance(value, dict) else entry(key, value)
                     for key, value in entries.items())
    return f'<ParameterList name="{name}">\n{inside}</ParameterList>\n'


def power_of_ten(draw, lowest, highest):
    return float(f"{10 ** draw.uniform(lowest, highest):.3g}")


def load_value(draw, width):
    """Pressure along a side from 0 to width, positive in sum: even, falling or on one part more than the other."""
    slope = round(draw.uniform(0.0, 0.9), 2)
    return draw.choice(("1", f"1 - {slope} * x / {width}", f"1 + {3 * slope:.2f} * (x / {width})^2"))


def gap_value(draw, width, floats):
    """Opening along the side. The shapes with a height of their own close only where a body floats or is soft."""
    rise = power_of_ten(draw, -4, -1)
    shapes = ["0", "0", f"{rise} * (x / {width})^2", f"{rise} * x / {width}"]
    return draw.choice(shapes + [f"0.05 + {rise} * (x / {width})^2"] if floats else shapes)


def box(lower, upper, cells, splits=None):
    mesh = {"Type": "Box", "Lower": lower, "Upper": upper, "Cells": cells}
    return mesh | {"Splits": splits} if splits else mesh


def material(draw, stiffness):
    return {"Young Modulus": stiffness, "Poisson Ratio": round(draw.uniform(0.0, 0.45), 2)}


def far_side(draw, name, columns, size):
    """The side that is not in contact: (its splits, where it may be held, where it is pressed)."""
    if columns < 3 or draw.random() < 0.6:
        return {}, name, name
    split = {"Side": name, "At": ((columns - 1) * size,), "Names": (f"{name}-free", f"{name}-end")}
    return {"far": split}, f"{name}-end", f"{name}-free"


def supports(draw, floats, side, at_contact):
    """Symmetry at x = 0; a floating body has nothing else. A clamp at_contact ends where contact does."""
    symmetry = {"symmetry": {"Type": "Roller", "Side": "left"}}
    if not floats and at_contact is not None and draw.random() < 0.3:
        return symmetry | {"held": {"Type": "Clamp", "Side": at_contact}}
    return symmetry if floats else symmetry | {"held": {"Type": draw.choice(("Clamp", "Roller")), "Side": side}}


def pressed(draw, side, width):
    return {"press": {"Type": "Pressure", "Side": side, "Value": load_value(draw, width)}}


def two_bodies_lists(seed, lowest, highest):
    draw = random.Random(f"two bodies {seed}")
    floating = draw.choice(("upper", "lower", None))
    width, heights = round(draw.uniform(0.5, 2.0), 1), [round(draw.uniform(0.1, 2.0), 2) for _ in range(2)]
    across, wider = draw.randint(3, 10), draw.choice((0, 0, draw.randint(1, 6)))
    size = width / across
    rows = [max(1, round(height / size * draw.uniform(0.6, 1.5))) for height in heights]
    far = (across + wider) * size
    stiffness = power_of_ten(draw, lowest, highest)
    split = {"contact": {"Side": "top", "At": (width,), "Names": ("contact", "free")}} if wider else {}
    top, bottom = far_side(draw, "top", across, size), far_side(draw, "bottom", across + wider, size)
    upper = {"Mesh": box((0.0, 0.0), (width, heights[0]), (across, rows[0]), top[0]),
             "Material": material(draw, stiffness), "Supports": supports(draw, floating == "upper", top[1], "right"),
             "Loads": pressed(draw, top[2], width) if floating != "lower" else {}}
    lower = {"Mesh": box((0.0, -heights[1]), (far, 0.0), (across + wider, rows[1]), split | bottom[0]),
             "Material": material(draw, 1.0), "Supports": supports(draw, floating == "lower", bottom[1], "free" if wider else "right"),
             "Loads": pressed(draw, bottom[2], far) if floating != "upper" else {}}
    roles = [("upper", "bottom"), ("lower", "contact" if wider else "top")]
    draw.shuffle(roles)
    contact = {"Dirichlet Body": roles[0][0], "Dirichlet Side": roles[0][1], "Neumann Body": roles[1][0],
               "Neumann Side": roles[1][1], "Gap": gap_value(draw, width, floating is not None)}
    title = f"upper {stiffness:g} times as stiff, {floating or 'no body'} floats"
    return {"Title": title, "Bodies": {"upper": upper, "lower": lower}, "Interfaces": {"contact": contact}}


def two_bodies(seed, lowest=-6.0, highest=6.0):
    """upper's stiffness over lower's between 10^lowest and 10^highest."""
    name, lists = f"two-bodies-{seed}", two_bodies_lists(seed, lowest, highest)
    return Scene(name, lists["Title"], to_xml(name, lists))


def add_regions(draw, body, lowest, highest):
    """One or two parts of a body's box, from grid line to grid line, 10^lowest to 10^highest times as stiff."""
    mesh, parts = body["Mesh"], {}
    grid = [[low + k * (high - low) / cells for k in range(cells + 1)]
            for low, high, cells in zip(mesh["Lower"], mesh["Upper"], mesh["Cells"], strict=True)]
    for name in ("first", "second")[:draw.randint(1, 2)]:
        ends = [sorted(draw.sample(lines, 2)) for lines in grid]
        parts[name] = {"Lower": tuple(low for low, _ in ends), "Upper": tuple(high for _, high in ends)}
    if len(parts) == 2 and all(max(a, c) < min(b, d) for a, b, c, d in zip(
            parts["first"]["Lower"], parts["first"]["Upper"], parts["second"]["Lower"], parts["second"]["Upper"])):
        del parts["second"]  # they would overlap
    mesh["Parts"] = parts
    stiffness = body["Material"]["Young Modulus"]
    body["Regions"] = {name: {"Material": material(draw, stiffness * power_of_ten(draw, lowest, highest))}
                       for name in parts}


def bodies_of_regions(seed, lowest=-3.0, highest=3.0):
    """Two bodies of similar stiffness that consist of several materials."""
    draw = random.Random(f"regions {seed}")
    lists = two_bodies_lists(f"of regions {seed}", -1.0, 1.0)
    for body in lists["Bodies"].values():
        body["Mesh"]["Pattern"] = draw.choice(("Right", "Alternating", "Crossed"))
        add_regions(draw, body, lowest, highest)
    lists["Discretization"] = {"Order": draw.choice((1, 2))}
    name = f"regions-{seed}"
    return Scene(name, lists["Title"], to_xml(name, lists))


def sweep_parser(doc, scenes):
    """The arguments of every sweep over seeds; doc: the script's."""
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("ndframe", help="the built program")
    parser.add_argument("--scenes", type=int, default=scenes)
    parser.add_argument("--seed", type=int, default=1, help="of the first scene")
    return parser
