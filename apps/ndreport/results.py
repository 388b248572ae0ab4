"""The files of a run or of a study, as far as they are there."""

import csv
import dataclasses
import json
import pathlib

from harness.errors import UsageError
from harness.exodus import Exodus

ENDINGS = (".summary.json", ".study.csv", ".study.partial.csv", ".contact.csv", ".levels.csv", ".report.html", ".e",
           ".xml")
# What every summary has had; `build` came later.
SUMMARY_KEYS = ("version", "title", "ranks", "per_unit_thickness", "deck", "bodies", "energy", "interfaces", "coupling", "residuals",
                "warnings", "errors", "accuracy", "expectations", "ledger")


class Missing(Exception):
    """What the user has to do before there can be a report."""


@dataclasses.dataclass
class Results:
    """`stem` begins the names of all files. A run has a summary, a study rows; the rest may be missing: see `gaps`."""

    stem: str
    summary: dict = None
    study: list = None
    fields: Exodus = None
    contact: dict = dataclasses.field(default_factory=dict)  # interface -> column -> list of floats
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
    """Results of NAME, which may end like one of the files; raises Missing with a sentence."""
    stem = stem_of(name)
    summary, study = pathlib.Path(f"{stem}.summary.json"), pathlib.Path(f"{stem}.study.csv")
    if not study.exists() and not summary.exists() and pathlib.Path(f"{stem}.study.partial.csv").exists():
        study = pathlib.Path(f"{stem}.study.partial.csv")
    wants_study = ".study." in name or not summary.exists()
    if study.exists() and wants_study:
        return read_study(stem, study)
    if not summary.exists():
        raise Missing(f"there is no {summary} and no {stem}.study.csv; run the deck first, in this folder or with the "
                      "folder in NAME (Output/Summary must not be false).")
    return read_run(stem, summary)


def stem_of(name):
    """What comes before the ending. The results of a deck elsewhere are looked for in the working directory."""
    ending = next((e for e in ENDINGS if name.endswith(e) and len(name) > len(e)), "")
    stem = name[: len(name) - len(ending)]
    beside = any(pathlib.Path(f"{stem}{e}").exists() for e in (".summary.json", ".study.csv", ".study.partial.csv"))
    return pathlib.Path(stem).name if ending == ".xml" and not beside else stem


def read_study(stem, path):
    rows = read_csv(path)
    if not rows or "case" not in rows[0] or "dofs" not in rows[0]:
        raise Missing(f"{path} is not the table of a study, or it has no row yet.")
    results = Results(stem, study=rows, files=[path.name])
    if "partial" in path.name:
        results.gaps.append("cases that were not run: the study was interrupted")
    return results


def read_run(stem, path):
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
        for key in SUMMARY_KEYS:
            summary[key]
        summary["deck"]["Bodies"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Missing(f"{path} cannot be read as a summary of ndframe ({type(error).__name__}: {error}); run the deck "
                      "again.") from None
    results = Results(stem, summary=summary, files=[path.name])
    read_fields(results)
    read_contact(results)
    read_levels(results)
    return results


def solved(summary):
    return summary["energy"] is not None


def read_fields(results):
    path = pathlib.Path(f"{results.stem}.e")
    if not path.exists():
        why = "Output/Exodus is false" if results.deck.get("Output", {}).get("Exodus") is False else "the file is missing"
        results.gaps.append(f"pictures of the bodies: there is no {path.name} ({why})")
        return
    try:
        fields = Exodus(str(path))
        if fields.times.size == 0 or "disp_x" not in fields.variables("nodal"):
            raise UsageError(f"{path.name} has no displacements")
        known = {body["name"] for body in results.summary["bodies"]}
        if not all(any(block == body or block.startswith(body + ":") for body in known) for block in fields.blocks):
            raise UsageError(f"{path.name} belongs to another run: its bodies are not those of the summary")
    except UsageError as error:
        results.gaps.append(f"pictures of the bodies: {error}")
        return
    results.fields = fields
    results.files.append(path.name)


def read_contact(results):
    path = pathlib.Path(f"{results.stem}.contact.csv")
    if not results.summary["interfaces"]:
        return
    if not path.exists():
        results.gaps.append(f"pressure and gap along the interfaces: there is no {path.name}")
        return
    try:
        rows = read_csv(path)
        for row in rows:
            table = results.contact.setdefault(row.pop("interface"), {})
            for key, value in row.items():
                table.setdefault(key, []).append(float(value))
    except (KeyError, TypeError, ValueError):
        results.contact = {}
        results.gaps.append(f"pressure and gap along the interfaces: {path.name} is damaged")
        return
    results.files.append(path.name)


def read_levels(results):
    accuracy = results.summary.get("accuracy")
    results.levels = accuracy["levels"] if accuracy else []


def read_csv(path):
    try:
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Missing(f"{path} cannot be read: {error}") from None
