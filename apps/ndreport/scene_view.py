"""The scene before it is loaded: bodies in their tints, what holds them, what loads them, where they may touch."""

import numpy
from matplotlib import colors
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from . import plane_view, solid_view
from .bodies import Scale
from .style import BODY_TINTS, PAGE

SUPPORT, LOAD, CONTACT = "#5b6b7d", "#d1495b", "#1f9e89"
HELD = "#64748b"  # sides of solids
KINDS = {"Clamp": "clamp", "Roller": "roller", "Displacement": "given displacement", "Hold": "hold", "Point": "point"}


def sides_of(bodies, what):
    """(entry of the deck, side set) of all supports or loads that have a side in the file."""
    for body in bodies.names:
        for entry in bodies.decks.get(body, {}).get(what, {}).values():
            side = f"{body}:{entry.get('Side', '')}"
            if side in bodies.fields.sides:
                yield entry, side


def interfaces(bodies):
    return [name[: -len(":dirichlet")] for name in bodies.fields.sides if name.endswith(":dirichlet")]


def tint(body):
    return BODY_TINTS[body % len(BODY_TINTS)]


def body_patches(bodies):
    parts = [(bodies.names[p.body], plane_view.RIGID if p.rigid else tint(p.body)) for p in bodies.pieces]
    few = list(dict.fromkeys(parts))
    return [Patch(color=colour, label=name) for name, colour in few] if len(few) <= 8 else []


def plane_scene(bodies, inks=PAGE):
    used = numpy.unique(numpy.concatenate([piece.nodes.ravel() for piece in bodies.pieces]))
    figure, axes = plane_view.canvas(bodies.points[used], extra=1.0)
    size = bodies.size()
    reach = 0.09 * size
    for limits, change in ((axes.get_xlim(), axes.set_xlim), (axes.get_ylim(), axes.set_ylim)):
        change(limits[0] - reach, limits[1] + reach)
    points = bodies.points
    for piece in bodies.pieces:
        cells = plane_view.PolyCollection(points[piece.nodes[:, :3]], linewidths=0.3, edgecolors="face",
                                          facecolors=plane_view.RIGID if piece.rigid else tint(piece.body))
        cells.set_rasterized(True)
        axes.add_collection(cells)
    plane_view.mesh_lines(axes, points, bodies.elastic())
    plane_view.outline(axes, points, bodies.elastic(), inks.text, 0.7)
    marks = body_patches(bodies)
    marks += plane_interfaces(axes, bodies, points)
    marks += plane_supports(axes, bodies, points, size)
    marks += plane_loads(axes, bodies, points, size)
    figure.legend(handles=marks, loc="lower center", ncols=3, fontsize=8.5)
    lift(figure, len(marks))
    return figure


def lift(figure, marks, columns=3):
    """Leaves room for the legend below the axes."""
    share = (0.12 + 0.17 * -(-marks // columns)) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0.0, share, 1.0, 1.0 - share))


def plane_interfaces(axes, bodies, points):
    names = interfaces(bodies)
    for name in names:
        for side in ("dirichlet", "neumann"):
            axes.add_collection(LineCollection(points[bodies.fields.facets(f"{name}:{side}")], colors=CONTACT, linewidths=2.6))
    return [Line2D([], [], color=CONTACT, linewidth=2.6, label="may touch")] if names else []


def spaced(points, facets, distance):
    """(places, outward normals) along a side, about `distance` apart, and at least three."""
    middles = points[facets].mean(axis=1)
    _, _, axes = numpy.linalg.svd(middles - middles.mean(axis=0), full_matrices=False)
    ends = points[facets[numpy.argsort(middles @ axes[0])]]  # as they follow each other on a side that is not too curved
    along = ends[:, 1] - ends[:, 0]
    lengths = numpy.linalg.norm(along, axis=1)
    normals = numpy.stack([along[:, 1], -along[:, 0]], axis=1) / lengths[:, None]
    back = along @ axes[0] < 0.0
    ends[back] = ends[back][:, ::-1]
    along[back] *= -1.0
    count = max(3, int(lengths.sum() / distance))
    wanted = (numpy.arange(count) + 0.5) / count * lengths.sum()
    upper = numpy.cumsum(lengths)
    facet = numpy.minimum(numpy.searchsorted(upper, wanted), len(lengths) - 1)
    share = (wanted - (upper[facet] - lengths[facet])) / lengths[facet]
    return ends[facet, 0] + share[:, None] * along[facet], normals[facet]


def plane_supports(axes, bodies, points, size):
    """Clamps as hatching, rollers as circles, the others as squares, outside of the body."""
    marks = {}
    for entry, side in sides_of(bodies, "Supports"):
        facets, kind = bodies.fields.facets(side), entry["Type"]
        axes.add_collection(LineCollection(points[facets], colors=SUPPORT, linewidths=1.8))
        places, normals = spaced(points, facets, 0.03 * size)
        if kind == "Clamp":
            turned = numpy.stack([-normals[:, 1], normals[:, 0]], axis=1)
            ticks = numpy.stack([places, places + 0.022 * size * (normals + turned)], axis=1)
            axes.add_collection(LineCollection(ticks, colors=SUPPORT, linewidths=0.9))
            marks[kind] = Line2D([], [], color=SUPPORT, marker=(2, 0, -45), markersize=9, linewidth=1.8, label="clamp")
            continue
        shape = "o" if kind == "Roller" else "s"
        axes.plot(*(places + 0.013 * size * normals).T, shape, color="none", markeredgecolor=SUPPORT, markersize=3.6,
                  markeredgewidth=0.9)
        marks[kind] = Line2D([], [], color=SUPPORT, marker=shape, markerfacecolor="none", linewidth=1.8, label=KINDS[kind])
    return list(marks.values())


def plane_loads(axes, bodies, points, size):
    """Arrows that say where and in which sense; lengths mean nothing."""
    found = False
    for entry, side in sides_of(bodies, "Loads"):
        places, normals = spaced(points, bodies.fields.facets(side), 0.06 * size)
        direction = direction_of(entry, places, normals)
        arrows(axes, places, direction, 0.075 * size, pulls=(direction * normals).sum(axis=1).mean() > 0.0)
        found = True
    for body, name in enumerate(bodies.names):
        for entry in bodies.decks.get(name, {}).get("Loads", {}).values():
            if entry["Type"] != "Body Force":
                continue
            nodes = numpy.concatenate([p.nodes[:, :3].ravel() for p in bodies.pieces if p.body == body])
            middle = points[nodes].mean(axis=0)[None]
            arrows(axes, middle, direction_of(entry, middle, None), 0.11 * size, pulls=True)
            found = True
    return [Line2D([], [], color=LOAD, marker=r"$\rightarrow$", markersize=11, linewidth=0, label="load")] if found else []


def direction_of(entry, places, normals):
    """Unit vectors of a load whose sense can be read off the deck; expressions count where they are numbers."""
    if entry["Type"] == "Pressure":
        return normals if number(entry["Value"]) < 0.0 else -normals
    vector = numpy.array([number(entry.get("X", "0"), None), number(entry.get("Y", "0"), None)], object)
    vector = numpy.array([1.0 if v is None else v for v in vector], float)  # an expression: along its axis
    length = float(numpy.linalg.norm(vector))
    return numpy.tile(vector / length if length > 0.0 else vector, (len(places), 1))


def number(text, otherwise=1.0):
    try:
        return float(text)
    except (TypeError, ValueError):
        return otherwise


def arrows(axes, places, direction, length, pulls):
    """Arrows that end at the places, or begin there when they pull."""
    start = places if pulls else places - length * direction
    for begin, end in zip(start, start + length * direction):
        axes.annotate("", end, begin, arrowprops={"arrowstyle": "-|>", "color": LOAD, "lw": 1.0, "shrinkA": 0, "shrinkB": 0,
                                                  "mutation_scale": 7})


def solid_scene(bodies, view, inks=PAGE):
    """Bodies shaded, their sides coloured by what acts there; two bodies with one interface are drawn apart."""
    points = bodies.moved(Scale(0.0, gaps=False))
    names, apart = interfaces(bodies), len(bodies.names) == 2
    if apart and names:
        moved = numpy.unique(bodies.fields.nodes(block_of(bodies, names[0])))
        points[moved] -= 0.2 * bodies.size() * solid_view.outward(bodies, f"{names[0]}:dirichlet")
    colour_at = facet_colours(bodies)

    def colour_of(piece, small, facet):
        keys = numpy.sort(piece.nodes[:, :3], axis=1)
        own = colors.to_rgb(plane_view.RIGID if piece.rigid else tint(piece.body))
        found = numpy.array([colour_at.get(tuple(key), own) for key in keys.tolist()])
        return numpy.repeat(found[facet][:, None], 3, axis=1)

    picture = solid_view.shaded(bodies, points, colour_of, view)
    figure, axes = solid_view.shown(picture, extra=0.6)
    solid_view.triad(axes, picture, view, inks)
    marks = body_patches(bodies)
    used = set(colour_at.values())
    for colour, label in ((CONTACT, "may touch"), (HELD, "held"), (LOAD, "loaded")):
        if colors.to_rgb(colour) in used:
            marks.append(Patch(color=colour, label=label))
    figure.legend(handles=marks, loc="lower center", ncols=3, fontsize=8.5)
    lift(figure, len(marks))
    return figure, apart and bool(names)


def block_of(bodies, interface):
    """The first block of the interface's Dirichlet body."""
    element = bodies.fields.file.side_sets[f"{interface}:dirichlet"].elements[0]
    block = bodies.fields.file.block_of(element)
    return next(name for name, other in bodies.fields.file.blocks.items() if other is block)


def facet_colours(bodies):
    """Colours of facets by their sorted vertices; what holds covers what loads, contact covers both."""
    found = {}
    entries = [(LOAD, side) for _, side in sides_of(bodies, "Loads")]
    entries += [(HELD, side) for _, side in sides_of(bodies, "Supports")]
    entries += [(CONTACT, f"{name}:{side}") for name in interfaces(bodies) for side in ("dirichlet", "neumann")]
    for colour, side in entries:
        for facet in numpy.sort(bodies.fields.facets(side), axis=1).tolist():
            found[tuple(facet)] = colors.to_rgb(colour)
    return found
