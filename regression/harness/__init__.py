"""What regression/nddiff and regression/ndregress are made of. Reads results with the module ndframe."""

import pathlib
import sys

# The module's folder: python in the sources, share/ndframe of an installation.
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "python" if (ROOT / "python").is_dir() else ROOT))
