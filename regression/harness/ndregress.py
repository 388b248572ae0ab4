"""The program ndregress: options, choice of cases, lines on the screen."""

import argparse
import collections
import concurrent.futures
import difflib
import fnmatch
import os
import pathlib
import shutil
import sys
import tempfile
import time

from .bless import bless
from .case import read_cases
from .errors import Error, UsageError
from .junit import write_junit
from .run_case import Runner
from .tolerance import read_toml, tables_of

DESCRIPTION = """\
Runs regression cases and compares what they write with their gold files. One line per run: result, seconds,
name, requirement. Exit codes: 0 all right, 1 a case failed, 2 wrong usage."""


def parse(arguments, root):
    parser = argparse.ArgumentParser("ndregress", description=DESCRIPTION,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", metavar="NAME", nargs="*", help="cases, * and ? allowed; all if none is named")
    parser.add_argument("--label", metavar="L", action="append", default=[],
                        help="only cases with this label; may be repeated")
    parser.add_argument("-j", "--jobs", metavar="N", type=int, default=1, help="runs at the same time (1)")
    ranks = parser.add_mutually_exclusive_group()
    ranks.add_argument("--np", metavar="N", type=int, help="only the runs on N ranks")
    ranks.add_argument("--ranks", metavar="N", type=int, help="every case on N ranks, whatever it says")
    parser.add_argument("--program", metavar="[NAME=]FILE", action="append", default=[],
                        help="ndframe, or the program NAME that a case asks for (installed: beside ndregress; in a clone: build/release/bin/ndframe)")
    parser.add_argument("--keep", metavar="FOLDER", type=pathlib.Path,
                        help="where outputs of failures go (a temporary folder)")
    parser.add_argument("--bless", action="store_true", help="show what changed, then rewrite gold of the cases named")
    parser.add_argument("--junit", metavar="FILE", help="write the results as JUnit XML")
    parser.add_argument("--list", action="store_true", help="show the cases, run nothing")
    parser.add_argument("--timeout", metavar="S", type=float, default=120.0, help="seconds that a run may take (120)")
    parser.add_argument("--cases", metavar="FOLDER", type=pathlib.Path, default=root / "cases",
                        help="where the cases are")
    return parser.parse_args(arguments)


def choose(cases, names, labels):
    """The cases that match a name (all without names) and have a label (any without labels)."""
    for name in names:
        if not fnmatch.filter(cases, name):
            near = difflib.get_close_matches(name, cases, 1)
            hint = f'did you mean "{near[0]}"?' if near else "--list shows them"
            raise UsageError(f'there is no case "{name}"; {hint}')
    known = sorted({label for case in cases.values() for label in case.labels})
    for label in set(labels) - set(known):
        raise UsageError(f'no case has the label "{label}"; labels are {", ".join(known)}')
    return [case for name, case in cases.items()
            if (not names or any(fnmatch.fnmatchcase(name, pattern) for pattern in names))
            and (not labels or set(labels) & set(case.labels))]


def find_programs(given, ndframe):
    """Name -> file."""
    programs = {"ndframe": ndframe}
    for text in given:
        name, equals, path = text.partition("=")
        programs |= {name: pathlib.Path(path)} if equals else {"ndframe": pathlib.Path(text)}
    for name, path in programs.items():
        if not (path.is_file() and os.access(path, os.X_OK)):
            raise UsageError(f"{path} is not a program; say where {name} is: --program {name}=FILE")
    return {name: str(path.resolve()) for name, path in programs.items()}


def read_rules(path):
    table = read_toml(path)
    ranks = tables_of(table.pop("ranks", {}), f"{path}: ranks")
    return tables_of(table, path) | {"ranks": ranks}


def show_list(cases):
    width = max(len(case.name) for case in cases)
    for case in cases:
        print(f"{case.name:{width}}  {case.requirement}  [{', '.join(case.labels)}]")
    print(f"{len(cases)} cases")


def run_all(runner, cases, options):
    """Runs side by side; lines in the order of the cases."""
    if options.ranks is not None and options.ranks < 1:
        raise UsageError("--ranks is at least 1")
    runs = [(case, ranks) for case in cases for ranks in ([options.ranks] if options.ranks else case.np)
            if options.np in (None, ranks)]
    if not runs:
        raise UsageError(f"none of these cases runs on {options.np} ranks")
    if any(ranks > 1 for _, ranks in runs) and not shutil.which("mpirun"):
        raise UsageError("there is no mpirun on the path; --np 1 leaves out the runs on several ranks")
    start = time.monotonic()
    results = []
    with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
        for result in pool.map(lambda run: runner.run(*run), runs):
            results.append(result)
            print(f"{result.status:10} {result.seconds:6.2f} s  {result.name:28}  {result.case.requirement}")
            print("".join(f"    {line}\n" for line in result.details.splitlines()), end="", flush=True)
    counts = collections.Counter(result.status for result in results)
    print(f"\n{len(cases)} cases, {len(runs)} runs: " + ", ".join(f"{n} {status}" for status, n in counts.items())
          + f"   {time.monotonic() - start:.1f} s")
    return results


def conclude(results, work, options):
    """Writes what is asked for, says where outputs are; the exit code."""
    if options.junit:
        write_junit(options.junit, results)
    failed = [result.name for result in results if result.failed]
    if failed:
        print(f"outputs of failures: {work}/NAME for {', '.join(failed)}")
    return 1 if failed else 0


def carry_out(options, root, ndframe):
    # Runs have folders of their own, where relative names would mean something else.
    cases = choose(read_cases(options.cases.resolve()), options.names, options.label)
    if options.list:
        show_list(cases)
        return 0
    if options.bless and not options.names:
        raise UsageError("--bless rewrites gold: name the cases that it is for")
    programs, rules = find_programs(options.program, ndframe), read_rules(root / "tolerances.toml")
    work = (options.keep or pathlib.Path(tempfile.mkdtemp(prefix="ndregress-"))).resolve()
    runner = Runner(programs, rules, work, options.timeout)
    try:
        if options.bless:
            return 0 if all([bless(runner, case, print) for case in cases]) else 1
        return conclude(run_all(runner, cases, options), work, options)
    finally:
        if work.is_dir() and not any(work.iterdir()):
            shutil.rmtree(work)


def main(root, ndframe, arguments=None):
    """`root`: the folder with cases/ and tolerances.toml; `ndframe`: the program that is run unless --program names another."""
    try:
        return carry_out(parse(arguments, root), root, ndframe)
    except Error as error:
        print(f"ndregress: {error}", file=sys.stderr)
        return 2
