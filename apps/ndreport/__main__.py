"""Makes NAME.report.html of the files of a run or a study; `ndframe report NAME` starts it.

    python3 ndreport [--check] [--output FILE] NAME

--check only looks for the packages that it needs. Exit codes: 0 written, 2 something is missing or damaged.
"""

import importlib.util
import pathlib
import sys

PACKAGES = {"netCDF4": "python3-netcdf4", "matplotlib": "python3-matplotlib", "jinja2": "python3-jinja2"}


def missing_packages(find=importlib.util.find_spec):
    return [package for module, package in PACKAGES.items() if find(module) is None]


def main(arguments):
    sys.path[:0] = [str(place) for place in homes()]
    if missing := missing_packages():
        print(f"the report needs Python packages that {sys.executable} does not find; on Debian: apt-get install "
              f"{' '.join(missing)}", file=sys.stderr)
        return 2
    if arguments == ["--check"]:
        return 0
    from ndreport.command import run
    return run(arguments)


def homes():
    """Folders of the packages ndreport and ndframe: one when they are installed, two in the sources."""
    here = pathlib.Path(__file__).resolve().parent
    return [folder for folder in (here.parent, here.parents[1] / "python") if folder.is_dir()]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
