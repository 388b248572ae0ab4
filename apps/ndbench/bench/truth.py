"""The true error of a run, without another solution: from the potential energy of the exact solution.

Let a(u,v) be the energy product (no 1/2), L the loads' work, K the displacements that meet the supports and the gap, u
the exact solution: the least J(v) = a(v,v)/2 - L(v) in K. Its contact traction t <= 0 satisfies t (w_u - g) = 0 and
a(u,v) = L(v) + int t w_v dS for every v that vanishes in the supported directions, w_v being the jump of its normal
displacements. Hence, for EVERY such v,

    |v - u|^2  =  2 J(v) - 2 J(u) - 2 int t (w_v - g) dS.                                                      (*)

Nothing is asked of v: neither that the sweeps have converged, nor the order of the elements, nor w_v <= g. So
  * a body alone, or everything closed (`punch`: w_v = g at all nodes, hence everywhere): the integral vanishes, the
    error is a difference of two numbers. After `Monolithic` without a gap 2 J(u_h) = -a(u_h,u_h): the familiar
    a(u,u) - a(u_h,u_h).
  * contact that ends inside: the integrand lives on the edge where it ends (first-order elements over a curved gap: on
    all edges). 2 J(v) - 2 J(u) alone is only an upper bound there, for v in K. The integral takes the stored
    pressure; it was at most 4 % of the squared error where it was looked at.

2 J(v) needs no loads: every body of a run is in finite element equilibrium, a(u_1,u_1) = L_1(u_1) + int t_1 u_1N dS and
a(u_2,u_2) = L_2(u_2) - int t_2 u_2N dS with the tractions t_1, t_2 of the contact table, so that

    2 J(v) = -a(v,v) + 2 int (t_1 u_1N - t_2 u_2N) dS.

Solids in contact are solved by `Monolithic`. Without a gap forces and openings are complementary, 2 J(v) = -a(v,v); with one
2 J(v) = a(v,v) - 2 L(v) is found from the displacements where they are pressed. Without a gap the integral in (*) is left out, and the error is an upper bound where contact ends
inside. With a gap the sides overlap between nodes, and J(v) on a coarse mesh is below J(u): the integral is taken at points of the
facets (overlap.py), with a pressure that depends on the distance from the axis alone (`hertz-3d`: to half a per cent).

Limits: supports that prescribe zero; plane scenes with one straight interface along x, solids with a gap round the axis z. 2 J(u) is
known up to a bracket (references.py), and with it the error.
"""

import bisect
import dataclasses
import math

# int psi_i psi_j over an edge, times SCALE / length, by the order.
MASS = {1: ((2, 1), (1, 2)), 2: ((4, 2, -1), (2, 16, 2), (-1, 2, 4))}
SCALE = {1: 6, 2: 30}
POINTS = 64  # of the midpoint rule on an edge where contact ends: the traction there has a root's behaviour


@dataclasses.dataclass(frozen=True)
class Exact:
    """What is known of the exact solution: 2 J(u) with low <= best <= high, |u|, and its pressure by position."""

    best: float
    low: float
    high: float
    norm: float
    pressure: tuple = ()  # of (x, t) with increasing x, of solids the distance from the axis; t <= 0

    def traction(self, x):
        at = bisect.bisect_right(self.pressure, (x, math.inf))
        if at in (0, len(self.pressure)):
            return self.pressure[min(at, len(self.pressure) - 1)][1]
        (a, left), (b, right) = self.pressure[at - 1], self.pressure[at]
        return left + (right - left) * (x - a) / (b - a)


@dataclasses.dataclass(frozen=True)
class TrueError:
    """|v - u| with low <= best <= high."""

    best: float
    low: float
    high: float

    @property
    def sharp(self):
        """Whether the reference is good enough for it: known to a quarter of itself."""
        return self.high - self.low <= 0.25 * self.best


def edges(contact, order):
    """The nodes of every edge of the interface, in order of x: (end, [middle,] end)."""
    nodes = sorted(contact, key=lambda node: node["x"])
    return [nodes[i : i + order + 1] for i in range(0, len(nodes) - 1, order)]


def work(contact, order, traction, displacement):
    """int t u dS of two columns of the contact table."""
    total = 0.0
    for edge in edges(contact, order):
        moments = (sum(m * node[displacement] for m, node in zip(row, edge)) for row in MASS[order])
        total += (edge[-1]["x"] - edge[0]["x"]) / SCALE[order] * sum(n[traction] * m for n, m in zip(edge, moments))
    return total


def twice_potential(run):
    """2 J(v) of a run's displacements."""
    if run.overlap:
        return run.summary["energy"] - 2 * run.overlap["work"]
    works = [work(run.contact, run.order, f"traction_{side}", f"u_{side}") for side in ("dirichlet", "neumann")]
    return -run.summary["energy"] + 2 * (works[0] - works[1])


def jump(edge, s):
    """w_v at the point s in [0, 1] of an edge."""
    values = [node["u_dirichlet"] - node["u_neumann"] for node in edge]
    if len(values) == 2:
        return values[0] * (1 - s) + values[1] * s
    return values[0] * (1 - s) * (1 - 2 * s) + values[1] * 4 * s * (1 - s) + values[2] * s * (2 * s - 1)


def contact_term(run, gap, exact):
    """2 int t (w_v - g) dS with the exact traction."""
    if run.overlap:
        return 2 * sum(exact.traction(math.hypot(x, y)) * part for x, y, part in run.overlap["points"])
    total = 0.0
    for edge in edges(run.contact, run.order):
        a, length = edge[0]["x"], edge[-1]["x"] - edge[0]["x"]
        if exact.traction(a) == exact.traction(a + length) == 0:
            continue
        for s in ((i + 0.5) / POINTS for i in range(POINTS)):
            total += exact.traction(a + s * length) * (jump(edge, s) - gap(a + s * length)) * length / POINTS
    return 2 * total


def true_error(run, gap, exact):
    value = twice_potential(run) - contact_term(run, gap, exact)
    return TrueError(*(math.sqrt(max(value - potential, 0.0)) for potential in (exact.best, exact.high, exact.low)))
