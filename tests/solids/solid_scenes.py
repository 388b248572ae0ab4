"""Two solids: meshes (gmsh 2.2) and decks of random scenes.

A solid is a grid of hexahedra cut into six tetrahedra each about a diagonal (Kuhn), moved by a map of the unit cube, its
vertices numbered at random. Grids with the same columns on the side of contact, and nothing shaken there, match.
"""

import dataclasses
import itertools
import pathlib
import random

SIDES = ("left", "right", "front", "back", "bottom", "top")  # x, y, z = 0, 1
# Of the recovery, for runs whose bounds are compared: fields that differ by what iterations leave may end it one step apart, which changes
# the bound by what the last step gains (0.5 %), and round-off of single precision grows with the steps.
AS_MANY_STEPS = tuple(f"Error Estimation/Recovery/{entry}" for entry in ("Type=Global", "Least Gain=0", "Steps=10"))


@dataclasses.dataclass
class Solid:
    name: str
    cells: tuple  # along x, y, z
    place: object  # (r, s, t) in the unit cube -> (x, y, z)
    foot: str  # the side of contact
    young: float = 1.0
    poisson: float = 0.3
    supports: dict = dataclasses.field(default_factory=dict)  # side -> Type, or name -> list of (key, type, value)
    loads: dict = dataclasses.field(default_factory=dict)  # name -> list of (key, type, value)
    shake: float = 0.0  # of the vertices inside, in parts of a cell
    seed: int = 0  # of numbering and shaking
    foot_shake: float = 0.0  # of the vertices inside the side of contact, along it
    group_of: object = lambda corner: "body"  # of a grid cell: the group of cells that it belongs to
    regions: dict = dataclasses.field(default_factory=dict)  # group -> Young's modulus; other cells have the body's

    def corners(self):
        """Of the grid cells."""
        return itertools.product(*(range(n) for n in self.cells))

    def write(self, folder):
        draw = random.Random(self.seed)
        counts = [n + 1 for n in self.cells]
        grid = list(itertools.product(*(range(n) for n in counts)))
        order = list(range(len(grid)))
        draw.shuffle(order)
        number = dict(zip(grid, order))
        points = [None] * len(grid)
        axis, end = divmod(SIDES.index(self.foot), 2)
        for at in grid:
            isInside = [0 < i < n for i, n in zip(at, self.cells)]
            isFoot = at[axis] == end * self.cells[axis] and all(isInside[:axis] + isInside[axis + 1:])
            shakes = [self.shake] * 3 if all(isInside) else [isFoot * self.foot_shake * (k != axis) for k in range(3)]
            moved = [(i + (draw.uniform(-by, by) if by else 0.0)) / n for i, n, by in zip(at, self.cells, shakes)]
            points[number[at]] = self.place(*moved)
        tetrahedra, triangles, groups = [], {side: [] for side in SIDES}, []
        for corner in self.corners():
            for path in itertools.permutations(range(3)):
                cell = [corner]
                for axis in path:
                    cell.append(tuple(c + (a == axis) for a, c in enumerate(cell[-1])))
                turns = sum(a > b for a, b in itertools.combinations(path, 2)) % 2  # an odd path turns the other way
                tetrahedra.append([number[at] for at in ([cell[1], cell[0], *cell[2:]] if turns else cell)])
                groups.append(self.group_of(corner))
                for facet in itertools.combinations(cell, 3):
                    for side, (axis, end) in zip(SIDES, itertools.product(range(3), (0, 1))):
                        if all(at[axis] == end * self.cells[axis] for at in facet):
                            triangles[side].append([number[at] for at in facet])
        self._save(pathlib.Path(folder) / f"{self.name}.msh", points, tetrahedra, triangles, groups)

    def _save(self, path, points, tetrahedra, triangles, groups):
        tag = {group: 7 + k for k, group in enumerate(dict.fromkeys(groups))}
        elements = [f"2 2 {k + 1} {k + 1} " + " ".join(str(v + 1) for v in facet)
                    for k, side in enumerate(SIDES) for facet in triangles[side]]
        elements += [f"4 2 {tag[group]} {tag[group]} " + " ".join(str(v + 1) for v in cell)
                     for cell, group in zip(tetrahedra, groups)]
        names = [f'2 {k + 1} "{side}"' for k, side in enumerate(SIDES)] + [f'3 {k} "{group}"' for group, k in tag.items()]
        text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names,
                "$EndPhysicalNames", "$Nodes", str(len(points))]
        text += [f"{k + 1} {x!r} {y!r} {z!r}" for k, (x, y, z) in enumerate(points)]
        text += ["$EndNodes", "$Elements", str(len(elements))]
        text += [f"{k + 1} {element}" for k, element in enumerate(elements)] + ["$EndElements", ""]
        path.write_text("\n".join(text))

    def deck(self):
        parameter = lambda key, kind, value: f'<Parameter name="{key}" type="{kind}" value="{value}"/>'
        listed = lambda name, entries: f'<ParameterList name="{name}">{"".join(entries)}</ParameterList>'
        given = lambda side, kind: kind if isinstance(kind, list) else [("Type", "string", kind), ("Side", "string", side)]
        supports = [listed(side, [parameter(*entry) for entry in given(side, kind)])
                    for side, kind in self.supports.items()]
        loads = [listed(name, [parameter(*entry) for entry in load]) for name, load in self.loads.items()]
        material = lambda young: listed("Material", [parameter("Young Modulus", "double", repr(young)),
                                                     parameter("Poisson Ratio", "double", repr(self.poisson)),
                                                     parameter("Hypothesis", "string", "Three Dimensional")])
        regions = [listed(group, [material(young)]) for group, young in self.regions.items()]
        return listed(self.name, [
            listed("Mesh", [parameter("Type", "string", "Gmsh"), parameter("File", "string", f"{self.name}.msh")]),
            material(self.young), *([listed("Regions", regions)] if regions else []),
            listed("Supports", supports), listed("Loads", loads)])


@dataclasses.dataclass
class Rigid:
    """A rigid body: the Type of its list Rigid, and what the list says besides: numbers, vectors, truths, expressions."""
    kind: str
    entries: dict
    name: str = "ground"
    foot = None

    def write(self, folder):
        pass

    def deck(self):
        def parameter(key, value):
            if isinstance(value, (tuple, list)):
                return f'<Parameter name="{key}" type="Array(double)" value="{{{", ".join(map(repr, value))}}}"/>'
            kind = {bool: "bool", float: "double", str: "string"}[type(value)]
            return f'<Parameter name="{key}" type="{kind}" value="{str(value).lower() if kind == "bool" else value}"/>'

        entries = "".join(parameter(key, value) for key, value in {"Type": self.kind, **self.entries}.items())
        return f'<ParameterList name="{self.name}"><ParameterList name="Rigid">{entries}</ParameterList></ParameterList>'


def pressure(side, value):
    return [("Type", "string", "Pressure"), ("Side", "string", side), ("Value", "string", value)]


def write_scene(folder, first, second, settings=()):
    """Writes meshes and deck of two solids; `first` is the Dirichlet body, `second` may be rigid. Returns the deck's path."""
    for solid in (first, second):
        solid.write(folder)
    entries = [("Dirichlet Body", "string", first.name), ("Dirichlet Side", "string", first.foot),
               ("Neumann Body", "string", second.name), *settings]
    if second.foot:
        entries.append(("Neumann Side", "string", second.foot))
    contact = "".join(f'<Parameter name="{key}" type="{kind}" value="{value}"/>' for key, kind, value in entries)
    path = pathlib.Path(folder) / "solids.xml"
    path.write_text(f'<ParameterList name="solids"><ParameterList name="Bodies">{first.deck()}{second.deck()}'
                    f'</ParameterList><ParameterList name="Interfaces"><ParameterList name="contact">{contact}'
                    "</ParameterList></ParameterList></ParameterList>")
    return path
