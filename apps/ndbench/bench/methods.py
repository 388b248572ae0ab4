"""The methods: what a user can choose for the same scene, as settings of the deck."""

import dataclasses

THETA = "Coupling/Relaxation/Type=Constant"
MONOLITHIC = "Coupling/Type=Monolithic"
CERTIFIED = "Error Estimation/Estimators={Global}"


def stopped_at(tolerance):
    return f"Coupling/Stopping/Tolerance={tolerance}"


@dataclasses.dataclass(frozen=True)
class Method:
    """Settings of the deck, on meshes that it names: a size is the number of cells along the interface."""

    name: str
    settings: tuple
    order: int = 2
    contact_only: bool = False  # differs from others only where bodies touch; plane scenes (truth.py)
    levels: int = 99  # on how many of a scene's sizes it is run: for methods that take minutes on the finer ones
    leave_out: tuple = ()  # scenes on which it takes minutes on every size
    joins_solids: bool = True  # likewise

    def fits(self, scene):
        if scene.joins_solids and not self.joins_solids:
            return False
        return scene.name not in self.leave_out and not (self.contact_only and (scene.alone or scene.dim == 3))

    def sizes(self, scene):
        """First-order elements get twice the cells: the same nodes, hence about the same dofs."""
        return tuple(2 * n if self.order == 1 else n for n in scene.sizes[: self.levels])

    def on(self, scene, size):
        return (*scene.on(size), *self.settings)

    def yardstick(self, scene, size):
        """Settings of the run of the libraries alone; None without a mesh that is given, and for solids in contact,
        whose factors take minutes and ten times the memory. Methods of one scene, size and order share the matrix."""
        return None if scene.joins_solids else (*scene.on(size), f"Discretization/Order={self.order}")

    def words(self, size):
        return f"{size} cells"


class Adaptive(Method):
    """An accuracy instead of a mesh: a size is a target, and the bound is part of it."""

    def fits(self, scene):
        return bool(scene.targets)

    def sizes(self, scene):
        return scene.targets

    def on(self, scene, size):
        return (*scene.settings, *self.settings, f"Accuracy/Target={size!r}")

    def yardstick(self, scene, size):
        return None

    def words(self, size):
        return f"target {100 * size:g} %"


ALL_AT_ONCE = Method("monolithic", (MONOLITHIC,))
ALL_AT_ONCE_CERTIFIED = Method("monolithic, certified", (MONOLITHIC, CERTIFIED))
AITKEN = Method("Aitken to 1e-4", ("Coupling/Relaxation/Type=Aitken", stopped_at("1e-4")), contact_only=True)
ADAPTIVE = Adaptive("adaptive, certified", ())

METHODS = (
    ALL_AT_ONCE,
    Method("monolithic, order 1", (MONOLITHIC, "Discretization/Order=1"), order=1),
    Method("monolithic, Mumps", (MONOLITHIC, "Linear Solver/Type=Mumps"), joins_solids=False),
    Method("monolithic, Krylov", (MONOLITHIC, "Linear Solver/Type=Krylov"), levels=3, leave_out=("hertz",),
           joins_solids=False),
    ALL_AT_ONCE_CERTIFIED,
    Method("theta 0.5 to 1e-4", (THETA, stopped_at("1e-4")), contact_only=True),
    AITKEN,
    Method("theta 0.5 to 0.1, certified", (THETA, stopped_at("0.1"), CERTIFIED), contact_only=True),
    ADAPTIVE,
)

# What solids in contact are solved by: uniform meshes beside a target.
OF_SOLIDS = (ALL_AT_ONCE, ALL_AT_ONCE_CERTIFIED, ADAPTIVE)
