"""Networks under loads at random: network_sweep.py NDFRAME [--scenes N] [--seed FIRST].

Every side that is free, or a part of it, is pressed, left alone or pulled. What is named neither pulled off nor not unique before the
solve has a solution, and all bodies together must find it, FETI too, with the same energy; what is pulled off ends with
exit code 3; what is not unique is solved, or ends saying that nothing presses the bodies together, which a wall may not whose top
is pressed in part (every eighth scene). One line a scene that
does otherwise; exit code 1 if there is one.
"""

import collections
import pathlib
import random
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import network_decks
from runs import Program, sweep_options

SAME = 1e-9
NOT_PRESSED = ("contact is undecided: nothing presses", "the load does not press the bodies together")


def network(seed, pulls=True):
    """(arguments of network_decks, deck) of a scene. pulls: some loads may pull."""
    draw = random.Random(f"network {seed}")
    scene = draw.choice((["wall", str(draw.randint(2, 5)), str(draw.randint(1, 4))], ["stack"], ["ring"],
                         ["chain", str(draw.randint(2, 7))], ["tjunction"]))
    arguments = [*scene, "--young", draw.choice(("uniform", "random:1", "random:2")), "--seed", str(seed),
                 "--shuffle", str(seed)]

    def load(boxes):
        for box in boxes:
            box.loads = []
        for box, side in network_decks.free_sides(boxes):
            if draw.random() < 0.8:
                first, last = box.along(side)
                middle = first + 0.25 * draw.randint(1, max(1, round(4 * (last - first)) - 1))
                start, end = draw.choice(((first, last), (first, middle), (middle, last)))
                box.press(side, draw.choice((1.0, 1.0, 0.5, 0.2, -0.1, -0.5) if pulls else (1.0, 0.5, 0.2)), start, end)

    return arguments, network_decks.deck(network_decks.options_of(arguments), load)


def loose_wall(seed):
    """The same of a wall of which a small part is pressed on top: most of its bricks are loose."""
    draw = random.Random(f"loose wall {seed}")
    arguments = ["wall", str(draw.randint(5, 14)), str(draw.randint(4, 18)), "--load", draw.choice(("0.05", "0.1", "0.2", "0.4")),
                 "--cell", "0.5", "--young", draw.choice(("uniform", "random:1", "random:2")), "--seed", str(seed),
                 "--shuffle", str(seed)]
    return arguments, network_decks.deck(network_decks.options_of(arguments))


def outcome(program, deck, couplings=("Monolithic", "FETI"), ends=(0, 3)):
    """(what was said before the solve, whether the answers of all couplings keep to it). ends: what a run whose place is not
    unique may end with; 3 where nothing but round-off may press the bodies."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "network.xml"
        path.write_text(network_decks.to_xml("network", deck))
        runs = [program.run(path, f"Coupling/Type={coupling}", "Output/Exodus=false")
                for coupling in couplings]
    if any("it pulls off" in run.screen for run in runs):
        return "pulled off", all(run.code == 3 for run in runs)
    solved = all(run.code == 0 for run in runs)
    energies = [run.summary["energy"] if run.summary else None for run in runs]
    if solved and max(energies) - min(energies) > SAME * abs(energies[0]):
        return f"energies {energies}", False
    if any(warning["kind"] == "not unique" for run in runs if run.summary for warning in run.summary["warnings"]):
        return "not unique", all(run.code == 0 or (run.code in ends and any(text in run.screen for text in NOT_PRESSED))
                                 for run in runs)
    return "held", solved


def main():
    options = sweep_options(__doc__)
    program, counts, wrong = Program(options.ndframe), collections.Counter(), 0
    for seed in range(options.seed, options.seed + options.scenes):
        is_loose = seed % 8 == 0
        arguments, deck = loose_wall(seed) if is_loose else network(seed)
        said, kept = (outcome(program, deck, ("Monolithic", "FETI", "Neumann-Neumann"), ends=(0,)) if is_loose
                      else outcome(program, deck))
        counts[said] += 1
        if not kept:
            wrong += 1
            print(f"{seed}: {' '.join(arguments)}: {said}, but the run ended otherwise")
    print(", ".join(f"{count} {said}" for said, count in sorted(counts.items())), f"; {wrong} wrong", sep="")
    sys.exit(1 if wrong or len(counts) < 3 else 0)


if __name__ == "__main__":
    main()
