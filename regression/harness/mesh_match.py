"""Which node, element and facet of one file is which of another, when they are numbered differently.

Bodies in contact have nodes at the same position, so a node is known by its position and by its first element block.
Nodes that agree in both are paired in the order of their numbers.
"""

import numpy

from .elements import canonical, sides_of


class MeshMatch:
    """`nodes[i]`, `elements[name][i]`, `facets[name][i]`: number in NEW of what is number i in GOLD.

    Only blocks and sets that both files have. `found` is false when the meshes differ; the report then says where.
    """

    def __init__(self, gold, new, tolerance, report):
        self.gold, self.new = gold, new
        self.elements, self.facets, self.node_sets = {}, {}, {}
        self.common = [name for name in gold.blocks if name in new.blocks]
        self.nodes = self._match_nodes(tolerance, report)
        self.found = self.nodes is not None and all([self._match_block(name, report) for name in self.common])
        if self.found:
            self._match_sets(report)

    def _same_connectivity(self):
        return all(numpy.array_equal(self.gold.blocks[name].nodes, self.new.blocks[name].nodes) for name in self.common)

    def _match_nodes(self, tolerance, report):
        """Numbers in NEW of GOLD's nodes; by number where the files agree, else by position."""
        if self.gold.points.shape[1] != self.new.points.shape[1]:
            report.say(f"dimension {self.gold.points.shape[1]} is {self.new.points.shape[1]} in NEW")
            return None
        scale = largest(numpy.ptp(self.gold.points, axis=0)) if len(self.gold.points) else 0.0
        reach = float(tolerance.allowed(scale, scale, scale))
        gold, new = self._labelled(self.gold, scale), self._labelled(self.new, scale)
        numbered_alike = gold.shape == new.shape and self._same_connectivity()
        by_number = numpy.arange(len(gold))
        if numbered_alike and largest(gold - new) <= reach:
            return by_number
        nodes = nearest(gold, new, min(reach, 1e-3 * scale))
        if numbered_alike and (nodes < 0).any():  # the same mesh with moved nodes: the coordinates are what differs
            report.compare("coordinates", tolerance, self.gold.points, self.new.points, scale,
                           lambda index: place("node", index[0], self.gold.points[index[0]]))
            return by_number
        return nodes if self._all_matched(nodes, report) else None

    def _all_matched(self, nodes, report):
        lost = numpy.flatnonzero(nodes < 0)
        extra = len(self.new.points) - len(numpy.unique(nodes[nodes >= 0]))
        if lost.size:
            report.say(f"{lost.size} of {len(nodes)} nodes are missing in NEW, the first: "
                       + place("node", lost[0], self.gold.points[lost[0]]))
        if extra:
            report.say(f"{extra} of {len(self.new.points)} nodes of NEW are not in GOLD")
        return not lost.size and not extra

    def _labelled(self, file, scale):
        """Positions with one more coordinate that keeps nodes of different blocks apart."""
        label = numpy.full(len(file.points), -1.0)
        for number, name in reversed(list(enumerate(self.common))):
            label[file.blocks[name].nodes] = number
        return numpy.column_stack([file.points, label * (scale or 1.0)])

    def _match_block(self, name, report):
        gold, new = self.gold.blocks[name], self.new.blocks[name]
        if (gold.type, gold.nodes.shape) != (new.type, new.nodes.shape):
            report.say(f"block {name} has {len(gold.nodes)} {gold.type} in GOLD, {len(new.nodes)} {new.type} in NEW")
            return False
        gold_rows, new_rows = numpy.sort(self.nodes[gold.nodes], axis=1), numpy.sort(new.nodes, axis=1)
        gold_order, new_order = numpy.lexsort(gold_rows.T), numpy.lexsort(new_rows.T)
        unequal = (gold_rows[gold_order] != new_rows[new_order]).any(axis=1)
        if unequal.any():
            self._say_elements(name, "other elements", gold_order[unequal], report)
            return False
        self.elements[name] = numpy.empty(len(gold.nodes), int)
        self.elements[name][gold_order] = new_order
        turned = canonical(gold.type, self.nodes[gold.nodes]) != canonical(new.type, new.nodes)[self.elements[name]]
        if turned.any():
            self._say_elements(name, "elements with their nodes in another order", turned.any(axis=1).nonzero()[0],
                               report)
        return True

    def _say_elements(self, name, what, elements, report):
        block = self.gold.blocks[name]
        centre = self.gold.points[block.nodes[elements[0]]].mean(axis=0)
        report.say(f"block {name} has {what}, {len(elements)} of {len(block.nodes)}, the first: "
                   + place("element", block.first + elements[0], centre))

    def _match_sets(self, report):
        for kind, result, keys in (("side_sets", self.facets, self._facet_keys),
                                   ("node_sets", self.node_sets, self._node_keys)):
            for name, gold in getattr(self.gold, kind).items():
                new = getattr(self.new, kind).get(name)
                if new is not None:
                    result[name] = paired(keys(self.gold, gold), keys(self.new, new), f"{kind[:4]} set {name}", report)

    def _facet_keys(self, file, side_set):
        """A facet by the corners of its element and its own, as numbers of NEW."""
        number = self.nodes if file is self.gold else numpy.arange(len(file.points))
        keys = []
        for element, side in zip(side_set.elements, side_set.sides):
            nodes = number[file.nodes_of(element)]
            corners = sides_of(file.block_of(element).type)
            on_side = sorted(nodes[list(corners[side - 1])]) if corners and side <= len(corners) else [side]
            keys.append((*sorted(nodes), *on_side))
        return keys

    def _node_keys(self, file, node_set):
        return [(int(node),) for node in (self.nodes[node_set.nodes] if file is self.gold else node_set.nodes)]


def nearest(gold, new, reach):
    """Number of the point of `new` within `reach` of each point of `gold`, each used once; -1 where there is none."""
    # Sorted along a direction in which a regular mesh has no two points abreast.
    direction = numpy.sqrt([2.0, 3.0, 5.0, 7.0][: gold.shape[1]]) / 4
    along = new @ direction
    order = numpy.argsort(along, kind="stable")
    width = reach * (numpy.linalg.norm(direction) * 1.01) + 1e-14 * largest(along)
    first = numpy.searchsorted(along[order], gold @ direction - width, "left")
    last = numpy.searchsorted(along[order], gold @ direction + width, "right")
    result, free = numpy.full(len(gold), -1), numpy.ones(len(new), bool)
    # Nearly all points have one candidate, which no other point has.
    single = numpy.flatnonzero(last - first == 1)
    found, index = numpy.unique(order[first[single]], return_index=True)
    single = single[index]
    close = numpy.abs(new[found] - gold[single]).max(axis=1, initial=0.0) <= reach
    result[single[close]], free[found[close]] = found[close], False
    for point in numpy.flatnonzero(result < 0):
        candidates = order[first[point] : last[point]]
        candidates = numpy.sort(candidates[free[candidates]])
        if candidates.size:
            distance = numpy.abs(new[candidates] - gold[point]).max(axis=1)
            if distance.min() <= reach:
                result[point] = candidates[numpy.argmin(distance)]
                free[result[point]] = False
    return result


def paired(gold_keys, new_keys, what, report):
    """Positions in `new_keys` of the keys of GOLD; None, and said, when they are not the same keys."""
    if sorted(gold_keys) != sorted(new_keys):
        lost, extra = len(set(gold_keys) - set(new_keys)), len(set(new_keys) - set(gold_keys))
        report.say(f"{what} has {len(gold_keys)} members in GOLD, {len(new_keys)} in NEW; "
                   f"{lost} are missing, {extra} extra")
        return None
    position = {key: i for i, key in enumerate(new_keys)}
    return numpy.array([position[key] for key in gold_keys], int)


def largest(values):
    """max |value|, 0 of nothing."""
    return float(numpy.max(numpy.abs(values), initial=0.0))


def place(what, number, point):
    """A place as text; numbers count from 1 as in the file."""
    return f"{what} {number + 1} at ({', '.join(f'{x:.6g}' for x in point)})"
