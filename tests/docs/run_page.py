"""Runs the commands of a page and compares what they show: run_page.py NDFRAME SOURCES BUILD PAGE."""

import os
import pathlib
import subprocess
import sys
import tempfile

from pages import blocks_of, file_of, missing_line


def environment(program, sources, build):
    return {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}", "NDFRAME_SOURCE": str(sources), "NDFRAME_BUILD": str(build),
            "PYTHONPATH": str(sources / "python"), "NDFRAME_PROGRAM": str(program), "PYTHONDONTWRITEBYTECODE": "1"}


def run_page(page, folder, variables):
    """Sentences about what is wrong."""
    screen = ""
    for block in blocks_of(page.read_text()):
        where = f"{page}:{block.line}"
        if name := file_of(block):
            (folder / name).write_text(block.text)
        elif block.language == "sh":
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", block.text], cwd=folder, env=variables, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            screen = done.stdout
            if done.returncode != 0:
                return [f"{where}: ended with {done.returncode}:\n{screen}"]
        elif block.language == "text" and (line := missing_line(block.text, screen)) is not None:
            return [f'{where}: the screen does not show "{line}" at its place:\n{screen}']
    return []


def main(program, sources, build, page):
    with tempfile.TemporaryDirectory() as folder:
        wrong = run_page(page, pathlib.Path(folder), environment(program, sources, build))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:])))
