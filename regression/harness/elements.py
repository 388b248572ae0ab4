"""Exodus's element types: their sides, and which orders of nodes describe the same element."""

import numpy

# Corners of a side, by the beginning of the element's type.
SIDES = {
    "TRI": ((0, 1), (1, 2), (2, 0)),
    "TET": ((0, 1, 3), (1, 2, 3), (0, 2, 3), (0, 1, 2)),
    "QUA": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "HEX": ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)),
}
# Ends of the edges in the order of the nodes on them, which follow the corners.
EDGES = {
    "TRI": SIDES["TRI"],
    "TET": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    "QUA": SIDES["QUA"],
    "HEX": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)),
}
# Rotations of the corners of which all others are made.
GENERATORS = {
    "TRI": ((1, 2, 0),),
    "TET": ((1, 2, 0, 3), (1, 0, 3, 2)),
    "QUA": ((1, 2, 3, 0),),
    "HEX": ((1, 2, 3, 0, 5, 6, 7, 4), (3, 2, 6, 7, 0, 1, 5, 4)),
}


def sides_of(element_type):
    """Corners of the sides; None for a type that is not known here."""
    return SIDES.get(element_type[:3].upper())


def rotations(element_type, nodes):
    """The orders of an element's `nodes` nodes that leave shape and orientation as they are: corners, nodes on the
    edges with them, one in the middle. Of other types only the order itself."""
    kind = element_type[:3].upper()
    generators, edges = GENERATORS.get(kind, ()), EDGES.get(kind, ())
    corners = len(generators[0]) if generators else 0
    if not generators or nodes - corners not in (0, 1, len(edges), len(edges) + 1):
        return [tuple(range(nodes))]
    found = [tuple(range(corners))]
    for turned in found:  # grows while it is read
        for step in generators:
            product = tuple(turned[i] for i in step)
            if product not in found:
                found.append(product)
    return [_of_all_nodes(turned, edges, nodes) for turned in found]


def _of_all_nodes(turned, edges, nodes):
    """The order of all nodes that goes with an order of the corners."""
    place = {frozenset(edge): len(turned) + i for i, edge in enumerate(edges)}
    moved = [place[frozenset(turned[corner] for corner in edge)] for edge in edges]
    order = [*turned, *moved] if nodes >= len(turned) + len(edges) else [*turned]
    return (*order, *range(len(order), nodes))


def canonical(element_type, rows):
    """`rows` [elements, nodes], each begun where its numbers are first in the order of words: equal rows mean equal
    elements."""
    best = rows
    for order in rotations(element_type, rows.shape[1]):
        turned = rows[:, order]
        first = numpy.argmax(turned != best, axis=1)[:, None]
        smaller = numpy.take_along_axis(turned, first, 1) < numpy.take_along_axis(best, first, 1)
        best = numpy.where(smaller, turned, best)
    return best
