"""Runs of ndframe with a target, and what they leave."""

import argparse
import dataclasses
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile


@dataclasses.dataclass(frozen=True)
class Run:
    """One call: `summary` as in NAME.summary.json, `contact` the text of NAME.contact.csv, None when there is none."""

    code: int
    screen: str
    summary: dict | None
    contact: str | None = None
    found: object = None  # what Program.run was asked to look for in its files

    @property
    def answered(self):
        return self.summary is not None and self.summary["accuracy"] is not None

    @property
    def accuracy(self):
        """{target, reached, limit, levels: [{dofs, sweeps, bound, iteration, ...}], ...}"""
        return self.summary["accuracy"]

    @property
    def levels(self):
        return self.accuracy["levels"]

    @property
    def dofs(self):
        """Of the last level."""
        return self.levels[-1]["dofs"]


class Program:
    """The built ndframe, alone or on several ranks."""

    def __init__(self, path, mpiexec=None, seconds=300):
        self.path = pathlib.Path(path).resolve()
        self.mpiexec = mpiexec
        self.seconds = seconds

    def run(self, deck, *settings, ranks=1, look=lambda folder: None, options=()):
        """Runs a deck with settings as of --set and other options, in a folder that is removed afterwards; look: at what is in it."""
        launch = [self.mpiexec, "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        command = [*launch, str(self.path), "-i", str(pathlib.Path(deck).resolve()), *options]
        for setting in settings:
            command += ["--set", setting]
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=self.seconds)
            summaries = list(pathlib.Path(folder).glob("*.summary.json"))
            summary = json.loads(summaries[0].read_text()) if summaries else None
            tables = list(pathlib.Path(folder).glob("*.contact.csv"))
            contact = tables[0].read_text() if tables else None
            return Run(done.returncode, done.stdout + done.stderr, summary, contact, look(pathlib.Path(folder)))


BALANCED = 1e-10  # largest defect of the recovered stress
EXACT = 1e-9  # of the solution: an error below is that of two exact solutions
FINER = 2  # times a reference is refined further before it is believed against a bound


def contradiction(errors, is_mean_bounded=True):
    """What a summary's reference says against its guaranteed bounds, or None."""
    bound, mean, reference = errors["global"], errors["mean_stress"], errors["reference"]
    if not bound["guaranteed"] or reference["relative"] <= EXACT:
        return None
    if reference["displacement"] > bound["absolute"]:
        return f"bound {bound['absolute']:.6g} below the error {reference['displacement']:.6g}"
    if is_mean_bounded and reference["mean_stress"] > mean["absolute"] * (1 + 1e-6):
        return f"mean stress {reference['mean_stress']:.6g} further than {mean['absolute']:.6g}"
    return None


def lasting_contradiction(errors, solve, refinements, is_mean_bounded=True):
    """The same; what is contradicted is asked again by solve(refinements) with references refined further: it may be the
    reference's own error."""
    for finer in range(refinements + 1, refinements + FINER + 1):
        if not contradiction(errors, is_mean_bounded):
            return None
        errors = solve(finer).summary["errors"]
    return contradiction(errors, is_mean_bounded)


def sharpness(errors):
    """Bound over error, or None where there is no error."""
    reference = errors["reference"]
    return errors["global"]["absolute"] / reference["displacement"] if reference["relative"] > EXACT else None


def certified(program, deck, *settings, estimators="Global, Reference"):
    """solve(refinements): runs a deck with a certificate and a reference of so many refinements."""
    return lambda refinements: program.run(
        deck, *settings, f"Error Estimation/Estimators={{{estimators}}}", "Error Estimation/Check Equilibrium=true",
        f"Error Estimation/Reference/Refinements={refinements}", "Output/Exodus=false", "Output/Contact Table=false")


def judge_certificate(run, solve, refinements, codes=(0,), ends=True, is_mean_bounded=True, excused=(),
                      balanced=BALANCED):
    """(what is wrong or None, bound / error of a run that ends where it should or None): how it ended, balance, guarantee, and
    what the reference says. run: solve(refinements). refinements: None if there is no reference. codes: it may end with. ends:
    it gets where it should, and has a certificate. excused: reasons why a bound may not be guaranteed. balanced: the largest
    defect of the stress."""
    if run.code not in codes:
        return f"exit code {run.code}: {run.screen[-300:]}", None
    errors = run.summary and run.summary["errors"]
    if not errors:
        return f"no certificate: {run.screen[-300:]}" if ends else None, None
    if errors["equilibrium"] > balanced:
        return f"the stress is out of balance by {errors['equilibrium']:.2e}", None
    bound = errors["global"]
    if run.code == 0 and not bound["guaranteed"] and not any(reason in bound["reason"] for reason in excused):
        return f"not guaranteed: {bound['reason']}", None
    if refinements is None:
        return None, None
    return (lasting_contradiction(errors, solve, refinements, is_mean_bounded),
            sharpness(errors) if ends and run.code == 0 else None)


def sweep_options(description, **more):
    """Command line of a sweep over random scenes, one a seed. more: further options, name -> (default, help)."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ndframe")
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    for name, (default, text) in more.items():
        parser.add_argument(f"--{name}", type=type(default), default=default, help=text)
    return parser.parse_args()


def sweep(options, judge):
    """judge(seed): (what is wrong or None, what it found, what it is about). Prints what is wrong as it comes; returns how
    often, and (found, about) of all scenes."""
    wrong, found = 0, []
    for seed in range(options.seed, options.seed + options.scenes):
        violation, value, about = judge(seed)
        if violation:
            wrong += 1
            print(f"{about}: {violation}", flush=True)
        found.append((value, about))
    return wrong, found


def print_sharpness(ratios, of=""):
    """Of bounds over reference errors."""
    print(f"bound / reference error{of}: {len(ratios)} converged runs, median {statistics.median(ratios):.3f}, "
          f"{min(ratios):.3f} to {max(ratios):.3f}")


def sweep_of_kinds(options, judge, words):
    """The sweep of a script that judges bounds: prints their sharpness for each kind of scene, the first `words` of what
    it is about, and ends the script; exit code 1 where something is wrong."""
    of_kinds = {}
    wrong, found = sweep(options, judge)
    for ratio, about in found:
        if ratio:
            of_kinds.setdefault(", ".join(about.split(": ")[1].split(", ")[:words]), []).append(ratio)
    for kind, ratios in sorted(of_kinds.items()):
        print_sharpness(ratios, f", {kind}")
    print(f"{options.scenes} scenes, {wrong} wrong")
    sys.exit(1 if wrong else 0)
