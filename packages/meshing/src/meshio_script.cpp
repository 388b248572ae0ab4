#include "meshio_script.hpp"

namespace ndframe
{

const char* const meshioScript = R"python(
"""Turns a mesh that meshio reads into a .msh file of format 2.2: FILE OUTPUT MESSAGE. Exit code 3: see MESSAGE."""

import contextlib
import io
import re
import sys

path, output, message = sys.argv[1:4]


def fail(text):
    with open(message, "w") as file:
        file.write(text)
    sys.exit(3)


try:
    import meshio
    import numpy
    if path.lower().endswith(".med"):
        import h5py
except ImportError as error:
    fail(f"such files are read by meshio, a library for Python, which is not installed ({error}); on Debian: apt-get "
         "install python3-meshio python3-h5py.")

# gmsh's numbers of elements of first order, their dimension and faces; those of second order begin with the vertices.
TYPES = {"line": (1, 1, []), "triangle": (2, 2, ["01", "12", "20"]), "quad": (3, 2, ["01", "12", "23", "30"]),
         "tetra": (4, 3, ["013", "123", "032", "021"]),
         "hexahedron": (5, 3, ["0154", "1265", "2376", "0473", "0321", "4567"]),
         "wedge": (6, 3, ["0143", "1254", "0352", "021", "345"]),
         "pyramid": (7, 3, ["014", "124", "234", "043", "0321"])}
VERTICES = {"line": 2, "triangle": 3, "quad": 4, "tetra": 4, "hexahedron": 8, "wedge": 6, "pyramid": 5}
SECOND = {"line3", "triangle6", "triangle7", "quad8", "quad9", "tetra10", "hexahedron20", "hexahedron27", "wedge15",
          "wedge18", "pyramid13", "pyramid14"}
FACETS = {2: 1, 3: 2, 4: 3}  # gmsh's types by the number of vertices


def kind_of(name):
    base = re.sub(r"\d+$", "", name)
    if name not in TYPES and name not in SECOND:
        fail(f"its cells of type {name} are not read.")
    return base


def cell_groups(mesh, blocks):
    """{name: {block: [cells]}}"""
    groups = {}
    for name, sets in mesh.cell_sets.items():
        for block, cells in enumerate(sets):
            groups.setdefault(name, {}).setdefault(block, set()).update(int(c) for c in numpy.atleast_1d(cells))
    names = getattr(mesh, "cell_tags", {})
    for key, values in mesh.cell_data.items():
        for block, ofBlock in enumerate(values):
            ofBlock = numpy.asarray(ofBlock)
            if ofBlock.ndim != 1 or ofBlock.dtype.kind not in "iu":
                continue
            for cell, value in enumerate(ofBlock.tolist()):
                for name in names.get(value, []) if key == "cell_tags" and names else [f"{key} {value}"]:
                    groups.setdefault(name, {}).setdefault(block, set()).add(cell)
    return groups


def point_groups(mesh):
    groups = {name: {int(p) for p in points} for name, points in mesh.point_sets.items()}
    names, tags = getattr(mesh, "point_tags", {}), mesh.point_data.get("point_tags")
    for point, tag in enumerate(numpy.asarray(tags).tolist() if names and tags is not None else []):
        for name in names.get(tag, []):
            groups.setdefault(name, set()).add(point)
    return groups


def surfaces(blocks, groups):
    """The faces of *SURFACE in an .inp file, by sets of elements: {name: [(block, cell, face)]}"""
    # Abaqus's faces by ours.
    order = {"tetra": [3, 0, 1, 2], "hexahedron": [4, 5, 0, 1, 2, 3], "wedge": [3, 4, 0, 1, 2], "pyramid": [4, 0, 1, 2, 3]}
    found, name = {}, None
    for line in open(path, errors="replace"):
        if line.startswith("*") and not line.startswith("**"):
            words = dict(part.strip().upper().partition("=")[::2] for part in line.split(","))
            given = re.search(r"NAME\s*=\s*([^,\s]+)", line, re.IGNORECASE)
            isFaces = words.get("TYPE", "ELEMENT").strip() == "ELEMENT"
            name = given.group(1) if line.upper().startswith("*SURFACE,") and given and isFaces else None
        elif name is not None and line.strip() and not line.startswith("**"):
            what, _, face = (part.strip() for part in line.partition(","))
            if what.isdigit():
                fail(f"its surface {name} names elements by their numbers, which meshio does not keep; name sets of "
                     "elements, or give a set of nodes (*NSET) or of elements of one dimension less.")
            if what not in groups or not re.fullmatch("S[1-6]", face.upper()):
                fail(f"its surface {name} names \"{line.strip()}\"; only sets of elements with a face S1 to S6 are read.")
            for block, cells in groups[what].items():
                kind = blocks[block][0]
                place = order.get(kind, [0, 1, 2, 3])
                if int(face[1]) <= len(TYPES[kind][2]):
                    found.setdefault(name, []).extend((block, c, place[int(face[1]) - 1]) for c in sorted(cells))
    return found


def main():
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            mesh = meshio.read(path)
    except Exception as error:
        fail(f"meshio cannot read it: {str(error) or type(error).__name__}")
    except SystemExit:  # after an explanation
        fail(f"meshio cannot read it: {' '.join(said.getvalue().split()) or 'it does not say why'}")
    blocks = [(kind_of(block.type), numpy.asarray(block.data)) for block in mesh.cells if block.type != "vertex"]
    if len(blocks) != len(mesh.cells):
        fail("cells that are single points are not read; take them out of the file.")
    dim = max((TYPES[kind][1] for kind, _ in blocks), default=0)
    if dim < 2:
        fail("the mesh has no cells of two or three dimensions.")
    blocks = [(kind, data[:, :VERTICES[kind]].tolist()) for kind, data in blocks]
    groups = cell_groups(mesh, blocks)
    tags, elements = {}, []
    tag = lambda d, name: tags.setdefault((d, name), len(tags) + 1)
    named = {}
    for name, ofBlocks in groups.items():
        for block, cells in ofBlocks.items():
            for cell in cells:
                named.setdefault((block, cell), []).append(tag(TYPES[blocks[block][0]][1], name))
    for block, (kind, data) in enumerate(blocks):
        number, ofDim, _ = TYPES[kind]
        for cell, vertices in enumerate(data):
            rest = 0 if not named or ofDim < dim or (block, cell) in named else tag(dim, "cells of no set")
            for group in named.get((block, cell), [rest]):
                elements.append((number, group, vertices))

    count, facets = {}, []
    for block, (kind, data) in enumerate(blocks):
        for cell, vertices in enumerate(data if TYPES[kind][1] == dim else []):
            for face, corners in enumerate(TYPES[kind][2]):
                facet = [vertices[int(k)] for k in corners]
                facets.append(((block, cell, face), facet))
                key = tuple(sorted(facet))
                count[key] = count.get(key, 0) + 1
    boundary = {place: facet for place, facet in facets if count[tuple(sorted(facet))] == 1}
    for name, points in point_groups(mesh).items():
        group = tag(dim - 1, name)
        elements += [(FACETS[len(facet)], group, facet) for facet in boundary.values() if points.issuperset(facet)]
    for name, faces in (surfaces(blocks, groups) if path.lower().endswith(".inp") else {}).items():
        group = tag(dim - 1, name)
        elements += [(FACETS[len(boundary[place])], group, boundary[place]) for place in faces if place in boundary]

    with open(output, "w") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(tags)}\n")
        for (ofDim, name), group in tags.items():
            file.write(f"{ofDim} {group} \"{name}\"\n")
        file.write(f"$EndPhysicalNames\n$Nodes\n{len(mesh.points)}\n")
        for number, point in enumerate(mesh.points.tolist()):
            file.write(f"{number + 1} " + " ".join(repr(float(x)) for x in (point + [0.0, 0.0])[:3]) + "\n")
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for number, (kind, group, vertices) in enumerate(elements):
            file.write(f"{number + 1} {kind} 2 {group} 1 " + " ".join(str(v + 1) for v in vertices) + "\n")
        file.write("$EndElements\n")


main()
)python";

} // namespace ndframe
