"""No bound of a network lies below its error: certificate_networks.py NDFRAME [--scenes N] [--seed FIRST].

Stacks, bridges, rings, chains and walls under random loads, with random moduli and cells, in any order of the deck, by a
random coupling that is stopped anywhere: after a few sweeps, or with a coarse tolerance. The error is that of a solution
on cells half as large (more halvings where one is not enough to tell). A guaranteed bound below it is a violation, and
so is a run that ends otherwise than it may. Prints the violations, and how sharp the bounds are.
"""

import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import network_decks
import network_sweep
from runs import Program, print_sharpness, sweep, sweep_options

ESTIMATES = ("Error Estimation/Estimators={Global, Discretization, Algorithm, Reference}",
             "Error Estimation/Check Equilibrium=true", "Output/Exodus=false", "Output/Contact Table=false")
EXACT = 1e-9  # of the solution: an error below is that of two exact solutions


def couplings(draw):
    """Settings of a coupling; the last one says whether it ends where it should."""
    kind = draw.choice(("Monolithic", "FETI", "FETI", "Neumann-Dirichlet"))
    if kind == "Monolithic":
        return ["Coupling/Type=Monolithic"], True
    if kind == "FETI":
        tolerance = draw.choice((1e-12, 1e-6, 1e-4, 1e-3, 1e-2, 0.09))
        return ["Coupling/Type=FETI", f"Coupling/Tolerance={tolerance}"], tolerance < 1e-9
    sweeps = draw.choice((1, 2, 3, 5, 10, 200))
    return ["Coupling/Type=Neumann-Dirichlet", f"Coupling/Stopping/Maximum Sweeps={sweeps}"], False


def mesh_apart(draw, deck, settings):
    """Other numbers of cells for every body, so that sides do not match, or some still do; contact in means on some interfaces
    where the coupling asks for them. Returns how it was changed."""
    if draw.random() < 0.5:
        return ""
    for body in deck["Bodies"].values():
        n, m = body["Mesh"]["Cells"]
        body["Mesh"]["Cells"] = (n + draw.randint(0, 4), m + draw.randint(0, 4))
    if "Coupling/Type=Neumann-Dirichlet" in settings:
        return ", apart"
    for contact in deck["Interfaces"].values():
        if draw.random() < 0.5:
            contact["Pairing"] = {"Type": "Mortar"}
    conditions = draw.choice(("Nodal", "Bernstein"))
    deck["Discretization"] = {"Contact Conditions": conditions}
    return f", apart, some in means, {conditions}"


def judge(program, seed):
    """(what is wrong or None, bound / error of a run that ends where it should, what it is about)"""
    draw = random.Random(f"certificate {seed}")
    arguments, deck = network_sweep.network(seed, pulls=draw.random() < 0.2)
    settings, ends = couplings(draw)
    apart = mesh_apart(random.Random(f"apart {seed}"), deck, settings)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "network.xml"
        path.write_text(network_decks.to_xml("network", deck))
        run = program.run(path, *settings, *ESTIMATES)
    about = f"{seed}: {' '.join(arguments)}, {', '.join(settings)}{apart}"
    if run.code not in (0, 2, 3):
        return f"exit code {run.code}: {run.screen[-300:]}", None, about
    if run.code == 2 and "ring of" not in run.screen and "meet at a node" not in run.screen:
        return f"refused: {run.screen[-300:]}", None, about
    if not run.summary or not run.summary["errors"]:
        return None, None, about
    errors = run.summary["errors"]
    bound, error = errors["global"]["absolute"], errors["reference"]["displacement"]
    guaranteed = errors["global"]["guaranteed"]
    if guaranteed and error > bound and errors["reference"]["relative"] > EXACT:
        return f"bound {bound:.6g} below the error {error:.6g}", None, about
    if not guaranteed and run.code == 0:
        return f"not guaranteed: {errors['global']['reason']}", None, about
    told = ends and run.code == 0 and errors["reference"]["relative"] > EXACT
    return None, bound / error if told else None, about


def main():
    options = sweep_options(__doc__)
    program = Program(options.ndframe)
    wrong, found = sweep(options, lambda seed: judge(program, seed))
    ratios = [ratio for ratio, _ in found if ratio]
    if ratios:
        print_sharpness(ratios)
    print(f"{options.scenes} scenes, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
