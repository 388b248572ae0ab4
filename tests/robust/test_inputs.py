"""Decks and meshes that are something else, cut off, or changed by somebody while they are read."""

import json
import os
import random
import shutil
import sys
import threading
import time

import netCDF4

from robust import DECKS, PROGRAM, RoughWorld, main, on_ranks

sys.path.insert(0, str(DECKS.parent / "python"))
from ndframe import deck_text  # noqa: E402

# One body, so that a result belongs to one state of the file.
BODY = {"Material": {"Young Modulus": 1.0, "Poisson Ratio": 0.3},
        "Supports": {"ground": {"Type": "Clamp", "Side": "bottom"}},
        "Loads": {"press": {"Type": "Pressure", "Side": "contact", "Value": 1.0}}}
READERS = {"mesh.e": ("Exodus", "Blocks", "punch-foundation.e"),
           "mesh.msh": ("Gmsh", "Regions", "punch-foundation-2.2.msh")}
RUNS = 12


def stretch_exodus(path):
    with netCDF4.Dataset(path, "r+") as mesh:
        mesh["coordy"][:] *= 2


def stretch_msh(path):
    head, rest = path.read_text().split("$Nodes\n")
    nodes, tail = rest.split("$EndNodes")
    count, *lines = nodes.splitlines()
    moved = [f"{number} {x} {2 * float(y)!r} {z}" for number, x, y, z in map(str.split, lines)]
    path.write_text(head + "$Nodes\n" + "\n".join([count, *moved]) + "\n$EndNodes" + tail)


class Rewriter(threading.Thread):
    """Writes one content after the other into a file, in two halves, until it is stopped."""

    def __init__(self, path, contents):
        super().__init__()
        self.path, self.contents = path, contents
        self.stopped = threading.Event()

    def run(self):
        draw = random.Random(1)
        while not self.stopped.is_set():
            content = draw.choice(self.contents)
            with open(self.path, "r+b" if draw.random() < 0.5 else "wb") as file:  # in place, or cut off first
                for half in (content[:len(content) // 2], content[len(content) // 2:]):
                    file.write(half)
                    file.flush()
                    time.sleep(draw.uniform(0.005, 0.02))
            time.sleep(draw.uniform(0, 0.2))

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *failure):
        self.stopped.set()
        self.join()


class Decks(RoughWorld):
    def test_what_is_no_deck_is_refused_at_once(self):
        os.mkfifo(self.folder / "pipe")
        (self.folder / "binary").write_bytes(PROGRAM.read_bytes()[:100_000])
        (self.folder / "folder").mkdir()
        for deck, message in (("pipe", "is not a regular file"), ("folder", "is a directory"), ("/dev/zero", "regular"),
                              ("binary", "is not UTF-8 text"), ("none", "No such file or directory")):
            self.assert_refused(self.run_program("-i", deck), message, "1 error; nothing was computed.")


class Meshes(RoughWorld):
    def prepare(self, name):
        """The deck of a mesh file, and the file's path."""
        reader, choice, source = READERS[name]
        mesh = {"Type": reader, "File": name, choice: ["foundation"]}
        (self.folder / "one.xml").write_text(deck_text({"Bodies": {"block": {"Mesh": mesh, **BODY}}}, "one"))
        shutil.copy(DECKS / "meshes" / source, self.folder / name)
        return self.folder / name

    def energy(self):
        done = self.run_program("-q", "-i", "one.xml")
        if done.returncode != 0:
            self.assert_refused(done, "one.xml", "nothing was computed")
            return None
        return json.loads((self.folder / "one.summary.json").read_text())["energy"]

    def test_a_file_that_changes_is_right_or_refused(self):
        for name, stretch in (("mesh.e", stretch_exodus), ("mesh.msh", stretch_msh)):
            path = self.prepare(name)
            contents, energies = [path.read_bytes()], [self.energy()]
            stretch(path)
            contents.append(path.read_bytes())
            energies.append(self.energy())
            self.assertGreater(energies[1], 1.2 * energies[0])
            with Rewriter(path, contents):
                found = [self.energy() for _ in range(RUNS)]
            for energy in found:
                if energy is not None:
                    self.assertTrue(any(abs(energy - right) < 1e-10 * right for right in energies), found)

    def test_a_cut_off_file_is_refused_by_one_voice(self):
        for name in READERS:
            path = self.prepare(name)
            path.write_bytes(path.read_bytes()[:-1000])
            for command in ((PROGRAM, "-q", "-i", "one.xml"), on_ranks(2, PROGRAM, "-q", "-i", "one.xml")):
                done = self.run_command(*command)
                self.assert_refused(done, "Bodies/block/Mesh")
                self.assertEqual(done.stderr.count(f"{name}: "), 1, done.stderr)

    def test_a_script_without_end_is_ended(self):
        mesh = {"Type": "Gmsh", "File": "loop.geo", "Maximum Seconds": 1}
        (self.folder / "one.xml").write_text(deck_text({"Bodies": {"block": {"Mesh": mesh, **BODY}}}, "one"))
        (self.folder / "loop.geo").write_text("For i In {0:1e9}\n  x = i;\nEndFor\n")
        for command in ((PROGRAM, "-i", "one.xml"), on_ranks(2, PROGRAM, "-i", "one.xml")):
            self.assert_refused(self.run_command(*command), "loop.geo: gmsh did not finish within 1 s")

    def test_a_pipe_is_refused(self):
        for name in READERS:
            self.prepare(name).unlink()
            os.mkfifo(self.folder / name)
            self.assert_refused(self.run_program("-q", "-i", "one.xml"), "not a regular file")


if __name__ == "__main__":
    main()
