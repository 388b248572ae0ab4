"""The report of a study: its table, and the trend of every quantity over the parameters."""

from . import curves, pictures, words
from .results import shown_case
from .style import svg

# Columns of NAME.study.csv in the order of the pictures, and how they are called there.
QUANTITIES = {"energy": "energy a(u,u)", "bound": "bound of the error", "bound_relative": "bound, of the solution",
              "mesh_part": "mesh part of the error", "iteration_part": "iteration part of the error",
              "reference_error": "error against the reference", "effectivity": "bound over error", "sweeps": "sweeps",
              "dofs": "degrees of freedom", "largest_displacement": "largest displacement",
              "largest_pressure": "largest contact pressure", "seconds": "seconds", "peak_bytes": "peak memory, MB"}
BOUNDS = ("bound", "bound_relative", "mesh_part")
# Pictures of a load case, and what they are called.
SECTIONS = {"scene": "Scene", "fields": "Bodies", "contact": "Contact", "errors": "What every element adds to the error"}
WORK = ("eps_tau", "converged", "guaranteed", "exit_code", "factorisations", "factors_reused", "meshes_reused",
        "references_reused", "back_solves", "reason")


def content(results):
    rows, columns = results.study, list(results.study[0])
    axes = columns[1 : columns.index("dofs")]
    groups = [axes] if results.cases else together(rows, axes)  # load cases are one axis, whatever their factors
    failed = [row for row in rows if (row["exit_code"] or "0") != "0"]
    return {
        "title": title(results), "name": results.name, "shown": shown(results), "state": "wrong" if failed else "right",
        "verdict": verdict(rows, failed, groups), "pictures": trends(rows, columns, axes, groups),
        "table": (*table(rows, columns, axes), 0), "failed": [(row["case"], row["reason"]) for row in failed], "gaps": results.gaps,
        "files": results.files, "axes": [(words.joined(group), words.count(len(different(rows, group[0])), "value")) for group in groups],
    }


def title(results):
    return (results.cases.summary["title"] if results.cases else "") or results.name


def shown(results):
    """(section of a run's page, pictures) of the last load case; of a study nothing."""
    found = shown_case(results.cases) if results.cases else None
    if not found:
        return []
    name, run = found
    sections = pictures.of_run(run)
    results.gaps += run.gaps
    results.files += [file for file in run.files if file not in results.files]
    return [(f"{called}, case {name}", sections[key]) for key, called in SECTIONS.items() if sections[key]]


def different(rows, column):
    return list(dict.fromkeys(row[column] for row in rows))


def together(rows, axes):
    """Parameters that change together, as lists; one that never changes is left out."""
    groups = []
    for axis in axes:
        if len(different(rows, axis)) < 2:
            continue
        pairs = lambda other: len({(row[axis], row[other]) for row in rows})
        for group in groups:
            if pairs(group[0]) == len(different(rows, axis)) == len(different(rows, group[0])):
                group.append(axis)
                break
        else:
            groups.append([axis])
    return groups or [axes[:1]]


def verdict(rows, failed, groups):
    names = "factors of loads" if groups[0][0] == "name" else words.joined(short(group[0]) + (" (and what varies with it)" if len(group) > 1 else "") for group in groups)
    text = f"{words.count(len(rows), 'case')} over {names}"
    energies = [number(row["energy"]) for row in rows if number(row["energy"]) is not None]
    if energies and min(energies) != max(energies):
        text += f"; the energy goes from {words.number(min(energies))} to {words.number(max(energies))}"
    bounds = [number(row["bound_relative"]) for row in rows if number(row.get("bound_relative")) is not None]
    if bounds:
        sure = all(row["guaranteed"] == "1" for row in rows if number(row.get("bound_relative")) is not None)
        text += (f"; errors in energy at most {words.percent(min(bounds))} to {words.percent(max(bounds))}"
                 f"{', guaranteed' if sure else ', not all guaranteed'}")
    return text + (f"; {words.count(len(failed), 'case')} did not end with exit code 0." if failed else "; all cases ended well.")


def short(axis):
    return axis.split("/")[-1]


def heads_of(axes):
    """The last word of a parameter's path; of those that share it, all but the first word."""
    words_ = [short(axis) for axis in axes]
    return [axis.partition("/")[2] if words_.count(word) > 1 else word for axis, word in zip(axes, words_)]


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def trends(rows, columns, axes, groups):
    """(svg, caption, wide) of every quantity that changes, over the parameter with the most values."""
    across = max(groups, key=lambda group: len(different(rows, group[0])))[0]
    others = [group[0] for group in groups if group[0] != across]
    values = different(rows, across)
    numeric = all(number(value) is not None for value in values)
    found = []
    extra = [c for c in columns[columns.index("dofs") :] if c not in QUANTITIES and c not in WORK and "/supports/" not in c]
    for column in [*QUANTITIES, *extra]:
        series = series_of(rows, column, across, others, None if numeric else values)
        numbers = {y for _, _, ys, _ in series for y in ys}
        if len(numbers) < 2:
            continue
        label = QUANTITIES.get(column, column)
        figure = curves.trend(series, short(across), label, None if numeric else values)
        found.append((svg(figure, f"{label} over {across}"), "", False))
    return found


def series_of(rows, column, across, others, categories):
    """[(label, [x], [y], [full marker])], one for every combination of the other parameters."""
    series = {}
    for row in rows:
        value = number(row.get(column))
        if value is None:
            continue
        label = ", ".join(f"{short(axis)} {row[axis]}" for axis in others)
        place = number(row[across]) if categories is None else categories.index(row[across])
        _, xs, ys, full = series.setdefault(label, (label, [], [], []))
        xs.append(place)
        ys.append(value / 1e6 if column == "peak_bytes" else value)
        full.append(column not in BOUNDS or row.get("guaranteed") == "1")
    ordered = []
    for label, xs, ys, full in series.values():
        order = sorted(range(len(xs)), key=lambda i: xs[i])
        ordered.append((label, *([column[i] for i in order] for column in (xs, ys, full))))
    return ordered


def table(rows, columns, axes):
    """Columns that say something, with the parameters by their last words."""
    kept = [c for c in columns if c == "case" or any(row[c] for row in rows)]
    called = dict(zip(axes, heads_of(axes)))
    heads = [called.get(c) or c.replace("_", " ") for c in kept]
    numeric = [all(number(row[c]) is not None for row in rows if row[c]) for c in kept]
    body = [[cell(row[c]) for c in kept] for row in rows]
    return [f">{head}" if is_number else head for head, is_number in zip(heads, numeric)], body


def cell(text):
    value = number(text)
    if value is None:
        return text or "–"
    return words.number(int(value)) if value == int(value) and abs(value) < 1e15 and "e" not in text else words.number(value, 6)
