"""What differs between two files, and how it is printed."""

import dataclasses

import numpy


@dataclasses.dataclass(frozen=True)
class Row:
    """One variable with different values: the worst place and how many there are."""

    name: str
    where: str
    gold: object
    new: object
    difference: float | None  # None: not numbers
    allowed: float | None
    places: str

    def excess(self):
        """Orders the rows: how many times the allowed difference."""
        if self.difference is None or not numpy.isfinite(self.difference) or self.allowed == 0:
            return numpy.inf
        return self.difference / self.allowed

    def cells(self):
        numbers = (self.gold, self.new, self.difference, self.allowed)
        return [self.name, self.where, *map(text, numbers), self.places]


class Report:
    """Everything found in one comparison: things that one file lacks, values that differ."""

    def __init__(self):
        self.lines = []
        self.rows = []

    def same(self):
        return not self.lines and not self.rows

    def say(self, line):
        self.lines.append(line)

    def missing(self, what, gold_names, new_names):
        """Says which names only one file has."""
        for name in gold_names:
            if name not in new_names:
                self.say(f"{what} {name} is missing in NEW")
        for name in new_names:
            if name not in gold_names:
                self.say(f"{what} {name} is extra in NEW")

    def compare(self, name, tolerance, gold, new, scale, where):
        """Adds a row if arrays of the same shape differ; `where(index)` names a place by its index in the arrays."""
        if tolerance.kind == "ignore" or gold.size == 0:
            return
        with numpy.errstate(invalid="ignore"):
            difference = numpy.abs(gold - new)
            allowed = tolerance.allowed(gold, new, scale)
            close = numpy.isfinite(difference) & (difference <= allowed)
            agree = close | (gold == new) | (numpy.isnan(gold) & numpy.isnan(new))
        if agree.all():
            return
        with numpy.errstate(divide="ignore", invalid="ignore"):
            excess = numpy.where(agree, -1.0, numpy.nan_to_num(difference / allowed, nan=numpy.inf))
        worst = numpy.unravel_index(numpy.argmax(excess), excess.shape)
        self.rows.append(Row(name, where(worst), float(gold[worst]), float(new[worst]), float(difference[worst]),
                             float(allowed[worst]), f"{int((~agree).sum())} of {agree.size}"))

    def text(self, worst=20):
        """Lines, then the `worst` rows as a table, the worst first."""
        lines = [f"  {line}" for line in self.lines[:worst]]
        if len(self.lines) > worst:
            lines.append(f"  ... and {len(self.lines) - worst} more of this kind")
        rows = sorted(self.rows, key=Row.excess, reverse=True)
        if rows:
            lines += table(["what", "worst place", "gold", "new", "difference", "allowed", "places"],
                           [row.cells() for row in rows[:worst]])
        if len(rows) > worst:
            lines.append(f"  ... and {len(rows) - worst} more that differ")
        return "\n".join(lines)


def table(header, rows):
    """Lines of a table with columns as wide as needed."""
    widths = [max(map(len, column)) for column in zip(header, *rows)]
    return ["  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in [header, *rows]]


def text(value):
    """Numbers with the digits that show a difference; long words cut."""
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.10g}"
    return str(value) if len(str(value)) <= 60 else str(value)[:57] + "..."
