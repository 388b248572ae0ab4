"""Ranges of colours for fields, the same in the plane and in space."""

import numpy
from matplotlib import colors


def cell_sizes(bodies, piece):
    """Areas or volumes of a block's elements, without their constant factor."""
    vertices = bodies.points[bodies.fields.nodes(piece.name)[:, : bodies.dim + 1]]
    return numpy.abs(numpy.linalg.det(vertices[:, 1:] - vertices[:, :1]))


def stress_norm(bodies):
    """(norm, largest value, its point): colours end where 0.3 % of the bodies lie above, for peaks at corners hide the rest."""
    values, sizes, peak = [], [], (-1.0, None)
    for piece in bodies.elastic():
        nodal = bodies.stress_at_nodes(piece)
        nodes = bodies.fields.nodes(piece.name)
        values.append(nodal[nodes[:, : bodies.dim + 1]].mean(axis=1))
        sizes.append(cell_sizes(bodies, piece))
        own = numpy.unique(nodes)
        best = own[numpy.argmax(nodal[own])]
        peak = max(peak, (float(nodal[best]), tuple(bodies.points[best])), key=lambda item: item[0])
    values, sizes = numpy.concatenate(values), numpy.concatenate(sizes)
    order = numpy.argsort(values)
    place = numpy.searchsorted(numpy.cumsum(sizes[order]), 0.997 * sizes.sum())
    high = float(values[order][min(place, len(order) - 1)])
    return colors.Normalize(0.0, high if high > 0.0 else 1.0), *peak


def norm_within(bodies, points, box):
    """Colours of the stress for a part of the picture."""
    values = []
    for piece in bodies.elastic():
        own = numpy.unique(piece.nodes)
        inside = own[((points[own] >= box[0]) & (points[own] <= box[1])).all(axis=1)]
        values.append(bodies.stress_at_nodes(piece)[inside])
    values = numpy.concatenate(values)
    high = float(numpy.percentile(values, 99.5)) if values.size else 0.0
    return colors.Normalize(0.0, high if high > 0.0 else 1.0)


def contribution_norm(bodies, name):
    """Logarithmic, three decades at most; None where the elements add nothing."""
    values = numpy.concatenate([bodies.element(name, piece) for piece in bodies.elastic()])
    values = values[values > 0.0]
    if values.size == 0:
        return None
    low, high = (float(v) for v in numpy.percentile(values, (2.0, 99.8)))
    return colors.LogNorm(max(low, 1e-3 * high), max(high, 1.01 * low))


def contribution_name(bodies):
    return next((name for name in ("eta_glob", "eta_dis", "eta_nda") if name in bodies.fields.names("element")), None)
