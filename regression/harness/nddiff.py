"""The program nddiff: its options, and how it chooses what to compare."""

import argparse
import sys

from .contact_diff import diff_contact
from .errors import Error
from .exodus_diff import EXODUS_DEFAULTS, diff_exodus
from .summary_diff import IGNORED, SUMMARY_DEFAULTS, diff_summary
from .tolerance import RULES, parse_rule, read_toml, tables_of

DESCRIPTION = ("Compares two Exodus files, NAME.summary.json, NAME.study.csv, NAME.cases.csv or NAME.contact.csv of "
               "ndframe.")

EPILOG = f"""\
Exodus files: blocks, side sets, node sets (by their names; ids, statuses and truth tables too), steps, coordinates and
all variables. Where nodes or elements are numbered differently, as by another partition, they are matched by position;
an element may begin at another corner, but not be turned inside out. Rules apply to names of variables, and to
`coordinates` and `time`; without one: scaled 1e-9.

Contact tables (files ending in contact.csv): rows are matched by interface and position, columns have the rules of an
Exodus file; u_dirichlet, u_neumann and gap have one scale, so have the tractions.

Summaries (files ending in .json): every leaf, by its path, e.g. interfaces/contact/contact_force. Numbers without a
rule: relative 1e-9; words, verdicts and whole numbers such as the ledger's counts must be equal. Ignored:
  {', '.join(IGNORED)};
parameters that only NEW's effective deck has. A study's table is compared like a summary, by the number of the case and
the name of the column, e.g. 3/energy; any other table (.csv) by the number of the row.

{RULES}
The patterns know * and ?; the last one that matches a name holds, options after the file. A file of rules is TOML:
  [exodus]
  default = {{ scaled = 1e-9, floor = 1e-14 }}
  "disp_*" = {{ relative = 1e-6, floor = 1e-12 }}
  [summary]
  "ledger/counts/*" = {{ ignore = true }}

Exit codes: 0 the same, 1 different, 2 wrong usage or a file that cannot be read.
"""


def differ(gold, new, rules):
    """The report on two files; `rules` has lists under `exodus` and `summary` that follow the defaults."""
    if str(gold).endswith("contact.csv"):
        return diff_contact(gold, new, EXODUS_DEFAULTS.with_rules(rules["exodus"]))
    if str(gold).endswith((".json", ".csv")):
        return diff_summary(gold, new, SUMMARY_DEFAULTS.with_rules(rules["summary"]))
    return diff_exodus(gold, new, EXODUS_DEFAULTS.with_rules(rules["exodus"]))


def parse(arguments):
    parser = argparse.ArgumentParser("nddiff", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gold", metavar="GOLD", help="the reference")
    parser.add_argument("new", metavar="NEW", help="the file to be compared with it")
    parser.add_argument("--tolerances", metavar="FILE", help="rules, TOML")
    parser.add_argument("--set", metavar="PATTERN=RULE", action="append", default=[],
                        help='one more rule, e.g. "disp_*=relative 1e-8 floor 1e-12"; `default` is for all others')
    parser.add_argument("--worst", metavar="N", type=int, default=20, help="length of the table (20)")
    parser.add_argument("-q", "--quiet", action="store_true", help="no table; the exit code alone")
    return parser.parse_args(arguments)


def main(arguments=None):
    options = parse(arguments)
    try:
        rules = tables_of(read_toml(options.tolerances) if options.tolerances else {}, options.tolerances)
        for text in options.set:
            rule = parse_rule(text)
            rules = {kind: [*entries, rule] for kind, entries in rules.items()}
        report = differ(options.gold, options.new, rules)
    except Error as error:
        print(f"nddiff: {error}", file=sys.stderr)
        return 2
    if not options.quiet:
        verdict = "the same" if report.same() else "DIFFERENT"
        print("\n".join(filter(None, [f"{verdict}: {options.gold} {options.new}", report.text(options.worst)])))
    return 0 if report.same() else 1
