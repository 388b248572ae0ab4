"""Solids meshed apart that nearly lie on each other: near_solids.py NDFRAME.

A block on a larger one: tilted or lifted a little, shifted by a little from a side of the same size, in other units, far from the
origin, stretched. Every run ends in an answer or in a message that says what to do, never in an assertion; a state that is not the
drawing's up to round-off is never called guaranteed.
"""

import pathlib
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program
from solid_scenes import Solid, pressure, write_scene

SMALL = (1e-12, 1e-10, 1e-9, 1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 1e-2)
EXACT = 1e-12  # a shift, lift or tilt below is round-off
TOLD = ("no part of one side lies on the other", "the sides are apart by", "the bodies overlap at the start", "cannot be cut to match")


def scenes():
    """(name, how far from round-off, place of the upper and of the lower body, cells of the lower one)"""
    large = lambda r, s, t: (1.4 * r, 1.4 * s, t - 1)
    for by in SMALL:
        yield f"tilted by {by}", by, lambda r, s, t, by=by: (r, s, 0.5 * t + by * r * (1 - t)), large, (4, 4, 1)
        for lift in (by, -by):
            yield f"lifted by {lift}", by, lambda r, s, t, by=lift: (r, s, 0.5 * t + by), large, (4, 4, 1)
        yield (f"shifted by {by}", None, lambda r, s, t, by=by: (r + by, s + 0.7 * by, 0.5 * t), lambda r, s, t: (r, s, t - 1), (3, 3, 1))
    for unit in (1e-3, 1e6):
        yield (f"in units of {unit}", 0.0, lambda r, s, t, k=unit: (k * r, k * s, 0.5 * k * t),
               lambda r, s, t, k=unit: (1.4 * k * r, 1.4 * k * s, k * (t - 1)), (4, 4, 1))
    for off in (1e3, 1e6):
        yield (f"{off} from the origin", 0.0, lambda r, s, t, k=off: (r + k, s - k, 0.5 * t + k),
               lambda r, s, t, k=off: (1.4 * r + k, 1.4 * s - k, t - 1 + k), (4, 4, 1))
    for aspect in (5, 20, 100):
        yield (f"stretched {aspect} to 1", 0.0, lambda r, s, t, k=aspect: (r, s / k, 0.5 * t),
               lambda r, s, t, k=aspect: (1.4 * r, 1.4 * s / k, t - 1), (4, 4, 1))


def judge(program, far, upper, lower, cells):
    """What is wrong, or None."""
    pair = (Solid("upper", (3, 3, 1), upper, "bottom", 1.0, 0.3, {"left": "Roller", "front": "Roller"}, {"press": pressure("top", "0.01")}),
            Solid("lower", cells, lower, "top", 1.0, 0.3, {"bottom": "Clamp"}, {}))
    with tempfile.TemporaryDirectory() as folder:
        run = program.run(write_scene(folder, *pair), "Error Estimation/Estimators={Global}", "Output/Exodus=false")
    if run.code == 2:
        return None if any(text in run.screen for text in TOLD) and far != 0.0 else run.screen[-300:]
    if run.code == 3:
        return None if "stiffness on the interface is lost in round-off" in run.screen else run.screen[-300:]
    if run.code != 0:
        return f"exit code {run.code}: {run.screen[-300:]}"
    if far is not None and far > EXACT and run.summary["errors"]["global"]["guaranteed"]:
        return "guaranteed, and not what was drawn"
    return None


def main():
    program, wrong = Program(sys.argv[1]), 0
    for name, *scene in scenes():
        problem = judge(program, *scene)
        wrong += problem is not None
        if problem:
            print(f"{name}: {problem}")
    print(f"{wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
