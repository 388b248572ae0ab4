"""Two Exodus files compared: mesh, sets, steps and all variables."""

import re
import threading

import numpy
from ndframe.exodus import VARIABLES, Exodus

from .mesh_match import MeshMatch, largest, place
from .report import Report
from .tolerance import Tolerance, Tolerances

# Round-off of one variable is a fraction of its largest value, not of the value at the place.
EXODUS_DEFAULTS = Tolerances(Tolerance("scaled", 1e-9))

# netCDF is not made for threads, and its Python module lets others run while it reads.
NETCDF = threading.Lock()


def diff_exodus(gold_path, new_path, tolerances=EXODUS_DEFAULTS):
    """The report of all differences; raises ReadError for files that cannot be read."""
    report = Report()
    with NETCDF, Exodus(gold_path) as gold, Exodus(new_path) as new:
        for what in ("block", "side set", "node set"):
            compare_entities(what, *(getattr(file, what.replace(" ", "_") + "s") for file in (gold, new)), report)
        match = MeshMatch(gold, new, tolerances.of("coordinates"), report)
        FieldDiff(gold, new, match, tolerances, report).run()
    return report


def compare_entities(what, gold, new, report):
    """Blocks or sets by their names: which there are, their ids and statuses."""
    report.missing(what, gold, new)
    for name in gold:
        if name in new:
            for key in ("id", "status"):
                values = [getattr(entities[name].entity, key) for entities in (gold, new)]
                if values[0] != values[1]:
                    report.say(f"{what} {name} has {key} {values[0]} in GOLD, {values[1]} in NEW")


class FieldDiff:
    """The steps and variables of two files with matched meshes."""

    def __init__(self, gold, new, match, tolerances, report):
        self.gold, self.new, self.match, self.tolerances, self.report = gold, new, match, tolerances, report
        self.steps = min(len(gold.times), len(new.times))

    def run(self):
        self._compare_times()
        for kind in VARIABLES:
            gold, new = self._wanted(self.gold, kind), self._wanted(self.new, kind)
            self.report.missing(f"{kind} variable", gold, new)
            common = [name for name in gold if name in new]
            scales = shared_scales({name: self._scale(kind, name) for name in common})
            for name in common:
                self._compare_variable(kind, name, scales[name])

    def _wanted(self, file, kind):
        return [name for name in file.variables(kind) if self.tolerances.of(name).kind != "ignore"]

    def _compare_times(self):
        gold, new = self.gold.times, self.new.times
        for step in range(self.steps, len(gold)):
            self.report.say(f"step {step + 1} (time {gold[step]:g}) is missing in NEW")
        for step in range(self.steps, len(new)):
            self.report.say(f"step {step + 1} (time {new[step]:g}) is extra in NEW")
        self.report.compare("time", self.tolerances.of("time"), gold[: self.steps], new[: self.steps], largest(gold),
                            lambda index: f"step {index[0] + 1}")

    def _parts(self, kind):
        """(name, number in GOLD, number in NEW, places of GOLD in NEW, text of a place) of the matched parts."""
        match, gold, new = self.match, self.gold, self.new
        if kind == "global":
            yield "", None, None, numpy.zeros(1, int), lambda _: ""
        elif not match.found:
            return
        elif kind == "nodal":
            yield "", None, None, match.nodes, lambda i: place("node", i, gold.points[i])
        else:
            of_gold, of_new, places, where = {
                "element": (gold.blocks, new.blocks, match.elements, self._element_place),
                "side set": (gold.side_sets, new.side_sets, match.facets, self._facet_place),
                "node set": (gold.node_sets, new.node_sets, match.node_sets, self._set_node_place),
            }[kind]
            for name, numbers in places.items():
                if numbers is not None:
                    entities = of_gold[name].entity, of_new[name].entity
                    yield name, *(one.number for one in entities), numbers, lambda i, n=name: where(n, i)

    def _element_place(self, name, i):
        element = self.gold.blocks[name].first + i
        return f"{name}, " + place("element", element, self.gold.points[self.gold.nodes_of(element)].mean(axis=0))

    def _facet_place(self, name, i):
        side_set = self.gold.side_sets[name]
        element = side_set.elements[i]
        centre = self.gold.points[self.gold.nodes_of(element)].mean(axis=0)
        return f"{name}, side {side_set.sides[i]} of " + place("element", element, centre)

    def _set_node_place(self, name, i):
        node = self.gold.node_sets[name].nodes[i]
        return f"{name}, " + place("node", node, self.gold.points[node])

    def _scale(self, kind, name):
        """Largest finite |value| in GOLD over all steps and parts."""
        arrays = [self.gold.values(kind, name, number) for _, number, *_ in self._parts(kind)]
        return max((largest(a[numpy.isfinite(a)]) for a in arrays if a is not None), default=0.0)

    def _compare_variable(self, kind, name, scale):
        for part, gold_number, new_number, places, where in self._parts(kind):
            declared = [[part] * file.declared(kind, name, number)
                        for file, number in ((self.gold, gold_number), (self.new, new_number))]
            self.report.missing(f"{kind} variable {name} in the truth table on", *declared)
            gold, new = self.gold.values(kind, name, gold_number), self.new.values(kind, name, new_number)
            if gold is None or new is None:
                holders = [[part] * (values is not None) for values in (gold, new)]
                self.report.missing(f"{kind} variable {name} on", *holders)
                continue
            self.report.compare(name, self.tolerances.of(name), gold[: self.steps], new[: self.steps][:, places], scale,
                                lambda index, at=where: f"step {index[0] + 1}  {at(index[1])}".rstrip())


def shared_scales(scales):
    """The components of one vector or tensor get the largest scale of them: stress_xy may vanish beside stress_yy."""
    stem = {name: re.sub(r"_[xyz]{1,2}$", "_", name) for name in scales}
    return {name: max(scales[other] for other in scales if stem[other] == stem[name]) for name in scales}
