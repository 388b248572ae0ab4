"""What the deck's probes found: a table of points and sides, curves along lines."""

import numpy
from matplotlib import pyplot

from .style import PAGE, plain_axis
from .words import number, vector

MOST_LINES = 12
AXES = "xyz"


def of_points(summary):
    """Heads and rows of the probes at one point."""
    heads = ["probe", "body", "at", ">displacement", ">von Mises stress", ">contact pressure", ">gap"]
    rows = [[probe["name"], probe["body"], vector(probe["point"]), vector(probe["displacement"]), number(probe["von_mises"]),
             number(probe["contact_pressure"]), number(probe["contact_gap"])]
            for probe in summary.get("probes") or [] if "point" in probe]
    return heads, rows


def of_sides(summary):
    """Heads and rows of the probes over sides."""
    heads = ["probe", "side", ">area or length", ">force", ">moment", "about", ">mean displacement"]
    rows = [[probe["name"], f"{probe['body']}: {probe['side']}", number(probe["measure"]), vector(probe["force"]),
             moment(probe), vector(probe["about"]), vector(probe["displacement"])]
            for probe in summary.get("probes") or [] if "side" in probe]
    return heads, rows


def moment(probe):
    """In the plane one number; what is left of a moment that forces cancel is none."""
    found = numpy.array(probe["moment"])
    arm = probe["measure"] if len(found) == 1 else probe["measure"] ** 0.5
    found[abs(found) <= 1e-12 * arm * max(map(abs, probe["force"]))] = 0.0
    return vector(found.tolist()) if len(found) > 1 else number(float(found[0]))


def of_lines(summary):
    """The probes along lines that are drawn, and how many are not."""
    lines = [probe for probe in summary.get("probes") or [] if len(probe.get("points") or []) > 1]
    return lines[:MOST_LINES], max(0, len(lines) - MOST_LINES)


def along_line(probe, inks=PAGE):
    """Displacement above, von Mises stress and contact pressure below, over the distance from the first point."""
    points = numpy.array([p["point"] for p in probe["points"]])
    lengths = numpy.linalg.norm(points - points[0], axis=1)
    figure, (upper, lower) = pyplot.subplots(2, 1, sharex=True, figsize=(5.0, 4.2))
    style = {"marker": "o" if len(lengths) <= 60 else None, "markersize": 2.5}
    for k, colour in zip(range(points.shape[1]), inks.series):
        upper.plot(lengths, [p["displacement"][k] for p in probe["points"]], color=colour, label=f"u {AXES[k]}", **style)
    upper.set_ylabel("displacement")
    upper.legend(loc="best")
    curves = [("von Mises stress", "von_mises"), ("contact pressure", "contact_pressure")]
    for (label, key), colour in zip(curves, inks.series):
        values = [p[key] for p in probe["points"]]
        if any(value is not None for value in values):
            lower.plot(lengths, [numpy.nan if value is None else value for value in values], color=colour, label=label, **style)
    low, high = lower.get_ylim()
    lower.set_ylim(min(0.0, low), high + 0.05 * (high - min(0.0, low)))  # 0 is in the picture
    lower.set_ylabel("stress")
    lower.set_xlabel(f"distance from {vector(probe['points'][0]['point'])}")
    lower.legend(loc="best")
    for axes in (upper, lower):
        axes.grid(True)
        plain_axis(axes.yaxis)
    plain_axis(lower.xaxis)
    return figure


def caption(probe):
    ends = [vector(probe["points"][end]["point"]) for end in (0, -1)]
    return f"{probe['name']}: {probe['body']} from {ends[0]} to {ends[1]}."
