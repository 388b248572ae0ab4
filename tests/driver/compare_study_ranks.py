"""A study, or load cases, give the same table on 1, 2 and 3 processes: compare_study_ranks.py MPIEXEC NDFRAME DECK [SETTING...]."""

import csv
import pathlib
import subprocess
import sys
import tempfile

MPIEXEC, NDFRAME, DECK, *SETTINGS = sys.argv[1:]
# What a run measures of itself.
OF_THE_PROCESS = {"seconds", "peak_bytes"}


def table_on(ranks):
    with tempfile.TemporaryDirectory() as folder:
        command = [MPIEXEC, "--oversubscribe", "-np", str(ranks), NDFRAME, "-i", DECK,
                   *(part for setting in SETTINGS for part in ("--set", setting))]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, f"{ranks} ranks: exit code {done.returncode}\n{done.stdout}{done.stderr}"
        assert done.stdout.count("wrote ") == 1, f"one rank speaks:\n{done.stdout}"
        (path,) = [path for path in pathlib.Path(folder).iterdir() if path.name.endswith((".study.csv", ".cases.csv"))]
        with open(path, newline="") as rows:
            return list(csv.DictReader(rows))


def same(a, b):
    """Texts; or numbers to round-off, those below it (a penetration of 1e-17) included."""
    try:
        x, y = float(a), float(b)
    except ValueError:
        return a == b
    return abs(x - y) <= 1e-8 * max(abs(x), abs(y)) + 1e-12


one = table_on(1)
assert len(one) > 1, one
for ranks in (2, 3):
    for row, other in zip(one, table_on(ranks), strict=True):
        for name in row.keys() - OF_THE_PROCESS:
            assert same(row[name], other[name]), (ranks, row["case"], name, row[name], other[name])
print(f"{len(one)} cases on 1, 2 and 3 ranks")
