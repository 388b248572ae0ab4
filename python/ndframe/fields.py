"""The fields of NAME.e on its mesh."""

from __future__ import annotations

import os
import pathlib

import numpy

from .errors import ReadError, unknown
from .exodus import Exodus
from .pieces import Pieces, pieces_of

# Vertices of a facet by Exodus's number of the side, from 1; counter-clockwise seen from outside.
SIDES = {2: ((0, 1), (1, 2), (2, 0)), 3: ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1))}


class Fields:
    """Mesh and fields of a run. docs/results.md has the names of all variables; units are those of the deck.

    A body is one block of elements, called like the body; with Regions each of them is a separate block `BODY:REGION`. A side of
    an interface is called `INTERFACE:dirichlet` or `INTERFACE:neumann`, any other `BODY:SIDE`. Steps are sweeps if the deck says
    Output/Steps = All Sweeps, load cases if it has some, otherwise there is one; -1 is the last, and for the fields of a load case its own:
    `last`. Where several processes have written pieces NAME.e.N.r, these are read as one: the same numbers of nodes and elements; the
    facets of a side are ordered by their elements. Raises ReadError for files that are damaged and for unknown names.
    """

    def __init__(self, path: str | os.PathLike[str], last: int = -1):
        self.path, self.last = pathlib.Path(path), last
        pieces = [] if self.path.exists() else pieces_of(self.path)
        if not pieces and not self.path.exists():
            raise ReadError(f"{path}: there is no such file; run the deck with Output/Exodus = true.")
        self.file = Pieces(path, pieces) if pieces else Exodus(str(path))
        if self.file.times.size == 0 or "disp_x" not in self.names("nodal"):
            raise ReadError(f"{path}: has no displacements; the run did not finish, or it is not an ndframe file.")

    @property
    def points(self) -> numpy.ndarray:
        """Coordinates of the nodes before loading, [nodes, dimension]."""
        return self.file.points

    @property
    def dimension(self) -> int:
        return self.points.shape[1]

    @property
    def steps(self) -> numpy.ndarray:
        """Number of the sweep, or of the load case, of each step, [steps]."""
        return self.file.times

    @property
    def blocks(self) -> tuple[str, ...]:
        """Names of the blocks of elements, in the order of the file."""
        return tuple(self.file.blocks)

    @property
    def sides(self) -> tuple[str, ...]:
        """Names of the sides of bodies and interfaces."""
        return tuple(self.file.side_sets)

    def names(self, kind: str) -> list[str]:
        """Variables of a kind: "nodal", "element" or "side set"."""
        return self.file.variables(kind)

    def nodes(self, block: str) -> numpy.ndarray:
        """Node numbers of a block's elements, from 0: [elements, 3 or 6] in 2D, [elements, 4 or 10] in 3D; vertices first."""
        if block not in self.file.blocks:
            raise unknown(str(self.path), "block", block, self.blocks)
        return self.file.blocks[block].nodes

    def triangles(self, block: str) -> numpy.ndarray:
        """[elements, 3] vertices of a plane block, as matplotlib's tripcolor and Triangulation take them."""
        if self.dimension != 2:
            raise ReadError(f"{self.path}: is a 3D scene, which has no triangles; use nodes().")
        return self.nodes(block)[:, :3]

    def nodal(self, name: str, step: int = -1) -> numpy.ndarray:
        """[nodes] of one variable on nodes."""
        return self._step(self._values("nodal", name, None), step)

    def vector(self, prefix: str, step: int = -1) -> numpy.ndarray:
        """[nodes, dimension] of the variables `prefix_x`, `prefix_y`, ...: "disp", "offset"."""
        return numpy.stack([self.nodal(f"{prefix}_{axis}", step) for axis in "xyz"[: self.dimension]], axis=1)

    @property
    def displacement(self) -> numpy.ndarray:
        """[nodes, dimension] of the last step, a length."""
        return self.vector("disp")

    def element(self, name: str, block: str, step: int = -1) -> numpy.ndarray:
        """[elements] of one variable on the elements of a block."""
        self.nodes(block)
        return self._step(self._values("element", name, self.file.blocks[block].entity.number), step)

    def stress(self, block: str, step: int = -1) -> numpy.ndarray:
        """[elements, 3, 3], means over the elements; also for plane scenes, where yz and zx vanish."""
        tensor = numpy.zeros((len(self.nodes(block)), 3, 3))
        for axes in ("xx", "yy", "zz", "xy", "yz", "zx"):
            if f"stress_{axes}" in self.names("element"):
                i, j = ("xyz".index(axis) for axis in axes)
                tensor[:, i, j] = tensor[:, j, i] = self.element(f"stress_{axes}", block, step)
        return tensor

    def facets(self, side: str) -> numpy.ndarray:
        """[facets, dimension] vertices of a side's edges (in 3D triangles), node numbers from 0."""
        chosen, local = self._side(side), SIDES[self.dimension]
        found = [self.file.nodes_of(e)[list(local[s - 1])] for e, s in zip(chosen.elements, chosen.sides)]
        return numpy.array(found, int).reshape(-1, self.dimension)

    def on_facets(self, name: str, side: str, step: int = -1) -> numpy.ndarray:
        """[facets] of one variable on a side: contact_pressure, contact_gap, contact_status, admissible_pressure."""
        return self._step(self._values("side set", name, self._side(side).entity.number, side), step)

    def _side(self, side):
        if side not in self.file.side_sets:
            raise unknown(str(self.path), "side", side, self.sides)
        return self.file.side_sets[side]

    def _values(self, kind, name, part, place=""):
        if name not in self.names(kind):
            raise unknown(str(self.path), f"variable on {VARIABLES_ON[kind]}", name, self.names(kind))
        values = self.file.values(kind, name, part)
        if values is None:
            raise ReadError(f'{self.path}: "{name}" is not defined on {place or "this block"}.')
        return values

    def _step(self, values, step):
        step = self.last if step == -1 else step
        if not -len(values) <= step < len(values):
            raise ReadError(f"{self.path}: there is no step {step}; there {'is 1' if len(values) == 1 else f'are {len(values)}'}, "
                            "from 0, and -1 is the last.")
        return numpy.array(values[step], float)


VARIABLES_ON = {"nodal": "nodes", "element": "elements", "side set": "sides"}
