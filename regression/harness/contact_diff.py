"""Two contact tables (NAME.contact.csv) compared, row by row of the same interface and position."""

import csv
import dataclasses

import numpy

from .errors import UsageError
from .mesh_match import largest, nearest, place
from .report import Report

POSITION = ("x", "y", "z")
# Columns that are the same quantity: the gap is round-off beside the displacements that it is the difference of.
SHARED_SCALES = (("u_dirichlet", "u_neumann", "gap"), ("traction_dirichlet", "traction_neumann"))


@dataclasses.dataclass(frozen=True)
class ContactTable:
    """`interfaces`: one name a row; `columns`: name -> numbers, one a row."""

    interfaces: list
    columns: dict

    @property
    def points(self):
        return numpy.stack([self.columns[axis] for axis in POSITION if axis in self.columns], axis=1)


def diff_contact(gold_path, new_path, tolerances):
    """The report of all differences; raises UsageError for files that cannot be read."""
    report = Report()
    gold, new = read(gold_path), read(new_path)
    wanted = [[name for name in table.columns if tolerances.of(name).kind != "ignore"] for table in (gold, new)]
    report.missing("column", *wanted)
    rows = match_rows(gold, new, tolerances.of("coordinates"), report)
    if rows is None:
        return report
    where = lambda index: f"{gold.interfaces[index[0]]}, {place('row', index[0], gold.points[index[0]])}"
    for name in wanted[0]:
        if name in new.columns and name not in POSITION:
            shared = next((group for group in SHARED_SCALES if name in group), (name,))
            scale = max(largest(gold.columns[other]) for other in shared if other in gold.columns)
            report.compare(name, tolerances.of(name), gold.columns[name], new.columns[name][rows], scale, where)
    return report


def read(path):
    try:
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
            if any(None in row for row in rows):
                raise ValueError("a row is longer than the head")
            interfaces = [label(row) for row in rows]
            columns = {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}
            return ContactTable(interfaces, columns | {axis: columns[axis] for axis in POSITION[:2]})
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror}") from None
    except (IndexError, KeyError, TypeError, ValueError, csv.Error):  # no rows, or not such rows
        raise UsageError(f"{path}: is not a contact table") from None


def label(row):
    """The interface; of load cases with the case before it."""
    case = [row.pop("case")] if "case" in row else []
    return ", ".join([*case, row.pop("interface")])


def match_rows(gold, new, tolerance, report):
    """Rows in NEW of GOLD's rows; None, and said, where they are not at the same places."""
    if gold.points.shape[1] != new.points.shape[1]:
        return None  # the report has the missing column
    scale = largest(numpy.ptp(gold.points, axis=0))
    names = list(dict.fromkeys(gold.interfaces + new.interfaces))
    labelled = [numpy.column_stack([table.points, [names.index(name) * (scale or 1.0) for name in table.interfaces]])
                for table in (gold, new)]
    reach = min(float(tolerance.allowed(scale, scale, scale)), 1e-3 * scale)
    rows = nearest(*labelled, reach)
    lost = numpy.flatnonzero(rows < 0)
    if lost.size or len(gold.points) != len(new.points):
        where = f", the first: {place('row', lost[0], gold.points[lost[0]])}" if lost.size else ""
        report.say(f"{len(gold.points)} rows in GOLD, {len(new.points)} in NEW; {lost.size} are missing{where}")
        return None
    return rows
