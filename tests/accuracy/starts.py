"""First meshes for a deck of boxes, as settings for --set: few cells, stretched cells, random triangles."""

import dataclasses
import itertools
import math
import random
import xml.etree.ElementTree

from matplotlib.tri import Triangulation

DECK = "Accuracy/Start=Deck"


@dataclasses.dataclass(frozen=True)
class Box:
    """Of the plane. `splits`: {bottom or top: (where it is cut, names of the parts)}."""

    body: str
    lower: tuple
    upper: tuple
    splits: dict

    def lengths(self):
        return [b - a for a, b in zip(self.lower, self.upper)]

    def sides(self):
        """[(name, one end, other end)], the parts of a split side one by one."""
        (x0, y0), (x1, y1) = self.lower, self.upper
        ends = {"left": ((x0, y0), (x0, y1)), "right": ((x1, y0), (x1, y1)),
                "bottom": ((x0, y0), (x1, y0)), "top": ((x0, y1), (x1, y1))}
        for side, (cuts, names) in self.splits.items():
            y = ends.pop(side)[0][1]
            stations = [(x, y) for x in (x0, *cuts, x1)]
            ends.update(zip(names, itertools.pairwise(stations)))
        return [(name, *pair) for name, pair in ends.items()]


def array(text, convert=str):
    return tuple(convert(entry.strip()) for entry in text.strip("{}").split(","))


def child(parent, name):
    return parent.find(f"*[@name='{name}']")


def box_of(body):
    """From the body's list in a deck."""
    mesh = child(body, "Mesh")
    lists = child(mesh, "Splits")
    splits = {child(one, "Side").get("value"): (array(child(one, "At").get("value"), float),
                                                array(child(one, "Names").get("value")))
              for one in (lists if lists is not None else ())}
    corners = (array(child(mesh, name).get("value"), float) for name in ("Lower", "Upper"))
    return Box(body.get("name"), *corners, splits)


def boxes_of(deck):
    return [box_of(body) for body in child(xml.etree.ElementTree.parse(deck).getroot(), "Bodies")]


def fits(boxes, density):
    """Whether cells, `density` to a length, end where sides are cut."""
    cuts = [x for box in boxes for at, _ in box.splits.values() for x in at]
    return all((x * density).is_integer() for x in cuts)


def cells(boxes, density, stretch=1):
    """`density` cells a length along x, `stretch` times as long as high."""
    settings = [DECK]
    for box in boxes:
        width, height = box.lengths()
        counts = round(width * density), round(height * density * stretch)
        settings.append(f"Bodies/{box.body}/Mesh/Cells={{{counts[0]}, {counts[1]}}}")
    return tuple(settings)


def random_line(one, other, size):
    """From one end to the other in uneven steps, the same at every call: bodies match where they share a side."""
    generator = random.Random(str((one, other)))
    count = math.ceil(math.dist(one, other) / size)
    inside = ((step + generator.uniform(-0.3, 0.3)) / count for step in range(1, count))
    return [tuple(a + s * (b - a) for a, b in zip(one, other)) for s in (0, *inside, 1)]


def random_triangles(box, size):
    """(points, triangles, {side: its points in a row}) of a Delaunay mesh whose vertices are random."""
    lines = {name: random_line(one, other, size) for name, one, other in box.sides()}
    points = list(dict.fromkeys(itertools.chain(*lines.values())))
    generator = random.Random(box.body)
    for _ in range(round(20 * math.prod(box.lengths()) / size**2)):
        candidate = tuple(generator.uniform(a + size / 3, b - size / 3) for a, b in zip(box.lower, box.upper))
        if all(math.dist(candidate, other) > size / 2 for other in points):
            points.append(candidate)
    triangles = Triangulation(*zip(*points)).triangles
    numbers = {point: number for number, point in enumerate(points)}
    return points, triangles, {name: [numbers[point] for point in line] for name, line in lines.items()}


def msh(box, size):
    """The text of a gmsh file (2.2) of random triangles."""
    points, triangles, sides = random_triangles(box, size)
    names = [f'1 {tag} "{side}"' for tag, side in enumerate(sides, 1)] + [f'2 1 "{box.body}"']
    nodes = [f"{number} {x!r} {y!r} 0" for number, (x, y) in enumerate(points, 1)]
    elements = [f"1 2 {tag} {tag} {a + 1} {b + 1}" for tag, line in enumerate(sides.values(), 1)
                for a, b in itertools.pairwise(line)]
    elements += [f"2 2 1 1 {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    elements = [f"{number} {element}" for number, element in enumerate(elements, 1)]
    text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    for section, lines in (("PhysicalNames", names), ("Nodes", nodes), ("Elements", elements)):
        text += "\n".join([f"${section}", str(len(lines)), *lines, f"$End{section}", ""])
    return text


def random_start(boxes, size, folder):
    """Writes a mesh of each body into the folder."""
    settings = [DECK]
    for box in boxes:
        file = folder / f"{box.body}.msh"
        file.write_text(msh(box, size))
        settings += [f"Bodies/{box.body}/Mesh/Type=Gmsh", f"Bodies/{box.body}/Mesh/File={file}",
                     f"Bodies/{box.body}/Mesh/Regions={{{box.body}}}"]
    return tuple(settings)


def starts(deck, folder):
    """{what: settings} of first meshes that the answer must not depend on."""
    boxes = boxes_of(deck)
    even = {f"{count} cells": cells(boxes, count) for count in (1, 2, 4, 8) if fits(boxes, count)}
    stretched = {f"{stretch}:1": cells(boxes, 8 // stretch, stretch) for stretch in (2, 4)}
    return even | stretched | {"random": random_start(boxes, 0.4, folder)}
