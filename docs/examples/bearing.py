#!/usr/bin/python3
"""Runs decks/bearing.xml to a given accuracy and plots the results: the pressure, the stress on the bodies, the bound level by level.

    PYTHONPATH=build/release/share/ndframe /usr/bin/python3 docs/examples/bearing.py decks/bearing.xml bearing.png

Needs python3-netcdf4 and python3-matplotlib. Takes a few seconds. PYTHONPATH is the folder with the
module ndframe; with ndframe installed in /usr it is not needed.
"""

import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

import ndframe  # noqa: E402


def draw_pressure(axes, run):
    """Along the side, with the guaranteed error of the whole answer in the title."""
    side = run.contact["contact"]
    axes.plot(side["arc_length"], side["pressure"])
    axes.set(xlabel="length along the hole", ylabel="contact pressure",
             title=f"error in energy at most {100 * run.bound.relative:.2g} %, guaranteed: {run.bound.guaranteed}")


def draw_stress(axes, run, factor):
    """von Mises stress on both bodies, moved by `factor` times their displacements."""
    fields = run.fields
    x, y = (fields.points + factor * fields.displacement).T
    largest = max(fields.element("von_mises", body).max() for body in fields.blocks)
    for body in fields.blocks:
        shown = axes.tripcolor(x, y, fields.triangles(body), fields.element("von_mises", body), vmin=0.0, vmax=0.3 * largest)
    axes.set(aspect="equal", title=f"von Mises stress, displacements {factor} times")
    axes.figure.colorbar(shown, ax=axes, extend="max")


def draw_levels(axes, run):
    """The bound over degrees of freedom."""
    axes.loglog(run.levels["dofs"], 100.0 * run.levels["relative"], "o-")
    axes.set(xlabel="degrees of freedom", ylabel="bound of the error, %", title="level by level")


def main(deck, picture):
    with tempfile.TemporaryDirectory() as folder:
        run = ndframe.run(deck, {"Accuracy/Target": 0.01}, folder=folder)
        figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(15.0, 4.5), constrained_layout=True)
        draw_pressure(left, run)
        draw_stress(middle, run, 1)
        draw_levels(right, run)
    figure.savefig(picture)
    print(f"{run.title}: largest pressure {run.interfaces['contact']['largest_pressure']:.4g}, {run.dofs} dofs")


if __name__ == "__main__":
    main(*sys.argv[1:3])
