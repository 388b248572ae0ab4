"""The meshes of decks/punch.xml as a gmsh file (format 2.2), to time the reading of one."""

REGIONS = {"foundation": 1, "punch": 2}
SIDES = {"bottom": 3, "left": 4, "contact": 5, "top": 6}


class Grid:
    """Squares cut into triangles; nodes are numbered row by row from `first`."""

    def __init__(self, region, corner, columns, rows, first):
        self.region, self.corner, self.columns, self.rows, self.first = region, corner, columns, rows, first
        self.count = (columns + 1) * (rows + 1)

    def node(self, column, row):
        return self.first + row * (self.columns + 1) + column

    def points(self, size):
        x, y = self.corner
        places = [(i, j) for j in range(self.rows + 1) for i in range(self.columns + 1)]
        return [f"{self.node(i, j)} {x + i * size!r} {y + j * size!r} 0" for i, j in places]

    def triangles(self):
        tag = REGIONS[self.region]
        for j in range(self.rows):
            for i in range(self.columns):
                a, b, c, d = self.node(i, j), self.node(i + 1, j), self.node(i + 1, j + 1), self.node(i, j + 1)
                yield f"2 2 {tag} {tag} {a} {b} {c}"
                yield f"2 2 {tag} {tag} {a} {c} {d}"

    def row(self, side, row, columns):
        return [f"1 2 {SIDES[side]} {SIDES[side]} {self.node(i, row)} {self.node(i + 1, row)}" for i in range(columns)]

    def left(self):
        tag = SIDES["left"]
        return [f"1 2 {tag} {tag} {self.node(0, j)} {self.node(0, j + 1)}" for j in range(self.rows)]


def write_punch(path, cells):
    """`cells` x `cells` squares of the punch on twice as many of the foundation."""
    foundation = Grid("foundation", (0.0, -1.0), 2 * cells, cells, 1)
    punch = Grid("punch", (0.0, 0.0), cells, cells, 1 + foundation.count)
    points = [*foundation.points(1.0 / cells), *punch.points(1.0 / cells)]
    elements = [
        *foundation.row("bottom", 0, 2 * cells), *foundation.row("contact", cells, cells), *foundation.left(),
        *punch.row("contact", 0, cells), *punch.row("top", cells, cells), *punch.left(),
        *foundation.triangles(), *punch.triangles(),
    ]
    names = [f'{2 if name in REGIONS else 1} {tag} "{name}"' for name, tag in {**REGIONS, **SIDES}.items()]
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames",
            "$Nodes", str(len(points)), *points, "$EndNodes",
            "$Elements", str(len(elements)), *(f"{i} {line}" for i, line in enumerate(elements, 1)), "$EndElements"]
    path.write_text("\n".join(text) + "\n")
