"""Solids: fields on the outside of deformed bodies, the scene with its sides, and maps of plane contact zones."""

import numpy
from matplotlib import colormaps, colors, pyplot
from matplotlib.cm import ScalarMappable

from .plane_view import colour_bar
from .rasterizer import FEATURE_LINE, MESH_LINE, View, render
from .style import FIELD_MAP, PAGE

RIGID_COLOUR = (0.62, 0.65, 0.69)
LIVELY = 25.0  # degrees between the normals of facets from which their edge is drawn as one of the body


def views(bodies):
    """Two views that together show all sides: the first from where planes of symmetry cut, so that the inside is seen."""
    direction = numpy.zeros(3)
    for piece in bodies.elastic():
        for support in bodies.decks[bodies.names[piece.body]]["Supports"].values():
            side = f"{bodies.names[piece.body]}:{support.get('Side', '')}"
            if support["Type"] == "Roller" and side in bodies.fields.sides:
                direction += outward(bodies, side)
    direction[2] = 0.0
    if numpy.linalg.norm(direction) < 0.5:
        direction = numpy.array([-0.7, -1.0, 0.0])
    direction /= numpy.linalg.norm(direction)
    if numpy.abs(direction[:2]).min() < 0.3:  # not along an axis, where depth is not seen
        direction = direction + 0.55 * numpy.array([-direction[1], direction[0], 0.0])
        direction /= numpy.linalg.norm(direction)
    elif abs(abs(direction[0]) - abs(direction[1])) < 0.1:  # nor along a diagonal, where edges cover each other
        direction = direction + 0.2 * numpy.array([-direction[1], direction[0], 0.0])
    up = numpy.array([0.0, 0.0, 1.0])
    return View.from_direction(direction + 0.42 * up), View.from_direction(-direction + 0.42 * up)


def outward(bodies, side_set):
    """Mean normal of a side, out of its body."""
    corners = bodies.points[bodies.fields.facets(side_set)]
    normal = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]).sum(axis=0)
    return normal / max(1e-300, float(numpy.linalg.norm(normal)))


def darkness(points, piece, mesh_is_drawn):
    """[triangles, 3]: how dark the mesh edge opposite of each vertex is drawn: faint, or dark where the surface bends."""
    corners = points[piece.nodes[:, :3]]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    edges = numpy.sort(numpy.concatenate([piece.nodes[:, c] for c in ([1, 2], [0, 2], [0, 1])]), axis=1)
    _, number = numpy.unique(edges, axis=0, return_inverse=True)
    number = number.ravel()
    total, count = numpy.zeros((number.max() + 1, 3)), numpy.zeros(number.max() + 1)
    numpy.add.at(total, number, numpy.tile(normals, (3, 1)))
    numpy.add.at(count, number, 1.0)
    bent = (numpy.linalg.norm(total, axis=1) < 2.0 * numpy.cos(numpy.radians(LIVELY / 2.0))) | (count == 1)
    dark = numpy.where(bent, FEATURE_LINE, MESH_LINE if mesh_is_drawn else 0.0)
    return dark[number].reshape(3, -1).T


def shaded(bodies, points, colour_of, view, columns=900):
    """A picture of all bodies; `colour_of(piece, small triangles, their facets)` gives the colours [n, 3, 3]."""
    mesh_is_drawn = sum(len(piece.nodes) for piece in bodies.pieces) < 6000
    corners, colours, lines = [], [], []
    for piece in bodies.pieces:
        small, facet, on_mesh = piece.parts()
        corners.append(points[small])
        colours.append(colour_of(piece, small, facet))
        lines.append(small_lines(darkness(points, piece, mesh_is_drawn), on_mesh, facet))
    return render(numpy.concatenate(corners), numpy.concatenate(colours), numpy.concatenate(lines), view, columns)


def small_lines(dark, on_mesh, facet):
    """Darkness of the edges of small triangles: edge k of a corner triangle lies on edge k of its facet."""
    return numpy.where(on_mesh, dark[facet], 0.0)


def shown(picture, width=5.0, extra=0.9):
    """A figure with the picture."""
    left, right, bottom, top = picture.extent
    height = float(numpy.clip(width * (top - bottom) / (right - left), 1.5, 1.1 * width))
    figure, axes = pyplot.subplots(figsize=(width, height + extra))
    axes.imshow(picture.pixels, extent=picture.extent, interpolation="none")
    axes.set_axis_off()
    axes.set_anchor("N")
    return figure, axes


def triad(axes, picture, view, inks):
    """Where x, y and z point, in the emptiest corner."""
    corner, length = emptiest_corner(picture), 0.055
    box = axes.get_window_extent()
    ratio = numpy.array([1.0, box.width / box.height])
    for name, direction in zip("xyz", numpy.eye(3)):
        arrow = view.project(direction)[:2] * length * ratio
        if numpy.linalg.norm(arrow) < 0.2 * length:
            continue
        axes.annotate("", corner + arrow, corner, "axes fraction", "axes fraction",
                      arrowprops={"arrowstyle": "-|>", "color": inks.text, "lw": 0.8, "shrinkA": 0, "shrinkB": 0})
        axes.annotate(name, corner + 1.45 * arrow, xycoords="axes fraction", ha="center", va="center", fontsize=8.5)


def emptiest_corner(picture):
    """Where the axes' directions hide least, as parts of the picture's width and height: the lower left one if it is empty."""
    cover = picture.pixels[::-1, :, 3]
    high, wide = (max(1, int(0.22 * size)) for size in cover.shape)
    corners = {(0.07, 0.1): cover[:high, :wide], (0.07, 0.86): cover[-high:, :wide], (0.93, 0.1): cover[:high, -wide:],
               (0.93, 0.86): cover[-high:, -wide:]}
    return numpy.array(min(corners, key=lambda place: float(corners[place].mean())))


def field_figure(bodies, points, values_of, norm, view, label, extend, inks):
    """`values_of(piece, small, facet)`: numbers [n, 3] at the corners."""
    colour_map = colormaps[FIELD_MAP]

    def colour_of(piece, small, facet):
        if piece.rigid:
            return numpy.broadcast_to(RIGID_COLOUR, (*small.shape, 3))
        return colour_map(norm(values_of(piece, small, facet)))[..., :3]

    picture = shaded(bodies, points, colour_of, view)
    figure, axes = shown(picture)
    triad(axes, picture, view, inks)
    colour_bar(figure, axes, ScalarMappable(norm, colour_map), label, extend)
    return figure


def stress_picture(bodies, scale, norm, view, inks=PAGE):
    """von Mises stress on the deformed bodies."""
    nodal = {piece.name: bodies.stress_at_nodes(piece) for piece in bodies.elastic()}
    return field_figure(bodies, bodies.moved(scale), lambda piece, small, _: nodal[piece.name][small], norm, view,
                        "von Mises stress", "max", inks)


def contribution_picture(bodies, scale, name, norm, view, inks=PAGE):
    """What every element at the outside adds to the error."""

    def values(piece, small, facet):
        return numpy.repeat(bodies.element(name, piece)[piece.owner[facet]][:, None], 3, axis=1)

    return field_figure(bodies, bodies.moved(scale), values, norm, view, "contribution of an element to the error", "both", inks)


def contact_maps(bodies, interface, inks=PAGE):
    """Pressure, admissible pressure and gap of an interface as maps in its mean plane; None without the side."""
    side = f"{interface}:dirichlet"
    if side not in bodies.fields.sides:
        return None
    facets = bodies.fields.facets(side)
    flat, labels = in_plane(bodies, facets, side)
    box = pressed_box(flat, bodies.facet_values(side, "contact_pressure"))
    rows = [(name, values) for name, key in (("contact pressure", "contact_pressure"),
                                             ("admissible pressure", "admissible_pressure"), ("gap", "contact_gap"))
            if (values := bodies.facet_values(side, key)) is not None]
    extent = box[1] - box[0]
    height = float(numpy.clip(2.9 * extent[1] / max(extent[0], 1e-300), 1.2, 3.6))
    figure, panels = pyplot.subplots(1, len(rows), figsize=(3.2 * len(rows), height + 1.0), squeeze=False)
    pressures = numpy.concatenate([v for n, v in rows if "pressure" in n])
    middle = flat.mean(axis=1)
    shown_here = ((middle >= box[0]) & (middle <= box[1])).all(axis=1)
    for axes, (name, values) in zip(panels[0], rows):
        high = float((pressures if "pressure" in name else values[shown_here]).max())
        norm = colors.Normalize(0.0, high if high > 0.0 else 1.0)
        drawn = axes.tripcolor(*flat.reshape(-1, 2).T, numpy.arange(3 * len(flat)).reshape(-1, 3), facecolors=values,
                               cmap=FIELD_MAP, norm=norm, edgecolors="face", linewidth=0.1)
        drawn.set_rasterized(True)
        axes.set_aspect("equal")
        axes.set(xlim=(box[0][0], box[1][0]), ylim=(box[0][1], box[1][1]))
        axes.locator_params(nbins=4)
        axes.set_xlabel(labels[0])
        axes.set_ylabel(labels[1] if axes is panels[0][0] else "")
        colour_bar(figure, axes, drawn, name)
    return figure


def pressed_box(flat, pressure):
    """(low, high) of what a map shows: the zone that is pressed with a margin, or all of it where most is pressed."""
    low, high = flat.reshape(-1, 2).min(axis=0), flat.reshape(-1, 2).max(axis=0)
    pressed = flat[pressure > 1e-3 * pressure.max()].reshape(-1, 2) if pressure.max() > 0.0 else flat.reshape(-1, 2)
    inner = numpy.array([pressed.min(axis=0), pressed.max(axis=0)])
    margin = 0.4 * float(numpy.ptp(inner, axis=0).max())
    inner = numpy.array([numpy.maximum(inner[0] - margin, low), numpy.minimum(inner[1] + margin, high)])
    return inner if numpy.prod(numpy.ptp(inner, axis=0)) < 0.4 * numpy.prod(high - low) else numpy.array([low, high])


def in_plane(bodies, facets, side):
    """([facets, 3, 2], names of the axes) of facets in their mean plane; along the axes of the scene where it can be."""
    points, normal = bodies.points[facets], outward(bodies, side)
    along = [axis for axis in range(3) if axis != int(numpy.argmax(numpy.abs(normal)))]
    if numpy.abs(normal).max() > 0.94:
        return points[..., along], ["xyz"[axis] for axis in along]
    first = numpy.cross(normal, [0.0, 0.0, 1.0])
    first /= numpy.linalg.norm(first)
    return numpy.stack([points @ first, points @ numpy.cross(normal, first)], axis=-1), ["along the side", "across"]
