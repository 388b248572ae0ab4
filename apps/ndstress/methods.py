"""The methods: what a user can choose for the same scene."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Method:
    """Lists of the deck, what it changes in the scene (fields of scenes.Scene), and on how many ranks it runs."""
    lists: dict
    scene: dict = dataclasses.field(default_factory=dict)
    ranks: int = 1


def sweeps(relaxation, **more):
    return {"Coupling": {"Type": "Neumann-Dirichlet", "Dirichlet Body": "As Given", "Relaxation": relaxation,
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
# The other degree and several ranks with the methods above: for some values of the rows that ask for them.
VARIANTS = {
    "degree 1, Aitken": Method(AITKEN, {"order": 1}),
    "degree 1, certified": Method({**AITKEN, **CERTIFICATE}, {"order": 1}),
    "2 ranks": Method(AITKEN, ranks=2),
    "2 ranks, degree 1": Method(MONOLITHIC, {"order": 1}, ranks=2),
    "3 ranks, certified": Method({**AITKEN, **CERTIFICATE}, ranks=3),
}
SHORT_VARIANTS = ("degree 1, certified", "2 ranks")
