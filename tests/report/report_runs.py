"""Runs whose reports are looked at, small versions of shipped decks."""

import pathlib
import subprocess

SMALL = ["Bodies/upper/Mesh/Cells={3, 3, 2}", "Bodies/lower/Mesh/Cells={6, 6, 3}"]
PROBES = [f"Output/Probes/{setting}" for setting in (
    "corner/Body=punch", "corner/At={1.0, 1.0}", "sole/Body=punch", "sole/From={0.0, 0.0}", "sole/To={1.0, 0.0}", "sole/Points=21",
    "ground/Body=foundation", "ground/Side=bottom")]
# name: (deck, settings, exit codes that are right here); settings may miss what the deck expects of its own mesh
RUNS = {
    "certificate": ("certificate", ["Error Estimation/Reference/Refinements=1"], (0, 4)),
    "levels": ("punch", ["Accuracy/Target=0.05"], (0, 4)),
    "solid": ("contact-loss-3d", [*SMALL, "Error Estimation/Mode=Strict"], (0, 4)),
    "without-bound": ("patch", [], (0,)),
    "probes": ("punch", PROBES, (0,)),
    "drawn": ("bearing", ["Accuracy/Target=0.05"], (0, 4)),
    "hertz": ("hertz", ["Output/Exodus=false"], (0, 4)),
    "moved": ("punch", ["Bodies/punch/Loads/press/Value=0", "Bodies/punch/Supports/moved/Type=Displacement",
                        "Bodies/punch/Supports/moved/Side=top", "Bodies/punch/Supports/moved/Y=-0.01"], (0, 4)),
    "assembly": ("flange", [], (0, 4)),
    "hidden-fields": ("punch", ["Output/Exodus=false"], (0,)),
    "no-solution": ("punch", ["Bodies/punch/Loads/press/Value=-1"], (3,)),
    "study": ("study", [], (0,)),
    "cases": ("load-cases", ["Load Cases/Factors/Bodies/upper/Loads/press={0.1, -0.5, 1, 1}"], (3,)),
}


class Runs:
    def __init__(self, program, decks, folder):
        self.program, self.decks, self.folder = program, pathlib.Path(decks), pathlib.Path(folder)

    def call(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True,
                              timeout=300)

    def compute(self, name):
        deck, settings, codes = RUNS[name]
        extra = [part for setting in [*settings, f"Output/Name={name}"] for part in ("--set", setting)]
        done = self.call("-q", "-i", self.decks / f"{deck}.xml", *extra)
        if done.returncode not in codes:
            raise AssertionError(f"{name} ended with {done.returncode}: {done.stderr}")

    def report(self, name):
        """Path of the page of a run that was computed."""
        done = self.call("report", name)
        if done.returncode != 0:
            raise AssertionError(f"report {name} ended with {done.returncode}: {done.stderr}")
        return self.folder / f"{name}.report.html"
