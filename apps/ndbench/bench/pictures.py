"""The pictures of a campaign. Imports matplotlib: only after the last measurement (child.py)."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from bench.analysis import exponents, power_law
from bench.campaign import BETWEEN, OUTSIDE

LEGEND = 0.2  # share of a picture's height, at the bottom
DOFS_FITTED = 10_000  # below, starting the program is most of the time


def groups(rows, *keys):
    """Rows by the values of `keys`, in their order of appearance."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row[key] for key in keys), []).append(row)
    return found


def panels(rows):
    scenes = groups(rows, "scene")
    size = (4.6 * len(scenes), 4.6)
    figure, axes = plt.subplots(1, len(scenes), figsize=size, squeeze=False, constrained_layout=True)
    figure.get_layout_engine().set(rect=(0, LEGEND, 1, 1 - LEGEND))
    return figure, [(scene, ax, own) for ((scene,), own), ax in zip(scenes.items(), axes[0])]


def save(figure, path):
    figure.savefig(path, dpi=90, metadata={"Software": None})
    plt.close(figure)


def styles(rows):
    """Colour and mark of every method, the same in all panels."""
    names = [name for (name,) in groups(rows, "method")]
    return {name: {"color": f"C{i}", "marker": "osD^vP*X<>"[i % 10]} for i, name in enumerate(names)}


def legend(figure, style, below=None):
    handles = [plt.Line2D([], [], **each, markersize=5, linewidth=1) for each in style.values()]
    figure.legend(handles, list(style), loc="lower center", ncols=4, fontsize=9, title=below)


def slope(axes, rows, x, y):
    """The exponent of the three finest sizes, written beside the last point."""
    points = [(row[x], row[y]) for row in rows][-3:]
    if len(points) == 3:
        axes.annotate(f"{power_law(points)[0]:.2f}", points[-1], fontsize=8, xytext=(4, 2), textcoords="offset points")


def label_in_percent(axis):
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{100 * value:g} %"))
    axis.set_minor_formatter(NullFormatter())


def error_against(rows, x, label, path):
    """Errors with the reference's bracket as error bars. Errors the reference is too coarse for are not drawn."""
    figure, parts = panels(rows)
    style = styles(rows)
    for scene, axes, own in parts:
        for (method,), line in groups(own, "method").items():
            shown = [row for row in line if row["error_sharp"]]
            if not shown:
                continue
            where, errors = [row[x] for row in shown], [row["error"] for row in shown]
            below, above = zip(*[(row["error"] - row["error_low"], row["error_high"] - row["error"]) for row in shown])
            axes.errorbar(where, errors, (below, above), **style[method], markersize=5, linewidth=1, capsize=3)
            if x == "dofs":
                slope(axes, shown, x, "error")
            bounds = [(row[x], row["bound"]) for row in shown if row["bound"]]
            axes.plot(*zip(*bounds or [((), ())]), ":", color=style[method]["color"], linewidth=1)
        axes.set(title=scene, xlabel=label, ylabel="true error, of the norm of the solution", xscale="log", yscale="log")
        label_in_percent(axes.yaxis)
        axes.grid(which="both", alpha=0.2)
    exponents = "; figures: exponent of the last three sizes" if x == "dofs" else ""
    legend(figure, style, "dotted: the guaranteed bound" + exponents)
    save(figure, path)


def time_against_dofs(rows, path):
    """Processor seconds, with the fitted exponents, with and without the start, in the legend of each panel."""
    figure, parts = panels(rows)
    style = styles(rows)
    for scene, axes, own in parts:
        for (method,), line in groups(own, "method").items():
            points = [(row["dofs"], row["seconds"]) for row in line]
            fitted = [point for point in points if point[0] >= DOFS_FITTED]
            fits = exponents(fitted, line[0]["start"])
            text = ", ".join("-" if fit is None else f"{fit:.2f}" for fit in fits)
            axes.plot(*zip(*points), **style[method], markersize=5, linewidth=1, label=text)
        axes.plot(*zip(*[(row["dofs"], row["yardstick"]) for row in own if row["method"] == own[0]["method"]]),
                  "k--", linewidth=1, label="yardstick")
        axes.set(title=scene, xlabel="degrees of freedom", ylabel="processor seconds", xscale="log", yscale="log")
        axes.grid(which="both", alpha=0.2)
        axes.set_ylim(top=axes.get_ylim()[1] * 100)  # the lines rise to the right; the upper left is the legend's
        axes.legend(fontsize=7, title=f"exponent from {DOFS_FITTED} dofs,\nand without the start", title_fontsize=7,
                    loc="upper left", ncols=2)
    legend(figure, style)
    save(figure, path)


def stage_shares(stages, path):
    """Stacked shares of the stages in the seconds of a run, at each method's finest size."""
    figure, parts = panels(stages)
    names = list(dict.fromkeys(row["stage"] for row in stages))
    names.sort(key=lambda name: (name == OUTSIDE, name == BETWEEN))  # the others in the order in which they run
    colours = {name: plt.get_cmap("tab20")(i % 20) for i, name in enumerate(names)} | {OUTSIDE: "0.85"}
    for scene, axes, own in parts:
        for (method,), mine in groups(own, "method").items():
            mine = [row for row in mine if row["dofs"] == max(row["dofs"] for row in mine)]
            total, left = sum(row["wall"] for row in mine), 0.0
            for row in sorted(mine, key=lambda row: names.index(row["stage"])):
                label = f"{method}\n{row['dofs']:,} dofs, {total:.2g} s"
                axes.barh(label, row["wall"] / total, left=left, color=colours[row["stage"]])
                left += row["wall"] / total
        axes.invert_yaxis()
        axes.tick_params(axis="y", labelsize=8)
        axes.set(title=scene, xlabel="share of the run", xlim=(0, 1))
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour) for colour in colours.values()]
    figure.legend(handles, names, loc="lower center", ncols=8, fontsize=9)
    save(figure, path)


def draw_solids(rows, folder):
    error_against(rows, "seconds", "processor seconds, start to exit", folder / "bench-solids.png")


def draw(rows, stages, folder):
    error_against(rows, "wall", "seconds, start to exit", folder / "bench-error-time.png")
    error_against(rows, "dofs", "degrees of freedom", folder / "bench-error-dofs.png")
    time_against_dofs(rows, folder / "bench-time-dofs.png")
    stage_shares(stages, folder / "bench-stages.png")
