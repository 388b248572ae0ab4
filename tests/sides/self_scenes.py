"""Bodies that touch themselves: meshes (gmsh 2.2) and decks of random scenes in the plane and in space.

A slit: a grid in which the nodes of a part of one row are there twice, so that the part is open. A hairpin: a strip bent round
so that its ends face each other; their columns differ. Bonded: two blocks that are tied along a part of their sides.
"""

import dataclasses
import itertools
import math
import pathlib


def parameter(key, kind, value):
    return f'<Parameter name="{key}" type="{kind}" value="{value}"/>'


def listed(name, *entries):
    return f'<ParameterList name="{name}">{"".join(entries)}</ParameterList>'


@dataclasses.dataclass
class Body:
    """points; cells: vertices; sides: name -> facets. supports: side -> Type; pressures: side -> expression."""
    name: str
    points: list
    cells: list
    sides: dict
    supports: dict = dataclasses.field(default_factory=dict)
    pressures: dict = dataclasses.field(default_factory=dict)
    young: float = 1.0
    poisson: float = 0.3

    def dim(self):
        return len(self.points[0])

    def write(self, folder):
        dim, types = self.dim(), {2: (1, 2), 3: (2, 4)}[self.dim()]
        text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(self.sides) + 1)]
        text += [f'{dim - 1} {k + 1} "{side}"' for k, side in enumerate(self.sides)] + [f'{dim} {len(self.sides) + 1} "body"']
        text += ["$EndPhysicalNames", "$Nodes", str(len(self.points))]
        text += [f"{k + 1} " + " ".join(repr(float(x)) for x in (*point, 0.0)[:3]) for k, point in enumerate(self.points)]
        rows = [(types[0], k + 1, facet) for k, side in enumerate(self.sides.values()) for facet in side]
        rows += [(types[1], len(self.sides) + 1, cell) for cell in self.cells]
        text += ["$EndNodes", "$Elements", str(len(rows))]
        text += [f"{n + 1} {kind} 2 {tag} {tag} " + " ".join(str(v + 1) for v in vertices)
                 for n, (kind, tag, vertices) in enumerate(rows)]
        (pathlib.Path(folder) / f"{self.name}.msh").write_text("\n".join([*text, "$EndElements", ""]))

    def deck(self):
        on = lambda side, kind, *more: listed(side, parameter("Type", "string", kind), parameter("Side", "string", side), *more)
        hypothesis = [parameter("Hypothesis", "string", "Three Dimensional")] if self.dim() == 3 else []
        return listed(
            self.name,
            listed("Mesh", parameter("Type", "string", "Gmsh"), parameter("File", "string", f"{self.name}.msh")),
            listed("Material", parameter("Young Modulus", "double", repr(self.young)),
                   parameter("Poisson Ratio", "double", repr(self.poisson)), *hypothesis),
            listed("Supports", *(on(side, kind) for side, kind in self.supports.items())),
            listed("Loads", *(on(side, "Pressure", parameter("Value", "string", value))
                              for side, value in self.pressures.items())))


def write_scene(folder, bodies, interfaces):
    """interfaces: name -> {key: (type, value)}. Returns the deck's path."""
    for body in bodies:
        body.write(folder)
    path = pathlib.Path(folder) / "self.xml"
    path.write_text(listed("self", listed("Bodies", *(body.deck() for body in bodies)),
                           listed("Interfaces", *(listed(name, *(parameter(key, *entry) for key, entry in entries.items()))
                                                  for name, entries in interfaces.items()))))
    return path


def contact(first, second, **more):
    """(body, side) twice, and what the interface says besides, with _ for blanks."""
    text = lambda value: ("string", value)
    return {"Dirichlet Body": text(first[0]), "Dirichlet Side": text(first[1]), "Neumann Body": text(second[0]),
            "Neumann Side": text(second[1]), **{key.replace("_", " "): value for key, value in more.items()}}


def grid(name, columns, rows, place, split=None, slit=None, depth=0):
    """The unit square (with `depth` layers the unit cube) in cells between columns and rows, moved by place(s, t[, r], above).

    split: (side, column): bottom or top is "near" up to the column, "far" beyond. slit: (row, column): the nodes of this row
    are there twice up to the column, "below" and "above"; place(.., above) is asked with 1 for the upper ones, else 0.
    """
    n, m, layers = len(columns) - 1, len(rows) - 1, range(depth + 1)
    number, points = {}, []

    def node(i, j, k, above):
        twice = slit is not None and j == slit[0] and i < slit[1]
        key = (i, j, k, bool(above and twice))
        if key not in number:
            number[key] = len(points)
            at = (columns[i], rows[j], k / depth) if depth else (columns[i], rows[j])
            points.append(place(*at, int(key[3])))
        return number[key]

    cells, sides = [], {}
    for i, j, k in itertools.product(range(n), range(m), range(max(depth, 1))):
        above = slit is not None and j >= slit[0]
        for path in itertools.permutations(range(3 if depth else 2)):
            corners = [(i, j, k)]
            for axis in path:
                corners.append(tuple(c + (a == axis) for a, c in enumerate(corners[-1])))
            cell = [node(*corner, above) for corner in corners]
            if sum(a > b for a, b in itertools.combinations(path, 2)) % 2:
                cell[0], cell[1] = cell[1], cell[0]
            cells.append(cell)
            for facet in itertools.combinations(corners, len(corners) - 1):
                for side in _sides(facet, n, m, depth, split, slit, above):
                    sides.setdefault(side, []).append([node(*corner, above) for corner in facet])
    return Body(name, points, cells, sides)


def _sides(facet, n, m, depth, split, slit, above):
    on = lambda axis, at: all(corner[axis] == at for corner in facet)
    last = max(corner[0] for corner in facet)
    for name, axis, at in (("left", 0, 0), ("right", 0, n), ("bottom", 1, 0), ("top", 1, m)):
        if on(axis, at):
            yield name if split is None or name != split[0] else "near" if last <= split[1] else "far"
    if depth:
        yield from (name for name, at in (("front", 0), ("back", depth)) if on(2, at))
    if slit is not None and on(1, slit[0]) and last <= slit[1]:
        yield "above" if above else "below"


def hairpin(radius, thickness, leg, bend):
    """Place of (s, t): along a strip of two legs and an arc between them, t = 0 inside. bend: share of columns in the arc."""
    def place(s, t, _):
        r = radius + t * thickness
        if s < 0.5 * (1 - bend):
            return leg * (1 - s / (0.5 * (1 - bend))), -r
        if s > 0.5 * (1 + bend):
            return leg * (s - 0.5 * (1 + bend)) / (0.5 * (1 - bend)), r
        angle = 1.5 * math.pi - math.pi * (s - 0.5 * (1 - bend)) / bend
        return r * math.cos(angle), r * math.sin(angle)

    return place
