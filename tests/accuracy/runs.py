"""Runs of ndframe with a target, and what they leave."""

import argparse
import dataclasses
import json
import pathlib
import statistics
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


def sweep_options(description, **more):
    """Command line of a sweep over random scenes, one a seed. more: further options, name -> (default, help)."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ndframe")
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    for name, (default, text) in more.items():
        parser.add_argument(f"--{name}", type=type(default), default=default, help=text)
    return parser.parse_args()


def sweep(options, judge):
    """judge(seed): (what is wrong or None, what it found, what it is about). Prints what is wrong as it comes; returns how
    often, and (found, about) of all scenes."""
    wrong, found = 0, []
    for seed in range(options.seed, options.seed + options.scenes):
        violation, value, about = judge(seed)
        if violation:
            wrong += 1
            print(f"{about}: {violation}", flush=True)
        found.append((value, about))
    return wrong, found


def print_sharpness(ratios, of=""):
    """Of bounds over reference errors."""
    print(f"bound / reference error{of}: {len(ratios)} converged runs, median {statistics.median(ratios):.3f}, "
          f"{min(ratios):.3f} to {max(ratios):.3f}")
