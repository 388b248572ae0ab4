"""Scenes of two plane bodies as plain values: what the program under test and the reference both get."""

import dataclasses
import random


@dataclasses.dataclass(frozen=True)
class Mesh:
    """Triangles: points (x, y), cells (three point numbers, counter-clockwise), sides (name -> edges)."""
    points: tuple
    cells: tuple
    sides: dict

    def moved(self, move):
        return dataclasses.replace(self, points=tuple(move(x, y) for x, y in self.points))

    def permuted(self, seed):
        """The same mesh with its points and cells in another order, and every cell begun at another corner."""
        draw = random.Random(seed)
        order = draw.sample(range(len(self.points)), len(self.points))
        new = {old: number for number, old in enumerate(order)}
        cells = [tuple(new[p] for p in cell) for cell in draw.sample(self.cells, len(self.cells))]
        cells = [cell[k:] + cell[:k] for cell in cells for k in [draw.randrange(3)]]
        sides = {name: tuple((new[a], new[b]) for a, b in draw.sample(edges, len(edges)))
                 for name, edges in self.sides.items()}
        return Mesh(tuple(self.points[p] for p in order), tuple(cells), sides)


def box(lower, upper, cells, contact=None):
    """A rectangle of 2 * nx * ny triangles with the sides left, right, bottom, top; `contact`: the edges of the top
    up to this column are a side of their own, too."""
    nx, ny = cells
    number = lambda i, j: i + j * (nx + 1)
    points = tuple((lower[0] + (upper[0] - lower[0]) * i / nx, lower[1] + (upper[1] - lower[1]) * j / ny)
                   for j in range(ny + 1) for i in range(nx + 1))
    triangles = []
    for j in range(ny):
        for i in range(nx):
            a, b, c, d = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
            triangles += [(a, b, c), (a, c, d)]
    sides = {"bottom": tuple((number(i, 0), number(i + 1, 0)) for i in range(nx)),
             "top": tuple((number(i + 1, ny), number(i, ny)) for i in range(nx)),
             "left": tuple((number(0, j + 1), number(0, j)) for j in range(ny)),
             "right": tuple((number(nx, j), number(nx, j + 1)) for j in range(ny))}
    if contact is not None:
        sides["contact"] = sides["top"][:contact]
    return Mesh(points, tuple(triangles), sides)


@dataclasses.dataclass(frozen=True)
class Body:
    """supports: side -> {axis (0, 1): value}; pressures: side -> polynomial in x as coefficients (1, x, x^2)."""
    mesh: Mesh
    young: float = 1.0
    poisson: float = 0.3
    supports: dict = dataclasses.field(default_factory=dict)
    pressures: dict = dataclasses.field(default_factory=dict)


@dataclasses.dataclass(frozen=True)
class Scene:
    """`upper` rests with its side `bottom` on the side `contact` of `lower`; gap: coefficients (1, x, x^2).
    swapped: the lower one is the Dirichlet body. origin: where x is counted from in pressures and gap."""
    upper: Body
    lower: Body
    gap: tuple = (0.0,)
    order: int = 2
    swapped: bool = False
    origin: float = 0.0

    def with_bodies(self, change):
        return dataclasses.replace(self, upper=change(self.upper), lower=change(self.lower))

    def moved(self, move):
        return self.with_bodies(lambda body: dataclasses.replace(body, mesh=body.mesh.moved(move)))


def pressed(cells=3, load=(1.0, 0.5), order=2):
    """A block that nothing but contact holds vertically, pressed on a wider one: all nodes close."""
    upper = Body(box((0, 0), (1, 1), (cells, cells)), supports={"left": {0: 0.0}}, pressures={"top": load})
    lower = Body(box((0, -1), (2, 0), (2 * cells, cells), cells),
                 supports={"left": {0: 0.0}, "bottom": {0: 0.0, 1: 0.0}})
    return Scene(upper, lower, order=order)


def lifting(cells=4, order=2):
    """A beam held at its left end, pressed down there and pulled up at the other end: contact is lost on a part."""
    upper = Body(box((0, 0), (1, 0.5), (cells, cells // 2)), supports={"left": {0: 0.0, 1: 0.0}},
                 pressures={"top": (1.0, -1.2)})
    lower = Body(box((0, -1), (2, 0), (2 * cells, cells), cells), supports={"bottom": {0: 0.0, 1: 0.0}})
    return Scene(upper, lower, order=order)


def scaled(scene, length, stress):
    """The same scene in other units: coordinates, gap and given displacements times `length`, moduli and pressures
    times `stress`."""
    def polynomial(coefficients, unit):
        return tuple(c * unit / length ** k for k, c in enumerate(coefficients))

    def convert(body):
        supports = {side: {axis: value * length for axis, value in given.items()}
                    for side, given in body.supports.items()}
        pressures = {side: polynomial(p, stress) for side, p in body.pressures.items()}
        return dataclasses.replace(body, mesh=body.mesh.moved(lambda x, y: (x * length, y * length)),
                                   young=body.young * stress, supports=supports, pressures=pressures)
    return dataclasses.replace(scene.with_bodies(convert), gap=polynomial(scene.gap, length),
                               origin=scene.origin * length)


def shifted(scene, by):
    """The scene elsewhere in the plane."""
    return dataclasses.replace(scene.moved(lambda x, y: (x + by, y + by)), origin=scene.origin + by)


def renumbered(scene, seed):
    """The scene with the points and cells of both meshes in another order."""
    return scene.with_bodies(lambda body: dataclasses.replace(body, mesh=body.mesh.permuted(seed)))


def loaded(scene, factor):
    """All pressures times `factor`."""
    return scene.with_bodies(lambda body: dataclasses.replace(
        body, pressures={side: tuple(c * factor for c in p) for side, p in body.pressures.items()}))
