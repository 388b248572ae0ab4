"""The files of a run, of load cases or of a study."""

from __future__ import annotations

import dataclasses
import functools
import json
import os
import pathlib
import re
from typing import Any

import numpy

from .errors import ReadError, unknown
from .fields import Fields
from .pieces import pieces_of
from .tables import Columns, columns, read_contact, read_rows

TABLES = (".study.csv", ".study.partial.csv", ".cases.csv", ".cases.partial.csv")
ENDINGS = (".summary.json", *TABLES, ".contact.csv", ".levels.csv", ".report.html", ".e", ".xml")
# What every summary has had; `build` came later.
SUMMARY_KEYS = ("version", "title", "ranks", "per_unit_thickness", "deck", "bodies", "energy", "interfaces", "coupling", "residuals",
                "warnings", "errors", "accuracy", "expectations", "ledger")


@dataclasses.dataclass(frozen=True)
class Bound:
    """The error in energy, sqrt(a(u - u_h, u - u_h)): `absolute` in the energy norm, `relative` over the norm of the computed
    displacement (NaN where there is none). Nothing is bounded where `guaranteed` is false: `reason` says why."""

    absolute: float
    relative: float
    guaranteed: bool
    reason: str


@dataclasses.dataclass(frozen=True)
class Run:
    """What a run has written. Units are those of the deck; in plane scenes forces and energies are those of a slice of thickness 1.

    `stem`: folder and NAME, with which the names of all its files begin; `summary`: NAME.summary.json as it is
    (docs/summary.schema.json); `code`: exit code, None for a run that was not started here; `screen`:
    its output. Files are read on first use; ReadError says which is missing or damaged.
    """

    stem: str
    summary: dict[str, Any]
    code: int | None = None
    screen: str = ""

    @property
    def name(self) -> str:
        return pathlib.Path(self.stem).name

    @property
    def title(self) -> str:
        return self.summary["title"]

    @property
    def deck(self) -> dict[str, Any]:
        """The deck with all defaults; deck_text() makes XML of it."""
        return self.summary["deck"]

    @property
    def solved(self) -> bool:
        """False when the run ended without a solution (exit code 3): numbers of the summary are None."""
        return self.summary["energy"] is not None

    @property
    def dofs(self) -> int:
        """Degrees of freedom of all bodies, supports included."""
        return sum(body["dofs"] for body in self.summary["bodies"])

    @property
    def energy(self) -> float:
        """a(u, u), twice the strain energy; NaN without a solution."""
        return _number(self.summary["energy"])

    @property
    def bound(self) -> Bound | None:
        """None if the deck asks for no bound (lists Error Estimation, Accuracy)."""
        found = (self.summary["errors"] or {}).get("global")
        return found and Bound(_number(found["absolute"]), _number(found["relative"]), found["guaranteed"], found["reason"])

    @property
    def energy_bracket(self) -> tuple[float, float] | None:
        """(lower, upper) of a(u, u) / 2 - L(u) of the exact solution, guaranteed; None without a guaranteed bound."""
        found = (self.summary["errors"] or {}).get("energy_bracket")
        return found and (found["lower"], found["upper"])

    @property
    def bodies(self) -> dict[str, dict[str, Any]]:
        """Entries `bodies` of the summary by name: dofs, energy, supports, largest_displacement, ..."""
        return {body["name"]: body for body in self.summary["bodies"]}

    @property
    def interfaces(self) -> dict[str, dict[str, Any]]:
        """Entries `interfaces` of the summary by name: contact_force, largest_pressure, closed_nodes, ..."""
        return {interface["name"]: interface for interface in self.summary["interfaces"]}

    @property
    def levels(self) -> Columns:
        """Column -> [levels]: dofs, bound, relative, mesh, iteration, seconds, ...; empty without the list Accuracy."""
        accuracy = self.summary["accuracy"]
        return columns(accuracy["levels"] if accuracy else [])

    @property
    def sweeps(self) -> Columns:
        """Column -> [sweeps]: eps_tau, theta, closed, open, ...; empty without interfaces."""
        coupling = self.summary["coupling"]
        return columns(coupling["history"] if coupling else [])

    @functools.cached_property
    def contact(self) -> dict[str, Columns]:
        """Interface -> column -> [nodes], from NAME.contact.csv: x, y, pressure, gap, arc_length (plane scenes), ..."""
        path = pathlib.Path(f"{self.stem}.contact.csv")
        if not path.exists():
            raise ReadError(f"there is no {path.name}" + ("." if self.interfaces else "; the scene has no interface."))
        return self._contact_in(path)

    @functools.cached_property
    def fields(self) -> Fields:
        """Mesh and fields, from NAME.e or its pieces NAME.e.N.r."""
        path = pathlib.Path(f"{self.stem}.e")
        if not path.exists() and not pieces_of(path):
            why = "Output/Exodus is false" if self.deck.get("Output", {}).get("Exodus") is False else "the file is missing"
            raise ReadError(f"there is no {path.name} ({why}).")
        fields = self._fields_in(path)
        if not all(any(block == body or block.startswith(body + ":") for body in self.bodies) for block in fields.blocks):
            raise ReadError(f"{path.name} belongs to another run: its bodies are not those of the summary.")
        return fields

    def _contact_in(self, path: pathlib.Path) -> dict[str, Columns]:
        return read_contact(path)

    def _fields_in(self, path: pathlib.Path) -> Fields:
        return Fields(path)


@dataclasses.dataclass(frozen=True)
class Case(Run):
    """A load case: a run whose files are those of all cases. `case`: its name; `number`: from 1, the time of its step."""

    case: str = ""
    number: int = 0

    @property
    def name(self) -> str:
        return f"{pathlib.Path(self.stem).name}.{self.case}"

    def _contact_in(self, path: pathlib.Path) -> dict[str, Columns]:
        return read_contact(path, self.case)

    def _fields_in(self, path: pathlib.Path) -> Fields:
        steps = list(Fields(path).steps)
        if self.number not in steps:
            raise ReadError(f'{path.name} has no step of the case "{self.case}".')
        return Fields(path, steps.index(self.number))


@dataclasses.dataclass(frozen=True)
class LoadCases:
    """What a deck with the list Load Cases has written: `cases["half"]` is a Run. `rows` of the table: one per case, as texts by column."""

    stem: str
    summary: dict[str, Any]
    code: int | None = None
    screen: str = ""

    @property
    def names(self) -> list[str]:
        """In the order in which they were solved."""
        return [case["name"] for case in self.summary["cases"]]

    def entry(self, name: str) -> dict[str, Any]:
        """The case in the summary: factors, exit_code, reason, seconds, results."""
        if name not in self.names:
            raise unknown(self.stem, "load case", name, self.names)
        return self.summary["cases"][self.names.index(name)]

    def __getitem__(self, name: str) -> Run:
        results = self.entry(name)["results"]
        if results is None:
            raise ReadError(f'{self.stem}: nothing was computed of the case "{name}": {self.entry(name)["reason"]}')
        if results["accuracy"]:  # it has files of its own
            return Run(f"{self.stem}.{name}", results, self.entry(name)["exit_code"])
        return Case(self.stem, results, self.entry(name)["exit_code"], "", name, self.names.index(name) + 1)

    @functools.cached_property
    def rows(self) -> list[dict[str, str]]:
        return read_rows(pathlib.Path(f"{self.stem}.cases.csv"))

    def column(self, name: str) -> numpy.ndarray:
        """[cases] of one column of NAME.cases.csv, as for a study."""
        return Study(self.stem, self.rows).column(name)


@dataclasses.dataclass(frozen=True)
class Study:
    """The table of a study. `rows`: one per case, as texts by column; `complete`: false for one that was interrupted."""

    stem: str
    rows: list[dict[str, str]]
    complete: bool = True
    code: int | None = None
    screen: str = ""

    def column(self, name: str) -> numpy.ndarray:
        """[cases] of one column: float, NaN where it is empty; texts where it is not all numbers."""
        if name not in self.rows[0]:
            raise unknown(self.stem, "column", name, self.rows[0])
        texts = [row[name] for row in self.rows]
        try:
            return numpy.array([float(text) if text else numpy.nan for text in texts])
        except ValueError:
            return numpy.array(texts)


def read(name: str | os.PathLike[str]) -> Run | LoadCases | Study:
    """The results of NAME: "punch", "results/punch", or one of its files.

    A study where only that is there, or where NAME ends like its table; the table of load cases that were interrupted is one, too.
    Raises ReadError where there is neither a summary nor a table, or where it is damaged.
    """
    name = os.fspath(name)
    stem = stem_of(name)
    summary = pathlib.Path(f"{stem}.summary.json")
    tables = [path for ending in TABLES if (path := pathlib.Path(f"{stem}{ending}")).exists()]
    of_study = bool(tables) and tables[0].name.endswith(".study.csv")
    if tables and (not summary.exists() or of_study and ".study." in name):
        return read_study(stem, tables[0])
    if not summary.exists():
        raise ReadError(f"there is no {summary} and no {stem}.study.csv; run the deck first, in this folder or with the folder in NAME "
                        "(Output/Summary must not be false).")
    return read_run(stem, summary)


def stem_of(name: str) -> str:
    """What comes before the ending. The results of a deck elsewhere are looked for in the working directory."""
    name = re.sub(r"\.e\.\d+\.\d+$", ".e", name)  # a piece
    ending = next((e for e in ENDINGS if name.endswith(e) and len(name) > len(e)), "")
    stem = name[: len(name) - len(ending)]
    beside = any(pathlib.Path(f"{stem}{e}").exists() for e in (".summary.json", *TABLES))
    return pathlib.Path(stem).name if ending == ".xml" and not beside else stem


def read_run(stem: str, path: pathlib.Path) -> Run | LoadCases:
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
        for results in [case["results"] for case in summary["cases"]] if "cases" in summary else [summary]:
            for key in () if results is None else SUMMARY_KEYS:
                results[key]
        summary["deck"]["Bodies"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ReadError(f"{path} cannot be read as an ndframe summary ({type(error).__name__}: {error}); run the deck "
                        "again.") from None
    return LoadCases(stem, summary) if "cases" in summary else Run(stem, summary)


def read_study(stem: str, path: pathlib.Path) -> Study:
    rows = read_rows(path)
    if not rows or "case" not in rows[0] or "dofs" not in rows[0]:
        raise ReadError(f"{path} is not the table of a study, or it has no row yet.")
    return Study(stem, rows, "partial" not in path.name)


def _number(value: float | None) -> float:
    return float("nan") if value is None else value
