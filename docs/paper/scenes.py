"""The two scenes of the paper, what the paper prints about them, and runs of ndframe.

The paper gives neither dimensions nor materials nor meshes: those of decks/punch.xml and decks/contact-loss.xml are used, and boxes
of cells cut by alternating diagonals. The decks table1.xml, ... are studies of these scenes, one for each table.
"""

import csv
import dataclasses
import functools
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[1] / "python"))
from ndframe import run as run_deck  # noqa: E402


def call(ndframe, deck, folder, *arguments):
    run = subprocess.run([ndframe, "-q", "-i", deck, *arguments], cwd=folder, capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"ndframe returned {run.returncode} on {deck} with {arguments}:\n{run.stderr}")


def settings(entries):
    return [part for entry in entries for part in ("--set", entry)]


def study(ndframe, table, *arguments):
    """The rows of a study's table, each by the names of its columns; arguments change the deck."""
    with tempfile.TemporaryDirectory() as folder:
        call(ndframe, HERE / f"{table}.xml", folder, *arguments)
        with open(pathlib.Path(folder) / f"{table}.study.csv", newline="") as rows:
            return list(csv.DictReader(rows))


class Run:
    """What one run of the program leaves: the summary, the fields and the table of the one interface, in order of x."""

    def __init__(self, program, deck, entries):
        with tempfile.TemporaryDirectory() as folder:
            run = run_deck(deck, dict(entry.split("=", 1) for entry in entries), folder=folder, program=program)
            self.summary, self.fields, (table,) = run.summary, run.fields, run.contact.values()
        order = numpy.argsort(table["x"])
        self.contact = {column: values[order] for column, values in table.items()}

    def bodies(self, name):
        """For every body: coordinates, triangles by their corners, and the element field `name`."""
        for block in self.fields.blocks:
            yield self.fields.points.T, self.fields.triangles(block), self.fields.element(name, block)


@dataclasses.dataclass(frozen=True)
class Scene:
    """The scene of a table. Its meshes follow from n, the number of cells along the interface: body -> cells."""

    table: str
    cells: callable

    def run(self, ndframe, n, *entries):
        """One run of the table's deck without its study and certificate."""
        deck = xml.etree.ElementTree.parse(HERE / f"{self.table}.xml")
        for name in ("Study", "Error Estimation"):
            deck.getroot().remove(deck.find(f"ParameterList[@name='{name}']"))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"{self.table}.xml"
            deck.write(path)
            meshes = [f"Bodies/{body}/Mesh/Cells={{{x}, {y}}}" for body, (x, y) in self.cells(n).items()]
            return Run(ndframe, path, [*meshes, *entries])

    @functools.cache
    def norm(self, ndframe):
        """Energy norm of the solution: its square is right to 2e-4, far more than the tables show."""
        return self.run(ndframe, 32, "Coupling/Type=Monolithic").summary["energy"] ** 0.5

    def mesh_axis(self, cells, refinements):
        """The axis of meshes for --study: other numbers of cells, all with the same reference."""
        bodies = self.cells(cells[0])
        sizes = lambda body: "; ".join("{%d, %d}" % self.cells(n)[body] for n in cells)
        axes = [f"Bodies/{body}/Mesh/Cells={sizes(body)}" for body in bodies]
        halvings = "; ".join([str(refinements)] * len(cells))
        return " && ".join([*axes, f"Error Estimation/Reference/Refinements={halvings}"])


PUNCH = Scene("table1", lambda n: {"punch": (n, n), "foundation": (2 * n, n)})
CONTACT_LOSS = Scene("table2", lambda n: {"upper": (n, round(0.8 * n)), "lower": (2 * n, 2 * n)})

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
