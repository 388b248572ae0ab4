"""What regression/nddiff and regression/ndregress are made of. Reads results with the module ndframe."""

import pathlib
import sys

# Beside this folder where it is installed; elsewhere in the sources.
SOURCES = pathlib.Path(__file__).resolve().parents[2] / "python"
if SOURCES.is_dir():
    sys.path.append(str(SOURCES))
