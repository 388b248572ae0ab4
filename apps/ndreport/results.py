"""What a report can show of the files that are there, and what is missing."""

import dataclasses
import pathlib

import ndframe

TABLES = (".study.csv", ".study.partial.csv", ".cases.partial.csv", ".cases.csv")


@dataclasses.dataclass
class Results:
    """`stem` begins the names of all files. A run has a summary, a study rows; the rest may be missing: see `gaps`."""

    stem: str
    summary: dict = None
    study: list = None
    cases: ndframe.LoadCases = None  # whose table is `study`
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


def read_results(name, case=None):
    """Results of NAME, which may end like one of the files, or of one of its load cases; raises ndframe.ReadError where there is nothing
    to report."""
    found = ndframe.read(name)
    if isinstance(found, ndframe.LoadCases):
        return of_run(found[case]) if case else of_cases(found)
    if case:
        raise ndframe.ReadError(f"{name} has no load cases; leave out --case.")
    return of_run(found) if isinstance(found, ndframe.Run) else of_study(found)


def of_cases(cases):
    """The table, and what is shown of the last case that has a solution."""
    name = pathlib.Path(cases.stem).name
    return Results(cases.stem, study=cases.rows, cases=cases, files=[f"{name}.cases.csv", f"{name}.summary.json"])


def shown_case(cases):
    """Name and results of the last load case that has a solution; nothing where none has."""
    for name in reversed(cases.names):
        if cases.entry(name)["results"] and cases[name].solved:
            return name, of_run(cases[name])
    return None


def of_study(study):
    ending = next(e for e in TABLES if pathlib.Path(study.stem + e).exists() and study.complete != ("partial" in e))
    results = Results(study.stem, study=study.rows, files=[pathlib.Path(study.stem).name + ending])
    if not study.complete:
        results.gaps.append("cases that were not run: the study was interrupted")
    return results


def of_run(run):
    called = pathlib.Path(run.stem).name
    results = Results(f"{pathlib.Path(run.stem).parent / run.name}", summary=run.summary, files=[f"{called}.summary.json"])
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
        results.files.append(pathlib.Path(run.stem).name + ending)
    except ndframe.ReadError as error:
        results.gaps.append(f"{called}: {str(error).rstrip('.')}")


def solved(summary):
    return summary["energy"] is not None
