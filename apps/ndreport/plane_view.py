"""Plane bodies: fields on the deformed bodies, and the scene with its supports and loads."""

import numpy
from matplotlib import colors, pyplot
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.tri import Triangulation

from .bodies import boundary_edges, mesh_edges
from .style import FIELD_MAP, PAGE, power_label, number_label

RIGID = "#9aa3ad"
SHORT_EDGE = 0.006  # of the axes' width and height


def canvas(points, width=5.0, extra=0.9, box=None):
    """A figure with axes of equal units, as high as the points need."""
    low, high = (points.min(axis=0), points.max(axis=0)) if box is None else box
    extent = numpy.maximum(high - low, 1e-12 * max(1e-300, float(numpy.abs(high).max())))
    margin = (0.03 if box is None else 0.0) * float(extent.max())
    height = float(numpy.clip((width - 0.7) * (extent[1] + 2 * margin) / (extent[0] + 2 * margin), 1.1, 1.15 * width))
    figure, axes = pyplot.subplots(figsize=(width, height + extra))
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.locator_params(nbins=6)
    for side in ("top", "right", "bottom", "left"):
        axes.spines[side].set_visible(False)
    return figure, axes


def outline(axes, points, pieces, colour, width=0.8, style="solid"):
    for piece in pieces:
        edges = boundary_edges(piece)
        order = [0, 2, 1] if edges.shape[1] == 3 else [0, 1]
        axes.add_collection(LineCollection(points[edges[:, order]], colors=colour, linewidths=width, linestyles=style,
                                           capstyle="round"))


def mesh_lines(axes, points, pieces):
    """White lines of the mesh, but for edges so short that they would veil the colours."""
    across = float(numpy.ptp(axes.get_xlim()) + numpy.ptp(axes.get_ylim()))
    for piece in pieces:
        ends = points[mesh_edges(piece)]
        shown = ends[numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > SHORT_EDGE * across]
        lines = LineCollection(shown, colors="white", linewidths=0.35 if len(shown) < 4000 else 0.2, alpha=0.4)
        lines.set_rasterized(True)
        axes.add_collection(lines)


def rigid_bodies(axes, points, pieces):
    for piece in pieces:
        shape = PolyCollection(points[piece.nodes[:, :3]], facecolors=RIGID, edgecolors=RIGID, linewidths=0.3)
        axes.add_collection(shape)


def smooth_field(axes, points, piece, values, norm):
    small, _, _ = piece.parts()
    drawn = axes.tripcolor(Triangulation(*points.T, small), values, shading="gouraud", cmap=FIELD_MAP, norm=norm)
    drawn.set_rasterized(True)
    return drawn


def cell_field(axes, points, piece, values, norm):
    order = [0, 3, 1, 4, 2, 5] if piece.nodes.shape[1] == 6 else [0, 1, 2]
    cells = PolyCollection(points[piece.nodes[:, order]], array=values, cmap=FIELD_MAP, norm=norm, edgecolors="face",
                           linewidths=0.1)
    cells.set_rasterized(True)
    axes.add_collection(cells)
    return cells


def colour_bar(figure, axes, drawn, label, extend="neither"):
    bar = figure.colorbar(drawn, ax=axes, orientation="horizontal", shrink=0.9, aspect=34, pad=0.02, extend=extend)
    bar.set_label(label)
    bar.outline.set_visible(False)
    if isinstance(drawn.norm, colors.LogNorm):
        bar.ax.xaxis.set_major_formatter(power_label)
        bar.ax.xaxis.set_minor_formatter(lambda *_: "")
    else:
        bar.locator = pyplot.MaxNLocator(6)
        bar.formatter = pyplot.FuncFormatter(lambda value, _: number_label(value))
        bar.update_ticks()
    return bar


def stress_picture(bodies, scale, norm, inks=PAGE, box=None, width=5.0):
    """von Mises stress on the deformed bodies; what they were before is dashed."""
    points = bodies.moved(scale)
    used = numpy.unique(numpy.concatenate([piece.nodes.ravel() for piece in bodies.pieces]))
    figure, axes = canvas(points[used], width, box=box)
    elastic = bodies.elastic()
    if box is None and scale.factor != 1.0:
        outline(axes, bodies.points, elastic, inks.soft, 0.6, (0, (4, 3)))
    for piece in elastic:
        drawn = smooth_field(axes, points, piece, bodies.stress_at_nodes(piece), norm)
    mesh_lines(axes, points, elastic)
    rigid_bodies(axes, points, [piece for piece in bodies.pieces if piece.rigid])
    outline(axes, points, elastic, inks.text)
    colour_bar(figure, axes, drawn, "von Mises stress", "max")
    return figure


def contribution_picture(bodies, name, norm, inks=PAGE, width=5.0):
    """What every element adds to the error, on the bodies as they were."""
    elastic = bodies.elastic()
    used = numpy.unique(numpy.concatenate([piece.nodes.ravel() for piece in elastic]))
    figure, axes = canvas(bodies.points[used], width)
    for piece in elastic:
        drawn = cell_field(axes, bodies.points, piece, bodies.element(name, piece), norm)
    mesh_lines(axes, bodies.points, elastic)
    outline(axes, bodies.points, elastic, inks.text)
    colour_bar(figure, axes, drawn, "contribution of an element to the error", "both")
    return figure
