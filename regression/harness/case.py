"""A regression case: the folder NAME with case.toml, the deck NAME.xml and the gold files."""

import dataclasses
import pathlib

from .errors import UsageError
from .tolerance import read_toml, tables_of

# Gold file -> how its counterpart in the outputs ends.
REQUIRED_FILES = {"gold.e": ".e", "gold.summary.json": ".summary.json", "gold.study.csv": ".study.csv",
                  "gold.cases.csv": ".cases.csv"}
# What a case may leave out: an empty gold.contact.csv, blessed, begins to compare the contact table.
GOLD_FILES = REQUIRED_FILES | {"gold.contact.csv": ".contact.csv"}

# Key of case.toml -> type of its value, default (None: the key must be there).
KEYS = {
    "requirement": (str, None),
    "labels": (list, None),
    "arguments": (list, []),
    "np": (list, [1]),
    "exit": (int, 0),
    "message": (str, ""),
    "program": (str, "ndframe"),
    "tolerances": (dict, {}),
}


@dataclasses.dataclass(frozen=True)
class Case:
    """What case.toml says. `message` must stand on the error stream; `rules` follow those of tolerances.toml."""

    folder: pathlib.Path
    requirement: str
    labels: list
    arguments: list
    np: list
    exit: int
    message: str
    program: str
    rules: dict

    @property
    def name(self):
        return self.folder.name

    @property
    def deck(self):
        return self.folder / f"{self.name}.xml"

    def gold(self):
        """The gold files that exist."""
        return [self.folder / name for name in GOLD_FILES if (self.folder / name).exists()]


def read_case(folder):
    where = folder / "case.toml"
    table = read_toml(where)
    for key in set(table) - set(KEYS):
        raise UsageError(f'{where}: "{key}" is not a key of a case; those are {", ".join(KEYS)}')
    values = {key: table.get(key, default) for key, (_, default) in KEYS.items()}
    for key, (kind, _) in KEYS.items():
        if not isinstance(values[key], kind) or values[key] == "" and key == "requirement":
            raise UsageError(f"{where}: {key} is {'missing' if values[key] is None else f'not a {kind.__name__}'}")
    if not values["np"] or not all(isinstance(ranks, int) and ranks > 0 for ranks in values["np"]):
        raise UsageError(f"{where}: np is a list of numbers of ranks, e.g. [1, 2]")
    rules = tables_of(values.pop("tolerances"), f"{where}: tolerances")
    case = Case(folder=folder, rules=rules, **values)
    if not case.deck.exists():
        raise UsageError(f"{where}: the deck {case.deck.name} is missing")
    return case


def read_cases(root):
    """All cases in a folder, by name."""
    folders = sorted(path.parent for path in root.glob("*/case.toml"))
    if not folders:
        raise UsageError(f"{root}: no folder in it has a case.toml")
    return {folder.name: read_case(folder) for folder in folders}
