"""The scenes: decks of this project on meshes of any size, and the graded meshes of their references."""

import dataclasses
import pathlib
import typing

ROOT = pathlib.Path(__file__).resolve().parents[3]
GRADED = pathlib.Path(__file__).resolve().parents[1] / "references"


NO_TABLE = "Output/Contact Table=false"


def no_gap(_):
    return 0.0


@dataclasses.dataclass(frozen=True)
class Scene:
    """A deck whose meshes follow from n, the cells along the interface (across the beam).

    The supports of every scene prescribe zero, which the true error relies on (truth.py). Solids in contact without a gap
    write no contact table: it relies on complementary contact there.
    """

    name: str
    meshes: typing.Callable  # n -> settings
    finest: typing.Callable  # level 0, 1, 2 -> settings of the graded meshes that make the reference
    sizes: tuple  # cells for second-order elements, coarse to fine; the first two are the short form
    targets: tuple = ()  # relative errors of runs with a target, likewise
    settings: tuple = ()
    gap: typing.Callable = no_gap  # x -> the deck's gap on the interface
    alone: bool = False  # one body, no interface
    dim: int = 2

    @property
    def deck(self):
        return ROOT / "decks" / f"{self.name}.xml"

    @property
    def joins_solids(self):
        return self.dim == 3 and not self.alone

    def on(self, n):
        return (*self.settings, *self.meshes(n))


def cells(body, *numbers):
    return f"Bodies/{body}/Mesh/Cells={{{', '.join(str(round(number)) for number in numbers)}}}"


def gmsh(scene, *bodies):
    """Settings that put `bodies` on the graded mesh of `scene`; every level halves the triangles' sides."""

    def meshes(level):
        for body in bodies:
            yield f"Bodies/{body}/Mesh/Type=Gmsh"
            yield f"Bodies/{body}/Mesh/File={GRADED / scene}.geo"
            yield f"Bodies/{body}/Mesh/Regions={{{body}}}"
            yield f"Bodies/{body}/Mesh/Mesh Size Factor={0.5 ** level}"
        yield "Interfaces/contact/Dirichlet Side=contact"
        yield "Interfaces/contact/Neumann Side=contact"

    return meshes


def to_target(level):
    """The meshes of runs with a target."""
    yield f"Accuracy/Target={(0.02, 0.009, 0.0045)[level]}"


def graded_beam(level):
    """Cells get finer towards the clamped end and, across, towards the edges."""
    yield cells("beam", *((8, 4, 4), (12, 8, 6), (20, 14, 10))[level])
    for axis, at, size in (("X", "0.0, 4.0", "0.01, 1.0"), ("Y", "-0.5, 0.0, 0.5", "0.1, 1.0, 0.1"),
                           ("Z", "-0.25, 0.0, 0.25", "0.1, 1.0, 0.1")):
        yield f"Bodies/beam/Mesh/Cell Sizes {axis}/At={{{at}}}"
        yield f"Bodies/beam/Mesh/Cell Sizes {axis}/Size={{{size}}}"


SCENES = (
    Scene("punch", lambda n: (cells("punch", n, n), cells("foundation", 2 * n, n)),
          gmsh("punch", "punch", "foundation"), (4, 8, 16, 32, 64, 128), (0.05, 0.01, 0.00455, 0.001, 1e-4)),
    Scene("contact-loss", lambda n: (cells("upper", n, 0.8 * n), cells("lower", 2 * n, 2 * n)),
          gmsh("contact-loss", "upper", "lower"), (6, 10, 20, 40, 80), (0.05, 0.01, 0.005, 0.001)),
    Scene("hertz", lambda n: (cells("cylinder", n, n / 2), cells("block", n, n / 2)),
          gmsh("hertz", "cylinder", "block"), (12, 24, 48, 96, 192), (0.05, 0.01, 0.005, 0.001),
          gap=lambda x: 0.5 * x * x),
    # Not the deck's own support, which prescribes the exact solution: a clamp, where the stress is singular.
    Scene("beam-3d", lambda n: (cells("beam", 4 * n, n, n / 2),), graded_beam, (2, 4, 8, 12),
          settings=("Bodies/beam/Supports/root/Type=Clamp", "Bodies/beam/Supports/root/Side=left"), alone=True, dim=3),
    Scene("punch-3d", lambda n: (cells("punch", n, n, n), cells("foundation", 2 * n, 2 * n, n)), to_target,
          (4, 6, 8, 12, 16), (0.1, 0.05, 0.02, 0.01), settings=(NO_TABLE,), dim=3),
    Scene("contact-loss-3d", lambda n: (cells("upper", n, n, n / 2), cells("lower", 2 * n, 2 * n, n)), to_target,
          (4, 6, 8, 12, 16), (0.1, 0.05, 0.02, 0.01), settings=(NO_TABLE,), dim=3),
    Scene("hertz-3d", lambda n: (cells("sphere", n, n, 0.8 * n), cells("block", n, n, 0.8 * n)), to_target,
          (5, 8, 10, 14, 20), (0.1, 0.05, 0.02, 0.01), dim=3),
)
