"""An Exodus file read through netCDF."""

import dataclasses

import netCDF4
import numpy

from .errors import UsageError

# Kind of variable -> name of its names, name of its values.
VARIABLES = {
    "global": ("name_glo_var", "vals_glo_var"),
    "nodal": ("name_nod_var", "vals_nod_var{variable}"),
    "element": ("name_elem_var", "vals_elem_var{variable}eb{part}"),
    "side set": ("name_sset_var", "vals_sset_var{variable}ss{part}"),
    "node set": ("name_nset_var", "vals_nset_var{variable}ns{part}"),
}


@dataclasses.dataclass(frozen=True)
class Block:
    """Elements of one type; `nodes` [elements, nodes of an element] counts from 0, `first` elements come before it."""

    number: int  # in the file, from 1
    type: str
    nodes: numpy.ndarray
    first: int


@dataclasses.dataclass(frozen=True)
class SideSet:
    """Facets by their element (from 0, over all blocks) and Exodus's number of the side (from 1)."""

    number: int
    elements: numpy.ndarray
    sides: numpy.ndarray


@dataclasses.dataclass(frozen=True)
class NodeSet:
    number: int
    nodes: numpy.ndarray


class Exodus:
    """Mesh, sets and variables by their names; arrays without netCDF's masks."""

    def __init__(self, path):
        self.path = path
        try:
            self.data = netCDF4.Dataset(path)
        except OSError as error:
            raise UsageError(f"{path}: cannot be read as Exodus (netCDF): {error.strerror or error}") from None
        self.data.set_auto_mask(False)
        if "num_dim" not in self.data.dimensions:
            raise UsageError(f"{path}: is netCDF, but not Exodus (no dimension num_dim)")
        try:
            self._read_mesh()
        except (IndexError, ValueError) as error:  # a variable is not there, or not as large as it must be
            raise UsageError(f"{path}: is no whole Exodus file: {error}") from None

    def _read_mesh(self):
        self.points = self._points()
        self.blocks = self._blocks()
        self.side_sets = {name: self._side_set(number) for name, number in self._entities("ss", "side set")}
        self.node_sets = {name: NodeSet(number, self._numbers(f"node_ns{number}"))
                          for name, number in self._entities("ns", "node set")}
        self.times = numpy.array(self.data["time_whole"][:] if "time_whole" in self.data.variables else [])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.data.close()

    def variables(self, kind):
        """Names of the variables of a kind."""
        return self._names(VARIABLES[kind][0])

    def values(self, kind, name, part=None):
        """[steps, places] of a variable, on one block or set; None where it is not defined."""
        index = self.variables(kind).index(name)
        values = VARIABLES[kind][1].format(variable=index + 1, part=part)
        if values in self.data.variables:
            array = self.data[values][:]
            return array[:, index : index + 1] if kind == "global" else array
        if kind == "nodal" and "vals_nod_var" in self.data.variables:  # files of the small model
            return self.data["vals_nod_var"][:, index]
        return None

    def block_of(self, element):
        return next(block for block in self.blocks.values() if block.first <= element < block.first + len(block.nodes))

    def nodes_of(self, element):
        """Node numbers of an element, which counts over all blocks."""
        block = self.block_of(element)
        return block.nodes[element - block.first]

    def _points(self):
        size = self.data.dimensions["num_dim"].size
        if "coord" in self.data.variables:  # files of the small model
            return numpy.array(self.data["coord"][:]).T
        if "coordx" not in self.data.variables:
            return numpy.zeros((0, size))
        return numpy.stack([self.data[f"coord{axis}"][:] for axis in "xyz"[:size]], axis=1)

    def _names(self, variable):
        if variable not in self.data.variables:
            return []
        rows = self.data[variable][:]
        return [row.tobytes().split(b"\0")[0].decode("utf-8", "replace").strip() for row in rows]

    def _entities(self, prefix, what):
        """(name, number in the file) of the blocks or sets; those without a name are called by their id."""
        if f"{prefix}_prop1" not in self.data.variables:
            return []
        ids = self.data[f"{prefix}_prop1"][:]
        names = self._names(f"{prefix}_names") or [""] * len(ids)
        return [(name or f"{what} {id_}", i + 1) for i, (name, id_) in enumerate(zip(names, ids))]

    def _numbers(self, variable):
        """Numbers from 1 as numbers from 0; none when the file leaves them out, as it does for empty sets."""
        return self.data[variable][:].astype(int) - 1 if variable in self.data.variables else numpy.zeros(0, int)

    def _blocks(self):
        blocks, first = {}, 0
        for name, number in self._entities("eb", "block"):
            nodes = self._numbers(f"connect{number}")
            kind = getattr(self.data[f"connect{number}"], "elem_type", "") if nodes.size else ""
            blocks[name] = Block(number, kind, nodes.reshape(len(nodes), -1), first)
            first += len(nodes)
        return blocks

    def _side_set(self, number):
        return SideSet(number, self._numbers(f"elem_ss{number}"), self._numbers(f"side_ss{number}") + 1)
