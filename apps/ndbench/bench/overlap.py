"""What the true error of solids with a gap needs of the files of a run: overlap.py FOLDER.

Prints {work, points}: L(v), the work of the pressures of the deck, which have to be numbers, and [x, y, dS (w_v - g)] at points of the
facets of the interface, where the sides may overlap between nodes, w_v the jump of quadratic displacements. A process of its own: a run
that is measured later starts with the resident size of its parent (child.py), and numpy is large.
"""

import csv
import json
import pathlib
import sys

PARTS = 4  # of a facet's edges; each part has the one point that is exact for linear functions
# The nodes of Exodus's sides of tetrahedra: corners, outward, then the middles of their edges 01, 12, 20.
SIDES = ((0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (0, 3, 2, 7, 9, 6), (0, 2, 1, 6, 5, 4))


def points(parts=PARTS):
    """Barycentric coordinates of the centres of equal parts of a triangle."""
    for i in range(parts):
        for j in range(parts - i):
            yield (i + 1 / 3) / parts, (j + 1 / 3) / parts
            if j < parts - i - 1:
                yield (i + 2 / 3) / parts, (j + 2 / 3) / parts


def quadratic(a, b):
    """Nodal functions: corners, then the middles of the edges 01, 12, 20."""
    c = 1 - a - b
    return [v * (2 * v - 1) for v in (a, b, c)] + [4 * a * b, 4 * b * c, 4 * c * a]


def names_in(file, variable):
    return [row.tobytes().split(b"\0")[0].decode() for row in file[variable][:]]


def facets(file, side):
    """The nodes of a side's facets, facets x 6."""
    import numpy

    number = next(i + 1 for i, name in enumerate(names_in(file, "ss_names")) if name.endswith(side))
    cells = numpy.concatenate([file[f"connect{block + 1}"][:] - 1 for block in range(len(file.dimensions["num_el_blk"]))])
    own = cells[file[f"elem_ss{number}"][:] - 1]
    return own[numpy.arange(len(own))[:, None], numpy.array(SIDES)[file[f"side_ss{number}"][:] - 1]]


def twice_areas(corners):
    """Outward normals times twice the areas."""
    import numpy

    return numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def work_of_pressures(file, places, deck):
    """-sum p int u . n dS; the integral of a quadratic function is the mean of its values at the middles of edges."""
    import numpy

    number = {name: i + 1 for i, name in enumerate(names_in(file, "name_nod_var"))}
    u = numpy.stack([file[f"vals_nod_var{number[f'disp_{axis}']}"][-1] for axis in "xyz"], axis=1)
    work = 0.0
    for body, lists in deck["Bodies"].items():
        for load in lists["Loads"].values():
            nodes = facets(file, f"{body}:{load['Side']}")
            work -= float(load["Value"]) * float((u[nodes[:, 3:]].mean(axis=1) * twice_areas(places[nodes[:, :3]]) / 2).sum())
    return work


def overlaps(file, places, rows):
    import numpy

    place = lambda point: tuple(round(float(value), 9) + 0.0 for value in point)
    left = {place(float(row[axis]) for axis in "xyz"): float(row["gap"]) for row in rows}  # of the gap
    bary = numpy.array([(a, b, 1 - a - b) for a, b in points()])
    functions = numpy.array([quadratic(a, b) for a, b in points()])
    nodes = facets(file, ":dirichlet")
    areas = numpy.linalg.norm(twice_areas(places[nodes[:, :3]]), axis=1) / 2
    for own, area in zip(nodes, areas):
        values = functions @ [-left[place(places[node])] for node in own]
        for (x, y, _), value in zip(bary @ places[own[:3]], values):
            yield [float(x), float(y), float(value * area / len(bary))]


def main():
    import netCDF4
    import numpy

    folder = pathlib.Path(sys.argv[1])
    summary = json.loads(next(folder.glob("*.summary.json")).read_text())
    with open(next(folder.glob("*.contact.csv")), newline="") as table, netCDF4.Dataset(next(folder.glob("*.e"))) as file:
        file.set_auto_mask(False)
        places = numpy.stack([file[f"coord{axis}"][:] for axis in "xyz"], axis=1)
        found = {"work": work_of_pressures(file, places, summary["deck"]), "points": list(overlaps(file, places, csv.DictReader(table)))}
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
