"""Runs of the program."""

from __future__ import annotations

import dataclasses
import os
import pathlib
import shlex
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from typing import Any

from .deck import Value, deck_text, output_stem, value_text
from .errors import Error, ReadError, RunError
from .results import LoadCases, Run, Study, read

Deck = str | os.PathLike[str] | Mapping[str, Any]
Settings = Mapping[str, Value]


# What was run, where another function was called for it.
MEANT = {Run: "neither the deck nor the call has load cases or an axis of a study; use run()",
         LoadCases: "the deck has a list Load Cases, which run_cases() runs", Study: "the deck has a list Study, which run_study() runs"}


def find_program() -> str:
    """The ndframe of the environment variable NDFRAME_PROGRAM, the one that this module was installed with, or the one on the path."""
    if given := os.environ.get("NDFRAME_PROGRAM"):
        return given
    here = pathlib.Path(__file__).absolute().parent
    for folder in (here, here.resolve()):
        beside = pathlib.Path(os.path.normpath(folder / "../../../bin/ndframe"))
        if beside.is_file():
            return str(beside)
    if found := shutil.which("ndframe"):
        return found
    raise Error("the program ndframe is neither next to this module nor on the path; name it in NDFRAME_PROGRAM or as program=.")


def run(deck: Deck, settings: Settings | None = None, *, folder: str | os.PathLike[str] = ".", ranks: int = 1,
        program: str | os.PathLike[str] | None = None, codes: Sequence[int] = (0,), restart: bool = False) -> Run:
    """Runs a deck and reads its results.

    deck: a file, or a deck as nested mappings, which is written to folder/deck.xml. settings: as --set, {"Accuracy/Target": 0.01};
    lists are sequences. folder: where the files are written, created if needed; paths in a deck start from the deck's folder. ranks: number
    of processes. codes: exit codes that are not errors; others raise RunError, whose `results` has the Run where one was written.
    restart: continues from the checkpoint that an earlier run with a target wrote to the folder (Output/Checkpoint).
    """
    return _finish(_call(deck, settings or {}, {}, pathlib.Path(folder), ranks, program, ["--restart"] * restart), codes, Run)


def run_cases(deck: Deck, cases: Mapping[str, Mapping[str, float]] | None = None, settings: Settings | None = None, *,
              folder: str | os.PathLike[str] = ".", ranks: int = 1, program: str | os.PathLike[str] | None = None,
              codes: Sequence[int] = (0,)) -> LoadCases:
    """Runs a deck for several load states in one process: {"half": {"Bodies/punch/Loads/press": 0.5}, ...}.

    Factors that a case does not name are 1. Without `cases`, those of the deck's list Load Cases;
    the rest is as in run(), the code is the most serious of all cases.
    """
    given: dict[str, Value] = dict(settings or {})
    if cases:
        given["Load Cases/Names"] = list(cases)
        for path in dict.fromkeys(path for factors in cases.values() for path in factors):
            given[f"Load Cases/Factors/{path}"] = [float(factors.get(path, 1.0)) for factors in cases.values()]
    return _finish(_call(deck, given, {}, pathlib.Path(folder), ranks, program), codes, LoadCases)


def run_study(deck: Deck, axes: Mapping[str, Sequence[Value]] | None = None, settings: Settings | None = None, *,
              folder: str | os.PathLike[str] = ".", ranks: int = 1, program: str | os.PathLike[str] | None = None,
              codes: Sequence[int] = (0,)) -> Study:
    """Runs a deck for every combination of the values of the axes, {"Coupling/Stopping/Tolerance": [0.1, 0.01]}, in one process.

    Axes are added to the list Study of the deck. The rest is as in run(); the code is the most serious of all cases.
    """
    return _finish(_call(deck, settings or {}, axes or {}, pathlib.Path(folder), ranks, program), codes, Study)


@dataclasses.dataclass(frozen=True)
class _Call:
    command: list[str]
    code: int
    screen: str
    errors: str
    stem: str
    is_study: bool


def _call(deck: Deck, settings: Settings, axes: Mapping[str, Sequence[Value]], folder: pathlib.Path, ranks: int,
          program: str | os.PathLike[str] | None, more: Sequence[str] = ()) -> _Call:
    folder.mkdir(parents=True, exist_ok=True)
    if isinstance(deck, Mapping):
        path = folder / "deck.xml"
        path.write_text(deck_text(deck) + "\n", encoding="utf-8")
    else:
        path = pathlib.Path(deck)
    stem = str(folder / output_stem(path, settings))
    # As the program finds them from the folder in which it works.
    named = os.fspath(program or find_program())
    command = [os.path.abspath(named) if os.path.dirname(named) else named, "-i", os.path.abspath(path), *more]
    for name, value in settings.items():
        command += ["--set", f"{name}={value_text(value)}"]
    for name, values in axes.items():
        command += ["--study", f"{name}={'; '.join(map(value_text, values))}"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command]
    is_study = bool(axes) or "Study" in _lists(path)
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    except OSError as error:
        raise Error(f"{error.filename} cannot be started: {error.strerror}.") from None
    return _Call(command, done.returncode, done.stdout + done.stderr, done.stderr, stem, is_study)


def _lists(path: pathlib.Path) -> set[str]:
    import xml.etree.ElementTree

    return {str(entry.get("name")) for entry in xml.etree.ElementTree.parse(path).getroot()}


def _finish(call: _Call, codes: Sequence[int], wanted: type) -> Any:
    """The results, or a RunError for a code that is not accepted."""
    written = call.code == 0 or 3 <= call.code <= 6
    results = None
    if written:
        results = read(call.stem + (".study.csv" if call.is_study else ".summary.json"))
        results = dataclasses.replace(results, code=call.code, screen=call.screen)
    if call.code not in codes or results is None:
        raise RunError(f"ndframe ended with exit code {call.code}:\n{call.errors.strip()}\n{shlex.join(call.command)}", call.code,
                       call.errors, results)
    if not isinstance(results, wanted):
        raise ReadError(f"{call.stem}: {MEANT[type(results)]}.")
    return results
