"""What a report can show of the files that are there, and what is missing."""

import dataclasses
import pathlib

import ndframe


@dataclasses.dataclass
class Results:
    """`stem` begins the names of all files. A run has a summary, a study rows; the rest may be missing: see `gaps`."""

    stem: str
    summary: dict = None
    study: list = None
    fields: ndframe.Fields = None
    contact: dict = dataclasses.field(default_factory=dict)  # interface -> column -> [nodes]
    levels: list = dataclasses.field(default_factory=list)
    files: list = dataclasses.field(default_factory=list)
    gaps: list = dataclasses.field(default_factory=list)

    @property
    def name(self):
        return pathlib.Path(self.stem).name

    @property
    def deck(self):
        return self.summary["deck"]


def read_results(name):
    """Results of NAME, which may end like one of the files; raises ndframe.ReadError where there is nothing to report."""
    found = ndframe.read(name)
    return of_run(found) if isinstance(found, ndframe.Run) else of_study(found)


def of_study(study):
    ending = ".study.csv" if study.complete else ".study.partial.csv"
    results = Results(study.stem, study=study.rows, files=[pathlib.Path(study.stem).name + ending])
    if not study.complete:
        results.gaps.append("cases that were not run: the study was interrupted")
    return results


def of_run(run):
    results = Results(run.stem, summary=run.summary, files=[f"{run.name}.summary.json"])
    take(results, "fields", run, "pictures of the bodies", ".e")
    if run.interfaces:
        take(results, "contact", run, "pressure and gap along the interfaces", ".contact.csv")
    accuracy = run.summary["accuracy"]
    results.levels = accuracy["levels"] if accuracy else []
    return results


def take(results, what, run, called, ending):
    """One of the run's files, or a gap that says why not."""
    try:
        setattr(results, what, getattr(run, what))
        results.files.append(run.name + ending)
    except ndframe.ReadError as error:
        results.gaps.append(f"{called}: {str(error).rstrip('.')}")


def solved(summary):
    return summary["energy"] is not None
