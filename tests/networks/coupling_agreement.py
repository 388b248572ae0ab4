"""All couplings give the same answer: coupling_agreement.py NDFRAME [--full].

Every network, and every regression case of two bodies that is named here, is solved by every coupling that can.
Energies, nodal forces (as parts of the largest one) and statuses must agree to 1e-10; the status of a node that neither
carries a force nor has a gap is free, and gaps are where bodies are not unique. FETI must do with the numbers of
iterations that its coarse problem promises. Sweeps may take too long where a body between two others is soft in bending,
if they say so. One line a scene; exit code 1 if one fails.
"""

import argparse
import csv
import dataclasses
import io
import pathlib
import sys
import tempfile
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import network_decks
from runs import Program

CASES = pathlib.Path(__file__).parents[2] / "regression" / "cases"
SAME = 1e-10
TO_THE_END = ("Coupling/Stopping/Tolerance=1e-12", "Coupling/Stopping/Maximum Sweeps=10000")


@dataclasses.dataclass(frozen=True)
class Scene:
    """Arguments of network_decks.py; FETI's iterations to 1e-8 of the contact forces, where something is promised."""

    arguments: str
    most_iterations: int | None = None
    conditions: str = "Nodal"

    def text(self):
        return network_decks.text(self.arguments.split())

    @property
    def swept(self):
        """Two colours and no node on two interfaces: Neumann-Dirichlet solves it too."""
        return self.arguments.split()[0] in ("stack", "chain")


@dataclasses.dataclass(frozen=True)
class TwoBodies:
    """A regression case without its coupling."""

    arguments: str
    conditions: str = "Nodal"
    most_iterations = None
    swept = False

    def text(self):
        root = xml.etree.ElementTree.parse(CASES / self.arguments / f"{self.arguments}.xml").getroot()
        for child in list(root):
            if child.get("name") in ("Coupling", "Expect"):
                root.remove(child)
        return xml.etree.ElementTree.tostring(root, encoding="unicode")


def walls(sizes, options="", most=None):
    return [Scene(f"wall {n} {n} {options}".strip(), most) for n in sizes]


SHORT = [Scene("stack"), Scene("tjunction"), Scene("chain 8"), Scene("chain 9 --young random:3 --seed 2", 20),
         Scene("ring", 30), Scene("wall 4 4 --load 0.5"), *walls([6], "--young random:2 --seed 1", 40)]
PAIRS = [TwoBodies(case) for case in ("contact-loss", "clamped-end", "inclined", "gap-opens", "held-means", "hertz")]
SHORT += PAIRS
SHORT += [dataclasses.replace(scene, conditions="Bernstein")
          for scene in (Scene("stack"), Scene("tjunction"), Scene("ring"), Scene("wall 4 4 --load 0.5"), *PAIRS)]
FULL = [*SHORT, *(Scene(f"chain {n}") for n in (2, 3, 4, 16, 32)),
        *(Scene(f"chain 8 --young {young}:{size} {shuffle}", 20 if young == "random" else None)
          for young, size in (("alternating", 1000), ("alternating", 0.001), ("random", 3))
          for shuffle in ("--seed 1", "--seed 2 --shuffle 2")),
        Scene("chain 32 --young random:3 --seed 4", 20),
        Scene("ring --cell 0.125", 30), Scene("ring --young random:3 --seed 5 --shuffle 1", 30),
        *walls([2, 4, 6], "", 25), *walls([8], "", 25), *walls([2, 3, 5, 6, 8], "--load 0.5"),
        *walls([4], "--load 0.3 --shuffle 7"),
        *(scene for seed in (1, 2, 3) for scene in walls([6, 8, 12], f"--young random:2 --seed {seed}", 40)),
        *(scene for seed in (1, 2, 3) for scene in walls([6], f"--young random:3 --seed {seed}", 45))]


def solve(program, deck, coupling, *settings):
    """(Run, {node: row of the contact table})"""
    run = program.run(deck, f"Coupling/Type={coupling}", "Output/Exodus=false", *settings)
    rows = csv.DictReader(io.StringIO(run.contact or ""))
    return run, {(row["interface"], row["x"], row["y"]): row for row in rows}


def differences(one, other):
    """What two solutions do not agree in."""
    (one, nodes), (other, others) = one, other
    if one.code or other.code:
        return [f"exit codes {one.code} and {other.code}"]
    found = []
    if abs(one.summary["energy"] - other.summary["energy"]) > SAME * abs(one.summary["energy"]):
        found.append(f"energies {one.summary['energy']!r} and {other.summary['energy']!r}")
    largest = max(abs(float(row["nodal_force"])) for row in nodes.values())
    deepest = max(abs(float(row["u_dirichlet"])) for row in nodes.values()) or 1.0
    worst = max(abs(float(row["nodal_force"]) - float(others[node]["nodal_force"])) for node, row in nodes.items())
    if worst > SAME * largest:
        found.append(f"nodal forces {worst / largest:.1e} apart")
    loose = any(warning["kind"] == "not unique" for warning in one.summary["warnings"])
    for node, row in nodes.items():
        told = abs(float(row["nodal_force"])) > SAME * largest or (abs(float(row["gap"])) > SAME * deepest and not loose)
        if told and row["closed"] != others[node]["closed"]:
            found.append(f"status of {node}")
            break
    return found


def check(program, scene):
    """(what is said of a scene, whether all is well)"""
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "network.xml"
        conditions = (f"Discretization/Contact Conditions={scene.conditions}",)
        deck.write_text(scene.text())
        reference = solve(program, deck, "Monolithic", *conditions)
        found = [f"{coupling}: {text}" for coupling in ("FETI", "Neumann-Neumann")
                 for text in differences(reference, solve(program, deck, coupling, *conditions))]
        said = []
        if scene.swept:
            swept = solve(program, deck, "Neumann-Dirichlet", *TO_THE_END, *conditions)
            if swept[0].code == 3 and "NOT CONVERGED" in swept[0].screen:
                said.append("sweeps too slow")
            else:
                found += [f"Neumann-Dirichlet: {text}" for text in differences(reference, swept)]
        inexact, _ = solve(program, deck, "FETI", "Coupling/Tolerance=1e-8", *conditions)
        iterations = inexact.summary["ledger"]["counts"]["FETI iterations"]
        said.append(f"{iterations} iterations")
        if scene.most_iterations and iterations > scene.most_iterations:
            found.append(f"FETI: more than {scene.most_iterations} iterations")
    return f"{scene.arguments}, {scene.conditions}: {', '.join(said + found)}", not found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ndframe")
    parser.add_argument("--full", action="store_true")
    options = parser.parse_args()
    program, wrong = Program(options.ndframe), 0
    for scene in FULL if options.full else SHORT:
        said, well = check(program, scene)
        wrong += not well
        print(("      " if well else "WRONG ") + said, flush=True)
    print(f"{wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
