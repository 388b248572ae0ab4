"""The command line of the report."""

import argparse
import os
import pathlib
import sys
import tempfile

import ndframe

from .results import read_results


def parse(arguments):
    parser = argparse.ArgumentParser(prog="ndframe report", description="Writes NAME.report.html, one file with all "
                                     "that a run, its load cases or a study has written: scene, verdict, pictures, tables, deck.")
    parser.add_argument("name", metavar="NAME", help="beginning of the run's file names, or one of its files: punch, "
                        "results/punch, punch.summary.json, certificate.study.csv")
    parser.add_argument("-o", "--output", metavar="FILE", type=pathlib.Path, help="instead of NAME.report.html")
    parser.add_argument("-c", "--case", metavar="CASE", help="for a run with load cases the report of this one, NAME.CASE.report.html; "
                        "without it, of all of them")
    parser.add_argument("-q", "--quiet", action="store_true", help="do not report what was written")
    return parser.parse_args(arguments)


def write_whole(path, text):
    """Under a temporary name first, so that nobody sees half a report."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:60]}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(temporary, 0o666 & ~mask)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def run(arguments):
    options = parse(arguments)
    try:
        results = read_results(options.name, options.case)
        from .page import page  # loads matplotlib, which a wrong name need not wait for
        path = options.output or pathlib.Path(f"{results.stem}.report.html")
        write_whole(path, page(results))
    except ndframe.ReadError as error:
        print(f"ndframe report: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"ndframe report: cannot write: {error.strerror} ({error.filename})", file=sys.stderr)
        return 2
    if not options.quiet:
        for gap in results.gaps:
            print(f"  not in the report: {gap}")
        print(f"  wrote {path}")
    return 0
