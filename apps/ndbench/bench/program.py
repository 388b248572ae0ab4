"""Runs of ndframe: what they cost and what they found."""

import csv
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

from bench.child import Cost, cost_of

# A run that is not converged (exit 3) has a true error like any other.
USABLE = (0, 3)
# Of the decks: expectations are about the decks' own meshes, and methods say what is certified.
LEFT_OUT = ("Error Estimation", "Expect")


@dataclasses.dataclass(frozen=True)
class Run:
    """One run: its cost, its summary, and the rows of its contact table (dictionaries of numbers)."""

    cost: Cost
    summary: dict
    contact: list
    overlap: dict | None = None  # {work, points} of solids with a gap (overlap.py)

    @property
    def dofs(self):
        return sum(body["dofs"] for body in self.summary["bodies"])

    @property
    def order(self):
        return self.summary["bodies"][0]["order"]

    @property
    def stages(self):
        """Seconds by stage, in the order in which they ran."""
        return {stage["name"]: stage["seconds"] for stage in self.summary["ledger"]["stages"]}

    @property
    def total_seconds(self):
        """Of the program, without the start and the exit of the process."""
        return self.summary["ledger"]["total_seconds"]

    @property
    def solving_seconds(self):
        """The same without reading and writing files."""
        return self.total_seconds - self.stages["read"] - self.stages["write"]

    @property
    def sweeps(self):
        """Of all levels; None for a body alone."""
        coupling = self.summary["coupling"]
        return (self.summary["accuracy"] or coupling)["sweeps"] if coupling else None

    @property
    def twice_energy(self):
        """The guaranteed bracket of 2 J(u), by all certificates of the run; None without one."""
        bracket = (self.summary["errors"] or {}).get("energy_bracket")
        return bracket and (2 * bracket["lower"], 2 * bracket["upper"])

    @property
    def bound(self):
        """The bound of the error in energy; None without a certificate, or where it is not guaranteed."""
        bound = (self.summary["errors"] or {}).get("global")
        return bound["absolute"] if bound and bound["guaranteed"] else None


def contact_rows(path):
    with open(path, newline="") as table:
        rows = csv.DictReader(table)
        return [{key: float(value) for key, value in row.items() if key != "interface"} for row in rows]


def overlap_of(contact, folder):
    """Of solids with a gap; None of others."""
    if not any("z" in row and row["gap"] > 0 for row in contact):
        return None
    script = pathlib.Path(__file__).with_name("overlap.py")
    done = subprocess.run([sys.executable, script, folder], stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout)


def bare(deck, folder):
    """A copy of the deck in `folder`, without the lists LEFT_OUT."""
    lists = xml.etree.ElementTree.parse(deck)
    for entry in [entry for entry in lists.getroot() if entry.get("name") in LEFT_OUT]:
        lists.getroot().remove(entry)
    path = pathlib.Path(folder) / pathlib.Path(deck).name
    lists.write(path)
    return path


def arguments(deck, settings):
    return ["-q", "-i", str(deck), *(part for setting in settings for part in ("--set", setting))]


def run(program, deck, settings, environment=None, ranks=1):
    """Runs `deck` with `settings` (texts for --set) in a folder of its own, all files written, and reads them back."""
    with tempfile.TemporaryDirectory(prefix="ndbench-") as folder:
        return run_in(folder, program, deck, settings, environment, ranks)


def run_in(folder, program, deck, settings, environment=None, ranks=1):
    """The same in `folder`, where the files stay."""
    launcher = [] if ranks == 1 else ["mpirun", "--oversubscribe", "-np", str(ranks)]
    command = [*launcher, program, *arguments(bare(deck, folder), settings)]
    cost, text = cost_of(command, folder, environment)
    if cost.exit not in USABLE:
        raise SystemExit(f"ndbench: {program} returned {cost.exit} on {deck} with {list(settings)}:\n{text}")
    files = pathlib.Path(folder)
    summary = json.loads(next(files.glob("*.summary.json")).read_text())
    contact = [row for path in files.glob("*.contact.csv") for row in contact_rows(path)]
    return Run(cost, summary, contact, overlap_of(contact, folder))
