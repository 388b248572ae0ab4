"""What tests of solids of which several processes have shares have in common; the script's arguments are NDFRAME DECKS MPIEXEC."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from xml.etree import ElementTree

import netCDF4
import numpy

NDFRAME, DECKS, MPIEXEC = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]

PUNCH = ["Linear Solver/Type=Multigrid", "Bodies/punch/Mesh/Cells={2, 2, 2}", "Bodies/foundation/Mesh/Cells={4, 4, 2}",
         "Bodies/punch/Mesh/Refine=1", "Bodies/foundation/Mesh/Refine=1"]


def add(parent, name, *lists, **parameters):
    """A list with parameters; underscores of their names are spaces."""
    made = ElementTree.SubElement(parent, "ParameterList", name=name)
    for key, value in parameters.items():
        kind = "Array(double)" if isinstance(value, list) else {str: "string", float: "double", int: "int"}[type(value)]
        text = "{" + ", ".join(map(repr, value)) + "}" if isinstance(value, list) else str(value)
        ElementTree.SubElement(made, "Parameter", name=key.replace("_", " "), type=kind, value=text)
    for build in lists:
        build(made)
    return made


def kill_session(leader):
    """Kills all processes of a session at once: ranks would go on for a while without their mpiexec."""
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            session = int((entry / "stat").read_text().rpartition(")")[2].split()[3])
            if session == leader:
                os.kill(int(entry.name), signal.SIGKILL)
        except (FileNotFoundError, ProcessLookupError):
            pass


class SharesTest(unittest.TestCase):
    """Runs of decks in a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    @staticmethod
    def bare(name):
        """A deck without its certificate and what it expects of it."""
        root = ElementTree.parse(DECKS / f"{name}.xml").getroot()
        for part in list(root):
            if part.get("name") in ("Error Estimation", "Expect"):
                root.remove(part)
        return root

    def run_deck(self, root, ranks, *settings, name=None, before=(), more=()):
        name = name or f"np{ranks}"
        (self.folder / "deck.xml").write_bytes(ElementTree.tostring(root))
        options = [part for setting in (*settings, f"Output/Name={name}") for part in ("--set", setting)]
        launch = [MPIEXEC, "--oversubscribe", "-np", str(ranks), *before] if ranks > 1 else []
        done = subprocess.run([*launch, NDFRAME, "-i", "deck.xml", *options, *more], cwd=self.folder, capture_output=True, text=True)
        path = self.folder / f"{name}.summary.json"
        return done, json.loads(path.read_text()) if path.exists() else None

    def right(self, root, ranks, *settings, **options):
        done, summary = self.run_deck(root, ranks, *settings, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        if summary and ranks > 1:
            self.assertGreater(summary["ledger"]["counts"].get("shared bodies", 0), 0, "ranks have shares")
        return summary

    def killed(self, root, ranks, name, times, *settings):
        """A run that is killed when its checkpoint has come so many times; whether it was."""
        (self.folder / "deck.xml").write_bytes(ElementTree.tostring(root))
        options = [part for setting in (*settings, f"Output/Name={name}") for part in ("--set", setting)]
        process = subprocess.Popen([MPIEXEC, "--oversubscribe", "-np", str(ranks), NDFRAME, "-i", "deck.xml", *options], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        path, seen = self.folder / f"{name}.checkpoint", set()
        while process.poll() is None and len(seen) < times:
            if path.exists():
                seen.add(path.stat().st_mtime_ns)
            time.sleep(0.001)
        kill_session(process.pid)
        process.wait()
        return not (self.folder / f"{name}.summary.json").exists()

    def parts(self, name):
        return sorted(path.name for path in self.folder.glob(f"{name}.checkpoint.*"))

    def compare(self, one, other, path="probes"):
        """The same numbers but for the solver's tolerance."""
        self.assertEqual(type(one), type(other), path)
        if isinstance(one, dict):
            self.assertEqual(one.keys(), other.keys(), path)
            for key in one:
                self.compare(one[key], other[key], f"{path}/{key}")
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), path)
            for k, values in enumerate(zip(one, other)):
                self.compare(*values, f"{path}/{k}")
        elif isinstance(one, float):
            self.assertAlmostEqual(one, other, delta=2e-6, msg=path)
        else:
            self.assertEqual(one, other, path)

    def by_place(self, name):
        """Nodes of a file by block and place, with their values; the file is checked on the way."""
        with netCDF4.Dataset(self.folder / f"{name}.e") as file:
            file.set_auto_mask(False)
            text = lambda names: [row.tobytes().split(b"\0")[0].decode() for row in file[names][:]]
            points = numpy.stack([file[f"coord{axis}"][:] for axis in "xyz"], axis=1)
            nodal = {n: file[f"vals_nod_var{v + 1}"][-1] for v, n in enumerate(text("name_nod_var"))}
            used, found = [], {}
            for b, block in enumerate(text("eb_names")):
                nodes = file[f"connect{b + 1}"][:] - 1
                used.append(numpy.unique(nodes))
                cells = numpy.sort(nodes[:, :4], axis=1)
                centres = points[cells].mean(axis=1).round(9)
                self.assertEqual(len(numpy.unique(centres, axis=0)), len(centres), "every cell once")
                for middle, (a, c) in zip(nodes[:, 4:].T, ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))):
                    numpy.testing.assert_allclose(points[middle], (points[nodes[:, a]] + points[nodes[:, c]]) / 2, atol=1e-12)
                order = numpy.lexsort(points[used[-1]].round(9).T)
                found[block] = points[used[-1]][order], {n: v[used[-1]][order] for n, v in nodal.items()}
                order = numpy.lexsort(centres.T)
                found[block, "cells"] = centres[order], {
                    n: file[f"vals_elem_var{v + 1}eb{b + 1}"][-1][order] for v, n in enumerate(text("name_elem_var"))}
            numpy.testing.assert_array_equal(numpy.unique(numpy.concatenate(used)), numpy.arange(len(points)))
            connects = numpy.concatenate([file[f"connect{b + 1}"][:, :4] - 1 for b in range(len(text("eb_names")))])
            sides = numpy.array(((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)))
            for s, side in enumerate(text("ss_names")):
                facets = connects[file[f"elem_ss{s + 1}"][:] - 1][numpy.arange(len(file[f"elem_ss{s + 1}"])).reshape(-1, 1),
                                                                 sides[file[f"side_ss{s + 1}"][:] - 1]]
                centres = points[facets].mean(axis=1).round(9)
                order = numpy.lexsort(centres.T)
                values = {n: file[f"vals_sset_var{v + 1}ss{s + 1}"][-1][order]
                          for v, n in enumerate(text("name_sset_var")) if f"vals_sset_var{v + 1}ss{s + 1}" in file.variables}
                found["side", side] = centres[order], values
            found["times"] = file["time_whole"][:], {"all": file["vals_glo_var"][-1]}
        return found

    def compare_files(self, one, other, allowed=1e-6):
        whole, shared = self.by_place(one), self.by_place(other)
        self.assertEqual(whole.keys(), shared.keys())
        for part, (points, values) in whole.items():
            numpy.testing.assert_allclose(shared[part][0], points, atol=1e-9)
            self.assertEqual(values.keys(), shared[part][1].keys())
            for name, ours in values.items():
                numpy.testing.assert_allclose(shared[part][1][name], ours, atol=allowed, err_msg=f"{part} {name}")
