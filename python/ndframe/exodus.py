"""An Exodus file read through netCDF."""

import dataclasses

import netCDF4
import numpy

from .errors import ReadError

# Kind of variable -> name of its names, name of its values; of those with parts also their truth table.
VARIABLES = {
    "global": ("name_glo_var", "vals_glo_var"),
    "nodal": ("name_nod_var", "vals_nod_var{variable}"),
    "element": ("name_elem_var", "vals_elem_var{variable}eb{part}"),
    "side set": ("name_sset_var", "vals_sset_var{variable}ss{part}"),
    "node set": ("name_nset_var", "vals_nset_var{variable}ns{part}"),
}


TRUTH_TABLES = {"element": "elem_var_tab", "side set": "sset_var_tab", "node set": "nset_var_tab"}


@dataclasses.dataclass(frozen=True)
class Entity:
    """A block or set: its number in the file, from 1, its id, and its status, 0 if the file calls it empty."""

    number: int
    id: int
    status: int


@dataclasses.dataclass(frozen=True)
class Block:
    """Elements of one type; `nodes` [elements, nodes of an element] counts from 0, `first` elements come before it."""

    entity: Entity
    type: str
    nodes: numpy.ndarray
    first: int


@dataclasses.dataclass(frozen=True)
class SideSet:
    """Facets by their element (from 0, over all blocks) and Exodus's number of the side (from 1)."""

    entity: Entity
    elements: numpy.ndarray
    sides: numpy.ndarray


@dataclasses.dataclass(frozen=True)
class NodeSet:
    entity: Entity
    nodes: numpy.ndarray


class Exodus:
    """Mesh, sets and variables by their names; arrays without netCDF's masks."""

    def __init__(self, path):
        self.path = path
        try:
            self.data = netCDF4.Dataset(path)
        except OSError as error:
            raise ReadError(f"{path}: cannot be read as Exodus (netCDF): {error.strerror or error}") from None
        self.data.set_auto_mask(False)
        if "num_dim" not in self.data.dimensions:
            raise ReadError(f"{path}: is netCDF, but not Exodus (no dimension num_dim)")
        try:
            self._read_mesh()
        except (IndexError, ValueError) as error:  # a variable is not there, or not as large as it must be
            raise ReadError(f"{path}: is not a complete Exodus file: {error}") from None

    def _read_mesh(self):
        self.points = self._points()
        self.blocks = self._blocks()
        self.side_sets = {name: self._side_set(entity) for name, entity in self._entities("ss", "side set")}
        self.node_sets = {name: NodeSet(entity, self._numbers(f"node_ns{entity.number}"))
                          for name, entity in self._entities("ns", "node set")}
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

    def declared(self, kind, name, part):
        """Whether the truth table says that a variable is there on a block or set; without a table it is on all."""
        table = self.data.variables.get(TRUTH_TABLES.get(kind))
        return table is None or bool(table[part - 1, self.variables(kind).index(name)])

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
        """(name, Entity) of the blocks or sets; those without a name are called by their id."""
        if f"{prefix}_prop1" not in self.data.variables:
            return []
        ids = self.data[f"{prefix}_prop1"][:].tolist()
        names = self._names(f"{prefix}_names") or [""] * len(ids)
        status = self.data.variables.get(f"{prefix}_status", [1] * len(ids))[:]
        return [(name or f"{what} {id_}", Entity(i, id_, int(filled)))
                for i, (name, id_, filled) in enumerate(zip(names, ids, status), 1)]

    def _numbers(self, variable):
        """Numbers from 1 as numbers from 0; none when the file leaves them out, as it does for empty sets."""
        return self.data[variable][:].astype(int) - 1 if variable in self.data.variables else numpy.zeros(0, int)

    def _blocks(self):
        blocks, first = {}, 0
        for name, entity in self._entities("eb", "block"):
            connect = f"connect{entity.number}"
            nodes = self._numbers(connect)
            kind = getattr(self.data[connect], "elem_type", "") if nodes.size else ""
            shape = (len(nodes), -1) if nodes.size else (0, 0)  # a piece may have none of a block
            blocks[name] = Block(entity, kind, nodes.reshape(shape), first)
            first += len(nodes)
        return blocks

    def _side_set(self, entity):
        number = entity.number
        return SideSet(entity, self._numbers(f"elem_ss{number}"), self._numbers(f"side_ss{number}") + 1)
