"""Decks that name no relaxation and no roles converge: default_sweep.py NDFRAME [--scenes N] [--seed FIRST].

Random scenes of two bodies (random_scenes.py), stiffness ratios 1e-6 to 1e6, either body floating. Each must end with
exit code 0 within the default Maximum Sweeps, and, when the tolerance is sharp, with the energy of Monolithic. One line
a scene that misses; exit code 1 if there is one. 1000 scenes take some minutes.
"""

import pathlib
import statistics
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import random_scenes
from runs import Program

SHARP = "Coupling/Stopping/Tolerance=1e-8"
DIGITS = 1e-6  # of the energy, with SHARP


def misses(program, deck):
    """([what does not hold], sweeps of the default run)"""
    plain = program.run(deck)
    if plain.code != 0:
        return [f"exit {plain.code}: {plain.screen.strip().splitlines()[-1]}"], 0
    sharp, exact = program.run(deck, SHARP), program.run(deck, "Coupling/Type=Monolithic")
    sweeps = plain.summary["coupling"]["sweeps"]
    if sharp.code != 0 or exact.code != 0:
        last = (sharp if sharp.code != 0 else exact).screen.strip().splitlines()[-1]
        return [f"exit {sharp.code} with {SHARP}, {exact.code} with Monolithic: {last}"], sweeps
    energy, wanted = sharp.summary["energy"], exact.summary["energy"]
    return ([] if abs(energy - wanted) <= DIGITS * wanted else [f"energy {energy}, Monolithic {wanted}"]), sweeps


def main():
    given = random_scenes.sweep_parser(__doc__, 1000).parse_args()
    program, missed, counts = Program(given.ndframe), 0, []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.seed, given.seed + given.scenes):
            scene = random_scenes.two_bodies(seed)
            missing, sweeps = misses(program, scene.write(pathlib.Path(folder)))
            counts.append(sweeps)
            missed += bool(missing)
            for text in missing:
                print(f"{scene.name} ({scene.title}): {text}", flush=True)
    print(f"{missed} of {given.scenes} scenes miss; sweeps: median {statistics.median(counts)}, most {max(counts)}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
