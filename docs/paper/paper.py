"""Computes tables 1 to 3 and figures 5 to 9 of Gallimard and Sassi (2010) with ndframe: paper.py NDFRAME [--quick] [FOLDER]

Writes table1.csv ..., figure5.png ... and README.md (page.md with the tables in it) to FOLDER, by default the folder of this script.
Fails when something that the page claims does not hold. --quick leaves the finer meshes out.
"""

import argparse
import pathlib
import sys

import pictures
import tables

HERE = pathlib.Path(__file__).resolve().parent


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ndframe", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=HERE)
    parser.add_argument("--quick", action="store_true")
    return parser.parse_intermixed_args()


def main():
    given = arguments()
    given.folder.mkdir(parents=True, exist_ok=True)
    computed = tables.compute(given.ndframe, given.quick)
    for name, rows in computed.items():
        (given.folder / f"{name}.csv").write_text(tables.as_csv(tables.beside_printed(name, rows)))
    (given.folder / "README.md").write_text((HERE / "page.md").read_text().format(**tables.page_tables(computed)))
    pictures.draw_all(given.ndframe, computed, given.folder, 3 if given.quick else 11)
    claims = tables.claims(computed)
    for sentence, holds in claims:
        print("holds: " if holds else "FAILS: ", sentence)
    print("wrote", given.folder)
    return 0 if all(holds for _, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
