"""Numbers out of rows: medians of repetitions, exponents, and the fastest setting for an error."""

import math
import statistics

# Relative errors 1, 0.5, 0.2, 0.1, ...
LEVELS = tuple(digit * 10.0**-power for power in (1, 2, 3, 4) for digit in (10, 5, 2))


def median(values):
    """The median of those that exist; None when none does."""
    known = [value for value in values if value is not None]
    return statistics.median(known) if known else None


def power_law(points):
    """Least squares for y = c x^p in logarithms: (p, c), from at least two distinct positive x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    x_mean, y_mean = (statistics.fmean(column) for column in zip(*logs))
    spread = sum((x - x_mean) ** 2 for x, _ in logs)
    exponent = sum((x - x_mean) * (y - y_mean) for x, y in logs) / spread
    return exponent, math.exp(y_mean - exponent * x_mean)


def exponents(points, start):
    """Of seconds against size, from (size, seconds): of the whole process, and without the seconds of its start.

    None where the seconds of fewer than two sizes exceed the start."""
    fits = []
    for offset in (0.0, start):
        left = [(size, seconds - offset) for size, seconds in points if seconds > offset]
        fits.append(power_law(left)[0] if len(left) > 1 else None)
    return tuple(fits)


def tied(one, other):
    """Whether the spreads of the repetitions overlap: the difference of the medians is noise then."""
    return one["seconds_least"] <= other["seconds_most"] and other["seconds_least"] <= one["seconds_most"]


def fastest(rows, levels=LEVELS):
    """For every relative error that some row attains for certain: (level, fastest row, fastest row of another method).

    The upper end of the error's bracket counts. Of several levels with the same fastest row the smallest is kept.
    """
    found = []
    for level in levels:
        good = sorted((row for row in rows if row["error_high"] <= level), key=lambda row: row["seconds"])
        if not good:
            break
        others = [row for row in good if row["method"] != good[0]["method"]]
        if found and found[-1][1] is good[0]:
            found.pop()
        found.append((level, good[0], others[0] if others else None))
    return found
