"""Completion scripts and the manual page that the program writes: test_shell_files.py NDFRAME."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


def output(*arguments):
    return subprocess.run([PROGRAM, *arguments], text=True, capture_output=True, check=True).stdout


OPTIONS = sorted(set(re.findall(r"(--[a-z][a-z-]+)", output("--help").split("Options:")[1].split("Subcommands:")[0])))


class Completion(unittest.TestCase):
    def completed(self, *words, folder="."):
        """What bash offers for the last word."""
        script = output("--completion", "bash") + """
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _ndframe; printf '%s\\n' "${COMPREPLY[@]}"
"""
        done = subprocess.run(["bash", "-c", script, "ndframe", "ndframe", *words], cwd=folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.split("\n")[:-1]

    def test_options(self):
        self.assertIn("--set", OPTIONS)
        self.assertEqual([o for o in OPTIONS if o not in self.completed("--")], [])
        self.assertEqual(sorted(self.completed("--ver")), ["--verbose", "--version"])

    def test_lists_components_and_parameters(self):
        self.assertEqual(self.completed("--help", "Ait"), ["Aitken"])
        self.assertIn("Error\\ Estimation", self.completed("--help", "Err"))
        self.assertIn("Coupling/Stopping/Maximum\\ Sweeps=", self.completed("--set", "Coupling/Stopping/M"))
        self.assertIn("Error\\ Estimation/Mode=", self.completed("--set", "Error\\ Estimation/M"))

    def test_what_is_offered_is_known(self):
        for name in self.completed("--help", "S"):
            output("--help", name.replace("\\ ", " "))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.xml", "a.e", "a.summary.json", "b.study.csv"):
                (pathlib.Path(folder) / name).touch()
            self.assertEqual(self.completed("a", folder=folder), ["a.xml"])
            self.assertEqual(self.completed("-i", "", folder=folder)[0], "a.xml")
            self.assertEqual(self.completed("report", "", folder=folder), ["a.summary.json", "b.study.csv"])
            self.assertEqual(self.completed("rep", folder=folder), ["report"])
            self.assertEqual(self.completed("ne", folder=folder), ["new"])
            (pathlib.Path(folder) / "a.geo").touch()
            self.assertEqual(self.completed("new", "from-geo", "", folder=folder), ["a.geo"])

    def test_templates(self):
        self.assertEqual(self.completed("new", ""), ["two-bodies", "hertz", "obstacle", "from-geo"])
        self.assertEqual(self.completed("new", "o"), ["obstacle"])

    def test_other_shells_take_their_scripts(self):
        for shell in ("zsh", "fish"):
            script = output("--completion", shell)
            long_options = [o[2:] for o in OPTIONS]
            self.assertEqual([o for o in long_options if not re.search(rf"(--|-l ){o}\b", script)], [], shell)
            if shutil.which(shell):
                done = subprocess.run([shell, "-n"], input=script, text=True, capture_output=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""), shell)

    def test_another_shell_is_refused(self):
        done = subprocess.run([PROGRAM, "--completion", "csh"], text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn('there is no script for "csh"; there are bash, zsh and fish.', done.stderr)


class ManualPage(unittest.TestCase):
    def test_has_every_option_and_section(self):
        page = output("--man")
        plain = re.sub(r"\\f[BIR]", "", page).replace("\\-", "-")
        self.assertEqual([o for o in OPTIONS if o not in plain], [])
        for head in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "ENVIRONMENT"):
            self.assertIn(f".SH {head}\n", page)

    @unittest.skipIf(shutil.which("groff") is None, "groff is not installed")
    def test_is_right_for_groff(self):
        done = subprocess.run(["groff", "-man", "-ww", "-Tutf8"], input=output("--man"), text=True, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
