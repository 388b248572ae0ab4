"""The matrix as a picture: a panel a row of the matrix, methods below each other, values side by side."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Patch

from judge import FEWEST_DIGITS, FINDING, MOST_DIGITS, REFUSED, RIGHT, STOPPED
from rows import ROWS

PLAIN = {REFUSED: ("#9aa7b5", "refused"), STOPPED: ("#e8b04a", "stopped, exit code 3"), FINDING: ("#c1121f", FINDING)}
DIGITS = matplotlib.colormaps["YlGn"]
FLOORED = "*"
COLUMNS = 2
HEAD = 2.2  # lines that a panel needs beside its methods


def green(share):
    """From the fewest digits (0) to the most (1)."""
    return DIGITS(0.15 + 0.75 * share)


def colour(result):
    outcome = FINDING if result.finding else result.verdict.outcome
    if outcome != RIGHT:
        return PLAIN[outcome][0]
    return green((result.verdict.digits - FEWEST_DIGITS) / (MOST_DIGITS - FEWEST_DIGITS))


def labels(values):
    """As few digits as tell all values apart, at least six."""
    for digits in range(6, 18):
        texts = [f"{v:.{digits}g}" if isinstance(v, float) else str(v) for v in values]
        if len(set(texts)) == len(values):
            break
    return texts


def panel(axes, row, results):
    """One row of the matrix; right results show their digits."""
    methods = list(dict.fromkeys(result.cell.method for result in results))
    values = list(dict.fromkeys(result.cell.value for result in results))
    for result in results:
        x, y = values.index(result.cell.value), methods.index(result.cell.method)
        axes.add_patch(plt.Rectangle((x, y), 1, 1, facecolor=colour(result), edgecolor="white"))
        if result.verdict.outcome == RIGHT:
            text = f"{result.verdict.digits:.0f}" + FLOORED * result.verdict.floored
            axes.text(x + 0.5, y + 0.52, text, ha="center", va="center", fontsize=6)
    axes.set_xlim(0, len(values))
    axes.set_ylim(len(methods), 0)
    axes.set_xticks([i + 0.5 for i in range(len(values))])
    axes.set_xticklabels(labels(values), fontsize=6)
    axes.set_yticks([i + 0.5 for i in range(len(methods))])
    axes.set_yticklabels(methods, fontsize=6)
    axes.tick_params(length=0)
    axes.set_title(row.name, fontsize=8, loc="left", pad=3)
    for spine in axes.spines.values():
        spine.set_visible(False)


def _height(results):
    return len({result.cell.method for result in results}) + HEAD


def draw(results, path):
    """Fills the columns of the page from above, each with about half of the lines."""
    by_row = {}
    for result in results:
        by_row.setdefault(result.cell.row, []).append(result)
    total = sum(_height(found) for found in by_row.values())
    columns, filled = [[] for _ in range(COLUMNS)], 0.0
    for row, found in by_row.items():
        columns[min(COLUMNS - 1, int(COLUMNS * filled / total))].append((row, found))
        filled += _height(found)
    tallest = max(sum(_height(found) for _, found in column) for column in columns)
    figure = plt.figure(figsize=(7.0 * COLUMNS, 0.16 * tallest + 0.8), dpi=110)
    for number, column in enumerate(columns):
        top = tallest
        for row, found in column:
            top -= _height(found)
            box = [(number + 0.13) / COLUMNS, (top + 1.0) / (tallest + 4), 0.85 / COLUMNS,
                   (_height(found) - HEAD) / (tallest + 4)]
            panel(figure.add_axes(box), ROWS[row], found)
    handles = [Patch(color=green(s), label=f"right, {FEWEST_DIGITS + s * (MOST_DIGITS - FEWEST_DIGITS):.0f} digits")
               for s in (0.0, 0.5, 1.0)] + [Patch(color=c, label=name) for c, name in PLAIN.values()]
    handles.append(plt.Line2D([], [], linestyle="none", marker=f"${FLOORED}$", color="black",
                              label="digits counted from a floor"))
    figure.legend(handles=handles, loc="upper center", ncol=len(handles), fontsize=8, frameon=False)
    figure.savefig(path)
