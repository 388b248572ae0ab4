"""What must hold for runs with a target. Every check returns sentences about what does not."""

import math
import statistics

SLOPE = -0.95  # of log(bound) against log(dofs)
WORK = 2.2  # dofs of all levels over those of the last
SPREAD = 0.15  # of the dofs with different first meshes
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
    return [] if steepness <= SLOPE else [f"slope {steepness:.2f} is not below {SLOPE}"]  # NaN neither


def no_answer(run):
    return [] if run.answered else [f"exit {run.code}: {run.screen[-300:]}"]


def missed_target(run):
    if run.code != 0 or not run.accuracy["reached"]:
        return [f"exit {run.code}, {run.accuracy['limit'] or 'no limit named'}"]
    last = run.levels[-1]
    error = run.summary["errors"]["global"]
    missed = [] if error["guaranteed"] else [f"not guaranteed: {error['reason']}"]
    if not math.isclose(error["absolute"], last["bound"], rel_tol=1e-9):
        missed.append(f"the last level says {last['bound']}, the certificate {error['absolute']}")
    return missed


def missed_without_reason(run):
    explained = run.code == 5 and run.accuracy["limit"]
    return [] if run.accuracy["reached"] or explained else [f"exit {run.code} without target and without a limit"]


def worse_than_before(run):
    """Where the answer that is written is not the best one, of those with a guarantee if there are any."""
    guaranteed = [level["bound"] for level in run.levels if level["guaranteed"]]
    bounds = [level["bound"] for level in run.levels]
    best, written = min(guaranteed or bounds), run.summary["errors"]["global"]["absolute"]
    if guaranteed and not run.summary["errors"]["global"]["guaranteed"]:
        return [f"no guarantee, but {best:.3g} on level {bounds.index(best) + 1} has one"]
    return [f"bound {written:.3g}, but {best:.3g} on level {bounds.index(best) + 1}"] if written > 1.001 * best else []


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


def wide_brackets(run, allowed):
    """Brackets (closed, open) of where contact ends that are missing or wider than allowed."""
    widths = [math.dist(*bracket) for interface in run.summary["interfaces"] for bracket in interface["end_brackets"]]
    missed = [] if widths else ["no bracket of where contact ends"]
    return missed + [f"contact ends in a bracket of {width:.4g}, {allowed} allowed" for width in widths
                     if width > allowed]


def dofs_apart(run, dofs):
    """Where a run with another first mesh ends with other dofs."""
    return [f"{run.dofs} dofs instead of {dofs}"] if abs(run.dofs - dofs) > SPREAD * dofs else []


def bound_below_error(run):
    reference = run.summary["errors"]["reference"]
    error, bound = reference["displacement"], run.levels[-1]["bound"]
    return [] if bound >= error else [f"bound {bound} below the error {error} on level {len(run.levels)}"]
