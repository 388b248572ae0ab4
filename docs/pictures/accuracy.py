#!/usr/bin/python3
"""Draws what a target costs: bound against dofs and seconds beside uniform meshes, and the last meshes.

    /usr/bin/python3 docs/pictures/accuracy.py build/release/bin/ndframe docs/pictures

Needs python3-netcdf4 and python3-matplotlib. Takes half a minute; seconds want a quiet machine.
"""
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "apps"), str(ROOT / "python")]
import ndframe  # noqa: E402
from ndreport import fields, plane_view, style  # noqa: E402
from ndreport.bodies import Bodies  # noqa: E402
from ndreport.results import read_results  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402

DECKS = ROOT / "decks"
# scene: target of the curves, target of the mesh that is shown, cells of uniform meshes per body for one size
SCENES = {
    "punch": (1e-4, 0.00455, {"punch": (1, 1), "foundation": (2, 1)}, (4, 8, 16, 32, 64, 128)),
    "contact-loss": (1e-3, 0.005, {"upper": (5, 4), "lower": (10, 10)}, (2, 4, 8, 16)),
}


def run(program, folder, scene, settings):
    codes = (0, 4)  # expectations of the deck are about its own mesh
    return ndframe.run(DECKS / f"{scene}.xml", settings, folder=folder, program=program, codes=codes)


def adaptive(program, folder, scene, target):
    levels = run(program, folder, scene, {"Accuracy/Target": target}).levels
    return list(zip(levels["dofs"], levels["seconds"], levels["relative"]))


def uniform(program, folder, scene, bodies, sizes):
    points = []
    for size in sizes:
        cells = {f"Bodies/{body}/Mesh/Cells": [x * size, y * size] for body, (x, y) in bodies.items()}
        done = run(program, folder, scene, cells | {"Error Estimation/Estimators": ["Global"], "Coupling/Stopping/Tolerance": 1e-4})
        points.append((done.dofs, done.summary["ledger"]["total_seconds"], done.bound.relative))
    return points


def draw_curves(curves, path):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True)
    for colour, (scene, (refined, even)) in zip(style.PAPER.series, curves.items()):
        for axis, column in zip(axes, (0, 1)):
            for points, dashes, name in ((refined, "o-", "target"), (even, "s--", "uniform")):
                axis.loglog([p[column] for p in points], [100 * p[2] for p in points], dashes, color=colour,
                            markersize=4, linewidth=1, label=f"{scene}, {name}")
    for axis, label in zip(axes, ("degrees of freedom", "seconds, all levels so far")):
        axis.set(xlabel=label, ylabel="guaranteed bound, %")
        axis.grid(which="both", alpha=0.2)
    axes[0].legend(fontsize=8)
    figure.savefig(path, dpi=100, facecolor="white", metadata={"Software": None})


def draw_mesh(axes, stem, title):
    """The cells of a run, coloured by their contributions."""
    bodies = Bodies(read_results(str(stem)))
    norm = fields.contribution_norm(bodies, "eta_glob")
    for piece in bodies.elastic():
        shown = plane_view.cell_field(axes, bodies.points, piece, bodies.element("eta_glob", piece), norm)
    plane_view.mesh_lines(axes, bodies.points, bodies.elastic())
    plane_view.outline(axes, bodies.points, bodies.elastic(), style.PAPER.text)
    axes.autoscale()
    axes.set(aspect="equal", title=title)
    plane_view.colour_bar(axes.figure, axes, shown, "contribution of an element to the error", "both")


def main(program, pictures):
    curves = {}
    figure, axes = plt.subplots(1, 2, figsize=(12, 5.2), constrained_layout=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for axis, (scene, (target, shown, bodies, sizes)) in zip(axes, SCENES.items()):
            curves[scene] = adaptive(program, folder, scene, target), uniform(program, folder, scene, bodies, sizes)
            adaptive(program, folder, scene, shown)
            draw_mesh(axis, folder / scene, f"{scene}, {100 * shown:g} %")
    draw_curves(curves, pictures / "accuracy.png")
    figure.savefig(pictures / "accuracy-meshes.png", dpi=100, facecolor="white", metadata={"Software": None})


if __name__ == "__main__":
    with style.looks(style.PAPER):
        main(sys.argv[1], pathlib.Path(sys.argv[2]))
