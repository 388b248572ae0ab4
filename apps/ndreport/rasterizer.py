"""Triangles in space as a picture: parallel projection, one light, hidden surfaces by a depth buffer. numpy only."""

import dataclasses

import numpy

OVERSAMPLING = 2
CHUNK = 150_000  # fragments at a time, so that they stay in the cache
MESH_LINE, FEATURE_LINE = 0.30, 0.85  # darkness
EDGE_COLOUR = numpy.array([0.07, 0.09, 0.12])


@dataclasses.dataclass(frozen=True)
class View:
    """An eye far away in direction `toward`; `right` and `up` span the picture."""

    toward: numpy.ndarray
    right: numpy.ndarray
    up: numpy.ndarray

    @staticmethod
    def from_direction(direction):
        toward = numpy.asarray(direction, float) / numpy.linalg.norm(direction)
        right = numpy.cross([0.0, 0.0, 1.0], toward)
        right = right / numpy.linalg.norm(right) if numpy.linalg.norm(right) > 1e-9 else numpy.array([1.0, 0.0, 0.0])
        return View(toward, right, numpy.cross(toward, right))

    def project(self, points):
        """[..., 3]: across, up, towards the eye."""
        return points @ numpy.stack([self.right, self.up, self.toward], axis=1)


@dataclasses.dataclass
class Picture:
    """RGBA [rows, columns, 4] of numbers in [0, 1], and where its borders are in the view: left, right, bottom, top."""

    pixels: numpy.ndarray
    extent: tuple


class Canvas:
    def __init__(self, low, high, columns):
        self.low, self.step = low, (high[0] - low[0]) / columns
        self.columns, self.rows = columns, max(1, int(numpy.ceil((high[1] - low[1]) / self.step)))
        self.depth = numpy.full(self.rows * self.columns, -numpy.inf)
        self.colour = numpy.zeros((self.rows * self.columns, 3))

    def place(self, projected):
        """Pixel coordinates of projected points."""
        return (projected[..., :2] - self.low) / self.step

    def take(self, pixel, depth, colour):
        """Puts fragments where nothing nearer is."""
        nearer = depth > self.depth[pixel]
        pixel, depth, colour = pixel[nearer], depth[nearer], colour[nearer]
        order = numpy.argsort(depth, kind="stable")  # the last of equal pixels stays
        self.depth[pixel[order]] = depth[order]
        self.colour[pixel[order]] = colour[order]


def render(corners, colours, lines, view, columns=900):
    """The picture of triangles.

    corners [n, 3, 3]: points, counter-clockwise from outside; colours [n, 3, 3]: red, green, blue at the corners;
    lines [n, 3]: how dark the edge opposite of each corner is, 0 for none.
    """
    projected = view.project(corners)
    flat = projected.reshape(-1, 3)
    low, high = flat.min(axis=0)[:2], flat.max(axis=0)[:2]
    margin = 0.015 * float(max(high - low))
    canvas = Canvas(low - margin, high + margin, columns * OVERSAMPLING)
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = numpy.linalg.norm(normals, axis=1)
    seen = (normals @ view.toward > 1e-9 * lengths) & (lengths > 0.0)
    normals = normals[seen] / lengths[seen, None]
    light = 0.45 * view.toward + 0.55 * view.up - 0.4 * view.right
    light /= numpy.linalg.norm(light)
    shade = 0.74 + 0.26 * numpy.clip(normals @ light, 0.0, 1.0)
    draw_triangles(canvas, projected[seen], colours[seen] * shade[:, None, None], lines[seen])
    return finished(canvas)


def draw_triangles(canvas, projected, colours, lines):
    """Row by row: the part of a pixel row inside a triangle lies between two of its three edges."""
    places = canvas.place(projected)
    area = (places[:, 1, 0] - places[:, 0, 0]) * (places[:, 2, 1] - places[:, 0, 1]) \
        - (places[:, 1, 1] - places[:, 0, 1]) * (places[:, 2, 0] - places[:, 0, 0])
    some = numpy.nonzero(area > 1e-9)[0]
    pieces = numpy.cumsum(area[some] + 2.0 * numpy.ptp(places[some], axis=1).sum(axis=1)) // CHUNK
    for piece in numpy.unique(pieces):
        draw_some(canvas, places, projected[..., 2], colours, lines, some[pieces == piece])


def weight_planes(places):
    """[n, 3 weights, 3]: each weight of a triangle is a x + b y + c."""
    matrix = numpy.concatenate([places.transpose(0, 2, 1), numpy.ones((len(places), 1, 3))], axis=1)
    return numpy.linalg.inv(matrix)


def draw_some(canvas, places, depths, colours, lines, some):
    planes = weight_planes(places[some])
    first = numpy.clip(numpy.floor(places[some, :, 1].min(axis=1)).astype(int), 0, canvas.rows)
    last = numpy.clip(numpy.ceil(places[some, :, 1].max(axis=1)).astype(int), 0, canvas.rows)
    of_row, row = counted(first, last - first)
    left, right = ends_of_rows(planes[of_row], row + 0.5)
    left = numpy.clip(numpy.ceil(left - 0.5), 0, canvas.columns).astype(int)
    right = numpy.clip(numpy.floor(right - 0.5) + 1, 0, canvas.columns).astype(int)
    row_of, column = counted(left, numpy.maximum(right - left, 0))
    place, row = of_row[row_of], row[row_of]
    triangle = some[place]
    weights = numpy.einsum("fkj,fj->fk", planes[place], numpy.stack([column + 0.5, row + 0.5, numpy.ones(len(row))], axis=1))
    depth = numpy.einsum("fk,fk->f", weights, depths[triangle])
    pixel = row * canvas.columns + column
    nearer = depth > canvas.depth[pixel]
    weights, triangle, pixel, depth, place = (a[nearer] for a in (weights, triangle, pixel, depth, place))
    colour = numpy.einsum("fk,fkc->fc", weights, colours[triangle])
    canvas.take(pixel, depth, with_lines(colour, weights, places[some], lines[some], place))


def counted(first, count):
    """(member, number): the numbers first, first + 1, ... of every member, one after the other."""
    member = numpy.repeat(numpy.arange(len(count)), count)
    before = numpy.cumsum(count) - count
    return member, first[member] + numpy.arange(len(member)) - before[member]


def ends_of_rows(planes, y):
    """Where on the line y all three weights are not negative."""
    slope, rest = planes[..., 0], planes[..., 1] * y[:, None] + planes[..., 2]
    with numpy.errstate(divide="ignore", invalid="ignore"):
        zero = -rest / slope
    left = numpy.where(slope > 0.0, zero, -numpy.inf).max(axis=1)
    right = numpy.where(slope < 0.0, zero, numpy.inf).min(axis=1)
    outside = ((slope == 0.0) & (rest < 0.0)).any(axis=1)
    return left, numpy.where(outside, left - 1.0, right)


def with_lines(colour, weights, places, lines, triangle):
    """Darkens what is nearer than a pixel to an edge that is drawn."""
    edges = numpy.stack([places[:, 2] - places[:, 1], places[:, 0] - places[:, 2], places[:, 1] - places[:, 0]], axis=1)
    area = edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0]
    heights = numpy.abs(area)[:, None] / numpy.maximum(numpy.linalg.norm(edges, axis=2), 1e-12)
    distance = weights * heights[triangle]
    width = numpy.where(lines >= FEATURE_LINE, 1.1, 0.55) * OVERSAMPLING / 2.0
    dark = numpy.where(distance < width[triangle], lines[triangle], 0.0).max(axis=1)
    return colour * (1.0 - dark[:, None]) + dark[:, None] * EDGE_COLOUR


def finished(canvas):
    """Draws the silhouettes, where the depth jumps, and takes the mean of the fine pixels."""
    depth = canvas.depth.reshape(canvas.rows, canvas.columns)
    colour = canvas.colour.reshape(canvas.rows, canvas.columns, 3)
    filled = numpy.isfinite(depth)
    jump = 0.02 * (numpy.ptp(depth[filled]) if filled.any() else 1.0)
    solid = numpy.where(filled, depth, -1e30)
    contour = numpy.zeros_like(filled)
    for axis in (0, 1):
        for step in (1, -1):
            contour |= filled & (solid - numpy.roll(solid, step, axis) > jump)
    colour[contour] = 0.25 * colour[contour] + 0.75 * EDGE_COLOUR
    rows = -(-canvas.rows // OVERSAMPLING) * OVERSAMPLING
    layers = numpy.zeros((rows, canvas.columns, 4))
    layers[: canvas.rows, :, :3] = colour * filled[..., None]
    layers[: canvas.rows, :, 3] = filled
    means = layers.reshape(rows // OVERSAMPLING, OVERSAMPLING, -1, OVERSAMPLING, 4).mean(axis=(1, 3))
    cover = means[..., 3:]
    means[..., :3] = numpy.divide(means[..., :3], cover, out=numpy.zeros_like(means[..., :3]), where=cover > 0.0)
    left, bottom = canvas.low
    return Picture(means[::-1], (left, left + canvas.columns * canvas.step, bottom, bottom + rows * canvas.step))
