"""Two bodies whose sides are meshed apart: meshes (gmsh 2.2) and decks of random scenes.

A body is a grid of quadrilaterals, each cut into two triangles, bent by a map of the unit square. Its columns are given
along the side of contact and become even towards the opposite side, so that meshes of any two sides can meet.
"""

import dataclasses
import math
import pathlib


@dataclasses.dataclass
class Block:
    """Sides: bottom, right, top, left. columns: places from 0 to 1 along the side of contact (`foot`: bottom or top)."""
    name: str
    columns: list
    rows: int
    place: object  # (s, t) in the unit square -> (x, y)
    foot: str
    young: float = 1.0
    poisson: float = 0.3
    supports: dict = dataclasses.field(default_factory=dict)  # side -> Type
    pressure: str = "0"  # on the side opposite to the foot

    def far(self):
        return "top" if self.foot == "bottom" else "bottom"

    def point(self, i, j):
        n, t = len(self.columns) - 1, j / self.rows
        near = 1.0 - t if self.foot == "bottom" else t
        return self.place(near * self.columns[i] + (1.0 - near) * i / n, t)

    def write(self, folder):
        n, m = len(self.columns) - 1, self.rows
        node = lambda i, j: 1 + i + j * (n + 1)
        lines = {"bottom": [(node(i, 0), node(i + 1, 0)) for i in range(n)],
                 "right": [(node(n, j), node(n, j + 1)) for j in range(m)],
                 "top": [(node(i + 1, m), node(i, m)) for i in range(n)],
                 "left": [(node(0, j + 1), node(0, j)) for j in range(m)]}
        cells = []
        for i in range(n):
            for j in range(m):
                a, b, c, d = node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)
                cells += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
        elements = [f"1 2 {k + 1} {k + 1} {a} {b}" for k, side in enumerate(lines) for a, b in lines[side]]
        elements += [f"2 2 5 5 {a} {b} {c}" for a, b, c in cells]
        names = [f'1 {k + 1} "{side}"' for k, side in enumerate(lines)] + ['2 5 "body"']
        points = [self.point(i, j) for j in range(m + 1) for i in range(n + 1)]
        text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names,
                "$EndPhysicalNames", "$Nodes", str(len(points))]
        text += [f"{k + 1} {x!r} {y!r} 0" for k, (x, y) in enumerate(points)]
        text += ["$EndNodes", "$Elements", str(len(elements))]
        text += [f"{k + 1} {element}" for k, element in enumerate(elements)] + ["$EndElements", ""]
        path = pathlib.Path(folder) / f"{self.name}.msh"
        path.write_text("\n".join(text))
        return path

    def deck(self):
        supports = "".join(f'<ParameterList name="{side}"><Parameter name="Type" type="string" value="{kind}"/>'
                           f'<Parameter name="Side" type="string" value="{side}"/></ParameterList>'
                           for side, kind in self.supports.items())
        loads = "" if self.pressure == "0" else (
            f'<ParameterList name="press"><Parameter name="Type" type="string" value="Pressure"/><Parameter name="Side" '
            f'type="string" value="{self.far()}"/><Parameter name="Value" type="string" value="{self.pressure}"/>'
            "</ParameterList>")
        return (f'<ParameterList name="{self.name}"><ParameterList name="Mesh"><Parameter name="Type" type="string" '
                f'value="Gmsh"/><Parameter name="File" type="string" value="{self.name}.msh"/></ParameterList>'
                f'<ParameterList name="Material"><Parameter name="Young Modulus" type="double" value="{self.young!r}"/>'
                f'<Parameter name="Poisson Ratio" type="double" value="{self.poisson!r}"/></ParameterList>'
                f'<ParameterList name="Supports">{supports}</ParameterList>'
                f'<ParameterList name="Loads">{loads}</ParameterList></ParameterList>')


@dataclasses.dataclass
class Rigid:
    """A rigid body: its list Rigid, name to (type, value)."""
    name: str
    entries: dict
    foot = None

    def write(self, folder):
        pass

    def deck(self):
        entries = "".join(f'<Parameter name="{key}" type="{kind}" value="{value}"/>'
                          for key, (kind, value) in self.entries.items())
        return f'<ParameterList name="{self.name}"><ParameterList name="Rigid">{entries}</ParameterList></ParameterList>'


def plane(point, normal, **more):
    """A rigid plane."""
    pair = lambda values: ("Array(double)", "{" + ", ".join(repr(value) for value in values) + "}")
    return Rigid("floor", {"Type": ("string", "Plane"), "Point": pair(point), "Normal": pair(normal),
                           **{key: pair(values) for key, values in more.items()}})


def cylinder(centre, radius, hollow=False):
    """A rigid cylinder."""
    return Rigid("floor", {"Type": ("string", "Cylinder"),
                           "Centre": ("Array(double)", "{" + ", ".join(repr(value) for value in centre) + "}"),
                           "Radius": ("double", repr(radius)), "Hollow": ("bool", str(hollow).lower())})


def write_scene(folder, first, second, settings=None):
    """Writes meshes and deck of a scene; `first` has the first (the deck's Dirichlet) side. Returns the deck's path."""
    folder = pathlib.Path(folder)
    contact = "".join(f'<Parameter name="{key}" type="{kind}" value="{value}"/>'
                      for key, (kind, value) in (settings or {}).items())
    for block in (first, second):
        block.write(folder)
    deck = (f'<ParameterList name="sides"><ParameterList name="Bodies">{first.deck()}{second.deck()}</ParameterList>'
            '<ParameterList name="Interfaces"><ParameterList name="contact">'
            f'<Parameter name="Dirichlet Body" type="string" value="{first.name}"/>'
            f'<Parameter name="Dirichlet Side" type="string" value="{first.foot}"/>'
            f'<Parameter name="Neumann Body" type="string" value="{second.name}"/>'
            + (f'<Parameter name="Neumann Side" type="string" value="{second.foot}"/>' if second.foot else "") + contact +
            "</ParameterList></ParameterList></ParameterList>")
    path = folder / "sides.xml"
    path.write_text(deck)
    return path


def even(n):
    return [i / n for i in range(n + 1)]


def spread(draw, n, least):
    """n random columns, no narrower than `least` of an even one."""
    widths = [max(least, draw.random() ** 2) for _ in range(n)]
    total, places = sum(widths), [0.0]
    for width in widths:
        places.append(places[-1] + width / total)
    return places[:-1] + [1.0]


def box(x0, y0, x1, y1, turn=0.0):
    """The map to a rectangle, turned about the origin by radians."""
    c, s = math.cos(turn), math.sin(turn)

    def place(u, v):
        x, y = x0 + u * (x1 - x0), y0 + v * (y1 - y0)
        return c * x - s * y, s * x + c * y

    return place


def under(curve, x0, x1, y):
    """Between the line at height y and a curve above or below it: the line at t = 0 if it is lower."""

    def place(u, v):
        x = x0 + u * (x1 - x0)
        low, high = (y, curve(x)) if y < curve(x) else (curve(x), y)
        return x, (1.0 - v) * low + v * high

    return place
