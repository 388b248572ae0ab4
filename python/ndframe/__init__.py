"""Runs of ndframe and their results, as numpy arrays.

    import ndframe

    run = ndframe.run("decks/bearing.xml", {"Accuracy/Target": 0.01}, folder="results")
    run = ndframe.read("results/bearing")           # the same later, without running it again
    print(run.bound.relative, run.interfaces["contact"]["largest_pressure"])
    side = run.contact["contact"]                   # column -> [nodes]
    matplotlib.pyplot.plot(side["arc_length"], side["pressure"])

Everything is in the deck's units, and in plane scenes for a slice of thickness 1. docs/python.md has an example that draws; docs/results.md
and docs/summary.schema.json name everything that is in the files. Needs netCDF4 for Python (Debian: python3-netcdf4).
"""

from .deck import deck_text
from .errors import Error, ReadError, RunError
from .exodus import Exodus
from .fields import Fields
from .program import find_program, run, run_cases, run_study
from .results import Bound, Case, LoadCases, Run, Study, read

__all__ = ["Bound", "Case", "Error", "Exodus", "Fields", "LoadCases", "ReadError", "Run", "RunError", "Study", "deck_text",
           "find_program", "read", "run", "run_cases", "run_study"]
