#!/usr/bin/python3
"""The Debian packages on a bare Debian 12: bare_debian.py FOLDER [TREE], as root, with a network.

Copies TREE (without it: what debootstrap makes), installs the packages of FOLDER there as a user would, goes from a drawing to a report,
runs the packages' own test, builds the example against ndframe-dev, removes the packages and looks for what stays. Not a part of ctest,
as it needs root and a network and takes ten minutes.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENVIRONMENT = {"HOME": "/root", "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", "TERM": "dumb"}
STEPS = {
    "refresh": "apt-get update",
    "install": "apt-get install -y /packages/ndframe_*.deb",
    "draw": "ndframe new from-geo mine.geo && ndframe mine.xml && ndframe report mine && test -s mine.report.html",
    "one process with MPI": "ndframe -q -i /usr/share/ndframe/decks/mumps.xml",
    "python": "python3 -c \"import ndframe; assert ndframe.read('mine').energy > 0\"",
    "compare": "nddiff mine.e mine.e",
    "own test": "ndregress | tail -n 2; test ${PIPESTATUS[0]} = 0",
    "install -dev, -doc": "apt-get install -y /packages/ndframe-*.deb cmake g++ make",
    "pages": "test ! -e /packages/ndframe-doc_*.deb -o -e /usr/share/doc/ndframe-doc/html/index.html",
    "client": "cmake -S /usr/share/ndframe/examples/client -B client && cmake --build client"
              " && client/client -q -i /usr/share/ndframe/examples/client/own-relaxation.xml",
    "remove": "apt-get purge -y 'ndframe*'",
    "nothing stays": "! find /usr -path '*ndframe*' | grep .",
}


def drawing():
    """The drawing of the README."""
    text = (ROOT / "README.md").read_text()
    return text[text.index("// mine.geo"):].split("```")[0]


def inside(tree, command):
    return subprocess.run(["chroot", tree, "bash", "-c", f"cd /work && {{ {command}; }}"], env=ENVIRONMENT, text=True,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def prepare(tree, packages, source):
    if source:
        subprocess.run(["cp", "-a", f"{source}/.", tree], check=True)
    else:
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", tree, "http://deb.debian.org/debian"], check=True)
    shutil.copy("/etc/resolv.conf", tree / "etc/resolv.conf")
    (tree / "work").mkdir()
    (tree / "work/mine.geo").write_text(drawing())
    shutil.copytree(packages, tree / "packages", ignore=lambda _, names: [name for name in names if not name.endswith(".deb")])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packages", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("source", metavar="TREE", nargs="?")
    options = parser.parse_args()
    if not list(options.packages.glob("ndframe_*.deb")):
        raise SystemExit(f"there is no ndframe_*.deb in {options.packages}; docs/how-to/install.md says how cpack makes it")
    with tempfile.TemporaryDirectory(dir="/var/tmp") as name:
        tree = pathlib.Path(name)
        prepare(tree, options.packages, options.source)
        subprocess.run(["mount", "-t", "proc", "proc", tree / "proc"], check=True)
        try:
            for title, command in STEPS.items():
                start = time.monotonic()
                done = inside(tree, command)
                print(f"{'ok' if done.returncode == 0 else 'FAILED':6} {time.monotonic() - start:6.1f} s  {title}: {command}", flush=True)
                if done.returncode != 0 or title == "own test":
                    print(done.stdout[-3000:])
                if done.returncode != 0:
                    return 1
        finally:
            subprocess.run(["umount", tree / "proc"], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
