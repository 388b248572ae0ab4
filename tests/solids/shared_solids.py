"""Solids whose meshes are shared out: shared_solids.py NDFRAME [--scenes N] [--seed FIRST].

Random scenes from files of gmsh, as they are drawn (fine enough for the ranks) or with `Refine`, on one process and on 2 to 6
ranks that have shares of the meshes: energies, reactions, peaks, probes and contact are the same, and so are the bounds of those that
are certified, whose stresses are in equilibrium. Solids have regions and loads in groups of cells, are tied, held at points or by
their mean motion, or meshed apart and cut. Some meshes are written in pieces first, which the ranks read for themselves where
they can. Scenes that are not shared (too small ones) are solved whole and compared, too. Prints what differs, and how many scenes of each kind were shared.
"""

import collections
import csv
import io
import math
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from certificate_solids import scene
from cut_solids import partial, patch
from runs import Program, sweep, sweep_options
from solid_scenes import AS_MANY_STEPS, pressure, write_scene

ENOUGH = 200  # vertices a rank: fewer are not shared out
SAME = 2e-6  # of the largest of its kind: iterations stop at 1e-10, and forces are derivatives


SAME_BOUND = 1e-4  # the recovery steps in single precision, and begins from what iterations left
EXACT = 1e-9  # of the solution: where that is exact, bounds are round-off
BALANCED = 1e-9


def reasons(bound):
    """Whether it is guaranteed, and why not: places come in the order of nodes, which shares number otherwise. Forces of points are
    compared as reactions."""
    reason = re.sub("with a force of [^ ,]*", "with a force", str(bound.get("reason", "")))
    return bound.get("guaranteed"), sorted(reason.split(". "))


UNBALANCED = "holds a point"  # where the recovery leaves what no stress balances depends on how cells are shared out


def shaken(program, deck, given, solids, bound):
    """How far the bound of one process is from those of scenes that are the same but for round-off of a modulus, relative: cells that
    cuts make thin are ill-conditioned for a given number of steps in single precision (up to 3e-4 has been seen)."""
    moduli = [f"Bodies/{solid.name}/Material/Young Modulus={solid.young * (1 + k * 1e-13)!r}" for solid in solids for k in range(1, 5)]
    runs = [program.run(deck, *given, modulus) for modulus in moduli]
    return max(abs(run.summary["errors"]["global"]["absolute"] / bound - 1) for run in runs)


def differs_in_bounds(one, shared, same):
    isUnbalanced = one is not None and UNBALANCED in str(one["global"].get("reason"))
    if (one is None) != (shared is None):
        return "a certificate without another"
    for name in ("global", "algorithm", "discretization") if one else ():
        first, second = one[name], shared[name]
        if (first is None) != (second is None):
            return f"no {name}"
        least = EXACT * one["global"]["absolute"] / one["global"]["relative"] if first and one["global"]["relative"] else 0.0
        if first and not isUnbalanced and abs(first["absolute"] - second["absolute"]) > same * one["global"]["absolute"] + least:
            return f"{name} {first['absolute']!r} and {second['absolute']!r}"
        if first and reasons(first) != reasons(second):
            return f"{name} guaranteed: {first.get('reason')!r} and {second.get('reason')!r}"
    if shared and not isUnbalanced and shared["equilibrium"] is not None and shared["equilibrium"] > BALANCED:
        return f"the stress is out of balance by {shared['equilibrium']:.2e}"
    return None


def numbers(summary):
    """(kind, where, value): all that is compared; of one kind the largest decides what is small."""
    for body in summary["bodies"]:
        name = body["name"]
        yield "size", f"{name} dofs", body["dofs"]
        yield "cells", f"{name} elements", body["elements"]
        yield "energy", f"{name} energy", body["energy"]
        yield "displacement", f"{name} displacement", body["largest_displacement"]["value"]
        for region in body.get("regions", []):
            yield "cells", f"{name} {region['name']} elements", region["elements"]
            yield "energy", f"{name} {region['name']} energy", region["energy"]
        for k, value in enumerate(body["load_force"]):
            yield "force", f"{name} load {k}", value
        for support in body["supports"]:
            for k, value in enumerate(support["force"]):
                yield "force", f"{name} {support['name']} force {k}", value
            for k, value in enumerate(support["moment"]):
                yield "force", f"{name} {support['name']} moment {k}", value
    for interface in summary["interfaces"]:
        yield "force", "contact force", interface["contact_force"]
        yield "nodes", "nodes", interface["nodes"]
    for probe in summary.get("probes", []):
        for place in probe.get("points", [probe]):
            for k, value in enumerate(place["displacement"]):
                yield "displacement", f"{probe['name']} displacement {k}", value
            for key, value in place.get("stress", {}).items():
                yield "stress", f"{probe['name']} stress {key}", value
        for k, value in enumerate([*probe.get("force", ()), *probe.get("moment", ())]):
            yield "stress", f"{probe['name']} force {k}", value


def add_probes(deck, draw, pair):
    """Points and sides of the solids; a point that is outside of a bent one ends both runs."""
    lists = []
    for solid in pair:
        if not solid.foot:
            continue
        for k in range(3):
            inner = [draw.choice((0.5, draw.uniform(0.2, 0.8))) for _ in range(3)]
            at = ", ".join(map(repr, solid.place(*inner)))
            lists.append(f'<ParameterList name="{solid.name} {k}"><Parameter name="Body" type="string" value="{solid.name}"/>'
                         f'<Parameter name="At" type="Array(double)" value="{{{at}}}"/></ParameterList>')
        lists.append(f'<ParameterList name="{solid.name} side"><Parameter name="Body" type="string" value="{solid.name}"/>'
                     f'<Parameter name="Side" type="string" value="{draw.choice(("left", solid.foot))}"/></ParameterList>')
    text, end = deck.read_text(), "</ParameterList>"
    assert text.endswith(end)
    deck.write_text(f'{text[:-len(end)]}<ParameterList name="Output"><ParameterList name="Probes">{"".join(lists)}{end}{end}{end}')


def table(text):
    """The contact table by place: shares number nodes otherwise."""
    if text is None:  # of bodies that are tied
        return {}
    rows = csv.DictReader(io.StringIO(text))
    return {tuple(round(float(row[x]), 9) for x in "xyz"): (float(row["pressure"]), float(row["gap"])) for row in rows}


def difference(one, shared, same=SAME_BOUND):
    if one.code != shared.code:
        return f"exit codes {one.code} and {shared.code}: {one.screen[-400:]} / {shared.screen[-400:]}"
    if one.code != 0:
        return None
    first, second = list(numbers(one.summary)), list(numbers(shared.summary))
    if [entry[:2] for entry in first] != [entry[:2] for entry in second]:
        return "other numbers"
    largest = {}
    for kind, _, value in first:
        largest[kind] = max(largest.get(kind, 0.0), abs(value))
    for (kind, where, value), (_, _, other) in zip(first, second):
        if abs(value - other) > SAME * largest[kind]:
            return f"{where} {value!r} and {other!r}"
    here, there = table(one.contact), table(shared.contact)
    if here.keys() != there.keys():
        return "contact at other places"
    scales = [max((abs(values[k]) for values in here.values()), default=0.0) for k in (0, 1)]
    scales[1] = max(scales[1], 1e-6 * largest["displacement"])  # gaps that are closed everywhere are round-off
    for place, values in here.items():
        for k, name in enumerate(("pressure", "gap")):
            if abs(values[k] - there[place][k]) > 1e-4 * scales[k]:
                return f"{name} at {place}: {values[k]} and {there[place][k]}"
    if shared.summary["residuals"]["equilibrium"] > 1e-7:
        return f"residual {shared.summary['residuals']['equilibrium']}"
    return differs_in_bounds(one.summary["errors"], shared.summary["errors"], same)


def divide(draw, solid):
    """Regions of one to all grid cells, in the body or at its foot, that no part of a mesh need have, and a force in them."""
    first = [draw.randrange(n) for n in solid.cells]
    isIn = draw.choice((lambda corner: list(corner) == first, lambda corner: corner[0] <= first[0],
                        lambda corner: corner[2] == first[2]))
    names = draw.sample(("core", "a b", "Rest"), 2)
    solid.group_of = lambda corner: names[0] if isIn(corner) else names[1] if corner[1] >= first[1] else "body"
    chosen = names if any(not isIn(corner) and corner[1] >= first[1] for corner in solid.corners()) else names[:1]
    solid.regions = {name: draw.choice((solid.young, 10.0 ** draw.uniform(-1, 1))) for name in chosen if draw.random() < 0.8}
    if draw.random() < 0.6:
        solid.loads["inside"] = [("Type", "string", "Body Force"), ("Cells", "Array(string)", f"{{{draw.choice(chosen)}}}"),
                                 ("Z", "string", draw.choice(("-0.2", "-0.1*(1+x)", "-0.1*cos(y)")))]


def hold(draw, solid):
    """Instead of its rollers: points, some with a force, or a mean motion."""
    at = lambda r, s, t: f"{{{', '.join(map(repr, solid.place(r, s, t)))}}}"
    point = lambda place, **held: [("Type", "string", "Point"), ("At", "Array(double)", at(*place)),
                                   *((axis, "string", value) for axis, value in held.items())]
    if draw.random() < 0.4:
        side = [("Side", "string", draw.choice(("left", "top")))] if draw.random() < 0.5 else []
        solid.supports = {"mean": [("Type", "string", "Hold"), *side]}
        return
    solid.supports = {"corner": point((0, 0, 1), X="0", Y="0"), "edge": point((1, 0, 1), Y=draw.choice(("0", "0", "1e-3*x")))}
    if draw.random() < 0.4:
        solid.loads["push"] = pressure("right", "0.05")


def drawn_scene(draw):
    """(kind, pair, settings, what it has more than contact)"""
    kind, pair, settings = scene(draw, 2)
    more = draw.choice(("", "regions", "regions", "held", "held", "cut", "cut", "tied"))
    if more == "cut":
        pair, _ = draw.choice((patch, partial))(draw)
        settings = []
    if more == "held" and kind != "flat":
        kind, pair, settings = scene(draw, 2)
    if (more == "held" and not kind.startswith("flat")) or (more == "tied" and "rigid" in kind):
        more = ""
    if more == "held":
        hold(draw, next(solid for solid in pair if solid.name == "upper"))
    if more == "tied":
        settings = [("Tied", "bool", "true")]
    return f"{kind} {more}", pair, settings, more


def in_pieces(program, deck, pieces, *settings):
    """The settings that make the deck read its meshes in pieces, which are written next to it; settings: of those meshes. None if it
    is refused."""
    options = [part for setting in settings for part in ("--set", setting)]
    done = subprocess.run([program.path, "-i", deck, *options, "--decompose", str(pieces)], cwd=deck.parent, capture_output=True, text=True)
    if done.returncode != 0:
        return None
    told = shlex.split(done.stdout.split("the deck reads them with", 1)[1].replace("\\\n", " "))
    return [setting.replace("/Mesh/File=", f"/Mesh/File={deck.parent}/") for setting in told if setting != "--set"]


def judge(program, seed):
    draw = random.Random(f"shared {seed}")
    other = random.Random(f"pieces {seed}")
    arePieces = other.random() < 0.4
    kind, pair, settings, more = drawn_scene(draw)
    ranks, halvings = draw.randint(2, 6), draw.choice((0, 0, 1, 1, 2) if more != "cut" else (0, 0, 1))
    if arePieces and halvings > 0:  # of meshes that are fine enough before
        ranks, halvings = min(ranks, 3), 1
    solids = [solid for solid in pair if solid.foot]
    for solid in solids:
        solid.cells = tuple(min(n, 2 if halvings == 2 else 4) for n in solid.cells)
    isWhole = halvings == 0 or arePieces or more in ("cut", "tied")  # rank 0 refines the last two
    shared = 0 if arePieces else halvings  # how often meshes are halved when they are shared out
    while isWhole and sum(math.prod(n * 2**shared + 1 for n in solid.cells) for solid in solids) < ENOUGH * ranks:
        for solid in solids:
            solid.cells = tuple(2 * n for n in solid.cells)
    for solid in solids[:1] if more == "tied" else solids:  # of tied ones one may have a material besides its regions
        if more == "regions" or draw.random() < 0.2:
            divide(draw, solid)
    given = [f"Bodies/{solid.name}/Mesh/Refine={halvings}" for solid in solids]
    given += ["Linear Solver/Type=Multigrid", "Coupling/Type=Monolithic", "Output/Exodus=false"]
    if draw.random() < 0.6:
        estimators = draw.choice(("{Global}", "{Global}", "{Global}" if more == "tied" else "{Global, Algorithm, Discretization}"))
        given += [f"Error Estimation/Estimators={estimators}", "Error Estimation/Check Equilibrium=true", *AS_MANY_STEPS]
    about = f"{seed}: {kind}, {ranks} ranks, {' '.join(given)}"
    with tempfile.TemporaryDirectory() as folder:
        deck = write_scene(folder, *pair, settings)
        if more != "tied":
            add_probes(deck, draw, pair)
        read = arePieces and in_pieces(program, deck, ranks * other.choice((1, 1, 2)))
        one, shared = program.run(deck, *given), program.run(deck, *given, *(read or ()), ranks=ranks)
        wrong = difference(one, shared)
        if wrong and one.code == 0 and one.summary["errors"] and difference(one, shared, same=1.0) is None:
            spread = shaken(program, deck, given, solids, one.summary["errors"]["global"]["absolute"])
            wrong = difference(one, shared, same=SAME_BOUND + 2 * spread)
    counts = shared.summary["ledger"]["counts"] if shared.summary else {}
    if counts.get("pieces read"):
        more = f"{more} in pieces".strip()
    return wrong, (one.code, counts.get("shared bodies", 0) > 0, more), f"{about} {' in pieces' if read else ''}"


def main():
    options = sweep_options(__doc__, mpiexec=("mpiexec", "what starts several ranks"))
    program = Program(options.ndframe, options.mpiexec, seconds=600)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    shared = collections.Counter(more for (code, isShared, more), _ in found if code == 0 and isShared)
    kinds = ", ".join(f"{count} {more or 'plain'}" for more, count in sorted(shared.items()))
    print(f"{options.scenes} scenes, {wrong} wrong, {shared.total()} solved in shares: {kinds}")
    sys.exit(1 if wrong or not shared else 0)


if __name__ == "__main__":
    main()
