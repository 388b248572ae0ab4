"""Looks of all pictures: one colour map, one set of inks, SVG that follows the page's light or dark colours."""

import dataclasses
import io
import itertools
import math
import re

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402

FIELD_MAP = "viridis"
BODY_TINTS = ("#a6c8e0", "#f2c89b", "#b5d8b0", "#d9bfe0", "#e8b4b0", "#cfd3a4", "#b9c3d6", "#d8c3b0")


@dataclasses.dataclass(frozen=True)
class Inks:
    """Colours of lines and text. Those of a page are placeholders, which svg() turns into variables of its style."""

    text: str
    soft: str
    series: tuple

    def names(self):
        return {self.text: "ink", self.soft: "soft", **{c: f"c{i}" for i, c in enumerate(self.series, 1)}}


PAGE = Inks("#010203", "#010204", ("#010205", "#010206", "#010207", "#010208", "#010209"))
PAPER = Inks("#1b1f24", "#8a929b", ("#0063a6", "#c4500a", "#00795a", "#a8457f", "#7a6400"))

_numbers = itertools.count(1)


def settings(inks):
    return {
        "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans"], "font.size": 9.5, "axes.titlesize": 9.5,
        "axes.labelsize": 9.5, "xtick.labelsize": 8.5, "ytick.labelsize": 8.5, "legend.fontsize": 8.5,
        "text.color": inks.text, "axes.labelcolor": inks.text, "axes.titlecolor": inks.text, "axes.edgecolor": inks.soft,
        "xtick.color": inks.soft, "ytick.color": inks.soft, "xtick.labelcolor": inks.text, "ytick.labelcolor": inks.text,
        "grid.color": inks.soft, "grid.alpha": 0.25, "grid.linewidth": 0.5, "axes.linewidth": 0.7,
        "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "lines.linewidth": 1.4,
        "lines.markersize": 4.0, "svg.fonttype": "none", "svg.hashsalt": "ndframe", "axes.unicode_minus": True,
        "figure.facecolor": "none", "axes.facecolor": "none", "savefig.facecolor": "none", "axes.axisbelow": True,
        "axes.prop_cycle": matplotlib.cycler(color=inks.series), "figure.constrained_layout.use": True,
    }


def looks(inks=PAGE):
    """A context in which all figures are drawn."""
    return matplotlib.rc_context(settings(inks))


def svg(figure, label, inks=PAGE):
    """The figure as an SVG element for a page, and the figure closed. `label` is read to those who do not see it."""
    text = io.StringIO()
    figure.savefig(text, format="svg", dpi=220, metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
    body = text.getvalue()
    body = body[body.index("<svg"):]
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    for colour, name in inks.names().items():
        body = body.replace(colour, f"var(--{name})")
    body = re.sub(r"image-rendering:[^;\"]*;?", "", body)  # pixels as they are look rough at other sizes
    prefix = f"p{next(_numbers)}"
    body = re.sub(r'\bid="', f'id="{prefix}-', body)
    body = re.sub(r'(url\(#|href="#)', rf"\g<1>{prefix}-", body)
    width = float(re.search(r'width="([\d.]+)pt"', body)[1])
    body = re.sub(r'<svg ([^>]*?)width="[\d.]+pt"', r"<svg \1", body, count=1)
    body = re.sub(r'<svg ([^>]*?)height="[\d.]+pt"', r"<svg \1", body, count=1)
    return body.replace("<svg ", f'<svg role="img" aria-label="{escaped(label)}" style="width:{width * 4 / 3:.0f}px" ', 1)


def escaped(text):
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def power_label(value, _=None):
    """1, 10, 0.1, 10⁻³: without markup, which a page would show in another font."""
    if value <= 0.0:
        return ""
    if 0.0099 < value < 9999.0:
        return f"{value:g}"
    mantissa, exponent = f"{value:e}".split("e")
    mantissa = "" if float(mantissa) == 1.0 else f"{float(mantissa):g}·"
    return f"{mantissa}10{str(int(exponent)).translate(SUPERSCRIPTS)}"


def log_axis(axis):
    """`axis`: axes.xaxis or axes.yaxis, already logarithmic. A short one gets labels at 2 and 5, too."""
    low, high = sorted(axis.get_view_interval())
    decades = 99.0 if low <= 0.0 else math.log10(high / low)
    axis.set_major_locator(ticker.LogLocator(subs=(1.0,) if decades > 1.8 else (1.0, 2.0, 5.0), numticks=7))
    axis.set_major_formatter(ticker.FuncFormatter(power_label))
    axis.set_minor_formatter(ticker.NullFormatter())


def plain_axis(axis):
    """Few ticks, the common factor in the numbers themselves."""
    axis.set_major_locator(ticker.MaxNLocator(5))
    axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: number_label(value)))


def number_label(value):
    if value == 0.0 or 1e-3 <= abs(value) < 1e5:
        return f"{value:.5g}".replace("-", "−")
    mantissa, exponent = f"{value:.3e}".split("e")
    return f"{float(mantissa):g}·10{str(int(exponent)).translate(SUPERSCRIPTS)}".replace("-", "−")
