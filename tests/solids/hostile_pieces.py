"""Pieces of meshes with something wrong: hostile_pieces.py NDFRAME [--scenes N] [--seed FIRST].

Random changes of the pieces of the body below a punch (numbers of nodes and elements, coordinates, cells, side sets, names, bytes) on one process, which
joins them, and on two ranks, which read a piece each: both refuse with the same message, or give the same answer. No run ends as a bug.
Prints what differs, and how many scenes were refused and answered.
"""

import collections
import pathlib
import random
import re
import sys
import tempfile

import netCDF4
import numpy

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program, sweep, sweep_options
from shared_solids import difference, in_pieces

DECK = pathlib.Path(__file__).parent.parent.parent / "decks/punch-3d.xml"
GIVEN = ["Linear Solver/Type=Multigrid", "Output/Exodus=false"]
CELLS = ["Bodies/punch/Mesh/Cells={4, 4, 4}", "Bodies/foundation/Mesh/Cells={8, 8, 4}"]  # enough vertices for two ranks


def renumber_alike(draw, files, name):
    """Other numbers of the same things, with gaps and in another order: the same mesh."""
    largest = max(int(file[name][:].max()) for file in files)
    numbers = numpy.array(draw.sample(range(1, 3 * largest + 1), largest + 1))
    for file in files:
        file[name][:] = numbers[file[name][:]]


def change_some(draw, files, name, value):
    """One to three entries of a variable become other ones."""
    file = draw.choice(files)
    if name in file.variables:
        values = file[name][:]
        for _ in range(draw.randint(1, 3)):
            values.flat[draw.randrange(values.size)] = value(values)
        file[name][:] = values


def some(draw, values):
    return values.flat[draw.randrange(values.size)]


NUMBERS = (-1, 0, -(2**31), 2**31 - 1)


def changes(draw, files):
    side = f"ss{draw.randint(1, 10)}"
    number = lambda values: draw.choice((*NUMBERS, some(draw, values)))
    return {
        "nodes alike": lambda: renumber_alike(draw, files, "node_num_map"),
        "elements alike": lambda: renumber_alike(draw, files, "elem_num_map"),
        "both alike": lambda: [renumber_alike(draw, files, name) for name in ("node_num_map", "elem_num_map")],
        "node numbers": lambda: change_some(draw, files, "node_num_map", number),
        "element numbers": lambda: change_some(draw, files, "elem_num_map", number),
        "coordinates": lambda: change_some(draw, files, f"coord{draw.choice('xyz')}",
                                           lambda values: draw.choice((numpy.nan, 1e300, 1e-17, some(draw, values), draw.uniform(-1, 1)))),
        "cells": lambda: change_some(draw, files, "connect1", lambda values: draw.choice((0, -1, 10**9, some(draw, values)))),
        "facets' elements": lambda: change_some(draw, files, f"elem_{side}", lambda values: draw.choice((0, -1, 10**9, some(draw, values)))),
        "facets' sides": lambda: change_some(draw, files, f"side_{side}", lambda values: draw.choice((0, 5, 1, 2, 3, 4))),
        "a name": lambda: change_some(draw, files, draw.choice(("ss_names", "eb_names")), lambda values: draw.choice((b"x", b"\0", b"\n"))),
    }


def damage(draw, folder):
    """What was changed."""
    pieces = sorted(folder.glob("*.foundation.e.2.*"))
    kind = draw.choice(("bytes", "twice", *(name for name in changes(draw, [])),))
    if kind == "bytes":
        path = draw.choice(pieces)
        data = bytearray(path.read_bytes())
        for _ in range(draw.randint(1, 4)):
            data[draw.randrange(draw.choice((2000, len(data))))] = draw.randrange(256)
        path.write_bytes(data)
    elif kind == "twice":
        pieces[1].write_bytes(pieces[0].read_bytes())
    else:
        files = [netCDF4.Dataset(path, "r+") for path in pieces]
        for file in files:
            file.set_auto_mask(False)
        changes(draw, files)[kind]()
        for file in files:
            file.close()
    return kind


def message(run):
    """What the screen says of the mistake."""
    return re.findall(r"(?m)^.*Bodies/foundation.*$", run.screen)


def judge(program, seed):
    draw = random.Random(f"hostile {seed}")
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "punch.xml"
        deck.write_text(re.sub(r'(?s)<ParameterList name="(Expect|Error Estimation)">.*?\n  </ParameterList>', "", DECK.read_text()))
        read = in_pieces(program, deck, 2, *CELLS)
        kind = damage(draw, pathlib.Path(folder))
        one, several = (program.run(deck, *GIVEN, *read, ranks=ranks) for ranks in (1, 2))
    if one.code in (1,) or several.code in (1,) or max(one.code, several.code) > 6:
        return f"exit codes {one.code} and {several.code}: {several.screen[-600:]}", (kind, one.code), f"{seed}: {kind}"
    wrong = difference(one, several)
    if wrong is None and message(one) != message(several) and one.code == 2:
        wrong = f"{message(one)} and {message(several)}"
    isRead = several.summary is not None and several.summary["ledger"]["counts"].get("pieces read", 0) > 0
    return wrong, (kind, one.code, isRead), f"{seed}: {kind}"


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    answered = collections.Counter(kind for (kind, code, *isRead), _ in found if code == 0 and isRead == [True])
    refused = sum(code == 2 for (_, code, *_), _ in found)
    print(f"{options.scenes} scenes, {wrong} wrong, {refused} refused, {answered.total()} answered by ranks that read their own: "
          + ", ".join(f"{count} {kind}" for kind, count in sorted(answered.items())))
    sys.exit(1 if wrong or not refused or not answered else 0)


if __name__ == "__main__":
    main()
