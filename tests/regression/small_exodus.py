"""A small Exodus file with everything in it, to be altered on purpose."""

import netCDF4
import numpy

# Two squares of two triangles each, one above the other, with two positions in common. A third triangle at the upper
# one makes the blocks different from each other.
POINTS = numpy.array([(0, 0), (1, 0), (0, 1), (1, 1), (2, 0.5), (0, 0), (1, 0), (0, -1), (1, -1)], float)
BLOCKS = {"upper": [(1, 2, 4), (1, 4, 3), (2, 5, 4)], "lower": [(6, 8, 9), (6, 9, 7)]}
SIDE_SETS = {"contact:upper": [(1, 1)], "contact:lower": [(5, 3)], "upper:right": [(3, 1), (3, 2)]}
NODE_SETS = {"corner": [1, 5]}


def fields(points):
    """(disp_x, disp_y) with the size of ordinary results; disp_y vanishes to round-off."""
    return {"disp_x": 1 + points[:, 0] + 2 * points[:, 1], "disp_y": 1e-17 * points[:, 0]}


def put_names(data, variable, dimension, names):
    if dimension not in data.dimensions:
        data.createDimension(dimension, len(names))
    data.createVariable(variable, "S1", (dimension, "len_name"))
    rows = numpy.array([name.ljust(33, "\0") for name in names], "S33")
    data[variable][:] = rows.view("S1").reshape(len(names), 33)


def put(data, name, kind, dimensions, values):
    data.createVariable(name, kind, dimensions)
    data[name][:] = values


class SmallExodus:
    """What the file holds; `nodes`, `elements` renumber it: new number -> old number, elements within their blocks."""

    def __init__(self, nodes=range(9), elements=((0, 1, 2), (0, 1)), times=(1.0, 2.0)):
        self.nodes, self.times = list(nodes), times
        self.points = POINTS[self.nodes]
        number = {old: new for new, old in enumerate(self.nodes)}
        self.blocks = {name: [[number[node - 1] + 1 for node in rows[i]] for i in order]
                       for (name, rows), order in zip(BLOCKS.items(), elements)}
        order = [*elements[0], *(3 + i for i in elements[1])]
        self.side_sets = {name: [(order.index(element - 1) + 1, side) for element, side in sides]
                          for name, sides in SIDE_SETS.items()}
        self.node_sets = {name: [number[node - 1] + 1 for node in set_] for name, set_ in NODE_SETS.items()}
        self.nodal = {name: numpy.outer(times, values) for name, values in fields(self.points).items()}
        self.element = {"stress_xx": {name: numpy.array([[10.0 * t + i for i in order] for t in times])
                                      for name, order in zip(BLOCKS, elements)}}
        self.side = {"pressure": {name: numpy.array([[t + 0.5 * i for i in range(len(sides))] for t in times])
                                  for name, sides in self.side_sets.items()}}
        self.globals = {"energy": numpy.array(times) * 3}
        self.side_set_ids = list(range(1, len(SIDE_SETS) + 1))
        self.side_set_status = [1] * len(SIDE_SETS)
        self.truth_table = [[1], [1]]  # blocks x element variables

    def add_middles(self):
        """Six nodes an element, the new ones in the middle of its edges."""
        middles = {}
        for row in [row for rows in self.blocks.values() for row in rows]:
            for a, b in ((0, 1), (1, 2), (2, 0)):
                ends = tuple(sorted((row[a], row[b])))
                row.append(middles.setdefault(ends, len(self.points) + len(middles) + 1))
        ends = numpy.array(list(middles)) - 1
        self.points = numpy.vstack([self.points, self.points[ends].mean(axis=1)])
        self.nodal = {name: numpy.outer(self.times, values) for name, values in fields(self.points).items()}
        return self

    def write(self, path):
        with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as data:
            data.createDimension("len_name", 33)
            data.createDimension("time_step", None)
            data.createDimension("num_dim", 2)
            data.createDimension("num_nodes", len(self.points))
            put(data, "time_whole", "f8", ("time_step",), self.times)
            for axis, column in zip("xy", self.points.T):
                put(data, f"coord{axis}", "f8", ("num_nodes",), column)
            self._write_blocks(data)
            self._write_sets(data)
            self._write_variables(data)
        return str(path)

    def _write_blocks(self, data):
        put_names(data, "eb_names", "num_el_blk", list(self.blocks))
        put(data, "eb_prop1", "i4", ("num_el_blk",), range(1, len(self.blocks) + 1))
        for i, rows in enumerate(self.blocks.values(), 1):
            data.createDimension(f"num_el_in_blk{i}", len(rows))
            data.createDimension(f"num_nod_per_el{i}", len(rows[0]))
            put(data, f"connect{i}", "i4", (f"num_el_in_blk{i}", f"num_nod_per_el{i}"), rows)
            data[f"connect{i}"].elem_type = f"TRI{len(rows[0])}"

    def _write_sets(self, data):
        put_names(data, "ss_names", "num_side_sets", list(self.side_sets))
        put(data, "ss_prop1", "i4", ("num_side_sets",), self.side_set_ids[: len(self.side_sets)])
        put(data, "ss_status", "i4", ("num_side_sets",), self.side_set_status[: len(self.side_sets)])
        for i, sides in enumerate(self.side_sets.values(), 1):
            data.createDimension(f"num_side_ss{i}", len(sides))
            for column, name in enumerate(("elem", "side")):
                put(data, f"{name}_ss{i}", "i4", (f"num_side_ss{i}",), [facet[column] for facet in sides])
        if self.node_sets:
            put_names(data, "ns_names", "num_node_sets", list(self.node_sets))
            put(data, "ns_prop1", "i4", ("num_node_sets",), range(1, len(self.node_sets) + 1))
        for i, nodes in enumerate(self.node_sets.values(), 1):
            data.createDimension(f"num_nod_ns{i}", len(nodes))
            put(data, f"node_ns{i}", "i4", (f"num_nod_ns{i}",), nodes)

    def _write_variables(self, data):
        put_names(data, "name_glo_var", "num_glo_var", list(self.globals))
        put(data, "vals_glo_var", "f8", ("time_step", "num_glo_var"), numpy.stack(list(self.globals.values()), 1))
        put_names(data, "name_nod_var", "num_nod_var", list(self.nodal))
        for v, values in enumerate(self.nodal.values(), 1):
            put(data, f"vals_nod_var{v}", "f8", ("time_step", "num_nodes"), values)
        for kind, parts, dimension, suffix in ((self.element, self.blocks, "num_el_in_blk", "elem_var{}eb"),
                                               (self.side, self.side_sets, "num_side_ss", "sset_var{}ss")):
            put_names(data, f"name_{suffix[:4]}_var", f"num_{suffix[:4]}_var", list(kind))
            for v, values in enumerate(kind.values(), 1):
                for i, name in enumerate(parts, 1):
                    put(data, f"vals_{suffix.format(v)}{i}", "f8", ("time_step", f"{dimension}{i}"), values[name])
        put(data, "elem_var_tab", "i4", ("num_el_blk", "num_elem_var"), self.truth_table)
