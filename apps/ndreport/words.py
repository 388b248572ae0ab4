"""The scene, the verdict and the numbers in words. Nothing here draws."""

import math

from .results import solved

AXES = "xyz"
LARGE_ERROR = 0.2  # a bound above it, guaranteed or not, is no good answer
EDGE = 1.3  # times what lies between the ends: the pressure of an edge that presses


def number(value, digits=4):
    """A number as an engineer writes it; a dash where there is none."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\u202f")
    if not math.isfinite(value):
        return "–"
    return f"{value:.{digits}g}".replace("-", "−")


def percent(value):
    return "–" if value is None else f"{100.0 * value:.3g} %"


def vector(values, digits=4):
    """Components; those that are round-off beside the largest are 0."""
    if values is None:
        return "–"
    largest = max((abs(v) for v in values if v is not None), default=0.0)
    return "(" + ", ".join("0" if v is not None and abs(v) <= 1e-9 * largest else number(v, digits) for v in values) + ")"


def count(amount, word, plural=None):
    return f"{number(amount)} {word if amount == 1 else plural or word + 's'}"


def joined(items):
    items = list(items)
    return items[0] if len(items) == 1 else ", ".join(items[:-1]) + " and " + items[-1] if items else ""


def material(entry):
    if entry["Type"] == "Isotropic":
        text = f"Young's modulus {number(entry['Young Modulus'])}, Poisson ratio {number(entry['Poisson Ratio'])}"
    else:
        given = [f"{key} {number(value) if isinstance(value, float) else value}" for key, value in entry.items()
                 if key not in ("Type", "Hypothesis") and not isinstance(value, dict)]
        text = f"{entry['Type'].lower()}: {', '.join(given)}"
    return f"{text}, {entry['Hypothesis'].lower()}" if "Hypothesis" in entry else text


def materials(body):
    """[sentence]; one for each region of a body of several materials."""
    if "Rigid" in body:
        return ["does not deform"]
    regions = [f"{name}: {material(region['Material'])}" for name, region in body.get("Regions", {}).items()]
    return regions + ([material(body["Material"])] if "Material" in body else [])


def components(entry):
    """The entries X, Y, Z of a support or load; a Z of 0 is not worth a word."""
    given = [(axis, entry[axis.upper()]) for axis in AXES if axis.upper() in entry]
    return ", ".join(f"{axis}: {value}" for axis, value in given if (axis, str(value)) not in (("z", "0"), ("z", "0.0")))


def load(name, entry):
    kind = entry["Type"]
    where = f" on {entry['Side']}" if entry.get("Side") else ""
    cells = f" in {joined(entry['Cells'])}" if entry.get("Cells") else ""
    size = str(entry["Value"]) if "Value" in entry else components(entry)
    return f"{name}: {kind.lower()} {size}{where}{cells}"


def supported(body, supports):
    """The sentences about what holds a body, those of given displacements with their values."""
    moved = {f"displacement at {entry['Side']}": components(entry) for entry in supports.values() if entry.get("Type") == "Displacement"}
    return [f"{text}: {moved[text]}" if moved.get(text) else text for text in body["held_by"].split("; ")]


def interface(name, entry):
    first = f"{entry['Dirichlet Side']} of {entry['Dirichlet Body']}"
    second = f"{entry['Neumann Side']} of {entry['Neumann Body']}" if "Neumann Side" in entry else entry["Neumann Body"]
    gap = str(entry.get("Gap", "0"))
    opening = "" if gap in ("0", "0.0") else f", a gap of {gap} added"
    return f"{name}: {first} and {second} may touch, without friction{opening}"


def scene(summary):
    """One or two sentences about what was computed."""
    bodies, deck = summary["bodies"], summary["deck"]
    rigid = [name for name, body in deck["Bodies"].items() if "Rigid" in body]
    elastic = len(bodies) - len(rigid)
    space = "plane scene, a slice of thickness 1" if summary["per_unit_thickness"] else "3D scene"
    text = count(elastic, "elastic body", "elastic bodies")
    if rigid:
        text += f" and {count(len(rigid), 'rigid one')}"
    touching = summary["interfaces"]
    meeting = f", which may touch at {count(len(touching), 'interface')}" if touching else ", without contact"
    return (f"A {space}: {text}{meeting}. {count(sum(b['dofs'] for b in bodies), 'degree of freedom', 'degrees of freedom')}, "
            f"{count(sum(b['elements'] for b in bodies), 'element')} of order {max(b['order'] for b in bodies)}.")


def peak_pressure(summary, contact):
    """(pressure, interface, point or None) of the largest contact pressure; None where nothing touches."""
    if not summary["interfaces"] or not solved(summary):
        return None
    top = max(summary["interfaces"], key=lambda i: i["largest_pressure"] or 0.0)
    if not top["largest_pressure"]:
        return 0.0, top["name"], None
    table = contact.get(top["name"])
    if not table:
        return top["largest_pressure"], top["name"], None
    row = max(range(len(table["pressure"])), key=lambda i: table["pressure"][i])
    return top["largest_pressure"], top["name"], [table[axis][row] for axis in AXES if axis in table]


def grows_with_the_mesh(summary, contact):
    """Whether the largest pressure stands where contact ends, far above what lies between: an edge presses, the pressure of the solution has
    no largest value, and finer meshes show larger ones. Of plane scenes."""
    peak = peak_pressure(summary, contact)
    if not peak or not peak[2] or len(peak[2]) > 2:
        return False
    pressure, length = list(contact[peak[1]]["pressure"]), list(contact[peak[1]]["arc_length"])
    pressed = [i for i, p in enumerate(pressure) if p > 0.0]
    ends = [i for i in pressed if None in (nearest_pressed(pressure, length, i, step) for step in (1, -1))]
    top, inner = max(pressed, key=lambda i: pressure[i]), [pressure[i] for i in pressed if i not in ends]
    return top in ends and len(inner) > 1 and pressure[top] > EDGE * max(inner)


def nearest_pressed(pressure, length, node, step):
    """The node next to one at another place of the same piece of the side, if it is pressed; None at an end of contact."""
    other = node + step
    while 0 <= other < len(length) and length[other] == length[node]:
        other += step
    inside = 0 <= other < len(length) and (length[other] - length[node]) * step > 0.0
    return other if inside and pressure[other] > 0.0 else None


def error_clause(summary):
    errors = summary["errors"]
    if errors is None:
        return "the error was not estimated (lists Error Estimation and Accuracy of the deck)"
    bound = errors.get("global")
    if not bound:
        return "the estimators that the deck asks for give no bound"
    if bound["relative"] is None:
        return "the error in energy has no finite bound"
    if bound["relative"] > 1.0:
        return "the bound of the error is above 100 %: it says nothing about the answer"
    if bound["guaranteed"]:
        return f"error in energy at most {percent(bound['relative'])}, guaranteed"
    why = f" ({bound['reason'].rstrip('.')})" if bound["reason"] else ""
    return f"error in energy about {percent(bound['relative'])}, not guaranteed{why}"


def advice(summary):
    """What would help, in a few words; empty if nothing is known or wanted."""
    errors, accuracy = summary["errors"], summary["accuracy"]
    if accuracy:
        target = percent(accuracy["target"]) if accuracy["relative"] else number(accuracy["target"])
        if accuracy["reached"]:
            return f"the target of {target} is reached"
        return f"the target of {target} is missed: {accuracy['limit'].rstrip('.')}"
    if not errors:
        return ""
    if errors.get("advice"):
        return errors["advice"].rstrip(".")
    mesh, iteration = errors.get("discretization"), errors.get("algorithm")
    if not mesh or not iteration:
        return ""
    return "a finer mesh would help" if mesh["absolute"] > iteration["absolute"] else "more sweeps would help"


def verdict(results):
    """(state, sentence): state is right, look or wrong."""
    summary = results.summary
    if not solved(summary):
        reason = (summary["coupling"] or {}).get("reason", "")
        return "wrong", f"There is no solution{': ' + reason.rstrip('.') if reason else ''}."
    parts = []
    peak = peak_pressure(summary, results.contact)
    if peak:
        where = f" at {vector(peak[2])}" if peak[2] else ""
        edge = ", at an edge, where finer meshes show larger values" if grows_with_the_mesh(summary, results.contact) else ""
        parts.append(f"peak pressure {number(peak[0])}{where}{edge}" if peak[0] else "nothing touches")
    else:
        parts.append(f"largest displacement {number(max(b['largest_displacement']['value'] for b in summary['bodies']))}")
    parts.append(error_clause(summary))
    if hint := advice(summary):
        parts.append(hint)
    state = state_of(summary)
    if summary["coupling"] and not summary["coupling"]["converged"]:
        parts.append(f"the sweeps have not converged ({summary['coupling']['reason'].rstrip('.')})")
    missed = [e["name"] for e in summary["expectations"] if not e["met"]]
    if missed:
        parts.append(f"{count(len(missed), 'expectation')} of the deck missed ({joined(missed)})")
    if summary["warnings"]:
        parts.append(f"{count(len(summary['warnings']), 'warning')} to look at")
    text = "; ".join(parts)
    return state, text[0].upper() + text[1:] + "."


def state_of(summary):
    errors, accuracy = summary["errors"], summary["accuracy"]
    if summary["coupling"] and not summary["coupling"]["converged"] and not accuracy:
        return "wrong"
    if accuracy and not accuracy["reached"] or any(not e["met"] for e in summary["expectations"]):
        return "wrong"
    guaranteed = errors is not None and bool(errors.get("global")) and errors["global"]["guaranteed"]
    small = guaranteed and errors["global"]["relative"] is not None and errors["global"]["relative"] <= LARGE_ERROR
    return "right" if small and not summary["warnings"] else "look"
