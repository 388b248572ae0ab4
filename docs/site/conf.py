"""Sphinx's settings for the documentation site; docs/site/build.py starts it. Nothing of the pages comes from a network."""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
from build import FONT

project = "ndframe"
release = re.search(r"project\(ndframe VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
copyright = re.search(r"Copyright \(c\) (.*)", (ROOT / "LICENSE").read_text())[1]
root_doc = "index"
extensions = ["myst_parser", "mathml"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
html_math_renderer = "mathml"
exclude_patterns = ["site", "paper/page.md"]
html_theme = "furo"
html_title = f"ndframe {release}"
html_theme_options = {"navigation_with_keys": True}
html_static_path = [str(HERE / "static"), str(FONT)]
html_css_files = ["site.css"]
html_copy_source = False
pygments_style = "default"
