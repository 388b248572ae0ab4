"""Runs ./bootstrap with stand-ins for apt-get, cmake, ninja and the rest, which only note how they were called.

test_bootstrap.py ROOT
"""

import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1])
REAL_TOOLS = "awk bash cat comm cp dirname env flock grep mkdir nproc sed sort tail xargs".split()

NOTE = '#!/bin/bash\necho "${0##*/} $*" >> "$NOTES"\n'
STAND_INS = {
    "dpkg-query": '#!/bin/bash\nsed "s/$/ installed/" "$INSTALLED"\n',
    "apt-get": NOTE + 'exit "${APT_STATUS:-0}"\n',
    "sudo": NOTE + 'exec "$@"\n',
    "cmake": NOTE + 'mkdir -p build/release && : > build/release/build.ninja\n',
    "ninja": NOTE + '[[ $* == *" -n "* && -e "$BUILT" ]] && echo "ninja: no work to do."\nexit 0\n',
    "ctest": NOTE + "exit 8\n",
}
PROGRAM = '#!/bin/bash\necho "in $PWD with" "$@"\nexit 3\n'


class Bootstrap(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.clone, self.tools = self.folder / "a clone", self.folder / "tools"
        for path in (self.clone, self.tools):
            path.mkdir()
        (self.clone / "docs/site").mkdir(parents=True)
        for name in ("bootstrap", "packages.txt", "docs/site/packages.txt"):
            shutil.copy(ROOT / name, self.clone / name)
        for name in REAL_TOOLS:
            (self.tools / name).symlink_to(shutil.which(name))
        for name, text in STAND_INS.items():
            self.write_program(self.tools / name, text)
        self.write_program(self.clone / "build/release/bin/ndframe", PROGRAM)
        self.packages = self.call("packages").stdout.split()
        self.install(self.packages)
        (self.folder / "notes").touch()

    def write_program(self, path, text):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def install(self, packages):
        (self.folder / "installed").write_text("".join(name + "\n" for name in packages))

    def call(self, *arguments, user=None, **environment):
        for path in [self.folder, *self.folder.rglob("*")]:
            if not path.is_symlink():
                path.chmod(0o777)
        places = {name.upper(): str(self.folder / name) for name in ("notes", "installed", "built")}
        return subprocess.run(
            [self.clone / "bootstrap", *arguments],
            cwd=self.folder,
            env={"PATH": str(self.tools), **places, **environment},
            capture_output=True,
            text=True,
            user=user,
        )

    def notes(self):
        return (self.folder / "notes").read_text().splitlines()

    def apt_notes(self):
        return [note for note in self.notes() if note.startswith(("apt-get", "sudo"))]

    def test_packages_are_listed_once_each(self):
        self.assertIn("libtrilinos-tpetra-dev", self.packages)
        self.assertEqual(len(self.packages), len(set(self.packages)))
        self.assertFalse([name for name in self.packages if "#" in name])

    def test_first_run_configures_builds_only_the_program_and_runs_it(self):
        run = self.call("run", "-i", "my deck.xml")
        self.assertEqual(self.apt_notes(), [])
        configure, dry, build = self.notes()
        self.assertEqual(configure, "cmake --preset release -D NDFRAME_COMPILE_GROUPS=ON")
        self.assertIn(" -n ndframe", dry)
        self.assertTrue(build.endswith(" ndframe") and " -n " not in build, build)
        self.assertIn("configuring", run.stderr)
        self.assertIn("building", run.stderr)

    def test_program_gets_its_arguments_in_the_callers_folder(self):
        run = self.call("run", "-i", "my deck.xml")
        self.assertEqual(run.stdout, f"in {self.folder} with -i my deck.xml\n")
        self.assertEqual(run.returncode, 3)

    def test_paper_hands_the_program_and_its_arguments_to_the_script(self):
        self.write_program(self.clone / "docs/paper/paper.py", "import sys; print(sys.argv[1:]); sys.exit(1)")
        run = self.call("paper", "my folder")
        self.assertTrue(self.notes()[-1].endswith(" ndframe"))
        self.assertEqual(run.stdout, f"{[str(self.clone / 'build/release/bin/ndframe'), 'my folder']}\n")
        self.assertEqual(run.returncode, 1)

    def test_docs_install_their_own_packages_and_build_no_program(self):
        self.write_program(self.clone / "docs/site/build.py", "import sys; print(sys.argv[1:]); sys.exit(1)")
        self.install(["python3-sphinx", "python3-myst-parser", "furo"])
        run = self.call("docs", "my folder")
        if os.geteuid() == 0:
            self.assertEqual(self.notes(), ["apt-get update", "apt-get install -y --no-install-recommends doxygen fonts-lmodern"])
            self.assertEqual((run.stdout, run.returncode), ("['my folder']\n", 1))
        else:
            self.assertIn("apt-get install -y --no-install-recommends doxygen fonts-lmodern", run.stderr)

    def test_second_run_is_silent_and_only_asks_ninja(self):
        self.call("run")
        (self.folder / "built").touch()
        (self.folder / "notes").write_text("")
        run = self.call("run")
        self.assertEqual(run.stderr, "")
        self.assertEqual(len(self.notes()), 1)
        self.assertIn(" -n ", self.notes()[0])

    def test_nothing_that_cmake_checks_at_every_build_makes_a_second_run_build(self):
        files = [path for folder in ("cmake", "packages", "apps", "tests") for path in (ROOT / folder).rglob("*") if path.name == "CMakeLists.txt" or path.suffix == ".cmake"]
        self.assertGreater(len(files), 30)
        self.assertEqual([str(path) for path in files if re.search(r"GLOB[^)]* CONFIGURE_DEPENDS", path.read_text())], [])

    def test_test_builds_everything_and_hands_on_ctests_verdict(self):
        run = self.call("test", "-R", "Aitken")
        self.assertTrue(self.notes()[-2].endswith(" all"))
        self.assertRegex(self.notes()[-1], r"^ctest --preset release -j \d+ -R Aitken$")
        self.assertEqual(run.returncode, 8)

    @unittest.skipUnless(os.geteuid() == 0, "needs root")
    def test_root_installs_exactly_what_is_missing(self):
        self.install(self.packages[2:])
        run = self.call("build")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.apt_notes()[0], "apt-get update")
        install = self.apt_notes()[1].split()
        self.assertEqual(install[:4], "apt-get install -y --no-install-recommends".split())
        self.assertEqual(sorted(install[4:]), sorted(self.packages[:2]))
        self.assertIn("installing 2 packages", run.stderr)

    @unittest.skipUnless(os.geteuid() == 0, "needs root")
    def test_failed_installation_stops_with_its_reason(self):
        self.install([])
        run = self.call("run", APT_STATUS="100")
        self.assertEqual(run.returncode, 1)
        self.assertIn("failed: apt-get update (all of it: ", run.stderr)
        self.assertEqual(run.stdout, "")

    @unittest.skipUnless(os.geteuid() == 0, "needs root to become somebody else")
    def test_sudo_is_announced_and_used_for_apt_only(self):
        self.install(self.packages[1:])
        run = self.call("build", user=65534)
        self.assertEqual(run.returncode, 0, run.stderr)
        words = f"apt-get install -y --no-install-recommends {self.packages[0]}"
        self.assertIn(f"sudo is used for two commands and nothing else: apt-get update; {words}", run.stderr)
        sudo = [note for note in self.notes() if note.startswith("sudo")]
        self.assertEqual(sudo, ["sudo apt-get update", f"sudo env DEBIAN_FRONTEND=noninteractive {words}"])

    @unittest.skipUnless(os.geteuid() == 0, "needs root to become somebody else")
    def test_without_sudo_the_command_is_printed(self):
        (self.tools / "sudo").unlink()
        self.install(self.packages[1:])
        run = self.call("run", user=65534)
        self.assertEqual(run.returncode, 1)
        self.assertIn("as root, run: apt-get update && apt-get install -y", run.stderr)
        self.assertEqual(self.notes(), [])

    def test_other_systems_are_told_what_to_do(self):
        (self.tools / "dpkg-query").unlink()
        run = self.call("run")
        self.assertEqual(run.returncode, 1)
        self.assertIn("only on Debian 12", run.stderr)
        self.assertIn("packages.txt", run.stderr)
        self.assertEqual(self.notes(), [])

    def test_failed_build_shows_the_compilers_error(self):
        self.write_program(self.tools / "ninja", '#!/bin/bash\necho "a.cpp:1: error: no such thing"\nexit 1\n')
        run = self.call("run")
        self.assertEqual(run.returncode, 1)
        self.assertIn("a.cpp:1: error: no such thing", run.stderr)
        self.assertEqual(run.stdout, "")

    @staticmethod
    def everything(terminal):
        """What was written to a terminal that nobody writes to any more: one read may give the first part only, and the end is an error (EIO)."""
        shown = b""
        with contextlib.suppress(OSError):
            while part := os.read(terminal, 10000):
                shown += part
        os.close(terminal)
        return shown.decode()

    def test_a_terminal_shows_the_last_line_of_what_takes_long(self):
        self.write_program(self.tools / "ninja", '#!/bin/bash\n[[ $* == *" -n "* ]] || printf "0 %%\\r[1/2] a.cpp\\r\\n \\n[2/2] b.cpp\\n"\n')
        ours, theirs = os.openpty()
        places = {name.upper(): str(self.folder / name) for name in ("notes", "installed", "built")}
        subprocess.run([self.clone / "bootstrap", "build"], env={"PATH": str(self.tools), **places}, stderr=theirs, check=True)
        os.close(theirs)
        shown = self.everything(ours)
        self.assertIn("\r\033[K[1/2] a.cpp\r\033[K[2/2] b.cpp\r\033[K", shown)

    def test_unknown_command_prints_the_usage(self):
        run = self.call("rum")
        self.assertEqual(run.returncode, 2)
        self.assertIn("./bootstrap run ARGS", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
