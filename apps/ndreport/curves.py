"""Curves: along interfaces, over sweeps and levels, over the cases of a study."""

import numpy
from matplotlib import pyplot

from .style import PAGE, log_axis, plain_axis

SIZE = (5.0, 3.0)


def along_interface(table, admissible, inks=PAGE):
    """Pressure above, gap below, over the length of the side.

    table: columns of NAME.contact.csv of one interface; admissible: [(start, end, value)] or None.
    """
    lengths = continued(table["arc_length"])
    figure, (upper, lower) = pyplot.subplots(2, 1, sharex=True, figsize=(5.0, 4.2), gridspec_kw={"height_ratios": [1.7, 1.0]})
    few = len(lengths) <= 60
    upper.plot(lengths, table["pressure"], color=inks.series[0], marker="o" if few else None, markersize=2.5, label="computed")
    if admissible:
        starts, ends, values = (numpy.array(c) for c in zip(*admissible))
        upper.hlines(values, starts, ends, color=inks.series[1], linewidth=1.4, label="admissible, mean of a facet")
        upper.legend(loc="best")
    lower.plot(lengths, table["gap"], color=inks.series[2], marker="o" if few else None, markersize=2.5)
    highest = 1.06 * max([*table["pressure"], *(step[2] for step in admissible or [])])
    upper.set_ylim(-0.03 * highest if highest > 0.0 else -1.0, highest if highest > 0.0 else 1.0)  # 0 is in the picture
    upper.set_ylabel("contact pressure")
    lower.set_ylabel("gap")
    lower.set_xlabel("length along the side")
    for axes in (upper, lower):
        axes.grid(True)
        plain_axis(axes.yaxis)
        mark_pieces(axes, table["arc_length"], lengths, inks)
    low, high = shown_part(lengths, numpy.array(table["pressure"]))
    lower.set_xlim(low, high)
    opening = max(gap for gap, place in zip(table["gap"], lengths) if low <= place <= high)
    if opening > 0.0:
        lower.set_ylim(-0.05 * opening, 1.05 * opening)
    plain_axis(lower.xaxis)
    if opening <= 1e-9 * max(1e-300, max(map(abs, table["u_dirichlet"]))):
        lower.set_ylim(-0.05, 1.0)
        lower.set_yticks([0.0])
    return figure


def continued(lengths):
    """Lengths of the connected pieces of a side, each of which begins with 0, one after the other."""
    lengths = numpy.array(lengths)
    begins = numpy.nonzero(numpy.diff(lengths) < 0.0)[0] + 1
    for begin in begins:
        lengths[begin:] += lengths[begin - 1] - lengths[begin]
    return lengths


def mark_pieces(axes, given, lengths, inks):
    for begin in numpy.nonzero(numpy.diff(given) < 0.0)[0] + 1:
        axes.axvline(lengths[begin], color=inks.soft, linewidth=0.8, linestyle=":")


def shown_part(lengths, pressure):
    """The pressed part and as much beside it, if that is less than half of the side."""
    pressed = lengths[pressure > 0.0]
    if pressed.size == 0:
        return lengths.min(), lengths.max()
    width = max(float(numpy.ptp(pressed)), 1e-3 * float(numpy.ptp(lengths)))
    low, high = max(lengths.min(), pressed.min() - 0.6 * width), min(lengths.max(), pressed.max() + 0.6 * width)
    return (low, high) if high - low < 0.5 * numpy.ptp(lengths) else (lengths.min(), lengths.max())


def sweeps(history, tolerance, inks=PAGE):
    """The stopping quantity over the sweeps, and the tolerance if that ended them."""
    figure, axes = pyplot.subplots(figsize=SIZE)
    values = [sweep["eps_tau"] for sweep in history]
    axes.semilogy([sweep["sweep"] for sweep in history], values, color=inks.series[0], marker="o")
    if tolerance:
        axes.axhline(tolerance, color=inks.series[1], linewidth=1.0, linestyle="--")
        axes.annotate("tolerance", (1.0, tolerance), xycoords=("axes fraction", "data"), ha="right", va="bottom", fontsize=8.5,
                      color=inks.series[1], xytext=(0, 2), textcoords="offset points")
    axes.xaxis.set_major_locator(pyplot.MaxNLocator(6, integer=True))
    axes.set_xlabel("sweep")
    axes.set_ylabel("stopping quantity eps_tau")
    axes.grid(True)
    log_axis(axes.yaxis)
    return figure


def levels(rows, target, inks=PAGE):
    """Bound and its parts over the degrees of freedom. `target` in the unit of the bound, or None."""
    figure, axes = pyplot.subplots(figsize=SIZE)
    dofs = [row["dofs"] for row in rows]
    looks = (("bound", "bound", "o", "-"), ("mesh", "mesh", "s", "--"), ("iteration", "iteration", "^", ":"))
    for (key, label, marker, style), colour in zip(looks, inks.series):
        points = [(d, row[key]) for d, row in zip(dofs, rows) if row[key] is not None and row[key] > 0.0]
        if points:
            axes.loglog(*zip(*points), marker=marker, linestyle=style, color=colour, label=label)
    if target:
        axes.axhline(target, color=inks.soft, linewidth=1.0, linestyle="--")
        axes.annotate("target", (0.0, target), xycoords=("axes fraction", "data"), va="bottom", fontsize=8.5, xytext=(3, 2),
                      textcoords="offset points")
    axes.set_xlabel("degrees of freedom")
    axes.set_ylabel("error in energy")
    axes.legend(loc="best")
    axes.grid(True)
    for axis in (axes.xaxis, axes.yaxis):
        log_axis(axis)
    return figure


def energies(rows, inks=PAGE):
    """Brackets of the exact energy, level by level: how far their ends lie from the middle of the last one."""
    figure, axes = pyplot.subplots(figsize=SIZE)
    middle = 0.5 * (rows[-1]["energy_bracket"]["lower"] + rows[-1]["energy_bracket"]["upper"])
    size = abs(middle) if middle != 0.0 else 1.0
    for row in rows:
        low, high = ((row["energy_bracket"][end] - middle) / size * 100.0 for end in ("lower", "upper"))
        axes.plot([row["level"]] * 2, [low, high], color=inks.series[0], linewidth=3.0, solid_capstyle="butt")
        axes.plot([row["level"]] * 2, [low, high], linestyle="none", marker="_", markersize=11, color=inks.series[0])
    axes.axhline(0.0, color=inks.soft, linewidth=0.8)
    axes.xaxis.set_major_locator(pyplot.MaxNLocator(6, integer=True))
    axes.set_xlabel("level")
    axes.set_ylabel("exact energy, %")
    axes.margins(x=0.15)
    axes.grid(True, axis="y")
    plain_axis(axes.yaxis)
    return figure


def trend(series, axis_label, quantity, categories, inks=PAGE):
    """One quantity of a study over one parameter.

    series: [(label, [x], [value], [guaranteed])]; categories: names of the x, or None where x are numbers.
    """
    figure, axes = pyplot.subplots(figsize=(3.6, 2.6))
    spans, values = [x for _, xs, *_ in series for x in xs], [y for _, _, ys, _ in series for y in ys]
    for i, (label, xs, ys, full) in enumerate(series):
        colour = inks.series[i % len(inks.series)]
        axes.plot(xs, ys, color=colour, linewidth=1.1, linestyle="-" if i < len(inks.series) else "--", label=label)
        filled = [(x, y) for x, y, f in zip(xs, ys, full) if f]
        hollow = [(x, y) for x, y, f in zip(xs, ys, full) if not f]
        axes.plot(*zip(*(filled or [(numpy.nan, numpy.nan)])), "o", color=colour)
        axes.plot(*zip(*(hollow or [(numpy.nan, numpy.nan)])), "o", markerfacecolor="none", markeredgecolor=colour)
    for axis, numbers, change in ((axes.xaxis, spans if categories is None else [], axes.set_xscale),
                                  (axes.yaxis, values, axes.set_yscale)):
        if numbers and min(numbers) > 0.0 and max(numbers) > 15.0 * min(numbers):
            change("log")
            log_axis(axis)
        else:
            plain_axis(axis)
    if categories is not None:
        axes.set_xticks(range(len(categories)), categories)
        axes.margins(x=0.12)
    axes.set_xlabel(axis_label)
    axes.set_title(quantity, loc="left")
    axes.grid(True)
    if len(series) > 1 and len(series) <= 6:
        axes.legend(fontsize=8, handlelength=1.2)
    return figure
