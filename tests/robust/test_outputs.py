"""Disks that are full, folders that are closed, screens that nobody reads."""

import json
import os
import shutil
import subprocess

from robust import PROGRAM, PUNCH, RESULTS, RoughWorld, limited, main, on_ranks

KEYS = {"punch.e": "Exodus", "punch.contact.csv": "Contact Table", "punch.summary.json": "Summary"}
NOBODY = 65534


class FullDisk(RoughWorld):
    def only(self, name):
        """Settings that leave one output."""
        return [part for other, key in KEYS.items() if other != name for part in ("--set", f"Output/{key}=false")]

    def test_a_file_that_does_not_fit_is_named_and_not_there(self):
        for name in RESULTS:
            self.assertEqual(self.run_program("-q", "-i", PUNCH, *self.only(name)).returncode, 0)
            size = (self.folder / name).stat().st_size
            old = b"the old file"
            for limit in (0, size // 2, size - 100):
                (self.folder / name).write_bytes(old)
                done = self.run_command(*limited("fsize", limit, PROGRAM, "-q", "-i", PUNCH, *self.only(name)))
                self.assert_refused(done, f'cannot write "{name}"', "File too large", "could not be written")
                self.assertEqual(self.files(), [name])
                self.assertEqual((self.folder / name).read_bytes(), old)
            (self.folder / name).unlink()

    def test_on_ranks_one_speaks(self):
        done = self.run_command(*on_ranks(2, *limited("fsize", 4096, PROGRAM, "-q", "-i", PUNCH)))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count('cannot write "punch.e"'), 1, done.stderr)
        self.assertEqual(self.files(), [])


class ClosedFolder(RoughWorld):
    def as_nobody(self):
        """Root may write everywhere, so a test of root's becomes somebody else."""
        if os.getuid() == 0:
            os.setgroups([])
            os.setgid(NOBODY)
            os.setuid(NOBODY)

    def program_for_nobody(self):
        """What nobody may read: the build folder may be root's alone."""
        shutil.copy(PROGRAM, self.folder / "ndframe")
        shutil.copy(PUNCH, self.folder / "punch.xml")
        self.folder.chmod(0o755)
        return "./ndframe", "-q", "-i", "punch.xml"

    def test_it_is_named_before_anything_is_computed(self):
        command = self.program_for_nobody()
        (self.folder / "closed").mkdir(mode=0o555)
        done = self.run_command(*command, "--set", "Output/Directory=closed", preexec_fn=self.as_nobody)
        self.assert_refused(done, "closed\" is not a writable folder", "nothing was computed")
        self.assertEqual(list((self.folder / "closed").iterdir()), [])

    def test_a_folder_that_takes_no_files_is_named(self):
        done = self.run_program("-q", "-i", PUNCH, "--set", "Output/Directory=/proc/self")
        self.assert_refused(done, "/proc/self")


class Screens(RoughWorld):
    def end_without_reader(self, *command):
        """The exit code and the messages of a program whose reader leaves after the first line."""
        process = self.start(*command)
        process.stdout.readline()
        process.stdout.close()
        error = process.stderr.read()
        return process.wait(timeout=60), error

    def test_a_reader_that_goes_away_does_not_stop_the_run(self):
        code, error = self.end_without_reader(PROGRAM, "-i", PUNCH)
        self.assertEqual((code, error), (0, ""))
        self.assertEqual(self.files(), RESULTS)

    def test_on_ranks_it_leaves_no_half_file(self):
        """There mpiexec writes to the reader, and may or may not end the job for it: only the files are ours."""
        self.end_without_reader(*on_ranks(2, PROGRAM, "-i", PUNCH))
        for summary in self.folder.glob("*.summary.json"):
            self.assertEqual(json.loads(summary.read_text())["ranks"], 2)

    def test_a_full_screen_is_said(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            done = self.run_program("-i", PUNCH, stdout=full)
        self.assert_refused(done, "cannot write to the standard output: No space left on device")
        self.assertEqual(self.files(), RESULTS)

    def test_closed_streams_count_as_nowhere(self):
        def close_all():
            os.closerange(0, 3)
        process = subprocess.Popen((PROGRAM, "-i", PUNCH), cwd=self.folder, preexec_fn=close_all)
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertEqual(self.files(), RESULTS)
        for name in RESULTS:
            self.assertNotIn(b"eps_tau   theta", (self.folder / name).read_bytes(), "no result got the screen's text")


if __name__ == "__main__":
    main()
