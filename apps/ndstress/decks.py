"""A scene as files: gmsh meshes and a deck for ndframe."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from ndframe import deck_text  # noqa: E402


def write_mesh(mesh, path):
    """Format 2.2 in ASCII; coordinates with all their digits."""
    names = sorted(mesh.sides)
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names) + 1)]
    lines += [f'1 {tag} "{name}"' for tag, name in enumerate(names, 1)] + [f'2 {len(names) + 1} "body"']
    lines += ["$EndPhysicalNames", "$Nodes", str(len(mesh.points))]
    lines += [f"{i} {float(x)!r} {float(y)!r} 0" for i, (x, y) in enumerate(mesh.points, 1)]
    elements = [(2, len(names) + 1, cell) for cell in mesh.cells]
    elements += [(1, tag, edge) for tag, name in enumerate(names, 1) for edge in mesh.sides[name]]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i} {kind} 2 {tag} {tag} " + " ".join(str(p + 1) for p in vertices)
              for i, (kind, tag, vertices) in enumerate(elements, 1)]
    path.write_text("\n".join(lines + ["$EndElements", ""]))


def polynomial_text(coefficients, origin):
    """c0 + c1 (x - o) + ... as a number or an expression of the deck."""
    if len(coefficients) == 1:
        return float(coefficients[0])
    x = f"(x - {float(origin)!r})" if origin else "x"
    return " + ".join(f"({float(c)!r})" + f" * {x}" * k for k, c in enumerate(coefficients))


def _support(side, given):
    component = {0: "X", 1: "Y"}
    return {"Type": "Displacement", "Side": side, **{component[axis]: float(value) for axis, value in given.items()}}


def _body(body, file, origin):
    return {"Mesh": {"Type": "Gmsh", "File": file},
            "Material": {"Young Modulus": body.young, "Poisson Ratio": body.poisson},
            "Supports": {f"at {side}": _support(side, given) for side, given in body.supports.items()},
            "Loads": {f"on {side}": {"Type": "Pressure", "Side": side, "Value": polynomial_text(p, origin)}
                      for side, p in body.pressures.items()}}


def deck_of(scene, method):
    """The deck as nested dictionaries. method: lists that replace the defaults, e.g. {"Coupling": {...}}."""
    sides = {"upper": "bottom", "lower": "contact"}
    first, second = ("lower", "upper") if scene.swapped else ("upper", "lower")
    contact = {"Dirichlet Body": first, "Dirichlet Side": sides[first], "Neumann Body": second,
               "Neumann Side": sides[second], "Gap": polynomial_text(scene.gap, scene.origin)}
    return {"Title": "stress", "Bodies": {"upper": _body(scene.upper, "upper.msh", scene.origin),
                                          "lower": _body(scene.lower, "lower.msh", scene.origin)},
            "Interfaces": {"contact": contact}, "Discretization": {"Order": scene.order}, **method}


def write_scene(scene, method, folder):
    """Meshes and deck.xml in `folder`."""
    write_mesh(scene.upper.mesh, folder / "upper.msh")
    write_mesh(scene.lower.mesh, folder / "lower.msh")
    (folder / "deck.xml").write_text(deck_text(deck_of(scene, method), "stress") + "\n")
