"""Tables as numpy arrays by the names of their columns."""

from __future__ import annotations

import csv
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy

from .errors import ReadError

Columns = dict[str, numpy.ndarray]


def columns(rows: Sequence[Mapping[str, Any]]) -> Columns:
    """Rows of a list in the summary as columns [rows]: numbers as float or int, NaN for null; all else as object."""
    names = list(rows[0]) if rows else []
    return {name: _array([row.get(name) for row in rows]) for name in names}


def _array(values: list[Any]) -> numpy.ndarray:
    if all(isinstance(value, int) for value in values):
        return numpy.array(values)
    if all(value is None or isinstance(value, (int, float)) for value in values):
        return numpy.array([numpy.nan if value is None else value for value in values], float)
    array = numpy.empty(len(values), object)
    array[:] = values
    return array


def read_rows(path: pathlib.Path) -> list[dict[str, str]]:
    """The rows of a CSV file as texts."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
    except OSError as error:
        raise ReadError(f"{path}: cannot be read: {error.strerror}.") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise ReadError(f"{path}: is not a table: {error}.") from None


def read_contact(path: pathlib.Path, case: str | None = None) -> dict[str, Columns]:
    """NAME.contact.csv: interface -> column -> [nodes] floats; of load cases the rows of one of them."""
    tables: dict[str, dict[str, list[float]]] = {}
    try:
        for row in read_rows(path):
            if case is not None and row.pop("case") != case:
                continue
            table = tables.setdefault(row.pop("interface"), {})
            for name, value in row.items():
                table.setdefault(name, []).append(float(value))
    except (KeyError, TypeError, ValueError):
        raise ReadError(f"{path} is damaged; run the deck again.") from None
    return {name: {column: numpy.array(values) for column, values in table.items()} for name, table in tables.items()}
