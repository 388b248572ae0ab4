#!/usr/bin/python3
"""Builds the documentation site without a network: build.py [FOLDER] [--without-api]; FOLDER: build/docs of the clone.

The pages are docs/**/*.md by Sphinx with MyST (docs/site/conf.py), formulas as MathML; FOLDER/html/api are the public headers by Doxygen.
Warnings are errors. Needs the packages of docs/site/packages.txt; `./bootstrap docs` installs them.
"""

import argparse
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FONT = pathlib.Path("/usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf")  # Debian: fonts-lmodern


def parse():
    parser = argparse.ArgumentParser(description="Builds the documentation site.")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=ROOT / "build/docs", help="for the site (build/docs)")
    parser.add_argument("--without-api", action="store_true", help="leave out the pages of the headers")
    return parser.parse_args()


def missing(without_api=False):
    """What the site needs and this machine has not."""
    modules = [name for name in ("sphinx", "myst_parser", "furo") if importlib.util.find_spec(name) is None]
    font = [] if FONT.exists() else [str(FONT)]
    return modules + font + ([] if without_api or shutil.which("doxygen") else ["doxygen"])


def pages(folder):
    """folder/html, made anew: pages that were renamed do not stay."""
    shutil.rmtree(folder / "html", ignore_errors=True)
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", "-c", HERE, "-d", folder / "doctrees",
               ROOT / "docs", folder / "html"]
    return subprocess.run(command).returncode


def headers():
    """The folders of the public headers, as Doxygen's settings name them."""
    return " ".join(f'"{path}"' for path in sorted((ROOT / "packages").glob("*/include")))


def undocumented():
    """A line for each type, member, function and constant of the public headers that no comment explains."""
    with tempfile.TemporaryDirectory() as folder:
        settings = (HERE / "Doxyfile").read_text() + f"""INPUT = {headers()} "{HERE / 'namespace.dox'}"
FILE_PATTERNS = *.hpp *.dox
OUTPUT_DIRECTORY = "{folder}"
GENERATE_HTML = NO
GENERATE_XML = YES
EXTRACT_ALL = NO
WARNINGS = YES
"""
        said = subprocess.run(["doxygen", "-"], input=settings, text=True, capture_output=True).stderr
    found = {line for line in said.splitlines() if "is not documented" in line}
    # Specialisations have the comment of their template, and attributes of lanes look like variables.
    return sorted(line for line in found if not re.search(r"Member \w+< \d >|base/lanes\.hpp", line))


def api(folder):
    """folder/html/api."""
    settings, inputs = (HERE / "Doxyfile").read_text(), headers()
    settings += f'INPUT = {inputs}\nSTRIP_FROM_PATH = {inputs}\nOUTPUT_DIRECTORY = "{folder / "html"}"\nHTML_OUTPUT = api\n'
    return subprocess.run(["doxygen", "-"], input=settings, text=True).returncode


def drop_dead_links(folder):
    """Doxygen links to a list of nested classes, which it leaves out where all of them are private."""
    for path in folder.glob("*.html"):
        text = path.read_text()
        if '"#nested-classes"' in text and 'name="nested-classes"' not in text:
            path.write_text(re.sub(r'<a href="#nested-classes">Classes</a>( &#124;)?', "", text))


def main():
    options = parse()
    if lacking := missing(options.without_api):
        sys.exit(f"docs: {', '.join(lacking)} not found; ./bootstrap docs installs what is needed, and --without-api leaves doxygen out")
    options.folder.mkdir(parents=True, exist_ok=True)
    folder = options.folder.resolve()
    failed = pages(folder) or (0 if options.without_api else api(folder))
    drop_dead_links(folder / "html/api")
    if not failed:
        print(f"  wrote {folder / 'html' / 'index.html'}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
