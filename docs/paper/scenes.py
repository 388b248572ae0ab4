"""The two scenes of the paper as variants of our decks, what the paper prints about them, and runs of ndframe.

The paper gives neither dimensions nor materials nor meshes: those of decks/punch.xml and decks/contact-loss.xml are used, and boxes
of cells cut by alternating diagonals. On the punch cells get finer towards the end of contact, where the stress is singular.
"""

import dataclasses
import functools
import json
import pathlib
import subprocess
import tempfile

import netCDF4
import numpy

DECKS = pathlib.Path(__file__).resolve().parents[2] / "decks"


class Run:
    """What one run of the program leaves: the summary, the Exodus file and the contact table."""

    def __init__(self, ndframe, deck, settings):
        arguments = [part for setting in settings for part in ("--set", setting)]
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([ndframe, "-q", "-i", deck, *arguments], cwd=folder, capture_output=True, text=True)
            if run.returncode != 0:
                raise SystemExit(f"ndframe returned {run.returncode} on {deck} with {settings}:\n{run.stderr}")
            files = pathlib.Path(folder)
            self.summary = json.loads(next(files.glob("*.summary.json")).read_text())
            self.exodus = netCDF4.Dataset("memory", memory=next(files.glob("*.e")).read_bytes())
            self.contact = numpy.genfromtxt(next(files.glob("*.contact.csv")), delimiter=",", names=True, dtype=None, encoding=None)

    @property
    def errors(self):
        return self.summary["errors"]

    @property
    def dofs(self):
        return sum(body["dofs"] for body in self.summary["bodies"])

    def bodies(self, name):
        """For every body: coordinates, triangles by their corners, and the element field `name`."""
        names = [b"".join(row.compressed()).decode() for row in self.exodus["name_elem_var"][:]]
        points = numpy.stack([self.exodus[f"coord{axis}"][:].data for axis in "xy"])
        for block in range(1, len(self.summary["bodies"]) + 1):
            values = self.exodus[f"vals_elem_var{names.index(name) + 1}eb{block}"][-1].data
            yield points, self.exodus[f"connect{block}"][:, :3].data - 1, values


@dataclasses.dataclass(frozen=True)
class Scene:
    """A deck whose meshes follow from n, the number of cells along the interface."""

    deck: str
    meshes: callable
    settings: tuple = ()

    def run(self, ndframe, n, *settings):
        return Run(ndframe, DECKS / self.deck, [*self.meshes(n), *self.settings, *settings])

    @functools.cache
    def norm(self, ndframe):
        """Energy norm of the solution: its square is right to 2e-4, far more than the tables show."""
        return self.run(ndframe, 32, "Coupling/Type=Monolithic").summary["energy"] ** 0.5


def boxes(upper, lower):
    """Cells of two boxes, cut by alternating diagonals."""
    for body, cells in (upper, lower):
        yield f"Bodies/{body}/Mesh/Cells={{{cells[0]}, {cells[1]}}}"
        yield f"Bodies/{body}/Mesh/Pattern=Alternating"


def sizes(body, axis, places, values):
    yield f"Bodies/{body}/Mesh/Cell Sizes {axis}/At={{{', '.join(map(str, places))}}}"
    yield f"Bodies/{body}/Mesh/Cell Sizes {axis}/Size={{{', '.join(map(str, values))}}}"


def punch_meshes(n):
    yield from boxes(("punch", (n, n)), ("foundation", (2 * n, n)))
    yield from sizes("punch", "X", (0.0, 1.0), (1.0, 0.5))
    yield from sizes("punch", "Y", (0.0, 1.0), (0.5, 1.0))
    yield from sizes("foundation", "X", (0.0, 1.0, 2.0), (1.0, 0.5, 1.0))
    yield from sizes("foundation", "Y", (-1.0, 0.0), (1.0, 0.5))


def contact_loss_meshes(n):
    return boxes(("upper", (n, round(0.8 * n))), ("lower", (2 * n, 2 * n)))


PUNCH = Scene("punch.xml", punch_meshes)
# Where contact ends is known to a cell only, and the coarsest cells are large.
CONTACT_LOSS = Scene("contact-loss.xml", contact_loss_meshes, ("Expect/contact ends near 0.957/Tolerance=0.25",))

# Tables 1 to 3 as printed, errors times 100.
PRINTED = {
    "table1": {
        "ndof": (114, 230, 446, 734, 1484, 2992, 5864),
        "glob": (10.7, 7.59, 6.50, 5.52, 4.96, 4.61, 4.39),
        "dis": (9.89, 6.59, 5.34, 4.04, 3.05, 2.32, 1.65),
        "nda": (4.02, 4.06, 4.06, 4.07, 4.07, 4.08, 4.08),
        "e_ref": (10.1, 6.99, 6.12, 5.29, 4.80, 4.39, 4.09),
    },
    "table2": {
        "ndof": (712, 1510, 1850, 3390, 5534, 6800),
        "glob": (9.348, 7.978, 5.981, 5.146, 4.576, 4.406),
        "dis": (8.442, 6.737, 4.222, 2.880, 1.706, 1.394),
        "nda": (4.156, 4.263, 4.263, 4.266, 4.255, 4.243),
    },
    "table3": {
        "tolerance": (2e-1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-8),
        "sweeps": (4, 5, 9, 11, 15, 28),
        "glob": (9.348, 8.804, 8.657, 8.657, 8.657, 8.657),
        "dis": (8.442, 8.546, 8.653, 8.656, 8.657, 8.657),
        "nda": (4.156, 2.279, 0.3812, 0.2237, 0.0593, 0.0066),
    },
}
PUNCH_CELLS = (2, 3, 4, 5, 8, 11, 15)
CONTACT_LOSS_CELLS = (4, 6, 8, 10, 12, 14)
