"""Bodies of an Exodus file as triangles to be drawn: where they are, how far they move, what they carry."""

import dataclasses
import math

import ndframe
import numpy

# Facets of a tetrahedron, by its local vertices in an order that points outwards, and its node in the middle of two vertices.
FACETS = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
MIDDLE = {(0, 1): 4, (1, 2): 5, (0, 2): 6, (0, 3): 7, (1, 3): 8, (2, 3): 9}
NOT_SEEN = 0.002  # of the scene's diagonal
TRIANGLE_MIDDLE = {(0, 1): 3, (1, 2): 4, (0, 2): 5}


@dataclasses.dataclass
class Piece:
    """What is drawn of one element block. In the plane its triangles are its cells, in space its outside.

    `nodes` [triangles, 3 or 6]: vertices, then the nodes between them, numbers of the file; `owner`: their element in
    the block. `body` is the body's number in the summary.
    """

    name: str
    body: int
    nodes: numpy.ndarray
    owner: numpy.ndarray
    rigid: bool

    def parts(self):
        """(small triangles [n, 3], their triangle, which of their three edges belong to the mesh [n, 3])."""
        count = len(self.nodes)
        if self.nodes.shape[1] == 3:
            return self.nodes, numpy.arange(count), numpy.ones((count, 3), bool)
        corners = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
        # edge k lies opposite of vertex k
        on_mesh = ((False, True, True), (True, False, True), (True, True, False), (False, False, False))
        small = numpy.concatenate([self.nodes[:, c] for c in corners])
        return small, numpy.tile(numpy.arange(count), 4), numpy.repeat(numpy.array(on_mesh), count, axis=0)


class Bodies:
    """Points, displacements and fields of the last step of a run."""

    def __init__(self, results):
        self.fields, self.names = results.fields, [body["name"] for body in results.summary["bodies"]]
        self.decks = results.deck["Bodies"]
        self.points = self.fields.points
        self.dim = self.points.shape[1]
        self.displacement = self.fields.displacement
        self.offset = self.fields.vector("offset") if "offset_x" in self.fields.names("nodal") else None
        self.pieces = [self.piece(name) for name in self.fields.blocks]
        self.contact = results.contact

    def element(self, name, piece):
        """Values of the block's elements; None where there are none."""
        try:
            return self.fields.element(name, piece.name)
        except ndframe.ReadError:
            return None

    def piece(self, name):
        body, cells = self.body_of(name), self.fields.nodes(name)
        rigid = "Rigid" in self.decks.get(self.names[body], {})
        if self.dim == 2:
            return Piece(name, body, oriented(self.points, cells), numpy.arange(len(cells)), rigid)
        nodes, owner = outside(cells)
        return Piece(name, body, nodes, owner, rigid)

    def body_of(self, block):
        fits = [i for i, name in enumerate(self.names) if block == name or block.startswith(name + ":")]
        return max(fits, key=lambda i: len(self.names[i]))

    def elastic(self):
        return [piece for piece in self.pieces if not piece.rigid]

    def facet_values(self, side, name):
        """Values on a side's facets, None where there are none."""
        try:
            return self.fields.on_facets(name, side)
        except ndframe.ReadError:
            return None

    def size(self):
        """Diagonal of the box around the elastic bodies."""
        used = numpy.unique(numpy.concatenate([piece.nodes.ravel() for piece in self.elastic()]))
        return float(numpy.linalg.norm(numpy.ptp(self.points[used], axis=0)))

    def stress_at_nodes(self, piece):
        """von Mises stress at the nodes: the file's, except where blocks meet and values of two materials were mixed."""
        values = self.fields.nodal("von_mises")
        shared = numpy.zeros(len(self.points), int)
        for block in self.fields.blocks:
            shared[numpy.unique(self.fields.nodes(block))] += 1
        own = self.fields.nodes(piece.name)
        border = numpy.unique(own)
        border = border[shared[border] > 1]
        if border.size and (cells := self.element("von_mises", piece)) is not None:
            total, count = numpy.zeros(len(values)), numpy.zeros(len(values))
            numpy.add.at(total, own, cells[:, None])
            numpy.add.at(count, own, 1.0)
            values[border] = total[border] / count[border]
        return values

    def moved(self, scale):
        """Where the nodes are drawn with displacements `scale` times: bodies that touch are drawn touching.

        A Gap that stands in the deck and not in the mesh is `offset`. Where displacements are enlarged together with it,
        the openings are, too, and closed nodes meet; `scale.gaps` says so.
        """
        moved = self.points + scale.factor * self.displacement
        if self.offset is not None:
            moved += (scale.factor if scale.gaps else 1.0) * self.offset
        return moved


@dataclasses.dataclass(frozen=True)
class Scale:
    factor: float
    gaps: bool  # openings are enlarged, too

    def words(self):
        if self.factor == 1.0:
            return "displacements and gaps true to scale"
        return f"displacements {'and gaps ' if self.gaps else ''}multiplied by {self.factor:g}"


def choose_scale(bodies):
    """Shows displacements, about a twentieth of the scene, unless bodies that touch would be drawn overlapping or apart.

    Between bodies that are drawn apart (distance g), closed nodes lie g (1 - factor) apart in the picture; bodies that slip on
    each other overlap by about the square of the factor. What is not seen is NOT_SEEN of the scene.
    """
    size = bodies.size()
    moved = numpy.unique(numpy.concatenate([piece.nodes.ravel() for piece in bodies.elastic()]))
    if not bodies.displacement[moved].any():
        return Scale(1.0, False)
    if bodies.offset is not None:
        largest = float(numpy.linalg.norm(bodies.displacement + bodies.offset, axis=1).max())
        wanted = nice_below(0.06 * size / largest)
        if wanted >= 1.0:
            return Scale(wanted, wanted != 1.0)
    largest = float(numpy.linalg.norm(bodies.displacement[moved], axis=1).max())
    factor, gaps = nice_below(0.06 * size / largest), drawn_gaps(bodies)
    wrong = lambda: max(apart(gaps, factor), drawn_overlap(bodies, bodies.moved(Scale(factor, False)))) > NOT_SEEN * size
    true_to_scale = apart(gaps, 0.0) > NOT_SEEN * size and largest < 0.3 * size
    least = 1.0 if true_to_scale or factor >= 1.0 else 0.1 * factor
    while factor > least and wrong():
        factor = nice_below(factor / 1.9)
    return Scale(max(factor, least), False)


def drawn_gaps(bodies):
    """[nodes, 2]: distance before and after loading, of all nodes of the interfaces."""
    rows = [numpy.stack([numpy.array(t["gap"]) + t["u_dirichlet"] - numpy.array(t["u_neumann"]), t["gap"]], axis=1)
            for t in bodies.contact.values()]
    return numpy.concatenate(rows) if rows else numpy.zeros((0, 2))


def apart(gaps, factor):
    """How far apart, or how deep in each other, nodes that touch are drawn."""
    before, after = gaps.T
    closed = after <= 1e-9 * numpy.abs(before).max(initial=0.0)
    return float(numpy.abs(before[closed] * (1.0 - factor)).max(initial=0.0))


def drawn_overlap(bodies, points):
    """How deep the sides of plane interfaces lie in each other when their nodes are drawn at these points."""
    deepest = 0.0
    names = [name[: -len(":dirichlet")] for name in bodies.fields.sides if name.endswith(":dirichlet")] if bodies.dim == 2 else []
    for name in names:
        sides = [points[bodies.fields.facets(f"{name}:{side}")] for side in ("dirichlet", "neumann")]
        for one, other in (sides, sides[::-1]):
            some = one[:: max(1, len(one) // 500), 0]
            deepest = max(deepest, depth_below(some, other))
    return deepest


def depth_below(nodes, facets):
    """The largest distance of a node from its nearest facet against the facet's outward normal; ends do not count."""
    along = facets[:, 1] - facets[:, 0]
    lengths = numpy.maximum(numpy.linalg.norm(along, axis=1), 1e-300)
    normals = numpy.stack([along[:, 1], -along[:, 0]], axis=1) / lengths[:, None]
    difference = nodes[:, None] - facets[None, :, 0]
    place = numpy.einsum("nfk,fk->nf", difference, along) / lengths**2
    foot = facets[None, :, 0] + numpy.clip(place, 0.0, 1.0)[..., None] * along[None]
    nearest = numpy.linalg.norm(nodes[:, None] - foot, axis=2).argmin(axis=1)
    row = numpy.arange(len(nodes))
    height = numpy.einsum("nk,nk->n", difference[row, nearest], normals[nearest])
    above = (place[row, nearest] > 0.0) & (place[row, nearest] < 1.0)
    return float(numpy.max(-height[above], initial=0.0))


def nice_below(value):
    """The largest of 1, 2, 5, 10, ... that is not above the value."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(digit * power for digit in (5.0, 2.0, 1.0) if digit * power <= value * (1.0 + 1e-12))


def oriented(points, nodes):
    """Plane cells with their vertices counter-clockwise."""
    if len(nodes) == 0:
        return nodes
    a, b, c = (points[nodes[:, k]] for k in range(3))
    turned = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] < 0.0
    nodes = nodes.copy()
    order = [0, 2, 1] + ([5, 4, 3] if nodes.shape[1] == 6 else [])
    nodes[turned] = nodes[turned][:, order]
    return nodes


def outside(cells):
    """(nodes [triangles, 3 or 6], cell) of the facets that one tetrahedron of the block has alone."""
    triangles = []
    for facet in FACETS:
        columns = list(facet)
        if cells.shape[1] == 10:
            pairs = ((0, 1), (1, 2), (0, 2))
            columns += [MIDDLE[tuple(sorted((facet[i], facet[j])))] for i, j in pairs]
        triangles.append(cells[:, columns])
    triangles = numpy.concatenate(triangles)
    owner = numpy.tile(numpy.arange(len(cells)), len(FACETS))
    _, first, count = numpy.unique(numpy.sort(triangles[:, :3], axis=1), axis=0, return_index=True, return_counts=True)
    alone = numpy.sort(first[count == 1])
    return triangles[alone], owner[alone]


def boundary_edges(piece):
    """[edges, 2 or 3] of a plane block's outline: two vertices, and the node between them."""
    corners = ((0, 1), (1, 2), (0, 2))
    columns = [[i, j] + ([TRIANGLE_MIDDLE[(i, j)]] if piece.nodes.shape[1] == 6 else []) for i, j in corners]
    edges = numpy.concatenate([piece.nodes[:, c] for c in columns])
    _, first, count = numpy.unique(numpy.sort(edges[:, :2], axis=1), axis=0, return_index=True, return_counts=True)
    return edges[first[count == 1]]


def mesh_edges(piece):
    """All edges of a plane block once."""
    edges = numpy.concatenate([piece.nodes[:, c] for c in ([0, 1], [1, 2], [0, 2])])
    return numpy.unique(numpy.sort(edges, axis=1), axis=0)
