"""The mesh that a run with a target ended with, solved and certified by itself: what knowing it would have saved."""

import pathlib
import tempfile

from bench.methods import ADAPTIVE, CERTIFIED, stopped_at
from bench.program import run, run_in

TOLERANCE = "1e-6"  # nearer to the limit than the balance goes: some more sweeps, which the seconds do not show

REPEATED = 3  # pairs in a round: they are short


def on_its_mesh(summary, path):
    """Settings that put the run of `summary` on the meshes in its Exodus file, which names a body's sides BODY:SIDE."""
    deck = summary["deck"]
    for body, lists in deck["Bodies"].items():
        mesh = f"Bodies/{body}/Mesh"
        yield from (f"{mesh}/Type=Exodus", f"{mesh}/File={path}", f"{mesh}/Blocks={{{body}}}")
        for kind in ("Supports", "Loads"):
            for name, entries in lists[kind].items():
                if "Side" in entries:
                    yield f"Bodies/{body}/{kind}/{name}/Side={body}:{entries['Side']}"
    for name, entries in deck["Interfaces"].items():
        for role in ("Dirichlet", "Neumann"):
            yield f"Interfaces/{name}/{role} Side={entries[f'{role} Body']}:{entries[f'{role} Side']}"


def pair(program, scene, target):
    """A run with a target, and the run of its last mesh alone."""
    with tempfile.TemporaryDirectory(prefix="ndbench-") as folder:
        whole = run_in(folder, program, scene.deck, ADAPTIVE.on(scene, target))
        path = next(pathlib.Path(folder).glob("*.e"))
        alone = (*scene.settings, *on_its_mesh(whole.summary, path), stopped_at(TOLERANCE), CERTIFIED)
        return whole, run(program, scene.deck, alone)


def least(pairs, seconds):
    """The least seconds of the whole runs and of those of their last mesh alone: other work only adds to short runs."""
    return [min(map(seconds, runs)) for runs in zip(*pairs)]
