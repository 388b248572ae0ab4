"""The page: what is shown of the results that are there."""

import datetime
import pathlib

import jinja2
import ndframe

from . import pictures, probes, study_page, tables, words
from .results import solved
from .style import looks

MOST_BODIES, MOST_INTERFACES = 40, 12  # that are described one by one
TEMPLATES = pathlib.Path(__file__).resolve().parent / "templates"


def page(results):
    """The whole report as text."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    with looks():
        if results.study is not None:
            return environment.get_template("study.html").render(now=now(), **study_page.content(results))
        return environment.get_template("run.html").render(now=now(), **content(results))


def now():
    return datetime.datetime.now().astimezone().strftime("%Y-%m-%d %H:%M %Z")


def content(results):
    summary = results.summary
    state, sentence = words.verdict(results)
    found = pictures.of_run(results)
    return {
        "title": summary["title"] or results.name, "name": results.name, "state": state, "verdict": sentence,
        "tiles": tiles(results), "scene": words.scene(summary), "bodies": body_rows(summary),
        "more_bodies": max(0, len(summary["bodies"]) - MOST_BODIES),
        "interfaces": interface_words(summary),
        "pictures": found, "tables": all_tables(results), "sweeps_text": sweeps_text(summary), "solved": solved(summary),
        "deck": ndframe.deck_text(summary["deck"]), "version": summary["version"], "build": summary.get("build") or {},
        "ranks": summary["ranks"], "files": results.files, "gaps": results.gaps, "warnings": summary["warnings"],
        "guarantee": guarantee(summary),
    }


def interface_words(summary):
    """A sentence for each interface of the deck; many are counted."""
    found = [words.interface(name, entry) for name, entry in summary["deck"].get("Interfaces", {}).items()
             if isinstance(entry, dict) and "Dirichlet Body" in entry]
    rest = len(found) - MOST_INTERFACES
    return found if rest <= 0 else [*found[:MOST_INTERFACES], f"and {rest} more, see the deck below"]


def tiles(results):
    """(label, number, remark) of what is looked at first."""
    summary = results.summary
    found = []
    if solved(summary):
        bound = (summary["errors"] or {}).get("global")
        if bound and bound["relative"] is not None:
            size = "> 100 %" if bound["relative"] > 1.0 else ("≤ " if bound["guaranteed"] else "≈ ") + words.percent(bound["relative"])
            found.append(("error in energy", size,
                          "guaranteed" if bound["guaranteed"] else "not guaranteed"))
        if peak := words.peak_pressure(summary, results.contact):
            found.append(("peak contact pressure", words.number(peak[0]), peak[1]))
            force = max(summary["interfaces"], key=lambda i: i["contact_force"] or 0.0)
            found.append(("contact force", words.number(force["contact_force"]), force["name"]))
        top = max(summary["bodies"], key=lambda b: b["largest_displacement"]["value"])
        found.append(("largest displacement", words.number(top["largest_displacement"]["value"]), top["name"]))
    found.append(("degrees of freedom", words.number(sum(b["dofs"] for b in summary["bodies"])),
                  words.count(sum(b["elements"] for b in summary["bodies"]), "element")))
    ledger = summary["ledger"]
    found.append(("time", f"{words.number(ledger['total_seconds'], 3)} s", tables.megabytes(ledger["peak_bytes"])))
    return found


def body_rows(summary):
    """(name, mesh, materials, what holds it, loads) of every body; all but the name are lists of sentences."""
    rows = []
    for body in summary["bodies"][:MOST_BODIES]:
        entry = summary["deck"]["Bodies"].get(body["name"], {})
        mesh = [] if "Rigid" in entry else [f"{words.count(body['elements'], 'element')}, {words.count(body['dofs'], 'dof')}"]
        rows.append((body["name"], mesh, words.materials(entry), words.supported(body, entry.get("Supports", {})),
                     [words.load(*item) for item in entry.get("Loads", {}).items()]))
    return rows


def all_tables(results):
    summary = results.summary
    found = {"bodies": tables.bodies(summary), "residuals": tables.residuals(summary), "counts": tables.counts(summary)}
    found["work"] = tables.work(summary)
    if solved(summary):
        found["forces"] = tables.forces(summary)
        for name, (heads, rows) in (("points", probes.of_points(summary)), ("sides", probes.of_sides(summary))):
            if rows:
                found[name] = heads, rows
    if summary["interfaces"] and solved(summary):
        found["interfaces"] = tables.interfaces(summary)
    if summary["errors"]:
        found["errors"] = tables.errors(summary)
        if bracket := tables.bracket(summary):
            found["bracket"] = bracket
    if summary["expectations"]:
        found["expectations"] = tables.expectations(summary)
    if results.levels:
        found["levels"] = tables.levels(results.levels)
    if summary["coupling"] and len(summary["coupling"]["history"]) > 1:
        found["sweeps"] = tables.sweeps(summary["coupling"]["history"])
    return {name: table if name == "work" else tables.shortened(table) for name, table in found.items()}


def sweeps_text(summary):
    coupling = summary["coupling"]
    if not coupling:
        return ""
    history = coupling["history"]
    text = f"{coupling['type']}: {words.count(coupling['sweeps'] or 0, 'sweep')}. It stopped: {coupling['reason'].rstrip('.')}."
    if len(history) == 1:
        last = history[0]
        text += (f" {words.count(last['status_passes'], 'pass', 'passes')} over the contact status with "
                 f"{words.count(last['status_changes'], 'change')}; {last['closed']} nodes closed, {last['open']} open.")
    return text


def guarantee(summary):
    """What the bound means, or why there is none."""
    errors = summary["errors"]
    if errors is None:
        return ("The deck asks for no error estimate. ndframe --set \"Error Estimation/Mode=Strict\" adds a bound, "
                "--set \"Accuracy/Target=0.01\" refines until it is below 1 %.")
    bound = errors.get("global")
    if not bound:
        return "The deck asks for indicators only, which bound nothing."
    if bound["guaranteed"]:
        return ("The error in the energy norm, of the displacement and of the stress, cannot be larger than the bound: every "
                "condition of the bound was checked in this run. Local values such as a peak pressure have no bound of their own.")
    return f"The bound is not guaranteed: {bound['reason']}"
