"""Two summaries (NAME.summary.json), or two tables (NAME.study.csv, NAME.cases.csv), compared leaf by leaf."""

import csv
import json
import re

import numpy

from .errors import UsageError
from .report import Report, Row
from .tolerance import EXACT, Tolerance, Tolerances

IGNORE = Tolerance("ignore")
# What differs from run to run and from machine to machine, or follows from that: round-off decides whether a stress is
# settled.
IGNORED = ("version", "build/*", "ranks", "*/seconds", "*/peak_bytes", "*/total_seconds", "ledger/counts/bytes written",
           "ledger/counts/settled stresses")
OF_A_CASE = "cases/*/results/"  # a summary of its own
OF_A_DECK = re.compile(r"(cases/.*/results/)?deck/")
SUMMARY_DEFAULTS = Tolerances(Tolerance("relative", 1e-9),
                              [(prefix + pattern, IGNORE) for pattern in IGNORED for prefix in ("", OF_A_CASE)])


def diff_summary(gold_path, new_path, tolerances=SUMMARY_DEFAULTS):
    """The report of all differences; raises UsageError for files that cannot be read."""
    report = Report()
    gold, new = ({path: leaf for path, leaf in leaves(read(file)) if tolerances.of(path).kind != "ignore"}
                 for file in (gold_path, new_path))
    # A parameter that only NEW's effective deck has is a new parameter at its default: no difference.
    report.missing("entry", gold, [path for path in new if path in gold or not OF_A_DECK.match(path)])
    for path in gold:
        if path in new:
            compare_leaf(path, gold[path], new[path], tolerances, report)
    return report


def read(path):
    parse, kind = (table, "a table") if str(path).endswith(".csv") else (json.load, "JSON")
    try:
        with open(path, encoding="utf-8", newline="") as file:
            tree = parse(file)
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror}") from None
    except (ValueError, csv.Error) as error:
        raise UsageError(f"{path}: is not {kind}: {error}") from None
    if not isinstance(tree, dict):
        raise UsageError(f"{path}: is JSON, but not a summary")
    return tree


def table(file):
    """case -> column -> number, text or, where the case has no such number, None; a table without cases, or with several probes
    of each, counts rows."""
    found = {}
    for number, row in enumerate(csv.DictReader(file), 1):
        case = str(number) if "probe" in row else row.pop("case", str(number))
        if case in found:
            raise ValueError(f"it has two rows of the case {case}")
        found[case] = {name: value_of(text) for name, text in row.items()}
    return found


def value_of(text):
    for kind in (int, float):
        try:
            return kind(text)
        except (TypeError, ValueError):  # TypeError: a row that is too long or too short
            pass
    return text or None


def leaves(node, path=""):
    """(path, value) of every leaf; entries of a list go by their "name", as in the quantities of the list Expect, or by
    their place where these are not all different."""
    if isinstance(node, dict) and node:
        entries = node.items()
    elif isinstance(node, list) and node:
        names = [entry.get("name", i) if isinstance(entry, dict) else i for i, entry in enumerate(node)]
        entries = zip(names if len(set(names)) == len(names) else range(len(node)), node)
    else:
        yield path, node
        return
    for key, value in entries:
        yield from leaves(value, f"{path}/{key}" if path else str(key))


def compare_leaf(path, gold, new, tolerances, report):
    """Numbers by their rule; whole numbers (counts), words and verdicts must be equal unless a rule names them."""
    numbers = all(isinstance(leaf, (int, float)) and not isinstance(leaf, bool) for leaf in (gold, new))
    if not numbers:
        if gold != new or isinstance(gold, bool) != isinstance(new, bool):
            report.rows.append(Row(path, "", gold, new, None, None, ""))
        return
    whole = isinstance(gold, int) and isinstance(new, int)
    tolerance = tolerances.named(path) or (EXACT if whole else tolerances.default)
    report.compare(path, tolerance, numpy.array([gold], float), numpy.array([new], float), abs(gold), lambda _: "")
