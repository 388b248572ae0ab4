"""Figures 5 to 9 of the paper: ours filled, the paper's printed numbers hollow."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy
from matplotlib.colors import LogNorm

from scenes import PRINTED, PUNCH

SERIES = {"glob": "global bound", "dis": "discretisation", "nda": "iteration", "e_ref": "reference error"}
MAPS = ("Error Estimation/Estimators={Global, Discretization}", "Error Estimation/Recovery/Degree=3")


def save(figure, path):
    figure.savefig(path, dpi=110, bbox_inches="tight", metadata={"Software": None})
    plt.close(figure)


def column(rows, name):
    return [line[name] for line in rows]


def gamma(rows, path):
    figure, axes = plt.subplots(figsize=(6, 4))
    printed = PRINTED["table1"]
    papers = numpy.divide(printed["glob"], printed["e_ref"])
    axes.semilogx(printed["ndof"], papers, "o--", color="gray", markerfacecolor="white", label="paper")
    for name, mark, label in (("gamma", "o-", "Optimal traction"), ("gamma_projected", "s-", "Projected traction (the paper's)")):
        axes.semilogx(column(rows, "ndof"), column(rows, name), mark, label=label)
    axes.axhline(1, color="black", linewidth=0.8)
    axes.set(xlabel="degrees of freedom", ylabel=r"$\gamma = \eta^{glob} / e_{ref}$", ylim=(0.95, 1.25))
    axes.grid(alpha=0.3)
    axes.legend()
    save(figure, path)


def errors(rows, path):
    figure, axes = plt.subplots(figsize=(6, 4.5))
    printed = PRINTED["table1"]
    for index, (name, label) in enumerate(SERIES.items()):
        axes.loglog(printed["ndof"], printed[name], "o--", color=f"C{index}", markerfacecolor="white", linewidth=0.8)
        axes.loglog(column(rows, "ndof"), column(rows, name), "o-", color=f"C{index}", label=label)
    axes.set(xlabel="degrees of freedom", ylabel="error in % of the solution's energy norm", title="dashed: printed in the paper")
    axes.set_yticks([1, 2, 5, 10], ["1", "2", "5", "10"])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend()
    save(figure, path)


def draw_map(axes, run, name, norm, limits):
    for points, triangles, values in run.bodies(name):
        drawn = axes.tripcolor(
            *points, triangles, 100 * values / norm, norm=LogNorm(*limits), cmap="viridis", edgecolors="white", linewidth=0.15
        )
    axes.axhline(0, color="red", linewidth=0.6)
    axes.set(aspect="equal", xlabel="x", ylabel="y")
    return drawn


def maps(ndframe, shown, path):
    """`shown`: (title, run, field) for each panel; one colour scale, the same in figures 7 and 9."""
    figure, panels = plt.subplots(1, len(shown), figsize=(5 * len(shown), 4.6), squeeze=False, constrained_layout=True)
    for axes, (title, run, name) in zip(panels[0], shown):
        drawn = draw_map(axes, run, name, PUNCH.norm(ndframe), (0.01, 1))
        axes.set_title(title)
    figure.colorbar(drawn, ax=panels[0], shrink=0.9, extend="both", label="contribution of the element, % of the solution")
    save(figure, path)


def nodal_forces(run):
    """Positions, forces and pressures of the contact nodes: the forces int psi_i t_neu that act on the foundation."""
    x, traction = run.contact["x"], run.contact["traction_neumann"]
    # int psi_i psi_j over a quadratic edge of length 1.
    mass = numpy.array([[4, 2, -1], [2, 16, 2], [-1, 2, 4]]) / 30
    forces = numpy.zeros_like(x)
    for first in range(0, len(x) - 1, 2):
        edge = slice(first, first + 3)
        forces[edge] -= (x[first + 2] - x[first]) * mass @ traction[edge]
    return x, forces, -traction


def contact_forces(runs, path):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True)
    for (label, run), mark in zip(runs.items(), "os^"):
        x, forces, pressure = nodal_forces(run)
        (line,) = left.plot(x[1::2], forces[1::2], mark + "-", markersize=5, linewidth=0.8, label=f"{label}, sum {forces.sum():.4f}")
        left.plot(x[::2], forces[::2], mark + ":", markersize=5, linewidth=0.8, color=line.get_color(), markerfacecolor="white")
        right.plot(x, pressure, mark + "-", markersize=4, linewidth=0.8, label=label)
    left.set(xlabel="x", ylabel="nodal force on the foundation", ylim=(0, None), title="filled: middle of an edge, hollow: vertex")
    right.set(xlabel="x", ylabel="contact pressure / load", ylim=(0, None), title="the same as pressure (load 1)")
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend()
    save(figure, path)


def draw_all(ndframe, tables, folder, cells):
    gamma(tables["table1"], folder / "figure5.png")
    errors(tables["table1"], folder / "figure6.png")
    loose = PUNCH.run(ndframe, cells, *MAPS)
    tight = PUNCH.run(ndframe, cells, *MAPS, "Coupling/Stopping/Tolerance=0.01")
    monolithic = PUNCH.run(ndframe, cells, "Coupling/Type=Monolithic")
    five, more = "five sweeps", f"eps_tau < 0.01 ({tight.summary['coupling']['sweeps']} sweeps)"
    maps(ndframe, [(f"global bound, {five}", loose, "eta_glob"), (f"discretisation, {five}", loose, "eta_dis")], folder / "figure7.png")
    maps(ndframe, [("global bound, eps_tau < 0.01", tight, "eta_glob")], folder / "figure9.png")
    contact_forces({five: loose, more: tight, "Monolithic": monolithic}, folder / "figure8.png")
