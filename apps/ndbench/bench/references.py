"""2 J(u) of every scene with its bracket, from certified runs on graded meshes; stored in references.json.

For v in K, (39) of the paper and (*) of truth.py with the guaranteed bound B >= |v - u| give

    2 J(v) - tau - B^2  <=  2 J(u)  <=  2 J(v) - tau,        tau = 2 int t (w_v - g) dS.

tau vanishes for a body alone and where everything is closed: there the bracket is guaranteed. Where contact ends inside,
tau is evaluated with the finest traction: the bracket is as good as that tau, which is stored beside it and is hundreds
of times narrower. Solids in contact have the meshes of runs with a target and those runs' own bracket of the exact energy
(docs/theory.md, section 8), guaranteed by a displacement that does not penetrate; tau is left out without a gap, and is only beside the
bracket with one. Inside the bracket the best value is the one for which the effectivity of the bound is the
same on the two finest meshes, 2 J(v) - tau - c B^2 with one c in [0, 1]: the bound converges like the error there.
"""

import json
import math
import pathlib

from bench.program import run
from bench.truth import Exact, contact_term, twice_potential

STORE = pathlib.Path(__file__).resolve().parents[1] / "references" / "references.json"
LEVELS = 3
CERTIFIED = (
    "Coupling/Type=Monolithic", "Error Estimation/Estimators={Global}", "Error Estimation/Require Guarantee=true",
    "Error Estimation/Recovery/Sweeps=2",
)
RINGS = 200  # in a unit of length
DIGITS = 9  # of the stored pressure, which enters only the contact term


def bracket(coarse, fine):
    """(best, low, high) of 2 J(u) from (2 J(v) - tau, bound) on two meshes."""
    (above, wide), (high, narrow) = coarse, fine
    share = (above - high) / (wide**2 - narrow**2)
    return high - min(max(share, 0.0), 1.0) * narrow**2, high - narrow**2, high


def ring_pressures(finest):
    """Means over the nodes of rings around the axis z."""
    rings = {}
    for row in finest.contact:
        distance = math.hypot(row["x"], row["y"])
        rings.setdefault(round(RINGS * distance), []).append((distance, -row["pressure"]))
    means = sorted(tuple(sum(column) / len(nodes) for column in zip(*nodes)) for nodes in rings.values())
    end = next((i for i, (_, t) in enumerate(means) if t == 0), len(means) - 1)
    return tuple((x, float(f"{t:.{DIGITS}g}")) for x, t in means[: end + 1])


def pressures(finest):
    if finest.overlap:
        return ring_pressures(finest)
    table = sorted((row["x"], min(row["traction_dirichlet"], 0.0)) for row in finest.contact)
    return tuple((x, float(f"{t:.{DIGITS}g}")) for x, t in table)


def compute(program, scene, levels=range(LEVELS)):
    """The reference of a scene as it is stored."""
    degree = () if scene.dim == 3 else ("Error Estimation/Recovery/Degree=3",)
    runs = [run(program, scene.deck, (*scene.settings, *scene.finest(level), *CERTIFIED, *degree)) for level in levels]
    if not all(each.bound for each in runs):
        raise SystemExit(f"ndbench: a reference of {scene.name} has no guaranteed bound")
    first = Exact(0.0, 0.0, 0.0, 0.0, pressures(runs[-1]))
    taus = [contact_term(each, scene.gap, first) for each in runs]
    values = [(twice_potential(each) - tau, each.bound) for each, tau in zip(runs, taus)]
    best, low, high = bracket(*values[-2:])
    if scene.joins_solids:
        low, high = runs[-1].twice_energy
        best = min(max(best, low), high)
    return {
        "best": best, "low": low, "high": high, "norm": math.sqrt(runs[-1].summary["energy"]),
        "runs": [
            {"dofs": each.dofs, "twice_potential": twice_potential(each), "tau": tau, "bound": each.bound}
            for each, tau in zip(runs, taus)
        ],
        "pressure": first.pressure,
    }


def store(references):
    STORE.write_text(json.dumps(references, separators=(",", ":")).replace('},"', '},\n"') + "\n")


def stored():
    return json.loads(STORE.read_text())


def load():
    """The stored references: Exact by scene name."""
    return {
        name: Exact(each["best"], each["low"], each["high"], each["norm"], tuple(map(tuple, each["pressure"])))
        for name, each in stored().items()
    }
