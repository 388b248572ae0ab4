"""The pieces NAME.e.N.r that several processes write, read as the one file NAME.e that they are."""

from __future__ import annotations

import dataclasses
import functools
import pathlib
import re

import numpy

from .errors import ReadError
from .exodus import Exodus


def pieces_of(path: pathlib.Path) -> list[pathlib.Path]:
    """The pieces of the file `path`, in their order; none where there are none. Raises ReadError where some are missing."""
    found = {}
    for piece in path.parent.glob(f"{path.name}.*.*"):
        match = re.fullmatch(r"(\d+)\.(\d+)", piece.name[len(path.name) + 1 :])
        if match and len(match[1]) == len(match[2]):
            found.setdefault(int(match[1]), {})[int(match[2])] = piece
    if not found:
        return []
    number = max(found, key=lambda pieces: max(p.stat().st_mtime for p in found[pieces].values()))
    missing = [piece for piece in range(number) if piece not in found[number]]
    if missing:
        raise ReadError(f"{path}: piece {missing[0]} of {number} is missing; all pieces of a file must be in one folder.")
    return [found[number][piece] for piece in range(number)]


class Pieces:
    """What `Exodus` has of the whole, gathered from its pieces: nodes, elements and facets in the order of the whole."""

    def __init__(self, path, pieces):
        self.path, self.files = str(path), [Exodus(str(piece)) for piece in pieces]
        self.times = self.files[0].times
        try:
            self._read_mesh()
        except (IndexError, KeyError, ValueError) as error:
            raise ReadError(f"{path}: its pieces do not belong together: {error}") from None

    def variables(self, kind):
        return self.files[0].variables(kind)

    def values(self, kind, name, part=None):
        """[steps, places] of a variable, on one block or set; None where it is not defined."""
        found = [file.values(kind, name, part) for file in self.files]
        if kind == "nodal":
            return self._gather(found, self.node_numbers, len(self.points))
        if kind == "element":
            block = self._numbered(self.blocks, part)
            return self._gather(found, [numbers - block.first for numbers in self.numbers_of[part]], len(block.nodes))
        if kind == "side set":
            places = self._facet_places(part)
            return self._gather(found, places, sum(map(len, places)))
        return found[0]

    def block_of(self, element):
        return next(block for block in self.blocks.values() if block.first <= element < block.first + len(block.nodes))

    def nodes_of(self, element):
        block = self.block_of(element)
        return block.nodes[element - block.first]

    def _read_mesh(self):
        self.node_numbers = [file.data["node_num_map"][:].astype(int) - 1 for file in self.files]
        self.element_numbers = [file.data["elem_num_map"][:].astype(int) - 1 for file in self.files]
        count = 1 + max(numbers.max() for numbers in self.node_numbers)
        self.points = numpy.full((count, self.files[0].points.shape[1]), numpy.nan)
        for file, numbers in zip(self.files, self.node_numbers):
            self.points[numbers] = file.points
        self.numbers_of, self.blocks, first = {}, {}, 0
        for name, block in self.files[0].blocks.items():
            self.blocks[name] = self._joined_block(name, block, first)
            first += len(self.blocks[name].nodes)
        self.side_sets = {name: self._joined_set(name) for name in self.files[0].side_sets}

    def _joined_block(self, name, block, first):
        parts = [file.blocks[name] for file in self.files]
        numbers = [n[p.first : p.first + len(p.nodes)] for n, p in zip(self.element_numbers, parts)]
        self.numbers_of[block.entity.number] = numbers
        filled = [i for i, part in enumerate(parts) if len(part.nodes)]
        nodes = numpy.zeros((sum(map(len, numbers)), parts[filled[0]].nodes.shape[1]), int)
        for i in filled:
            nodes[numbers[i] - first] = self.node_numbers[i][parts[i].nodes]
        return dataclasses.replace(parts[filled[0]], nodes=nodes, first=first)

    def _joined_set(self, name):
        """Facets by their elements: the order of the whole's side set is not in the pieces."""
        parts = [file.side_sets[name] for file in self.files]
        elements = numpy.concatenate([n[p.elements] for n, p in zip(self.element_numbers, parts)])
        sides = numpy.concatenate([part.sides for part in parts])
        order = numpy.lexsort((sides, elements))
        return dataclasses.replace(parts[0], elements=elements[order], sides=sides[order])

    @functools.lru_cache(maxsize=None)
    def _facet_places(self, part):
        """Per piece the places of its facets in the joined side set."""
        side = self._numbered(self.side_sets, part)
        place = {facet: i for i, facet in enumerate(zip(side.elements.tolist(), side.sides.tolist()))}
        name = next(name for name, joined in self.side_sets.items() if joined is side)
        return [numpy.array([place[facet] for facet in zip(n[file.side_sets[name].elements].tolist(), file.side_sets[name].sides.tolist())], int)
                for file, n in zip(self.files, self.element_numbers)]

    @staticmethod
    def _numbered(entities, number):
        return next(one for one in entities.values() if one.entity.number == number)

    @staticmethod
    def _gather(values, places, count):
        if all(one is None for one in values):
            return None
        steps = next(len(one) for one in values if one is not None)
        joined = numpy.full((steps, count), numpy.nan)
        for one, where in zip(values, places):
            if one is not None:
                joined[:, where] = one
        return joined
