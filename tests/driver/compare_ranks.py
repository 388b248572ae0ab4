"""The same answer on 1, 2 and 3 processes: compare_ranks.py MPIEXEC NDFRAME DECK [SETTING ...]."""

import json
import pathlib
import subprocess
import sys
import tempfile

MPIEXEC, NDFRAME, DECK, *SETTINGS = sys.argv[1:]


def summary_on(ranks):
    settings = [part for setting in SETTINGS for part in ("--set", setting)]
    with tempfile.TemporaryDirectory() as folder:
        command = [MPIEXEC, "--oversubscribe", "-np", str(ranks), NDFRAME, "-i", DECK, *settings]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, f"{ranks} ranks: exit code {done.returncode}\n{done.stdout}{done.stderr}"
        assert done.stdout.count("wrote ") == 1, f"one rank speaks:\n{done.stdout}"
        return json.loads(next(pathlib.Path(folder).glob("*.summary.json")).read_text())


def close(a, b, tolerance):
    return abs(a - b) <= tolerance * max(abs(a), abs(b), 1e-300)


def compare_errors(one, other, where, norm=None):
    """Every number, word and verdict. Parts that vanish are the root of round-off: squares, relative to the bound's."""
    if isinstance(one, dict):
        assert isinstance(other, dict) and one.keys() == other.keys(), (where, one, other)
        norm = norm or (one.get("global") or {}).get("absolute")
        for key, value in one.items():
            if not key.startswith("equilibrium"):
                compare_errors(value, other[key], f"{where}: {key}", norm)
            elif value is not None:
                assert max(value, other[key]) < 1e-12, (where, one, other)
    elif isinstance(one, float):
        assert close(one, other, 1e-8) or abs(one**2 - other**2) <= 1e-9 * (norm or 0) ** 2, (where, one, other)
    else:
        assert one == other, (where, one, other)


one = summary_on(1)
largest_reaction = max((abs(x) for body in one["bodies"] for support in body["supports"]
                        for x in support["force"] + support["moment"]), default=0.0)
for ranks in (2, 3):
    other = summary_on(ranks)
    assert other["ranks"] == ranks
    assert close(one["energy"], other["energy"], 1e-10), (one["energy"], other["energy"])
    for a, b in zip(one["bodies"], other["bodies"], strict=True):
        assert close(a["energy"], b["energy"], 1e-10), (ranks, a, b)
        assert close(a["largest_displacement"]["value"], b["largest_displacement"]["value"], 1e-8), (ranks, a, b)
        assert close(a["largest_strain"]["value"], b["largest_strain"]["value"], 1e-8), (ranks, a, b)
        for p, q in zip(a["supports"], b["supports"], strict=True):
            reactions = list(zip(p["force"] + p["moment"], q["force"] + q["moment"], strict=True))
            assert all(abs(x - y) <= 1e-8 * largest_reaction for x, y in reactions), (ranks, p, q)
    assert one["warnings"] == other["warnings"], (ranks, one["warnings"], other["warnings"])
    for a, b in zip(one["interfaces"], other["interfaces"], strict=True):
        assert a["closed_nodes"] == b["closed_nodes"] and a["end_points"] == b["end_points"], (ranks, a, b)
        assert close(a["largest_pressure"], b["largest_pressure"], 1e-6), (ranks, a, b)
    compare_errors(one["errors"], other["errors"], f"errors on {ranks} ranks")
    if one["coupling"]:
        histories = one["coupling"]["history"], other["coupling"]["history"]
        for a, b in zip(*histories, strict=True):
            assert (a["closed"], a["status_passes"]) == (b["closed"], b["status_passes"]), (ranks, a, b)
            assert close(a["eps_tau"], b["eps_tau"], 1e-6), (ranks, a, b)
print(f"energy {one['energy']} on 1, 2 and 3 ranks")
