"""Plane bodies as they are deformed, coloured by von Mises stress: bodies.py NAME.e PICTURE.png [SCALE [XMIN XMAX YMIN YMAX]]

    /usr/bin/python3 docs/pictures/bodies.py bearing.e docs/pictures/bearing.png 1
    /usr/bin/python3 docs/pictures/bodies.py rigid-cylinder.e docs/pictures/rigid-cylinder.png 1   # Accuracy/Target=0.005
    /usr/bin/python3 docs/pictures/bodies.py flange.e docs/pictures/flange.png 100                 # Accuracy/Target=0.02

Every vertex has the mean of its cells' stresses, body by body; rigid bodies are grey. SCALE multiplies displacements.
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import netCDF4
import numpy as np
from matplotlib.tri import Triangulation


def names(file, variable):
    return [b"".join(row.compressed()).decode().strip("\0 ") for row in file[variable][:]]


def main():
    source, target = sys.argv[1:3]
    scale = float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
    file = netCDF4.Dataset(source)
    nodal, cell = names(file, "name_nod_var"), names(file, "name_elem_var")
    x, y = file["coordx"][:].filled(), file["coordy"][:].filled()
    for name, place in (("disp_x", x), ("disp_y", y)):
        place += scale * file[f"vals_nod_var{nodal.index(name) + 1}"][-1].filled()
        if (offset := name.replace("disp", "offset")) in nodal:
            place += file[f"vals_nod_var{nodal.index(offset) + 1}"][-1].filled()
    plt.style.use("default")
    figure, axes = plt.subplots(figsize=(7, 6), constrained_layout=True)
    pieces = []
    for block in range(1, len(file.dimensions["num_el_blk"]) + 1):
        corners = file[f"connect{block}"][:].filled()[:, :3] - 1
        stress = {k: file[f"vals_elem_var{cell.index('stress_' + k) + 1}eb{block}"][-1].filled()
                  for k in ("xx", "yy", "zz", "xy")}
        mises = np.sqrt(0.5 * ((stress["xx"] - stress["yy"]) ** 2 + (stress["yy"] - stress["zz"]) ** 2
                               + (stress["zz"] - stress["xx"]) ** 2) + 3.0 * stress["xy"] ** 2)
        total, count = np.zeros(len(x)), np.zeros(len(x))
        for k in range(3):
            np.add.at(total, corners[:, k], mises)
            np.add.at(count, corners[:, k], 1.0)
        pieces.append((corners, total / np.maximum(count, 1.0)))
    areas = np.concatenate([np.abs((x[c[:, 1]] - x[c[:, 0]]) * (y[c[:, 2]] - y[c[:, 0]])
                                   - (x[c[:, 2]] - x[c[:, 0]]) * (y[c[:, 1]] - y[c[:, 0]])) for c, _ in pieces])
    means = np.concatenate([values[c].mean(axis=1) for c, values in pieces])
    order = np.argsort(means)
    high = means[order][np.searchsorted(np.cumsum(areas[order]), 0.998 * areas.sum())]  # peaks at corners hide the rest
    levels = np.linspace(0.0, high, 25)
    for corners, values in pieces:
        triangles = Triangulation(x, y, corners)
        if not values[corners].any():
            axes.tripcolor(triangles, np.zeros(len(corners)), cmap="Greys", vmin=-1.0, vmax=1.0)
            continue
        drawn = axes.tricontourf(triangles, values, levels=levels, cmap="viridis", extend="max")
        axes.triplot(triangles, color="white", linewidth=0.15)
    if len(sys.argv) > 4:
        box = [float(value) for value in sys.argv[4:8]]
        axes.set_xlim(box[:2])
        axes.set_ylim(box[2:])
    axes.set_aspect("equal")
    figure.colorbar(drawn, label="von Mises stress", shrink=0.8)
    axes.set_xlabel("x")
    axes.set_ylabel("y")
    figure.savefig(target, dpi=110)


if __name__ == "__main__":
    main()
