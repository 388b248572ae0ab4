"""Tables 1 to 3 of the paper computed again, and what is claimed about them. Errors are 100 times those over the norm of the solution."""

from scenes import CONTACT_LOSS, PRINTED, PUNCH, settings, study

# The axis "bound" of the decks: ours with its parts and the reference, then other ways to it.
OTHERS = ("projected", "published", "eet")
TOLERANCE = "Coupling/Stopping/Tolerance"
# Coarse meshes only, each compared with its own h/8.
QUICK = {
    "table1": ["--study", PUNCH.mesh_axis((2, 3), 3)],
    "table2": ["--study", CONTACT_LOSS.mesh_axis((4, 6), 3)],
    "table3": settings(["Error Estimation/Reference/Refinements=3"]),
}


def line(norm, own, others):
    """A line of a table from the cases of the study that differ in nothing but the bound."""
    number = lambda name: float(own[name])
    e_ref = number("reference_error")
    absolute = {
        "glob": number("bound"),
        "dis": number("mesh_part"),
        "nda": number("iteration_part"),
        "e_ref": e_ref,
        **{f"glob_{name}": float(other["bound"]) for name, other in others.items()},
    }
    return {
        "ndof": int(own["dofs"]),
        "sweeps": int(own["sweeps"]),
        "eps_tau": number("eps_tau"),
        **{name: 100 * value / norm for name, value in absolute.items()},
        **{name.replace("glob", "gamma"): absolute[name] / e_ref for name in ("glob", *(f"glob_{name}" for name in OTHERS))},
        "guaranteed": own["guaranteed"] == "1",
    }


def table(ndframe, name, scene, quick):
    """The lines of a table, each with the tolerance if that varies."""
    cases = study(ndframe, name, *(QUICK[name] if quick else []))
    lines = []
    for first in range(0, len(cases), 1 + len(OTHERS)):
        own, *others = cases[first : first + 1 + len(OTHERS)]
        varied = {"tolerance": float(own[TOLERANCE])} if TOLERANCE in own else {}
        lines.append({**varied, **line(scene.norm(ndframe), own, dict(zip(OTHERS, others)))})
    return lines


def compute(ndframe, quick):
    """All tables; a quick run leaves out the finer meshes."""
    scenes = {"table1": PUNCH, "table2": CONTACT_LOSS, "table3": CONTACT_LOSS}
    return {name: table(ndframe, name, scene, quick) for name, scene in scenes.items()}


def within(values, lowest, highest):
    return all(lowest <= value <= highest for value in values)


def claims(tables):
    """(sentence, whether it holds) of everything the page says about the tables."""
    punch, meshes, stopping = ([*tables[name]] for name in ("table1", "table2", "table3"))
    rows = [*punch, *meshes, *stopping]
    glob, dis = ([line[name] for line in stopping] for name in ("glob", "dis"))
    expected = ((4, 4), (5, 5), (8, 9), (11, 12), (15, 16), (28, 29))
    return [
        ("every bound is called guaranteed, and none is below the error", all(r["guaranteed"] and r["gamma"] >= 1 for r in rows)),
        ("table 1: five sweeps on every mesh", within([r["sweeps"] for r in punch], 5, 5)),
        ("table 1: eta_nda is 4.0 to 4.2 % on every mesh", within([r["nda"] for r in punch], 4.0, 4.2)),
        ("table 1: gamma is at most 1.12 on every mesh", within([r["gamma"] for r in punch], 1, 1.12)),
        ("table 2: eta_nda differs by less than 2 % from mesh to mesh", max(r["nda"] for r in meshes) < 1.02 * min(r["nda"] for r in meshes)),
        ("table 3: 4, 5, 8-9, 11-12, 15-16, 28-29 sweeps", all(within([r["sweeps"]], *e) for r, e in zip(stopping, expected))),
        ("table 3: the bound levels off, the last four within 0.2 %", max(glob[2:]) < 1.002 * min(glob[2:])),
        ("table 3: it levels off at the discretisation part, within 2 %", within([glob[-1] / dis[-1]], 0.98, 1.02)),
    ]


def beside_printed(name, rows):
    """Our rows with the paper's figures in columns paper_*."""
    printed = PRINTED[name]
    return [{**line, **{f"paper_{key}": values[i] for key, values in printed.items()}} for i, line in enumerate(rows)]


def as_csv(rows):
    text = lambda value: f"{value:.5g}" if isinstance(value, float) else str(value)
    return "\n".join([",".join(rows[0]), *(",".join(text(value) for value in line.values()) for line in rows)]) + "\n"


def as_markdown(columns, rows):
    """`columns`: title -> function of a row."""
    lines = [columns, ["---:"] * len(columns), *([cell(line) for cell in columns.values()] for line in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def pair(name, digits):
    return lambda r: f"{r[name]:.{digits}f} ({r[f'paper_{name}']:.{digits}f})"


def errors_of(digits):
    return {
        "eta_glob": pair("glob", digits),
        "eta_dis": pair("dis", digits),
        "eta_nda": pair("nda", digits),
    }


def with_gamma(name):
    return lambda r: f"{r[f'glob_{name}']:.2f}, {r[f'gamma_{name}']:.2f}"


def page_tables(tables):
    rows = {name: beside_printed(name, lines) for name, lines in tables.items()}
    count = lambda name: lambda r: f"{r[name]} ({r[f'paper_{name}']})"
    others = {f"{title}, gamma": with_gamma(name) for name, title in zip(OTHERS, ("Projected", "Published", "EET"))}
    own = {"e_ref": lambda r: f"{r['e_ref']:.2f}", "gamma": lambda r: f"{r['gamma']:.3f}"}
    both = {"e_ref": pair("e_ref", 2), "gamma": lambda r: f"{r['gamma']:.3f} ({r['paper_glob'] / r['paper_e_ref']:.3f})"}
    meshes = {"NDOF": count("ndof")}
    stopping = {"eps_tau <": lambda r: f"{r['tolerance']:g}", "sweeps": count("sweeps")}
    return {
        "table1": as_markdown({**meshes, **errors_of(2), **both, **others}, rows["table1"]),
        "table2": as_markdown({**meshes, **errors_of(2), **own, **others}, rows["table2"]),
        "table3": as_markdown({**stopping, **errors_of(3), **own, **others}, rows["table3"]),
    }
