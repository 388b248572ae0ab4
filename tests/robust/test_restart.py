"""Output/Checkpoint and --restart: a run that was ended goes on, with the bits of one that was not."""

import json
import random
import time

import netCDF4

from robust import DECKS, PROGRAM, PUNCH, SECONDS, RoughWorld, end_session, limited, main, on_ranks

# What differs from run to run, and what a restart may change.
TIMES = ("seconds", "total_seconds", "peak_bytes", "bytes written", "stages")
LIMITS = ("Maximum Levels", "Maximum Dofs")
PRECISE = ("Accuracy/Target=0.0005",)
BEGIN_AGAIN = "run without --restart, from the beginning."


def numbers(node, path=""):
    """path -> leaf of a summary."""
    if isinstance(node, dict):
        found = {}
        for key, value in node.items():
            if key not in TIMES + LIMITS and f"{path}/{key}" != "/deck/Output":
                found.update(numbers(value, f"{path}/{key}"))
        return found
    if isinstance(node, list):
        return {key: value for i, entry in enumerate(node) for key, value in numbers(entry, f"{path}/{i}").items()}
    return {path: node}


def fields(path):
    """name -> bytes of a variable of an Exodus file."""
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        return {name: variable[:].tobytes() for name, variable in file.variables.items()
                if not name.startswith(("qa_records", "info_records"))}


class Restarts(RoughWorld):
    def command(self, name, deck, settings, *more, ranks=1):
        """A run that leaves its files in the folder `name`."""
        command = [PROGRAM, "-i", deck, *more]
        for setting in ("Output/Checkpoint=true", f"Output/Directory={name}", *settings):
            command += ["--set", setting]
        return on_ranks(ranks, *command) if ranks > 1 else command

    def end(self, name, deck, settings, *more, code=0, ranks=1):
        done = self.run_command(*self.command(name, deck, settings, *more, ranks=ranks))
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def checkpoint(self, name):
        return next((self.folder / name).glob("*.checkpoint"))

    def results(self, name):
        folder = self.folder / name
        summary = json.loads(next(folder.glob("*.summary.json")).read_text())
        return summary, numbers(summary), fields(next(folder.glob("*.e")))

    def assert_same(self, name, other):
        (_, ours, our_fields), (_, theirs, their_fields) = self.results(name), self.results(other)
        keys = [key for key in {*ours, *theirs} if "reduction" not in key]  # those are of the processes that went on
        self.assertEqual({}, {key: (ours.get(key), theirs.get(key)) for key in keys if ours.get(key) != theirs.get(key)})
        self.assertEqual(our_fields, their_fields)

    def assert_goes_on(self, deck, *settings, code=0):
        """After every level: a limit of levels ends the runs that are gone on with."""
        path = DECKS / f"{deck}.xml"
        self.end("whole", path, settings, code=code)
        levels = self.results("whole")[0]["accuracy"]["number_of_levels"]
        self.assertGreater(levels, 2)
        for level in range(1, levels):
            name = f"to-{level}"
            self.end(name, path, (*settings, f"Accuracy/Maximum Levels={level}"), code=5)
            done = self.end(name, path, settings, "--restart", code=code)
            self.assertIn("level 1 is not solved again" if level == 1 else f"levels 1 to {level} are not", done.stdout)
            self.assert_same(name, "whole")


class AfterEachLevel(Restarts):
    def test_in_the_plane(self):
        self.assert_goes_on("punch", "Accuracy/Target=0.003")

    def test_where_contact_opens(self):
        self.assert_goes_on("contact-loss", "Accuracy/Target=0.005", "Error Estimation/Mode=Strict")

    def test_with_sides_that_are_cut(self):
        self.assert_goes_on("drawn-punch", "Accuracy/Target=0.01")

    def test_with_meshes_that_are_made_again(self):
        self.assert_goes_on("drawn-punch", "Accuracy/Target=0.005", "Accuracy/Refinement/Type=Remesh")

    def test_with_solids_that_are_made_again(self):
        self.assert_goes_on("stamp-3d", "Accuracy/Target=0.06", "Accuracy/Refinement/Type=Remesh")

    def test_with_tied_and_rigid_bodies(self):
        self.assert_goes_on("flange", "Accuracy/Target=0.04")

    def test_in_space(self):
        self.assert_goes_on("rigid-plane-3d", "Accuracy/Target=0.05", code=4)

    def test_with_two_levels_of_a_solver(self):
        self.assert_goes_on("punch-3d", "Accuracy/Target=0.06", "Linear Solver/Type=Multigrid", code=4)

    def test_from_factors_to_two_levels_of_a_solver(self):
        """A level that is factored leaves its displacements to one that is not."""
        settings, path = ("Accuracy/Target=0.018",), DECKS / "punch-3d.xml"
        self.end("whole", path, settings, code=4)
        counts = self.results("whole")[0]["ledger"]["counts"]
        self.assertGreater(counts["multigrid set-ups"], 0)
        self.assertEqual(self.results("whole")[0]["accuracy"]["number_of_levels"], 5)
        self.end("to-4", path, (*settings, "Accuracy/Maximum Levels=4"), code=5)
        self.end("to-4", path, settings, "--restart", code=4)
        self.assert_same("to-4", "whole")

    def test_without_interfaces_and_with_markings_that_do_not_aim(self):
        self.assert_goes_on("punch", "Accuracy/Target=0.03", "Accuracy/Marking/Type=Doerfler")

    def test_where_the_best_level_is_not_the_last(self):
        """A limit of dofs that is met: the answer is computed once more."""
        settings = ("Accuracy/Target=0.0001", "Accuracy/Maximum Dofs=3000")
        self.end("whole", PUNCH, settings, code=5)
        self.end("again", PUNCH, settings, "--restart", code=2)
        self.end("again", PUNCH, (*settings, "Accuracy/Maximum Levels=3"), code=5)
        self.end("again", PUNCH, settings, "--restart", code=5)
        self.assert_same("again", "whole")

    def test_with_interfaces_that_are_found(self):
        self.assert_goes_on("automatic", "Accuracy/Target=0.02", "Bodies/lintel/Loads/press/Value=1+x", code=4)

    def test_with_more_dofs_than_before(self):
        self.end("raised", PUNCH, ("Accuracy/Target=0.003", "Accuracy/Maximum Dofs=1500"), code=5)
        self.end("raised", PUNCH, ("Accuracy/Target=0.003",), "--restart")
        self.assertTrue(self.results("raised")[0]["accuracy"]["reached"])

    def test_with_the_limit_that_has_ended_it(self):
        """Nothing is left to do but the answer once more, one sweep on."""
        settings = ("Accuracy/Target=0.0001", "Accuracy/Maximum Dofs=3000")
        self.end("run", PUNCH, settings, code=5)
        before = self.results("run")[0]
        self.end("run", PUNCH, settings, "--restart", code=5)
        after = self.results("run")[0]
        self.assertEqual(after["accuracy"]["number_of_levels"], before["accuracy"]["number_of_levels"])
        self.assertAlmostEqual(after["energy"] / before["energy"], 1.0, delta=1e-3)


class Killed(Restarts):
    def kill_after(self, process, name, checkpoints, delay):
        """Kills a run some time after so many new checkpoints; False when it ended before."""
        path, seen, end = self.folder / name / "punch.checkpoint", None, time.monotonic() + SECONDS
        seen = path.stat().st_mtime_ns if path.exists() else None
        while checkpoints > 0 and process.poll() is None and time.monotonic() < end:
            now = path.stat().st_mtime_ns if path.exists() else None
            checkpoints -= now != seen
            seen = now
        time.sleep(delay)
        ended = process.poll() is not None
        end_session(process)
        return not ended

    def test_anywhere_and_again_and_again(self):
        self.end("whole", PUNCH, PRECISE)
        kills = 0
        for seed in range(12):
            name, chance = f"killed-{seed}", random.Random(seed)
            goes_on = ()
            for _ in range(4):
                process = self.start(*self.command(name, PUNCH, PRECISE, *goes_on))
                kills += self.kill_after(process, name, chance.randint(0, 2), 0.08 * chance.random())
                goes_on = ("--restart",) if (self.folder / name / "punch.checkpoint").exists() else ()
            done = self.run_command(*self.command(name, PUNCH, PRECISE, *goes_on))
            if done.returncode == 2:  # the last one came to its end
                self.assertIn("is finished", done.stderr)
            else:
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assert_same(name, "whole")
        self.assertGreater(kills, 12)

    def assert_near(self, name, other):
        (ours, _, _), (theirs, _, _) = self.results(name), self.results(other)
        self.assertEqual([level["dofs"] for level in ours["accuracy"]["levels"]],
                         [level["dofs"] for level in theirs["accuracy"]["levels"]])
        for of in (lambda s: s["energy"], lambda s: s["errors"]["global"]["absolute"]):
            self.assertAlmostEqual(of(ours) / of(theirs), 1.0, delta=1e-9)

    def test_on_ranks(self):
        """MUMPS has other round-off each time, with or without a restart."""
        for solver, target, compare in (("Krylov", 0.003, self.assert_same), ("Mumps", 0.0003, self.assert_near)):
            settings = (f"Accuracy/Target={target}", f"Linear Solver/Type={solver}")
            killed, whole = f"killed-{solver}", f"whole-{solver}"
            self.end(whole, PUNCH, settings, ranks=3)
            process = self.start(*self.command(killed, PUNCH, settings, ranks=3))
            self.assertTrue(self.kill_after(process, killed, 2, 0.0))
            self.end(killed, PUNCH, settings, "--restart", ranks=3)
            compare(killed, whole)

    def test_on_another_number_of_ranks(self):
        """All levels before are those of one rank, the last ones those of three."""
        self.end("whole", PUNCH, PRECISE)
        self.end("moved", PUNCH, (*PRECISE, "Accuracy/Maximum Levels=4"), code=5)
        self.end("moved", PUNCH, PRECISE, "--restart", ranks=3)
        self.assert_near("moved", "whole")


# Some 190 sweeps.
SLOW = ("Coupling/Relaxation/Theta=0.1", "Coupling/Stopping/Tolerance=1e-9", "Coupling/Stopping/Maximum Sweeps=1000")
# Some 20.
FASTER = ("Coupling/Relaxation/Theta=0.6", *SLOW[1:])
# Statuses that change in most sweeps, on interfaces whose factor moves with them.
MOVING = ("Bodies/upper/Mesh/Cells={250, 4}", "Bodies/lower/Mesh/Cells={500, 4}", "Coupling/Stopping/Tolerance=1e-9",
          "Coupling/Stopping/Maximum Sweeps=1000", "Coupling/Type=Neumann-Dirichlet")


class Sweeps(Restarts):
    """Runs that a limit of sweeps has ended go on from the last that were kept."""

    def assert_sweeps_go_on(self, deck, settings, *limits, ranks=1, every=20):
        path, settings = DECKS / f"{deck}.xml", (*settings, f"Output/Checkpoint Sweeps={every}")
        self.end("whole", path, settings, ranks=ranks)
        self.assertGreater(self.results("whole")[0]["coupling"]["sweeps"], max(limits))
        for limit in limits:
            name = f"to-{limit}"
            self.end(name, path, (*settings, f"Coupling/Stopping/Maximum Sweeps={limit}"), code=3, ranks=ranks)
            done = self.end(name, path, settings, "--restart", ranks=ranks)
            self.assertIn(f"{(limit - 1) // every * every} sweeps are not solved again", done.stdout)
            self.assert_same(name, "whole")

    def test_a_constant_factor(self):
        self.assert_sweeps_go_on("punch", SLOW, 21, 59, 150)

    def test_a_certificate(self):
        self.assert_sweeps_go_on("certificate", SLOW, 90)

    def test_operators_that_are_applied(self):
        self.assert_sweeps_go_on("punch", (*SLOW, "Interface Operator/Type=Matrix Free"), 90)

    def test_factors_that_move(self):
        self.assert_sweeps_go_on("contact-loss", (*MOVING, "Coupling/Relaxation/Type=Constant", "Coupling/Relaxation/Theta=0.05"), 5, 10, 30, every=4)

    def test_factors_that_move_under_a_changing_theta(self):
        self.assert_sweeps_go_on("contact-loss", (*MOVING, "Coupling/Relaxation/Type=Aitken"), 4, 7, every=2)

    def test_on_ranks(self):
        self.assert_sweeps_go_on("punch", (*FASTER, "Linear Solver/Type=Krylov"), 12, every=5, ranks=3)

    def test_on_the_way_to_a_target(self):
        """Level 3 and its sweeps; the sweeps of a level count from its own."""
        settings = ("Accuracy/Target=0.003", "Coupling/Relaxation/Theta=0.02", "Coupling/Initial Traction=Zero",
                    "Coupling/Stopping/Maximum Sweeps=2000", "Output/Checkpoint Sweeps=7")
        self.end("whole", PUNCH, settings)
        levels = self.results("whole")[0]["accuracy"]["levels"]
        self.assertGreater(max(level["sweeps"] for level in levels), 14)
        found = set()
        for limit in (10, 15, 20, 30, 40, 60):
            name = f"to-{limit}"
            self.run_command(*self.command(name, PUNCH, (*settings, f"Coupling/Stopping/Maximum Sweeps={limit}")))
            if not (self.folder / name / "punch.checkpoint").exists():
                continue
            done = self.run_command(*self.command(name, PUNCH, settings, "--restart"))
            if "is finished" in done.stderr:
                continue
            found.add(done.stdout.split("not solved again")[0].split(": ")[-1])
            self.assert_same(name, "whole")
        self.assertTrue(any("sweeps" in text for text in found), found)

    def test_killed_anywhere(self):
        self.end("whole", PUNCH, (*SLOW, "Output/Checkpoint Sweeps=1"))
        path, kills = self.folder / "killed" / "punch.checkpoint", 0
        for _ in range(6):
            goes_on = ("--restart",) if path.exists() else ()
            process = self.start(*self.command("killed", PUNCH, (*SLOW, "Output/Checkpoint Sweeps=1"), *goes_on))
            time.sleep(0.02 + 0.06 * random.Random(kills).random())
            kills += process.poll() is None
            end_session(process)
        done = self.run_command(*self.command("killed", PUNCH, (*SLOW, "Output/Checkpoint Sweeps=1"),
                                              *(("--restart",) if path.exists() else ())))
        self.assertIn(done.returncode, (0, 2), done.stderr)
        self.assertGreater(kills, 0)
        self.assert_same("killed", "whole")


# Some ten passes over the statuses of solids that are solved whole, of a tenth of a second each.
WHOLE = ("Linear Solver/Type=Multigrid", "Bodies/sphere/Mesh/Cells={6, 6, 4}", "Bodies/block/Mesh/Cells={6, 6, 4}")


# Contact opens, and bricks are loose on the way.
PRESSED = tuple(f"Bodies/brick 4.{i}/Loads/press 1/Value=(x<2)+0.01" for i in (1, 2, 3, 4))


class Passes(Restarts):
    """Couplings without sweeps go on from their last pass over the statuses."""

    def caught(self, name, deck, settings, ranks, code):
        """A run, and its checkpoints one after another, as far as they could be seen."""
        process = self.start(*self.command(name, deck, settings, ranks=ranks))
        path, caught = self.folder / name / f"{deck.stem}.checkpoint", []
        while process.poll() is None:
            files = self.files_of(path)
            if files and all(files[path.name] != before[path.name] for before in caught[-1:]):
                caught.append(files)
            time.sleep(0.001)
        self.assertEqual(process.returncode, code, name)
        return caught

    @staticmethod
    def files_of(path):
        """A checkpoint and the parts of ranks that have shares, by name; none where it is not there or just replaced."""
        try:
            files = {file.name: file.read_bytes() for file in (path, *path.parent.glob(f"{path.name}.*"))}
            return files if files[path.name] and path.read_bytes() == files[path.name] else {}
        except FileNotFoundError:
            return {}

    def put(self, name, files):
        (self.folder / name).mkdir()
        for file, content in files.items():
            (self.folder / name / file).write_bytes(content)

    def assert_passes_go_on(self, deck, *settings, ranks=1, least=2, code=0):
        path, whole, found = DECKS / f"{deck}.xml", f"whole-{ranks}", set()
        caught = self.caught(whole, path, settings, ranks, code)
        for number, files in enumerate(caught[:: 1 if ranks == 1 else max(1, len(caught) // 3)]):
            name = f"pass-{ranks}-{number}"
            self.put(name, files)
            done = self.run_command(*self.command(name, path, settings, "--restart", ranks=ranks))
            if "is finished" in done.stderr:
                continue
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
            found.add(done.stdout.split(" not solved again")[0].split(": ")[-1])
            self.assert_same(name, whole)
        self.assertGreaterEqual(sum("status pass" in text for text in found), least, found)

    def test_of_whole_solids_on_1_2_and_3_ranks(self):
        for ranks in (1, 2, 3):
            with self.subTest(ranks=ranks):
                self.assert_passes_go_on("hertz-3d", *WHOLE, ranks=ranks)

    def test_on_another_number_of_ranks(self):
        """Forces to 1e-10 of the loads, by iterations of one rank and of two."""
        deck = DECKS / "hertz-3d.xml"
        self.put("moved", self.caught("whole", deck, WHOLE, 1, 0)[0])
        done = self.end("moved", deck, WHOLE, "--restart", ranks=2)
        self.assertIn("status pass", done.stdout)
        ours, theirs = (self.results(name)[0] for name in ("moved", "whole"))
        self.assertEqual(ours["interfaces"][0]["closed_nodes"], theirs["interfaces"][0]["closed_nodes"])
        self.assertAlmostEqual(ours["energy"] / theirs["energy"], 1.0, delta=1e-8)

    def test_on_the_way_to_a_target(self):
        self.assert_passes_go_on("contact-loss-3d", "Linear Solver/Type=Multigrid", "Accuracy/Target=0.1", least=3, code=4)

    def test_of_forces(self):
        self.assert_passes_go_on("wall", *PRESSED, "Coupling/Type=FETI", least=1, code=4)

    def test_killed_anywhere(self):
        deck, kills = DECKS / "hertz-3d.xml", 0
        self.end("whole", deck, WHOLE)
        seconds = self.results("whole")[0]["ledger"]["total_seconds"]
        path = self.folder / "killed" / "hertz-3d.checkpoint"
        for seed in range(6):
            goes_on = ("--restart",) if path.exists() else ()
            process = self.start(*self.command("killed", deck, WHOLE, *goes_on))
            time.sleep(0.6 * seconds * random.Random(seed).random())  # the machine may be faster now
            kills += process.poll() is None
            end_session(process)
        done = self.run_command(*self.command("killed", deck, WHOLE, *(("--restart",) if path.exists() else ())))
        self.assertIn(done.returncode, (0, 2), done.stderr)
        self.assertGreater(kills, 0)
        self.assert_same("killed", "whole")


class Refused(Restarts):
    def refuse(self, *messages, deck=PUNCH, settings=PRECISE, ranks=1):
        done = self.end("run", deck, settings, "--restart", code=2, ranks=ranks)
        for message in messages:
            self.assertIn(message, done.stderr)
        self.assertEqual(done.stderr.count("nothing was computed"), 1, done.stderr)

    def ended(self):
        self.end("run", PUNCH, (*PRECISE, "Accuracy/Maximum Levels=3"), code=5)
        return self.checkpoint("run")

    def test_without_a_checkpoint(self):
        self.refuse('there is no "run/punch.checkpoint" to continue from', "Output/Checkpoint = true writes it", BEGIN_AGAIN)

    def test_a_run_that_has_reached_its_target(self):
        self.end("run", PUNCH, PRECISE)
        self.refuse('the run of "run/punch.checkpoint" is finished', "it wrote run/punch.e, ")

    def test_another_deck(self):
        self.ended()
        self.refuse('"run/punch.checkpoint" belongs to another deck: ', "Bodies/punch/Material/Young Modulus is ", " and was ",
                    "use the original deck, or run without --restart.",
                    settings=(*PRECISE, "Bodies/punch/Material/Young Modulus=7"))
        self.refuse("Accuracy/Target is 0.01 and was 0.0005;", settings=("Accuracy/Target=0.01",))
        self.refuse(", and 1 more", ranks=2, settings=("Accuracy/Target=0.01", "Bodies/punch/Material/Young Modulus=7"))

    def test_what_changes_no_answer_is_no_other_deck(self):
        self.ended()
        self.end("run", PUNCH, (*PRECISE, "Title=other", "Output/Mean Stress=true"), "--restart")

    def test_other_mesh_files(self):
        mesh = self.folder / "punch-foundation.geo"
        mesh.write_text((DECKS / "meshes" / mesh.name).read_text())
        deck = self.folder / "gmsh-geo.xml"
        deck.write_text((DECKS / deck.name).read_text().replace("meshes/", ""))
        self.end("run", deck, ("Accuracy/Target=0.001", "Accuracy/Maximum Levels=2"), code=5)
        self.end("run", deck, ("Accuracy/Target=0.02",), "--restart", code=2)
        mesh.write_text(mesh.read_text() + "\nMesh.MeshSizeFactor = 0.9;\n")
        self.refuse("belongs to other meshes: those of level 1 are not the same; use the original mesh files",
                    deck=deck, settings=("Accuracy/Target=0.001",))

    def test_another_version(self):
        path = self.ended()
        path.write_bytes(path.read_bytes().replace(b"gversione0.1.0", b"gversione0.0.9"))
        self.refuse("was written by ndframe 0.0.9 (format 8), and this is 0.1.0 (format 8)", BEGIN_AGAIN)

    def test_files_that_are_no_checkpoints(self):
        path = self.ended()
        whole = path.read_bytes()
        for length in (1, 100, len(whole) // 2, len(whole) - 1):
            path.write_bytes(whole[:length])
            self.refuse('"run/punch.checkpoint" is not an ndframe checkpoint, or ends too early', BEGIN_AGAIN)
        path.write_bytes(whole.replace(b"tractionNeumann", b"tractionneumann", 1))
        self.refuse("lacks a part of a checkpoint", BEGIN_AGAIN)
        path.write_bytes(b"")
        self.refuse('"run/punch.checkpoint" is empty', BEGIN_AGAIN, ranks=2)
        path.unlink()
        path.mkdir()
        self.refuse('cannot read "run/punch.checkpoint"', BEGIN_AGAIN, ranks=2)

    def test_decks_without_levels_sweeps_and_passes(self):
        for deck, setting in ((DECKS / "beam-3d.xml", "Title=alone"), (PUNCH, "Output/Checkpoint Sweeps=0"),
                              (DECKS / "wall.xml", "Output/Checkpoint Sweeps=0")):
            done = self.run_program("-i", deck, "--set", "Output/Checkpoint=true", "--set", setting)
            self.assert_refused(done, "Output: Checkpoint continues from the levels of a run with a target or from the sweeps",
                                "the deck asks for neither")

    def test_all_sweeps(self):
        done = self.run_program("-i", PUNCH, "--set", "Output/Checkpoint=true", "--set", "Output/Steps=All Sweeps")
        self.assert_refused(done, "Checkpoint Sweeps keeps the last state alone", "set Checkpoint Sweeps = 0")

    def test_passes_of_another_deck_and_damaged_ones(self):
        sphere = DECKS / "hertz-3d.xml"
        process = self.start(*self.command("run", sphere, WHOLE))
        path, end = self.folder / "run" / "hertz-3d.checkpoint", time.monotonic() + SECONDS
        while not path.exists() and time.monotonic() < end:
            time.sleep(0.001)
        end_session(process)
        self.refuse("belongs to another deck: Bodies/block/Material/Young Modulus is 2.0 and was 1.0", deck=sphere,
                    settings=(*WHOLE, "Bodies/block/Material/Young Modulus=2"))
        whole = path.read_bytes()
        for damaged, message in ((whole[:-1], "ends too early"), (whole.replace(b"levelClosed", b"levelclosed"), "lacks a part")):
            path.write_bytes(damaged)
            self.refuse(message, BEGIN_AGAIN, deck=sphere, settings=WHOLE, ranks=2)

    def test_sweeps_of_another_deck(self):
        self.end("run", PUNCH, (*SLOW, "Coupling/Stopping/Maximum Sweeps=50"), code=3)
        self.refuse("belongs to another deck: Coupling/Stopping/Tolerance is 1e-06 and was 1e-09",
                    settings=(*SLOW, "Coupling/Stopping/Tolerance=1e-6"))

    def test_finished_sweeps(self):
        self.end("run", PUNCH, SLOW)
        self.refuse('the run of "run/punch.checkpoint" is finished', settings=SLOW)

    def test_studies(self):
        for more in (("--restart",), ("--set", "Output/Checkpoint=true")):
            done = self.run_program("-i", PUNCH, "--set", "Accuracy/Target=0.1", "--study", "Accuracy/Target=0.1; 0.05",
                                    *more)
            self.assert_refused(done, "--restart and Output/Checkpoint are for one run")


class FullDisk(Restarts):
    def test_it_is_said_and_the_checkpoint_before_stays(self):
        self.end("run", PUNCH, (*PRECISE, "Accuracy/Maximum Levels=3"), code=5)
        before = self.checkpoint("run").read_bytes()
        done = self.run_command(*limited("fsize", len(before) // 2, *self.command("run", PUNCH, PRECISE, "--restart", "-q")))
        self.assert_refused(done, 'cannot write "run/punch.checkpoint"', "File too large")
        self.assertEqual(self.checkpoint("run").read_bytes(), before)

    def test_the_run_goes_on_from_any_level_when_there_is_room(self):
        self.end("whole", PUNCH, PRECISE)
        found = set()
        for size in range(4000, 80000, 4000):
            name = f"below-{size}"
            done = self.run_command(*limited("fsize", size, *self.command(name, PUNCH, PRECISE, "-q")))
            self.assert_refused(done, f'cannot write "{name}/punch.')
            levels = done.stderr.count("punch.checkpoint") and (self.folder / name / "punch.checkpoint").exists()
            if not levels:
                continue
            done = self.end(name, PUNCH, PRECISE, "--restart")
            found.add(done.stdout.split("not solved again")[0].split(": ")[-1])
            self.assert_same(name, "whole")
        self.assertGreater(len(found), 2, found)


if __name__ == "__main__":  # the classes are entries of CMakeLists.txt
    main()
