"""Tables of the report: (heads, rows) of text; heads that begin with > stand above numbers."""

from .words import number, percent, vector

MOST_ROWS = 300


def bodies(summary):
    heads = ["body", ">dofs", ">elements", "solver", ">energy a(u,u)", ">largest displacement", "at", ">largest strain", "at"]
    rows = []
    for body in summary["bodies"]:
        u, strain = body["largest_displacement"] or {}, body["largest_strain"] or {}
        rows.append([body["name"], number(body["dofs"]), number(body["elements"]), body["solver"], number(body["energy"], 7),
                     number(u.get("value")), vector(u.get("point")), number(strain.get("value")), vector(strain.get("point"))])
    return heads, rows


def forces(summary):
    """What acts on every body, and what its sum leaves."""
    heads, rows = ["body", "by", ">force", ">moment", "about"], []
    for body in summary["bodies"]:
        if body["load_force"] is None:
            continue
        parts = [("loads", body["load_force"], None, None)]
        parts += [(f"{s['name']} ({s['description']})", s["force"], s["moment"], s["centre"]) for s in body["supports"]]
        parts += [(f"interface {name}", force, None, None) for name, force in contact_forces(summary, body["name"])]
        for by, force, moment, centre in parts:
            rows.append([body["name"], by, vector(force, 6), vector(moment, 5) if moment else "", vector(centre) if centre else ""])
        rows.append([body["name"], "sum", rest(force for _, force, _, _ in parts), "", ""])
    return heads, rows


def contact_forces(summary, body):
    for interface in summary["interfaces"]:
        for side, key in (("dirichlet_body", "force_on_dirichlet"), ("neumann_body", "force_on_neumann")):
            if interface[side] == body and interface[key] is not None:
                yield interface["name"], interface[key]


def rest(forces):
    """The sum of forces beside the largest of them."""
    forces = list(forces)
    largest = max(abs(c) for force in forces for c in force)
    total = max(abs(sum(components)) for components in zip(*forces))
    return f"0 to within {number(total / largest, 2)} of the largest" if largest > 0.0 else "0"


def interfaces(summary):
    """A column for every interface, or a row where there are many."""
    found = summary["interfaces"]
    area = "contact_area" in found[0]
    lines = (("Dirichlet side on", lambda i: i["dirichlet_body"]), ("Neumann side on", lambda i: i["neumann_body"]),
             ("nodes, closed", lambda i: f"{number(i['nodes'])}, {number(i['closed_nodes'])}"),
             ("contact force", lambda i: number(i["contact_force"], 6)),
             ("contact area" if area else "contact length", lambda i: number(i.get("contact_length", i.get("contact_area")), 6)),
             ("largest pressure", lambda i: number(i["largest_pressure"], 6)),
             ("largest penetration", lambda i: number(i["largest_penetration"], 2)),
             ("closed nodes lie in" if area else "closed from – to", lambda i: " – ".join(vector(p) for p in i["end_points"] or []) or "–"),
             ("contact ends between", lambda i: "; ".join(f"{vector(a)} and {vector(b)}" for a, b in i["end_brackets"] or [])))
    rows = [[label, *(text(i) for i in found)] for label, text in lines]
    rows = [["interface", *(i["name"] for i in found)], *(row for row in rows if any(row[1:]))]
    if len(found) > 3:
        rows = [list(column) for column in zip(*rows)]
    return rows[0], rows[1:]


RESIDUALS = {
    "equilibrium": "unbalanced forces, relative to the largest nodal load or reaction",
    "complementarity": "gap times contact force, relative to the largest of each",
    "penetration": "relative to the largest displacement",
    "tension": "nodal contact forces in tension, relative to the largest",
}


def residuals(summary):
    rows = [[name, number(value, 2), RESIDUALS.get(name, "")] for name, value in summary["residuals"].items()]
    return ["residual", ">0 is perfect", "what it is"], rows


PARTS = (("global", "bound of the error in energy"), ("discretization", "mesh"), ("algorithm", "iteration"),
         ("mean_stress", "bound for the mean stress"))


def errors(summary):
    """Bounds and indicators: <= bounds, ~ indicates, = is measured."""
    found, rows = summary["errors"], []
    for key, label in PARTS:
        part = found.get(key)
        if not part:
            continue
        bounds = key in ("global", "mean_stress")
        sign = ("≤" if found["global"] and found["global"]["guaranteed"] else "≲") if bounds else "~"
        rows.append([label, sign, number(part["absolute"]), percent(part["relative"])])
    for key, label in (("split_stress", "mesh, by the split"), ("zienkiewicz_zhu", "Zienkiewicz-Zhu, a comparison"),
                       ("residual", "residual, a comparison")):
        if found.get(key) is not None:
            rows.append([label, "~", number(found[key]), ""])
    if reference := found.get("reference"):
        label = f"measured against a finer mesh, {number(reference['dofs'])} dofs"
        rows.append([label, "=", number(reference["displacement"]), percent(reference["relative"])])
    return ["error", "", ">energy norm", ">of the solution"], rows


def bracket(summary):
    """What the bound says of the exact solution."""
    found = (summary["errors"] or {}).get("energy_bracket")
    if not found:
        return None
    rows = [["strain energy less work of the loads", number(found["lower"], 7), number(found["upper"], 7)]]
    if found.get("work"):
        rows.append([f"work of {found.get('work_of') or 'the loads'}", number(found["work"]["lower"], 7), number(found["work"]["upper"], 7)])
    if drive := found.get("drive"):
        rows += [[f"{what} of {drive['cause']}", number(drive[what]["lower"], 7), number(drive[what]["upper"], 7)]
                 for what in ("force", "displacement", "stiffness") if drive.get(what)]
    return ["of the exact solution, guaranteed", ">at least", ">at most"], rows


def expectations(summary):
    rows = [[e["name"], number(e["value"], 8), number(e["expected"], 8), number(e["tolerance"], 3), "met" if e["met"] else "MISSED"]
            for e in summary["expectations"]]
    return ["the deck expects", ">computed", ">expected", ">within", ""], rows


def levels(rows):
    heads = [">level", ">dofs", ">sweeps", ">bound", ">of the solution", ">mesh", ">iteration", ">seconds", "largest contribution"]
    lines = []
    for row in rows:
        largest = row["largest"] or {}
        where = f"{vector(largest.get('point'))} in {largest['body']}" if largest.get("body") else "–"
        lines.append([number(row["level"]), number(row["dofs"]), number(row["sweeps"]), number(row["bound"]), percent(row["relative"]),
                      number(row["mesh"]), number(row["iteration"], 3), number(row["seconds"], 3), where])
    return heads, lines


def sweeps(history):
    heads = [">sweep", ">eps_tau", ">theta", ">closed", ">open", ">changed", ">force on Dirichlet side", ">on Neumann side",
             ">penetration", "note"]
    rows = [[number(s["sweep"]), number(s["eps_tau"], 3), number(s["theta"], 3), number(s["closed"]), number(s["open"]),
             number(s["status_changes"]), number(s["force_on_dirichlet"], 6), number(s["force_on_neumann"], 6),
             number(s["penetration"], 2), s["note"]] for s in history]
    return heads, rows


def work(summary):
    """(heads, rows, share of the time of every row)."""
    ledger = summary["ledger"]
    total = ledger["total_seconds"] or 1.0
    rows = [[stage["name"], number(stage["seconds"], 3), f"{100.0 * stage['seconds'] / total:.0f} %", megabytes(stage["peak_bytes"])]
            for stage in ledger["stages"]]
    rest_of_time = total - sum(stage["seconds"] for stage in ledger["stages"])
    rows.append(["between the stages", number(max(rest_of_time, 0.0), 3), f"{max(0.0, 100.0 * rest_of_time / total):.0f} %", ""])
    rows.append(["total", number(total, 3), "", megabytes(ledger["peak_bytes"])])
    shares = [stage["seconds"] / total for stage in ledger["stages"]] + [max(0.0, rest_of_time / total), None]
    return ["stage", ">seconds", ">share", ">peak memory"], rows, shares


def counts(summary):
    return ["what was done", ">times"], [[what, number(times)] for what, times in summary["ledger"]["counts"].items()]


def shortened(table):
    """(heads, rows, how many rows were left out)."""
    heads, rows = table
    return heads, rows[:MOST_ROWS], max(0, len(rows) - MOST_ROWS)


def megabytes(size):
    return "–" if not size else f"{size / 1e6:.0f} MB"
