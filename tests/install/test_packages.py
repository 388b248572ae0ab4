"""The Debian packages, unpacked: test_packages.py BUILD. They are not installed; that needs root and apt."""

import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "docs/site"))
import build

CAN_BUILD_SITE = not build.missing()


def call(*command, **more):
    return subprocess.run([str(word) for word in command], text=True, capture_output=True, **more)


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name).resolve()
        done = call("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder / "packages", "-D",
                    "CPACK_COMPONENTS_ALL=program;development" + (";documentation" if CAN_BUILD_SITE else ""), "-D",
                    "CPACK_DEBIAN_COMPRESSION_TYPE=gzip")  # in a third of the time
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)
        cls.packages = {path.name.split("_")[0]: path for path in (cls.folder / "packages").glob("*.deb")}
        for package in cls.packages.values():
            call("dpkg-deb", "-x", package, cls.folder / "root", check=True)
        cls.usr = cls.folder / "root/usr"

    def field(self, package, name):
        return call("dpkg-deb", "-f", self.packages[package], name, check=True).stdout

    def test_program_and_development_files_are_packages_of_their_own(self):
        self.assertEqual(sorted(set(self.packages) - {"ndframe-doc"}), ["ndframe", "ndframe-dev"])
        contents = {name: call("dpkg-deb", "-c", path, check=True).stdout for name, path in self.packages.items()}
        for place in ("usr/bin/ndframe", "usr/share/ndframe/decks/punch.xml", "usr/share/ndframe/ndreport/page.py", "usr/share/man/man1/ndframe.1.gz",
                      "usr/bin/ndregress", "usr/share/ndframe/regression/cases/punch/gold.e", "usr/lib/python3/dist-packages/ndframe"):
            self.assertIn(place, contents["ndframe"])
        for place in ("usr/include/ndframe/driver/main.hpp", "usr/lib/libndframe_driver.a", "usr/lib/cmake/ndframe/ndframeConfig.cmake"):
            self.assertIn(place, contents["ndframe-dev"])
            self.assertNotIn(place, contents["ndframe"])
        self.assertNotIn("__pycache__", contents["ndframe"])

    def test_each_has_debians_papers(self):
        for package in self.packages:
            folder = self.usr / "share/doc" / package
            copyright = (folder / "copyright").read_text()
            for words in ("\nLicense: BSD-3-Clause\n BSD 3-Clause License\n .\n Copyright (c)", "CGAL (GPL 3 or later)", "Eclipse Public License"):
                self.assertIn(words, copyright)
            changelog = gzip.decompress((folder / "changelog.gz").read_bytes()).decode()
            self.assertRegex(changelog, r"^ndframe \([\d.]+\) bookworm; urgency=medium\n\n  \* .*\n\n -- .* <.*@.*>  \w{3}, \d\d \w{3} \d{4} ")

    def test_the_installation_tests_itself(self):
        done = call(self.usr / "bin/ndregress", "--np", "1", "punch", "rings", "target-remesh", "wrong-deck", cwd=self.folder)
        self.assertIn("4 cases, 4 runs: 4 ok", done.stdout, done.stderr)
        done = call(self.usr / "bin/nddiff", *[self.usr / "share/ndframe/regression/cases/punch/gold.e"] * 2)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(list(self.usr.rglob("__pycache__")), [])

    @unittest.skipUnless(CAN_BUILD_SITE, "the packages of docs/site/packages.txt are not installed")
    def test_the_site_is_a_package(self):
        self.assertTrue((self.usr / "share/doc/ndframe-doc/html/tutorials/first-run.html").exists())
        self.assertEqual(self.field("ndframe-doc", "Architecture"), "all\n")

    def test_libraries_are_dependencies(self):
        depends = self.field("ndframe", "Depends")
        for library in ("libcholmod3", "libmumps-5.5", "libexodusii5", "libopenmpi3", "libtrilinos-tpetra-13.2", "libtrilinos-muelu-13.2", "python3-netcdf4"):
            self.assertRegex(depends, rf"(^|, ){re.escape(library)}\b")
        self.assertIn("libgmsh4.8", self.field("ndframe", "Recommends"))
        self.assertRegex(self.field("ndframe-dev", "Depends"), r"^ndframe \(= [\d.]+\), .*libtrilinos-teuchos-dev")
        self.assertNotIn("gtest", self.field("ndframe-dev", "Depends"))

    def test_the_program_runs_reports_and_is_imported(self):
        program = self.usr / "bin/ndframe"
        done = call(program, "-i", self.usr / "share/ndframe/decks/punch.xml", "--set", "Output/Report=true", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("punch.report.html", done.stdout)
        self.assertEqual(call(program, "--check", self.usr / "share/ndframe/decks/krylov.xml", cwd=self.folder).returncode, 0)
        text = "import ndframe; print(ndframe.find_program(), ndframe.read('punch').energy > 0)"
        done = call("/usr/bin/python3", "-B", "-c", text, cwd=self.folder, env={**os.environ, "PYTHONPATH": str(self.usr / "lib/python3/dist-packages")})
        self.assertEqual(done.stdout, f"{program} True\n", done.stderr)

    def test_find_package_builds_the_example(self):
        example, build = self.usr / "share/ndframe/examples/client", self.folder / "client"
        call("cmake", "-S", example, "-B", build, "-G", "Ninja", "-D", f"CMAKE_PREFIX_PATH={self.usr}", check=True)
        call("cmake", "--build", build, check=True)
        done = call(build / "client", "-i", example / "own-relaxation.xml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
