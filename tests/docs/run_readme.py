"""Runs the commands of README.md as in a fresh clone: run_readme.py NDFRAME SOURCES BUILD.

`./bootstrap run` is a stand-in that starts NDFRAME; what ./bootstrap itself does is tested by tests/structure/test_bootstrap.py.
"""

import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from run_page import environment, run_page  # noqa: E402

BOOTSTRAP = '#!/bin/sh\n[ "$1" = run ] || exit 9\nshift\nexec ndframe "$@"\n'
LEFT = ["punch.report.html", "punch.e", "punch.summary.json", "punch.contact.csv", "mine.xml", "mine.report.html"]  # the first screen says so


def main(program, sources, build):
    with tempfile.TemporaryDirectory() as name:
        clone = pathlib.Path(name)
        (clone / "decks").symlink_to(sources / "decks")
        (clone / "bootstrap").write_text(BOOTSTRAP)
        (clone / "bootstrap").chmod(0o755)
        wrong = run_page(sources / "README.md", clone, environment(program, sources, build))
        wrong += [f"README.md: no command leaves {file}" for file in LEFT if not (clone / file).exists()]
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:])))
