"""Formulas as MathML, which browsers typeset themselves: no script, no font and no picture is loaded.

docutils turns LaTeX into MathML. Where it does not know a command the build stops and names the formula.
"""

from docutils.utils.math import latex2mathml
from sphinx.errors import SphinxError


class WrongFormula(SphinxError):
    category = "Formula"


def mathml(text, inline):
    try:
        return latex2mathml.tex2mathml(text, inline=inline)
    except SyntaxError as error:
        raise WrongFormula(f"{error}: {text}") from None


def visit_inline(translator, node):
    translator.body.append(mathml(node.astext(), True))
    raise_skip()


def visit_block(translator, node):
    translator.body.append(f'<div class="formula">{mathml(node.astext().strip(), False)}</div>')
    raise_skip()


def raise_skip():
    from docutils.nodes import SkipNode
    raise SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    return {"parallel_read_safe": True}
