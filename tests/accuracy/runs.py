"""Runs of ndframe with a target, and what they leave."""

import dataclasses
import json
import pathlib
import subprocess
import tempfile


@dataclasses.dataclass(frozen=True)
class Run:
    """One call: `summary` as in NAME.summary.json, `contact` the text of NAME.contact.csv, None when there is none."""

    code: int
    screen: str
    summary: dict | None
    contact: str | None = None

    @property
    def answered(self):
        return self.summary is not None and self.summary["accuracy"] is not None

    @property
    def accuracy(self):
        """{target, reached, limit, levels: [{dofs, sweeps, bound, iteration, ...}], ...}"""
        return self.summary["accuracy"]

    @property
    def levels(self):
        return self.accuracy["levels"]

    @property
    def dofs(self):
        """Of the last level."""
        return self.levels[-1]["dofs"]


class Program:
    """The built ndframe, alone or on several ranks."""

    def __init__(self, path, mpiexec=None, seconds=300):
        self.path = pathlib.Path(path).resolve()
        self.mpiexec = mpiexec
        self.seconds = seconds

    def run(self, deck, *settings, ranks=1):
        """Runs a deck with settings as of --set, in a folder that is removed afterwards."""
        launch = [self.mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        command = [*launch, str(self.path), "-i", str(pathlib.Path(deck).resolve())]
        for setting in settings:
            command += ["--set", setting]
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=self.seconds)
            summaries = list(pathlib.Path(folder).glob("*.summary.json"))
            summary = json.loads(summaries[0].read_text()) if summaries else None
            tables = list(pathlib.Path(folder).glob("*.contact.csv"))
            contact = tables[0].read_text() if tables else None
        return Run(done.returncode, done.stdout + done.stderr, summary, contact)
