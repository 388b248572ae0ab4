"""What became of one run: right with so many digits, refused, stopped, or a finding."""

import csv
import dataclasses
import json
import math

import netCDF4
import numpy as np

import reference

RIGHT, REFUSED, STOPPED, FINDING = "right", "refused", "stopped", "FINDING"
FEWEST_DIGITS = 6.0
MOST_DIGITS = 16.0
SMALL_MOVE = 1e-8  # a body that moves less than this part of the largest displacement rests: measured against that


@dataclasses.dataclass(frozen=True)
class Verdict:
    outcome: str
    digits: float = math.nan  # of a right result: the fewest of all compared quantities
    text: str = ""            # the program's reason, or what is wrong
    floored: bool = False     # whether a quantity was so small that it was measured against something larger


def _first(text, *words):
    """The first line that holds one of the words."""
    return next((line.strip() for line in text.splitlines() if any(word in line for word in words)), "")


def digits_of(found, expected, scale, least=1.0):
    """Digits that agree, relative to the largest entry of `expected`; below `least` of `scale`, relative to `scale`."""
    found, expected = np.asarray(found, dtype=float), np.asarray(expected, dtype=float)
    unit = np.abs(expected).max(initial=0.0)
    unit = unit if unit > least * scale else scale
    error = np.abs(found - expected).max(initial=0.0)
    if not np.isfinite(error):
        return -math.inf
    if error == 0.0:
        return MOST_DIGITS
    return min(MOST_DIGITS, -math.log10(error / unit)) if unit > 0.0 else -math.inf


def below(expected, scale, least):
    """Whether all of `expected` is so small that its digits are counted from `scale`."""
    return bool(np.abs(np.asarray(expected, dtype=float)).max(initial=0.0) < least * scale)


def compare(answer, scene, contact, summary, floor=0.0):
    """Digits by quantity, and whether one was measured against something larger than itself.

    Forces count from the largest nodal force of loads and contact, and with a floor at least from this part of E times
    the largest displacement: below it they are round-off. A body that hardly moves counts from the one that does."""
    rows = sorted(contact, key=lambda row: float(row["x"]))
    column = lambda name: np.array([float(row[name]) for row in rows])
    swapped = summary["interfaces"][0]["dirichlet_body"] == "lower"
    first, second = ("u_neumann", "u_dirichlet") if swapped else ("u_dirichlet", "u_neumann")
    sign = 1.0 if swapped else -1.0
    move, load = float(answer.move), float(answer.load)
    force = max(load, floor * max(scene.upper.young, scene.lower.young) * move)
    least, least_energy = max(floor, SMALL_MOVE), max(floor, SMALL_MOVE ** 2)
    quantities = {"upper displacement": (sign * column(first), answer.u_upper, move, least),
                  "lower displacement": (sign * column(second), answer.u_lower, move, least)}
    energies = {body["name"]: body["energy"] for body in summary["bodies"]}
    for name, energy in zip(("upper", "lower"), answer.energies):
        quantities[f"energy of {name}"] = ([energies[name]], [energy], force * move, least_energy)
    floored = force > load or any(below(*expected) for _, *expected in quantities.values())
    quantities["contact force"] = (-column("nodal_force"), answer.force, force, 1.0)
    return {name: digits_of(*quantity) for name, quantity in quantities.items()}, floored


def not_finite(folder):
    """Name of a number in the files that is not finite; empty if all are."""
    for path in sorted(folder.glob("*.contact.csv")):
        for row in csv.DictReader(path.read_text().splitlines()):
            for name, value in row.items():
                if name != "interface" and not math.isfinite(float(value)):
                    return f"{name} in {path.name}"
    for path in sorted(folder.glob("*.e")):
        with netCDF4.Dataset(path) as file:
            for name, variable in file.variables.items():
                if variable.dtype.kind == "f" and not np.isfinite(np.ma.filled(variable[:], 0.0)).all():
                    return f"{name} in {path.name}"
    return ""


def _holds_null(value):
    if isinstance(value, dict):
        value = list(value.values())
    return any(map(_holds_null, value)) if isinstance(value, list) else value is None


def not_a_number(folder, summary):
    """Where a number is missing or not finite, in the files or in the summary; empty if nowhere."""
    parts = [part for name, part in (summary or {}).items() if name not in ("errors", "accuracy", "coupling", "deck")]
    return not_finite(folder) or ("in the summary" if _holds_null(parts) else "")


def without_solution(folder, summary):
    """Whether a run wrote no solution and says so: no fields, and every number of the solution null."""
    numbers = [summary["energy"], *(body["energy"] for body in summary["bodies"]), *summary["residuals"].values()]
    return all(number is None for number in numbers) and not [*folder.glob("*.contact.csv"), *folder.glob("*.e")]


def bound_holds(errors):
    """The bound against the error that the run itself measured on a finer mesh."""
    reference_error = errors["reference"]["displacement"] if errors["reference"] else 0.0
    return errors["global"]["absolute"] >= (1 - 1e-6) * reference_error


def _judge_results(summary, expected, scene, folder, floor):
    contact = list(csv.DictReader((folder / "deck.contact.csv").read_text().splitlines()))
    digits, floored = compare(expected, scene, contact, summary, floor)
    worst = min(digits, key=digits.get)
    if digits[worst] < FEWEST_DIGITS:
        return Verdict(FINDING, digits[worst], f"silently wrong: {worst} has {digits[worst]:.1f} digits")
    errors = summary["errors"]
    if errors and errors["global"]["guaranteed"] and not bound_holds(errors):
        return Verdict(FINDING, digits[worst], "a guaranteed bound below the error against its reference")
    return Verdict(RIGHT, digits[worst], worst, floored)


def _judge_refusal(said, results_written):
    if "nothing was computed" not in said:
        return Verdict(FINDING, text=f"exit code 2, but not refused before the solution: {_first(said, '')}")
    if results_written:
        return Verdict(FINDING, text="refused, yet results written")
    return Verdict(REFUSED, text=_first(said, ""))


def _judge_stop(said, summary):
    reason = _first(said, "not converged", "not guaranteed", "no certificate")
    unmarked = summary and ("not converged" in reason and summary["coupling"]["converged"] or
                            "no certificate" in reason and summary["errors"])
    if not reason or unmarked:
        return Verdict(FINDING, text="stopped without saying so")
    return Verdict(STOPPED, text=reason)


def judge(run, scene, answer, folder, floor=0.0):
    """run: a finished process (returncode, stdout, stderr), or None when it took too long; answer(): the reference's
    Answer, or Unheld; called only for a run that claims to be right."""
    if run is None:
        return Verdict(FINDING, text="no end within the time limit")
    path = folder / "deck.summary.json"
    if run.returncode == 2:
        return _judge_refusal(run.stderr, path.exists())
    if run.returncode not in (0, 3):
        return Verdict(FINDING, text=f"exit code {run.returncode}: {_first(run.stderr, '')}")
    summary = json.loads(path.read_text()) if path.exists() else None
    if run.returncode == 3 and summary and without_solution(folder, summary):
        return _judge_stop(run.stderr, summary)
    bad = not_a_number(folder, summary)
    if bad:
        return Verdict(FINDING, text=f"not a number: {bad}")
    if run.returncode == 3:
        return _judge_stop(run.stderr, summary)
    try:
        return _judge_results(summary, answer(), scene, folder, floor)
    except reference.Unheld:
        return Verdict(FINDING, text="silently wrong: an answer where nothing holds the body")
