"""How much two numbers may differ: one rule a variable, chosen by a pattern of names."""

import dataclasses
import fnmatch
import math
import tomllib

import numpy

from .errors import UsageError

RULES = """\
A rule is one of
  absolute T    |gold - new| <= T
  relative T    |gold - new| <= T max(|gold|, |new|)
  scaled T      |gold - new| <= T S, where S is the largest |gold| of the variable in all steps and places; the
                components of one vector or tensor (disp_x, disp_y; stress_xx, stress_xy, ...) share S
  ignore        anything goes, a missing value too
and may end in `floor F`: values that are both smaller than F in magnitude are equal. absolute, relative and floor mean
what they mean to exodiff; NaN equals NaN and nothing else.
"""


@dataclasses.dataclass(frozen=True)
class Tolerance:
    """One rule; `kind` is absolute, relative, scaled or ignore."""

    kind: str
    value: float = 0.0
    floor: float = 0.0

    def allowed(self, gold, new, scale):
        """The largest |gold - new| that is no difference, place by place; `scale` is what `scaled` refers to."""
        larger = numpy.maximum(numpy.abs(gold), numpy.abs(new))
        size = {"absolute": 1.0, "relative": larger, "scaled": scale, "ignore": math.inf}[self.kind]
        return numpy.where(larger < self.floor, math.inf, self.value * size if self.kind != "ignore" else math.inf)


EXACT = Tolerance("absolute", 0.0)


class Tolerances:
    """Rules by patterns of names (`*` and `?`); of those that match a name the last one holds."""

    def __init__(self, default, rules=()):
        self.default = default
        self.rules = list(rules)

    def with_rules(self, rules):
        """Copy with more rules, which come after those here; the pattern `default` replaces the default."""
        default = next((rule for pattern, rule in reversed(rules) if pattern == "default"), self.default)
        return Tolerances(default, self.rules + [entry for entry in rules if entry[0] != "default"])

    def named(self, name):
        """The rule that a pattern gives to this name, None if there is none."""
        return next((rule for pattern, rule in reversed(self.rules) if fnmatch.fnmatchcase(name, pattern)), None)

    def of(self, name):
        return self.named(name) or self.default


def parse_rule(text):
    """(pattern, rule) from `PATTERN=relative 1e-8 floor 1e-12`."""
    pattern, _, rule = text.rpartition("=")
    words = rule.split()
    if not pattern or not words:
        raise UsageError(f'"{text}" is not a rule; write e.g. --set "disp_*=relative 1e-8 floor 1e-12"')
    entries = {"ignore": True} if words[0] == "ignore" else {}
    words = words[1:] if entries else words
    if len(words) % 2:
        raise UsageError(f'"{text}": every word of a rule is followed by a number, except ignore')
    return pattern, rule_of(entries | dict(zip(words[::2], words[1::2])), text)


def rule_of(entries, where):
    """A rule from its words and numbers, e.g. {"relative": 1e-8, "floor": 1e-12}."""
    kinds = [word for word in entries if word != "floor"]
    if len(kinds) != 1 or kinds[0] not in ("absolute", "relative", "scaled", "ignore"):
        raise UsageError(f"{where}: a rule is one of absolute, relative, scaled, ignore, with a floor if wanted")
    numbers = {word: positive(value, f"{where}: {word}") for word, value in entries.items() if word != "ignore"}
    return Tolerance(kinds[0], numbers.get(kinds[0], 0.0), numbers.get("floor", 0.0))


def positive(value, where):
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not number >= 0:
        raise UsageError(f"{where} = {value} is not a number >= 0")
    return number


def rules_of(table, where):
    """[(pattern, rule), ...] from a TOML table of rules, in its order."""
    for pattern, entries in table.items():
        if not isinstance(entries, dict):
            raise UsageError(f'{where}: "{pattern}" needs a rule such as {{ relative = 1e-8 }}')
    return [(pattern, rule_of(entries, f"{where}: {pattern}")) for pattern, entries in table.items()]


def read_toml(path):
    try:
        with open(path, "rb") as file:
            return tomllib.load(file)
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise UsageError(f"{path}: {error}") from None


def tables_of(table, where):
    """The rules of a TOML table with the tables `exodus` and `summary`."""
    unknown = set(table) - {"exodus", "summary"}
    if unknown or not all(isinstance(entry, dict) for entry in table.values()):
        found = ", ".join(unknown) or "values"
        raise UsageError(f"{where}: rules belong in the tables exodus and summary, not in {found}")
    return {kind: rules_of(table.get(kind, {}), f"{where}: {kind}") for kind in ("exodus", "summary")}
