"""Decks as nested dictionaries, and as the XML that ndframe reads."""

from __future__ import annotations

import os
import pathlib
import xml.etree.ElementTree
from collections.abc import Mapping, Sequence
from typing import Any
from xml.sax.saxutils import escape

from .errors import Error, ReadError

Value = bool | int | float | str | Sequence[Any]


def deck_text(deck: Mapping[str, Any], name: str = "deck") -> str:
    """A deck as XML. Lists of the deck are mappings; values are bool, int, float, str, or sequences of one of them.

    The `deck` of a summary, defaults included, gives a deck that runs and gives the same results. Entries that are None are
    left out.
    """
    lines = [f'<ParameterList name="{_quoted(name)}">']
    _write(deck, 1, lines)
    return "\n".join([*lines, "</ParameterList>"])


def value_text(value: Value) -> str:
    """A value as it stands in a deck and after the `=` of --set."""
    return _typed(value)[1]


def output_stem(deck: str | os.PathLike[str], settings: Mapping[str, Value]) -> str:
    """How the names of the files begin that a run of this deck writes: [Output/Directory/]NAME."""
    path = pathlib.Path(deck)
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except OSError as error:
        raise ReadError(f"{path}: the deck cannot be read: {error.strerror}.") from None
    except xml.etree.ElementTree.ParseError as error:
        raise ReadError(f"{path}: the deck is not XML: {error}.") from None

    def given(key: str, otherwise: str) -> str:
        entry = root.find(f"*[@name='Output']/*[@name='{key}']")
        return str(settings.get(f"Output/{key}") or (entry.get("value") if entry is not None else "") or otherwise)

    return str(pathlib.Path(given("Directory", ".")) / given("Name", path.stem))


def _write(entries: Mapping[str, Any], depth: int, lines: list[str]) -> None:
    margin = "  " * depth
    for name, value in entries.items():
        if isinstance(value, Mapping):
            if not value:
                lines.append(f'{margin}<ParameterList name="{_quoted(name)}"/>')
                continue
            lines.append(f'{margin}<ParameterList name="{_quoted(name)}">')
            _write(value, depth + 1, lines)
            lines.append(f"{margin}</ParameterList>")
        elif value is not None:
            kind, text = _typed(value)
            lines.append(f'{margin}<Parameter name="{_quoted(name)}" type="{kind}" value="{_quoted(text)}"/>')


def _typed(value: Any) -> tuple[str, str]:
    """(type, text) of a value; numpy's numbers are those of Python."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    for python, kind, text in ((bool, "bool", lambda v: str(v).lower()), (int, "int", str), (float, "double", repr), (str, "string", str)):
        if isinstance(value, python):
            return kind, text(value)
    if not isinstance(value, Sequence):
        raise Error(f"{value!r} is not allowed in a deck; values are bool, int, float, str, or lists of one of them.")
    parts = [_typed(entry) for entry in value]
    kinds = {kind for kind, _ in parts} or {"string"}
    kind = "double" if "double" in kinds else parts[0][0] if parts else "string"
    return f"Array({kind})", "{" + ", ".join(text for _, text in parts) + "}"


def _quoted(text: str) -> str:
    return escape(text, {'"': "&quot;"})
