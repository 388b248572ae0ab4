#!/usr/bin/python3
"""The pictures of README and docs, by the code that draws the reports: deformed bodies, what elements add to the error.

    /usr/bin/python3 docs/pictures/pictures.py build/release/bin/ndframe docs/pictures [NAME...]

Needs python3-netcdf4 and python3-matplotlib. Takes half a minute.
"""
import pathlib
import sys
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "apps"), str(ROOT / "python")]
import ndframe  # noqa: E402
from matplotlib import image, pyplot  # noqa: E402
from ndreport import fields, plane_view, solid_view, style  # noqa: E402
from ndreport.bodies import Bodies, choose_scale  # noqa: E402
from ndreport.results import of_run  # noqa: E402

# picture: deck, settings, how it is drawn
SCENES = {
    "punch": ("punch", {}, "stress"),
    "bearing": ("bearing", {"Accuracy/Target": 0.01}, "stress"),
    "rigid-cylinder": ("rigid-cylinder", {"Accuracy/Target": 0.005}, "stress"),
    "flange": ("flange", {"Accuracy/Target": 0.02}, "stress"),
    "ball": ("rigid-plane-3d", {}, "solid"),
    "solids": ("contact-loss-3d", {"Accuracy/Target": 0.03}, "solid"),
}


def solved(program, folder, deck, settings):
    """The bodies of a run."""
    codes = (0, 4)  # expectations of the deck are about its own mesh
    return Bodies(of_run(ndframe.run(ROOT / "decks" / f"{deck}.xml", settings, folder=folder, program=program, codes=codes)))


def save(figure, path):
    figure.savefig(path, dpi=110, facecolor="white", metadata={"Software": None})
    pyplot.close(figure)


def draw_stress(bodies, path):
    norm, _, _ = fields.stress_norm(bodies)
    save(plane_view.stress_picture(bodies, choose_scale(bodies), norm, style.PAPER, width=7.0), path)


def draw_solid(bodies, path):
    """Stress and contributions side by side."""
    scale, view = choose_scale(bodies), solid_view.views(bodies)[0]
    norm, _, _ = fields.stress_norm(bodies)
    name = fields.contribution_name(bodies)
    figures = (solid_view.stress_picture(bodies, scale, norm, view, style.PAPER),
               solid_view.contribution_picture(bodies, scale, name, fields.contribution_norm(bodies, name), view, style.PAPER))
    parts = []
    for figure in figures:
        save(figure, path)
        parts.append(image.imread(path))
    rows = min(len(part) for part in parts)
    image.imsave(path, numpy.hstack([part[:rows] for part in parts]), metadata={"Software": None})


def main(program, pictures, *names):
    with tempfile.TemporaryDirectory() as holder, style.looks(style.PAPER):
        for name in names or SCENES:
            deck, settings, kind = SCENES[name]
            bodies = solved(pathlib.Path(program).resolve(), pathlib.Path(holder), deck, settings)
            {"stress": draw_stress, "solid": draw_solid}[kind](bodies, pathlib.Path(pictures) / f"{name}.png")


if __name__ == "__main__":
    main(*sys.argv[1:])
