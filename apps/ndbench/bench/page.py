"""Markdown tables of a campaign."""

from bench.analysis import fastest, tied

GIGABYTE = 1e9


def table(head, lines):
    """A Markdown table of texts."""
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, ["---"] * len(head), *lines]) + "\n"


def setting(row):
    return f"{row['method']}, {row['size']}"


def seconds(row):
    return f"{row['seconds']:.2g} s"


def fastest_table(rows):
    """Which setting reaches an error first; a next method within the spread of the repetitions is a tie."""
    lines = []
    for scene in dict.fromkeys(row["scene"] for row in rows):
        for level, best, other in fastest([row for row in rows if row["scene"] == scene]):
            second = f"{setting(other)}: {seconds(other)}" + " (tie)" * tied(best, other) if other else "none"
            lines.append([scene, f"{100 * level:g} %", setting(best), seconds(best), f"{best['dofs']:,}", second])
    head = ["scene", "error at most", "fastest", "processor", "dofs", "the next method"]
    return table(head, lines) + "\n(tie): the spreads of the repetitions overlap, so neither is the faster one.\n"


def number(value, form):
    return "" if value is None else format(value, form)


def error_text(row):
    """The true error with half its bracket; only an upper limit where the reference is too coarse for it."""
    if not row["error_sharp"]:
        return f"below {100 * row['error_high']:.2g} %"
    return f"{100 * row['error']:.3g} ± {50 * (row['error_high'] - row['error_low']):.1g} %"


def finest_table(rows):
    """Every method on its finest mesh."""
    lines = []
    for key in dict.fromkeys((row["scene"], row["method"]) for row in rows):
        row = max((row for row in rows if (row["scene"], row["method"]) == key), key=lambda row: row["dofs"])
        lines.append([
            *key, f"{row['dofs']:,}", number(row["sweeps"], "d"), f"{row['wall']:.2g}", f"{row['seconds']:.2g}",
            number(row["ratio"], ".2f"), f"{row['peak_bytes'] / GIGABYTE:.2f}", error_text(row),
            number(row["bound"] and 100 * row["bound"], ".3g"), number(row["effectivity"], ".3f"),
        ])
    head = ["scene", "method", "dofs", "sweeps", "seconds", "processor", "over yardstick", "GB", "error", "bound, %"]
    return table([*head, "bound / error"], lines)


def solids_table(rows):
    """Every run."""
    lines = [
        [row["scene"], setting(row), f"{row['dofs']:,}", f"{row['seconds']:.2g}", f"{row['wall']:.2g}",
         f"{row['peak_bytes'] / GIGABYTE:.2f}", error_text(row), number(row["bound"] and 100 * row["bound"], ".3g"),
         number(row["effectivity"], ".3f")]
        for row in rows
    ]
    head = ["scene", "run", "dofs", "processor", "seconds", "GB", "error", "bound, %", "bound / error"]
    return table(head, lines)


def percent(value):
    return f"{100 * value:g} %"


def accuracy_table(rows):
    """A run with a target and the uniform runs beside it."""
    lines = []
    for row in rows:
        if row["wall"] is None:
            dofs = f"some {float(format(row['dofs'], '.2g')):,.0f}"
            name = f"uniform: {row['beside']}"
            lines.append([row["scene"], percent(row["target"]), name, dofs, *[""] * 5, "not run"])
            continue
        name = f"{row['method']}, {row['size']}: {row['beside']}" if row["beside"] else row["method"]
        lines.append([
            row["scene"], percent(row["target"]), name, f"{row['dofs']:,}", error_text(row),
            number(row["bound"] and 100 * row["bound"], ".3g"), f"{row['wall']:.2g}", f"{row['seconds']:.2g}",
            f"{row['peak_bytes'] / GIGABYTE:.2f}", f"{row['times']:.3g}",
        ])
    head = ["scene", "target", "run", "dofs", "error", "bound, %", "seconds", "processor", "GB", "times the seconds"]
    return table(head, lines)


def last_mesh_table(rows):
    """The whole of a run with a target over its last mesh alone."""
    lines = [
        [row["scene"], percent(row["target"]), str(row["levels"]), str(row["sweeps"]), f"{row['dofs']:,}",
         f"{row['work']:.2f}", f"{row['seconds']:.2g}", f"{row['alone']:.2g}", f"{row['over']:.2f}",
         f"{row['wall_over']:.2f}", f"{row['same_bound']:.3f}"]
        for row in rows
    ]
    head = ["scene", "target", "levels", "sweeps", "dofs", "sum of dofs over last", "seconds", "last mesh alone"]
    return table([*head, "ratio", "ratio of processes", "bound over bound"], lines)


def between(text, name, content):
    """`text` with what stands between the comments `<!-- ndbench NAME -->` and `<!-- end -->` replaced."""
    before, mark, rest = text.partition(f"<!-- ndbench {name} -->\n")
    _, end, after = rest.partition("<!-- end -->")
    if not mark or not end:
        raise SystemExit(f'ndbench: the page has no place "<!-- ndbench {name} -->" ... "<!-- end -->"')
    return f"{before}{mark}\n{content}\n{end}{after}"
