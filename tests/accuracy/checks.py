"""What must hold for runs with a target. Every check returns sentences about what does not."""

import math
import statistics

SLOPE = -0.95  # of log(bound) against log(dofs)
WORK = 2.2  # dofs of all levels over those of the last
FIRST = 2  # levels before this index are too coarse to tell a slope


def slope(points):
    """Of the line of least squares through (log dofs, log bound)."""
    dofs, bounds = zip(*points)
    return statistics.linear_regression([math.log(d) for d in dofs], [math.log(b) for b in bounds]).slope


def points_of(runs):
    """(dofs, bound) of the levels from the third on, of all runs of a scene."""
    return sorted({(level["dofs"], level["bound"]) for run in runs for level in run.levels[FIRST:]})


def slope_of(runs):
    """Of a scene's runs together; NaN when they span too few dofs for one."""
    points = points_of(runs)
    return slope(points) if len(points) > 2 and points[-1][0] > 3 * points[0][0] else math.nan


def missed_slope(runs):
    steepness = slope_of(runs)
    return [f"slope {steepness:.2f} is above {SLOPE}"] if steepness > SLOPE else []


def missed_target(run):
    if run.code != 0 or not run.accuracy["reached"]:
        return [f"exit {run.code}, {run.accuracy['limit'] or 'no limit named'}"]
    last = run.levels[-1]
    error = run.summary["errors"]["global"]
    missed = [] if error["guaranteed"] else [f"not guaranteed: {error['reason']}"]
    if not math.isclose(error["absolute"], last["bound"], rel_tol=1e-9):
        missed.append(f"the last level says {last['bound']}, the certificate {error['absolute']}")
    return missed


def work(run):
    """The dofs of all levels over those of the last."""
    return sum(level["dofs"] for level in run.levels) / run.dofs


def wasted_work(run):
    counts = run.summary["ledger"]["counts"]
    wanted = len(run.summary["bodies"]) * len(run.levels)
    missed = []
    if work(run) > WORK:
        missed.append(f"all levels have {work(run):.2f} times the dofs of the last")
    if counts["factorisations"] != wanted:
        missed.append(f"{counts['factorisations']} factorisations for {wanted} meshes")
    return missed


def lost_force(run, tolerance=1e-9):
    """Where the tractions of the two sides have different resultants, or the equations are not solved."""
    missed = []
    for interface in run.summary["interfaces"]:
        one, other = interface["force_on_dirichlet"], interface["force_on_neumann"]
        if math.hypot(*(a + b for a, b in zip(one, other))) > tolerance * math.hypot(*one):
            missed.append(f"forces on {interface['name']}: {one} and {other}")
    return missed


def too_many_sweeps(run, allowed):
    return [f"{level['sweeps']} sweeps on level {level['level']}" for level in run.levels[1:]
            if level["sweeps"] > allowed]


def bound_below_error(run):
    reference = run.summary["errors"]["reference"]
    error, bound = reference["displacement"], run.levels[-1]["bound"]
    return [] if bound >= error else [f"bound {bound} below the error {error} on level {len(run.levels)}"]
