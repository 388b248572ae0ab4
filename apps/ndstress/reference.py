"""The same scenes solved by other means: dense elimination in long double numbers, both bodies at once.

Nothing of ndframe is used, and nothing is fast: some hundred dofs a body. A long double has 18 to 19 digits, so what
ndframe loses to round-off shows. The answer is accepted only if it satisfies the conditions of contact, which determine
it; how it was found does not matter then.
"""

import dataclasses

import numpy as np

REAL = np.longdouble
PIVOT = 1e-15  # of its diagonal entry: below it the system does not hold the bodies


class Unheld(Exception):
    """The contact that is left does not hold a body: the load pulls it off."""


@dataclasses.dataclass(frozen=True)
class Answer:
    """points, u_upper, u_lower, force: per contact node sorted by x; force on the upper body, positive in pressure;
    energies: a(u,u) of the upper and of the lower body; load: the largest nodal force of loads and contact;
    move: the largest displacement or gap."""
    points: np.ndarray
    u_upper: np.ndarray
    u_lower: np.ndarray
    force: np.ndarray
    energies: tuple
    load: float
    move: float


def eliminate(A, B):
    """A^-1 B for symmetric positive definite A."""
    A, B = A.copy(), B.copy()
    diagonal, n = np.diag(A).copy(), len(A)
    for k in range(n):
        if not A[k, k] > PIVOT * diagonal[k]:
            raise Unheld
        factors = A[k + 1:, k] / A[k, k]
        A[k + 1:, k + 1:] -= np.outer(factors, A[k, k + 1:])
        B[k + 1:] -= np.outer(factors, B[k])
    for k in reversed(range(n)):
        B[k] = (B[k] - A[k, k + 1:] @ B[k + 1:]) / A[k, k]
    return B


def polynomial(coefficients, x):
    return sum(REAL(c) * x ** k for k, c in enumerate(coefficients))


class _Elements:
    """Nodes and shape functions of degree 1 or 2 on a body's triangles."""

    def __init__(self, mesh, order):
        self.order, self.nodes = order, [tuple(map(REAL, p)) for p in mesh.points]
        self.middle = {}
        self.cells = [tuple(c) + (self._middles(c) if order == 2 else ()) for c in mesh.cells]

    def _middles(self, cell):
        return tuple(self.between(cell[a], cell[b]) for a, b in ((0, 1), (1, 2), (2, 0)))

    def between(self, a, b):
        key = (min(a, b), max(a, b))
        if key not in self.middle:
            self.middle[key] = len(self.nodes)
            self.nodes.append(tuple((p + q) / 2 for p, q in zip(self.nodes[a], self.nodes[b])))
        return self.middle[key]

    def edge_nodes(self, edge):
        return tuple(edge) + ((self.between(*edge),) if self.order == 2 else ())

    def gradients(self, cell):
        """Area of a cell and the shape functions' gradients at its mid-edge points, where degree 2 is integrated."""
        x = np.array([self.nodes[v] for v in cell[:3]])
        e = x[[2, 0, 1]] - x[[1, 2, 0]]
        area = (e[2][0] * -e[1][1] + e[2][1] * e[1][0]) / 2
        slope = np.stack([-e[:, 1], e[:, 0]], axis=1) / (2 * area)
        if self.order == 1:
            return area, [slope]
        found = []
        for at in np.array([[1, 1, 0], [0, 1, 1], [1, 0, 1]], dtype=REAL) / 2:
            corners = (4 * at - 1)[:, None] * slope
            mids = [4 * (at[a] * slope[b] + at[b] * slope[a]) for a, b in ((0, 1), (1, 2), (2, 0))]
            found.append(np.vstack([corners, mids]))
        return area, found


def stiffness(elements, body):
    """K for plane strain, 2 dofs a node."""
    E, nu = REAL(body.young), REAL(body.poisson)
    mu, lam = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
    D = np.array([[lam + 2 * mu, lam, 0], [lam, lam + 2 * mu, 0], [0, 0, mu]], dtype=REAL)
    K = np.zeros((2 * len(elements.nodes),) * 2, dtype=REAL)
    for cell in elements.cells:
        area, points = elements.gradients(cell)
        dofs = [2 * v + k for v in cell for k in (0, 1)]
        for slope in points:
            B = np.zeros((3, len(dofs)), dtype=REAL)
            B[0, 0::2], B[1, 1::2], B[2, 0::2], B[2, 1::2] = slope[:, 0], slope[:, 1], slope[:, 1], slope[:, 0]
            K[np.ix_(dofs, dofs)] += area / len(points) * (B.T @ D @ B)
    return K


def gauss():
    """Four points on [0, 1] with their weights: exact to degree 7."""
    inner, outer = (np.sqrt(REAL(3) / 7 + sign * REAL(2) / 7 * np.sqrt(REAL(6) / 5)) for sign in (-1, 1))
    most, least = ((18 + sign * np.sqrt(REAL(30))) / 72 for sign in (1, -1))
    return [(s, w) for r, w in ((inner, most), (outer, least)) for s in ((1 - r) / 2, (1 + r) / 2)]


def load(elements, body, origin):
    """Nodal forces of the pressures."""
    f = np.zeros(2 * len(elements.nodes), dtype=REAL)
    rule = gauss()
    for side, coefficients in body.pressures.items():
        for edge in body.mesh.sides[side]:
            a, b = (np.array(elements.nodes[v]) for v in edge)
            inward = np.array([a[1] - b[1], b[0] - a[0]])  # times the length; the body is on the left
            for s, w in rule:
                N = (1 - s, s) if elements.order == 1 else ((1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s))
                p = polynomial(coefficients, a[0] + s * (b[0] - a[0]) - REAL(origin))
                for node, value in zip(elements.edge_nodes(edge), N):
                    f[2 * node:2 * node + 2] += w * value * p * inward
    return f


class _Half:
    """One body condensed to the vertical displacements of its contact nodes."""

    def __init__(self, body, side, scene):
        elements = _Elements(body.mesh, scene.order)
        self.K, self.f = stiffness(elements, body), load(elements, body, scene.origin)
        self.u = np.zeros(len(self.f), dtype=REAL)
        given = {2 * v + axis: value for name, values in body.supports.items() for edge in body.mesh.sides[name]
                 for v in elements.edge_nodes(edge) for axis, value in values.items()}
        for dof, value in given.items():
            self.u[dof] = value
        nodes = sorted({v for edge in body.mesh.sides[side] for v in elements.edge_nodes(edge)},
                       key=lambda v: elements.nodes[v][0])
        self.points = np.array([elements.nodes[v][0] for v in nodes])
        self.contact = [2 * v + 1 for v in nodes]
        self.given = [dof in given for dof in self.contact]
        self.free = [i for i in range(len(self.f)) if i not in given]

    def condense(self, kept):
        self.kept = [self.contact[i] for i in kept]
        self.inner = sorted(set(self.free) - set(self.kept))
        rhs = self.f - self.K @ self.u
        coupling = self.K[np.ix_(self.inner, self.kept)]
        solved = eliminate(self.K[np.ix_(self.inner, self.inner)], np.column_stack([coupling, rhs[self.inner]]))
        self.X, self.x = solved[:, :-1], solved[:, -1]
        self.S = self.K[np.ix_(self.kept, self.kept)] - coupling.T @ self.X
        self.g = rhs[self.kept] - coupling.T @ self.x

    def recover(self, normal):
        self.u[self.kept] = normal
        self.u[self.inner] = self.x - self.X @ normal
        bent = self.u.copy()  # without the translation, whose round-off would drown the energy of a stiff body
        for axis in (0, 1):
            bent[axis::2] -= bent[axis::2].mean()
        return bent @ self.K @ bent


def _closed_set(A, b, n):
    """Jump (<= 0) and the rest of the unknowns; the force on closed nodes is b - A v >= 0 along the jump."""
    closed, visited, one_at_a_time = np.ones(n, dtype=bool), set(), False
    while True:
        free = np.append(~closed, np.ones(len(b) - n, dtype=bool))
        v = np.zeros(len(b), dtype=REAL)
        v[free] = eliminate(A[np.ix_(free, free)], b[free, None])[:, 0]
        force = np.where(closed, (b - A @ v)[:n], 0)
        wrong = np.where(closed, force < -1e-16 * np.abs(b).max(), v[:n] > 1e-16 * np.abs(v).max())
        if not wrong.any():
            return v, force
        one_at_a_time = one_at_a_time or closed.tobytes() in visited
        visited.add(closed.tobytes())
        closed[np.flatnonzero(wrong)[:1] if one_at_a_time else wrong] ^= True


def solve(scene):
    """The Answer; raises Unheld when nothing holds a body."""
    upper, lower = _Half(scene.upper, "bottom", scene), _Half(scene.lower, "contact", scene)
    kept = [i for i, pair in enumerate(zip(upper.given, lower.given)) if not any(pair)]
    upper.condense(kept)
    lower.condense(kept)
    gap = polynomial(scene.gap, upper.points - REAL(scene.origin)) + np.zeros(len(upper.points), dtype=REAL)
    g, n = gap[kept], len(kept)
    # Unknowns: d = (lower - upper) - gap <= 0 and the lower displacement y; upper = y - d - g.
    pushed = upper.g + upper.S @ g
    A = np.block([[upper.S, -upper.S], [-upper.S, upper.S + lower.S]])
    v, force = _closed_set(A, np.concatenate([-pushed, pushed + lower.g]), n)
    energies = upper.recover(v[n:] - v[:n] - g), lower.recover(v[n:])
    full = np.zeros(len(upper.points), dtype=REAL)
    full[kept] = force
    largest = max(np.abs(values).max(initial=0) for values in (force, upper.f, lower.f))
    return Answer(upper.points, upper.u[upper.contact], lower.u[lower.contact], full, energies, largest,
                  max(np.abs(values).max() for values in (upper.u, lower.u, gap)))
