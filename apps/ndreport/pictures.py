"""All pictures of a run, with their captions. What cannot be drawn is said in the report's gaps."""

import numpy

from . import curves, fields, plane_view, probes, scene_view, solid_view
from .bodies import Bodies, choose_scale
from .results import solved
from .style import svg
from .words import number, vector

MOST_INTERFACES, MOST_ZOOMS = 12, 2


def of_run(results):
    """{section: [(svg, caption, wide)]}."""
    found = {"scene": [], "fields": [], "errors": [], "contact": [], "probes": [], "sweeps": [], "levels": []}
    summary = results.summary
    bodies = Bodies(results) if results.fields and solved(summary) else None
    if bodies:
        add_bodies(found, bodies)
    touching = sorted(summary["interfaces"], key=lambda i: i["contact_force"] or 0.0, reverse=True) if solved(summary) else []
    if len(touching) > MOST_INTERFACES:
        results.gaps.append(f"pictures of the {len(touching) - MOST_INTERFACES} interfaces with the smallest forces")
    for interface in touching[:MOST_INTERFACES]:
        add_contact(found, results, bodies, interface["name"])
    add_probes(found, results)
    history = summary["coupling"]["history"] if summary["coupling"] else []
    if len(history) > 1 and sum(s["eps_tau"] is not None and s["eps_tau"] > 0.0 for s in history) > 1:
        tolerance = summary["deck"].get("Coupling", {}).get("Stopping", {}).get("Tolerance")
        stopped_by_it = "eps_tau" in summary["coupling"]["reason"]
        add(found["sweeps"], curves.sweeps(history, tolerance if stopped_by_it else None), "Stopping quantity after every sweep.")
    add_levels(found, results)
    return found


def add_probes(found, results):
    lines, more = probes.of_lines(results.summary) if solved(results.summary) else ([], 0)
    for probe in lines:
        add(found["probes"], probes.along_line(probe), probes.caption(probe))
    if more:
        results.gaps.append(f"curves of {more} more lines of probes")


def add(section, figure, caption, wide=False):
    section.append((svg(figure, caption), caption, wide))


def add_bodies(found, bodies):
    scale = choose_scale(bodies)
    norm, peak, place = fields.stress_norm(bodies)
    name = fields.contribution_name(bodies)
    shares = fields.contribution_norm(bodies, name) if name else None
    stress_caption = (f"von Mises stress on the deformed bodies, {scale.words()}. The largest value at a node is {number(peak)} at "
                      f"{vector(place)}; colours end at {number(norm.vmax)}.")
    share_caption = "What every element adds to the error: where a finer mesh would help most."
    if bodies.dim == 2:
        add(found["scene"], scene_view.plane_scene(bodies), "The scene before loading. Arrows show where and in which direction loads act,  "
            "not how large they are.")
        add(found["fields"], plane_view.stress_picture(bodies, scale, norm), stress_caption)
        add_zooms(found, bodies, scale)
        if shares:
            add(found["errors"], plane_view.contribution_picture(bodies, name, shares), share_caption)
        return
    first, second = solid_view.views(bodies)
    figure, apart = scene_view.solid_scene(bodies, second)
    add(found["scene"], figure, f"The scene before loading{', the bodies drawn apart' if apart else ''}.")
    add(found["scene"], scene_view.solid_scene(bodies, first)[0], "The same from the other side.")
    add(found["fields"], solid_view.stress_picture(bodies, scale, norm, first), stress_caption)
    add(found["fields"], solid_view.stress_picture(bodies, scale, norm, second), "The same from the other side.")
    if shares:
        add(found["errors"], solid_view.contribution_picture(bodies, scale, name, shares, first), share_caption)


def add_zooms(found, bodies, scale):
    """What is near small contact zones on long sides, with colours of their own; at most MOST_ZOOMS."""
    for name, table in list(bodies.contact.items()):
        places = numpy.stack([table["x"], table["y"]], axis=1)
        closed = places[numpy.array(table["closed"]) > 0.5]
        if len(closed) < 2 or not any(table["pressure"]) or len(found["fields"]) > MOST_ZOOMS:
            continue
        extent, side = (float(numpy.ptp(some, axis=0).max()) for some in (closed, places))
        if extent > 0.15 * bodies.size() or extent > 0.5 * side:
            continue
        middle, reach = 0.5 * (closed.min(axis=0) + closed.max(axis=0)), 1.5 * extent
        used = numpy.unique(numpy.concatenate([piece.nodes.ravel() for piece in bodies.pieces]))
        moved = bodies.moved(scale)[used]
        box = numpy.maximum(middle - reach, moved.min(axis=0)), numpy.minimum(middle + reach, moved.max(axis=0))
        if numpy.all(box[1] - box[0] > 0.2 * reach):
            figure = plane_view.stress_picture(bodies, scale, fields.norm_within(bodies, bodies.moved(scale), box), box=box)
            add(found["fields"], figure, f"The same near {name}, with its own colour scale.")


def add_contact(found, results, bodies, name):
    table = results.contact.get(name)
    if bodies and bodies.dim == 3:
        figure = solid_view.contact_maps(bodies, name)
        if figure:
            add(found["contact"], figure, f"{name}: pressure and gap, means over the facets.", True)
    elif table and "arc_length" in table:
        admissible = admissible_steps(bodies, name, table) if bodies else None
        more = "; the admissible pressure is the one of the error bound" if admissible else ""
        add(found["contact"], curves.along_interface(table, admissible), f"{name}: pressure and gap along the side{more}.")


def admissible_steps(bodies, name, table):
    """[(start, end, value)] of the facets along the side whose nodes are the rows of the table; None without them."""
    rows = numpy.stack([table["x"], table["y"]], axis=1)
    lengths = curves.continued(table["arc_length"])
    for side in (f"{name}:dirichlet", f"{name}:neumann"):  # they lie apart where bodies are drawn apart
        values = bodies.facet_values(side, "admissible_pressure")
        steps = steps_along(bodies.points[bodies.fields.facets(side)], values, rows, lengths) if values is not None else []
        if values is not None and len(steps) == len(values):
            return sorted(steps)
    return None


def steps_along(facets, values, rows, lengths):
    """Facets with both ends among the rows: from where to where they go, and their values."""
    steps, size = [], float(numpy.ptp(rows, axis=0).max())
    for ends, value in zip(facets, values):
        distance = numpy.linalg.norm(rows[None] - ends[:, None], axis=2)
        first, last = (int(i) for i in distance.argmin(axis=1))
        if distance.min(axis=1).max() < 1e-7 * size and first != last:
            steps.append((*sorted((float(lengths[first]), float(lengths[last]))), float(value)))
    return steps


def add_levels(found, results):
    rows, accuracy = results.levels, results.summary["accuracy"]
    if len(rows) < 2:
        return
    bounds = [row for row in rows if row["bound"] is not None]
    if len(bounds) > 1:
        scale = next((row["bound"] / row["relative"] for row in reversed(bounds) if row["relative"]), None)
        target = accuracy["target"] * scale if accuracy["relative"] and scale else (None if accuracy["relative"] else accuracy["target"])
        add(found["levels"], curves.levels(bounds, target), "Bound of the error and its parts on every level (energy norm).")
    bracketed = [row for row in rows if row.get("energy_bracket")]
    if len(bracketed) > 1:
        add(found["levels"], curves.energies(bracketed), "Where the exact energy lies, by the certificates up to each level, in percent from the middle of the last.")
