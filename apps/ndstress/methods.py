"""The methods: what a user can choose for the same scene."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Method:
    """Lists of the deck, and what it changes in the scene (fields of scenes.Scene)."""
    lists: dict
    scene: dict = dataclasses.field(default_factory=dict)


def sweeps(relaxation, **more):
    return {"Coupling": {"Type": "Neumann-Dirichlet", "Relaxation": relaxation,
                         "Stopping": {"Tolerance": 1e-9, "Maximum Sweeps": 500}, **more}}


AITKEN = sweeps({"Type": "Aitken"})
MONOLITHIC = {"Coupling": {"Type": "Monolithic"}}
CERTIFICATE = {"Error Estimation": {"Estimators": ["Global", "Algorithm", "Discretization", "Reference"],
                                    "Check Equilibrium": True, "Reference": {"Refinements": 1}}}

METHODS = {
    "Constant": Method(sweeps({"Type": "Constant", "Theta": 0.5})),
    "Aitken": Method(AITKEN),
    "Monolithic": Method(MONOLITHIC),
    "roles chosen": Method(sweeps({"Type": "Aitken"}, **{"Dirichlet Body": "Automatic"})),
    "roles swapped": Method(AITKEN, {"swapped": True}),
    "degree 1": Method(MONOLITHIC, {"order": 1}),
    "Mumps": Method({**MONOLITHIC, "Linear Solver": {"Type": "Mumps"}}),
    "Krylov": Method({**MONOLITHIC, "Linear Solver": {"Type": "Krylov"}}),
    "certified": Method({**AITKEN, **CERTIFICATE}),
}
SHORT_METHODS = ("roles chosen", "Monolithic", "certified")
