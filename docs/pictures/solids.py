#!/usr/bin/python3
"""Draws an Exodus file of solids: deformed bodies coloured by stress, and their cells by what they add to the bound.

    ndframe -i decks/contact-loss-3d.xml --set "Accuracy/Target=0.03"
    /usr/bin/python3 docs/pictures/solids.py contact-loss-3d.e docs/pictures/solids.png 0.3

Seen from the corner where symmetry cuts: bodies that have moved apart are drawn apart.
Needs the Debian packages python3-matplotlib and python3-netcdf4; the product itself does not.
"""

import sys

import matplotlib
import netCDF4
import numpy

matplotlib.use("Agg")
from matplotlib import colors, pyplot
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

FACETS = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))


def names(file, variable):
    return [bytes(row.filled(b"\0") if numpy.ma.isMaskedArray(row) else row).split(b"\0")[0].decode()
            for row in file.variables[variable][:]]


def skin(cells):
    """Triangles of one cell only, and whose."""
    triangles = numpy.concatenate([cells[:, facet] for facet in FACETS])
    owners = numpy.tile(numpy.arange(len(cells)), len(FACETS))
    _, first, counts = numpy.unique(numpy.sort(triangles, axis=1), axis=0, return_index=True, return_counts=True)
    outside = first[counts == 1]
    return triangles[outside], owners[outside]


def draw(axes, file, variable, factor, norm, cmap, edges):
    points = numpy.stack([file.variables[f"coord{axis}"][:] for axis in "xyz"], axis=1)
    nodal, element = names(file, "name_nod_var"), names(file, "name_elem_var")
    moved = points + factor * numpy.stack(
        [file.variables[f"vals_nod_var{nodal.index(f'disp_{axis}') + 1}"][-1] for axis in "xyz"], axis=1)
    number = element.index(variable) + 1
    triangles, values = [], []
    for block in range(1, len(file.dimensions["num_el_blk"]) + 1):
        outside, owners = skin(file.variables[f"connect{block}"][:, :4] - 1)
        triangles.append(moved[outside])
        values.append(file.variables[f"vals_elem_var{number}eb{block}"][-1][owners])
    axes.add_collection3d(Poly3DCollection(numpy.concatenate(triangles), facecolors=cmap(norm(numpy.concatenate(values))),
                                           edgecolors=edges, linewidths=0.15))
    low, high = moved.min(axis=0), moved.max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(high - low)
    axes.view_init(elev=18, azim=222)
    axes.set_axis_off()


def main(path, picture, factor):
    with netCDF4.Dataset(path) as file:
        element = names(file, "name_elem_var")
        blocks = range(1, len(file.dimensions["num_el_blk"]) + 1)
        every = lambda name: numpy.concatenate(
            [file.variables[f"vals_elem_var{element.index(name) + 1}eb{block}"][-1].filled() for block in blocks])
        figure, panels = pyplot.subplots(1, 2, figsize=(12, 5), subplot_kw={"projection": "3d"})
        stress, share = every("stress_zz"), every("eta_glob")
        looks = (("stress_zz", colors.Normalize(*numpy.percentile(stress, (1, 99))), "viridis", "stress $\\sigma_{zz}$"),
                 ("eta_glob", colors.LogNorm(*numpy.percentile(share[share > 0], (2, 99.5))), "magma_r",
                  "contribution to the bound"))
        for axes, (variable, norm, cmap, label) in zip(panels, looks):
            draw(axes, file, variable, factor, norm, pyplot.get_cmap(cmap), "0.25")
            figure.colorbar(pyplot.cm.ScalarMappable(norm, cmap), ax=axes, shrink=0.6, label=label)
        figure.tight_layout()
        figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
