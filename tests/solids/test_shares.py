"""What several processes write and say of solids of which each has a share: test_shares.py NDFRAME DECKS MPIEXEC.

Probes, warnings and the one file of all are those of one process; only the order of nodes and elements in the file is the ranks'.
Runs that are ended go on on any number of processes, on as many with the same bits.
"""

import csv
import pathlib
import re
import sys
import unittest
from xml.etree import ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "python"))
sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "io"))
import exodus_pieces  # noqa: E402
import ndframe  # noqa: E402
import netCDF4  # noqa: E402
from shares_test import PUNCH, SharesTest, add  # noqa: E402


class Shares(SharesTest):
    def probed(self):
        root = self.bare("punch-3d")
        output = add(root, "Output")
        probes = add(output, "Probes")
        add(probes, "inside", Body="punch", At=[0.31, 0.47, 0.53])
        add(probes, "corner", Body="punch", At=[0.5, 0.5, 0.5])  # of many cells, of several ranks
        add(probes, "line", Body="foundation", From=[0.0, 0.0, -1.0], To=[2.0, 2.0, 0.0], Points=9)
        add(probes, "contact", Body="punch", From=[0.0, 0.0, 0.0], To=[1.0, 1.0, 0.0], Points=7)
        add(probes, "outside", Body="foundation", At=[1.0, 1.3, 0.004], Tolerance=0.01)
        add(probes, "top", Body="punch", Side="top")
        add(probes, "below", Body="foundation", Side="contact", About=[0.1, 0.2, 0.3])
        return root

    def test_probes_are_those_of_one_process(self):
        root = self.probed()
        one = self.right(root, 1, *PUNCH, "Output/Exodus=false")
        pressed = [point for probe in one["probes"] if probe["name"] == "contact" for point in probe["points"]]
        self.assertGreater(pressed[3]["contact_pressure"], 0.5)
        shared = self.right(root, 4, *PUNCH, "Output/Exodus=false")
        self.compare(one["probes"], shared["probes"])
        first, other = ((self.folder / f"np{n}.probes.csv").read_text().splitlines() for n in (1, 4))
        self.assertEqual((len(first), first[0]), (len(other), other[0]))

    def test_a_point_in_no_cell_is_refused_alike(self):
        root = self.probed()
        add(root.find("ParameterList[@name='Output']/ParameterList[@name='Probes']"), "nowhere", Body="punch", At=[0.5, 0.5, 1.5])
        messages = []
        for ranks in (1, 3):
            done, summary = self.run_deck(root, ranks, *PUNCH, "Output/Exodus=false")
            self.assertEqual((done.returncode, summary), (2, None), done.stdout)
            messages.append([line for line in done.stderr.splitlines() if "nowhere" in line])
        self.assertIn("(0.5, 0.5, 1.5) lies outside of \"punch\"", messages[0][0])
        self.assertEqual(messages[0], messages[1])

    def blocks(self, push):
        """Two blocks one above the other with nothing between them; the upper one grows by `push`."""
        root = ElementTree.Element("ParameterList", name="blocks")
        bodies = add(root, "Bodies")
        solid = dict(Young_Modulus=1.0, Poisson_Ratio=0.0, Hypothesis="Three Dimensional")
        for name, lower, upper, held in (("lower", [0.0, 0.0, 0.0], [1.0, 1.0, 1.0], "bottom"),
                                         ("upper", [0.3, 0.2, 1.002], [1.3, 1.1, 2.002], "top")):
            body = add(bodies, name)
            mesh = add(body, "Mesh", Type="Box", Lower=lower, Upper=upper, Refine=1)
            ElementTree.SubElement(mesh, "Parameter", name="Cells", type="Array(int)", value="{3, 3, 3}")
            add(body, "Material", **solid)
            add(add(body, "Supports"), "held", Type="Clamp", Side=held)
            if name == "upper":
                add(add(body, "Loads"), "pull", Type="Pressure", Side="bottom", Value=-push)
        ElementTree.SubElement(root, "Parameter", name="Strain Limit", type="double", value="10.0")
        return root

    def test_bodies_that_are_brought_into_each_other_get_the_warning_of_one_process(self):
        for push, count in ((0.009, 1), (0.001, 0)):
            root, found = self.blocks(push), []
            for ranks in (1, 2, 3):
                summary = self.right(root, ranks, "Linear Solver/Type=Multigrid", "Output/Exodus=false")
                found.append([warning for warning in summary["warnings"] if warning["kind"] == "overlapping bodies"])
            self.assertEqual([len(warnings) for warnings in found], [count] * 3, found)
            said = {re.sub(r" near \(.*?\)", "", warning["message"]) for warnings in found for warning in warnings}
            self.assertEqual(len(said), count, said)  # of equally deep points ranks may name another one

    def test_one_file_of_all_shares_is_that_of_one_process(self):
        root = self.bare("punch-3d")
        self.right(root, 1, *PUNCH)
        for ranks in (4,):
            (self.folder / f"np{ranks}.e.2.0").write_text("of an earlier run")
            self.right(root, ranks, *PUNCH, "Output/Exodus Files=Single")
            self.assertEqual([path.name for path in self.folder.glob(f"np{ranks}.e*")], [f"np{ranks}.e"])
            self.compare_files("np1", f"np{ranks}")
        whole, shared = (ndframe.read(str(self.folder / f"np{ranks}")).fields for ranks in (1, 4))
        self.assertEqual((whole.blocks, whole.sides), (shared.blocks, shared.sides))

    def test_one_file_of_load_cases(self):
        root = self.bare("punch-3d")
        cases = add(root, "Load Cases")
        ElementTree.SubElement(cases, "Parameter", name="Names", type="Array(string)", value="{once, twice}")
        add(cases, "Factors", **{"Bodies/punch/Loads/press": [1.0, 2.0]})
        for ranks, *files in ((1,), (3, "Output/Exodus Files=Single")):
            done, _ = self.run_deck(root, ranks, *PUNCH, *files)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.compare_files("np1", "np3")
        done, _ = self.run_deck(root, 2, *PUNCH, "Output/Exodus Files=Pieces")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        exodus_pieces.Pieces(self.folder.glob("np2.e.2.*")).check_maps()

    def test_where_the_file_cannot_be_written_nothing_is_left(self):
        (self.folder / "np3.e").mkdir()
        done, _ = self.run_deck(self.bare("punch-3d"), 3, *PUNCH, "Output/Exodus Files=Single")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertEqual(done.stderr.count('cannot write "np3.e": it is a folder'), 1, done.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["deck.xml", "np3.e"])

    def test_a_full_disk_of_one_process_leaves_nothing(self):
        limited = ["sh", "-c", 'test "$OMPI_COMM_WORLD_RANK" = 1 && ulimit -f 80; exec "$0" "$@"']
        done, _ = self.run_deck(self.bare("punch-3d"), 2, *PUNCH, "Output/Exodus Files=Single", before=limited)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stderr.count('cannot write "np2.e": '), 1, done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["deck.xml"])

    LOSS = ["Linear Solver/Type=Multigrid", "Bodies/upper/Mesh/Cells={3, 3, 2}", "Bodies/lower/Mesh/Cells={6, 6, 3}",
            "Bodies/upper/Mesh/Refine=1", "Bodies/lower/Mesh/Refine=1", "Output/Checkpoint=true", "Output/Exodus Files=Pieces"]

    def test_fields_of_the_certificate_take_what_they_take_on_one_process(self):
        root, all_of_them = self.bare("contact-loss-3d"), "Error Estimation/Estimators={Global, Algorithm, Discretization}"
        counts, bounds = [], []
        for ranks in (1, 3):
            summary = self.right(root, ranks, *self.LOSS, all_of_them)
            counts.append(summary["ledger"]["counts"])
            bounds.append([summary["errors"][name]["absolute"] for name in ("global", "algorithm", "discretization")])
        for count in ("Krylov solves", "multigrid set-ups"):
            self.assertEqual(counts[0][count], counts[1][count], count)
        self.assertGreater(counts[0]["multigrid set-ups"], 2, "every body has cycles of its own")
        self.assertLessEqual(counts[1]["Krylov iterations"], 1.2 * counts[0]["Krylov iterations"])
        for one, shared in zip(*bounds):
            self.assertAlmostEqual(shared / one, 1.0, delta=1e-7)

    def test_killed_runs_go_on_on_any_number_of_processes(self):
        """Of shares or of whole bodies, and from either to the other."""
        root, caught = self.bare("contact-loss-3d"), 0
        whole = {ranks: self.right(root, ranks, *self.LOSS, name=f"whole{ranks}") for ranks in (1, 3)}
        self.assertEqual(self.parts("whole3"), [], "a run that has ended leaves no parts")
        for first, passes, others in ((3, 1, (1, 3, 4)), (3, 2, (2, 3)), (1, 1, (1, 3)), (1, 2, (2, 4))):
            self.put({})
            if not self.killed(root, first, "killed", passes, *self.LOSS):
                continue
            caught += 1
            kept = {path.name: path.read_bytes() for path in self.folder.glob("killed.checkpoint*")}
            self.assertEqual(len(self.parts("killed")) >= 3, first == 3, kept.keys())
            for ranks in others:
                self.go_on(root, kept, ranks, first, whole[first])
            if first == 3:
                name = next(name for name in kept if name.endswith(".3.1"))
                self.put(kept)
                (self.folder / name).unlink()
                done, _ = self.run_deck(root, 3, *self.LOSS, name="killed", more=["--restart"])
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(name, done.stderr)
            (self.folder / "killed.summary.json").unlink(missing_ok=True)
        self.assertGreater(caught, 1)

    def put(self, kept):
        for path in self.folder.glob("killed.checkpoint*"):
            path.unlink()
        for name, content in kept.items():
            (self.folder / name).write_bytes(content)

    def go_on(self, root, kept, ranks, first, whole):
        """What `first` processes have kept."""
        self.put(kept)
        (self.folder / "killed.summary.json").unlink(missing_ok=True)
        done, summary = self.run_deck(root, ranks, *self.LOSS, name="killed", more=["--restart"])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, "status pass(es)? (is|are) not solved again")
        self.assertEqual(self.parts("killed"), [])
        self.assertEqual(summary["interfaces"][0]["closed_nodes"], whole["interfaces"][0]["closed_nodes"])
        self.assertAlmostEqual(summary["energy"] / whole["energy"], 1.0, delta=0.0 if ranks == first else 1e-8)
        if ranks == first:
            tables = [(self.folder / f"{name}.contact.csv").read_bytes() for name in ("killed", f"whole{ranks}")]
            self.assertEqual(tables[0], tables[1])

    def test_contact_is_told_in_one_order(self):
        """Tables of processes with shares and of one with all name the same places row by row."""
        root, rows = self.bare("contact-loss-3d"), []
        for ranks in (1, 2, 4):
            self.right(root, ranks, *self.LOSS)
            with open(self.folder / f"np{ranks}.contact.csv") as file:
                rows.append([[line[key] for key in ("x", "y", "z")] for line in csv.DictReader(file)])
        self.assertGreater(len(rows[0]), 100)
        self.assertEqual(rows[0], rows[1])
        self.assertEqual(rows[0], rows[2])

    def test_vtk_reads_the_one_file(self):
        try:
            from vtkmodules.vtkIOExodus import vtkExodusIIReader
        except ImportError:
            self.skipTest("VTK is not installed")
        self.right(self.bare("punch-3d"), 3, *PUNCH, "Output/Exodus Files=Single")
        reader = vtkExodusIIReader()
        reader.SetFileName(str(self.folder / "np3.e"))
        reader.UpdateInformation()
        reader.SetAllArrayStatus(vtkExodusIIReader.NODAL, 1)
        reader.Update()
        blocks = reader.GetOutput().GetBlock(0)
        with netCDF4.Dataset(self.folder / "np3.e") as file:
            cells = [len(file[f"connect{b + 1}"]) for b in range(2)]
            self.assertEqual([blocks.GetBlock(b).GetNumberOfCells() for b in range(2)], cells)
        self.assertGreater(abs(blocks.GetBlock(0).GetPointData().GetArray("disp_").GetRange(2)[0]), 0.1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
