"""What the regression cases protect, all of it: test_cases.py REGRESSION NDFRAME."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

REGRESSION, NDFRAME = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
sys.path.insert(0, str(REGRESSION))

from harness.case import read_cases  # noqa: E402


def ask(option):
    return subprocess.run([NDFRAME, option], check=True, capture_output=True, text=True).stdout


def components():
    """(list of the deck with * for names, component) of all that are registered, from `ndframe --list`."""
    found, where = set(), None
    for line in ask("--list").splitlines():
        if line.startswith("  "):
            found.add((where, re.split(r"  +", line.strip())[0]))
        elif line:
            where = line.strip()
    return found


def chosen(node, path=()):
    """(list, component) of every list of an effective deck that has a Type."""
    if isinstance(node, dict):
        if "Type" in node:
            yield path, node["Type"]
        for key, value in node.items():
            yield from chosen(value, (*path, key))


def stands_for(pattern, path):
    """Whether a list such as Bodies/*/Mesh describes a list of a deck. Parts of a mesh are made of what meshes are."""
    words = pattern.replace("/Mesh/Parts/*", "/Mesh").split("/")
    return len(words) == len(path) and all(word in ("*", name) for word, name in zip(words, path))


class Cases(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cases = read_cases(REGRESSION / "cases")
        cls.decks = [json.loads(path.read_text())["deck"] for path in REGRESSION.glob("cases/*/gold.summary.json")]

    def test_every_component_is_in_a_case(self):
        used = [entry for deck in self.decks for entry in chosen(deck)]
        known = components()
        self.assertGreater(len(known), 20, "ndframe --list was read")
        missing = {(where, name) for where, name in known
                   if not any(name == other and stands_for(where, path) for path, other in used)}
        self.assertEqual(missing, set())

    def test_every_estimator_is_in_a_case(self):
        row = next(line for line in ask("--reference").splitlines() if line.startswith("| `Estimators`"))
        estimators = {word.strip() for word in row.split(" | ")[3].split("\\|")}
        self.assertGreater(len(estimators), 5, row)
        used = {name for deck in self.decks for name in deck.get("Error Estimation", {}).get("Estimators", [])}
        self.assertEqual(estimators - used, set())

    def test_every_exit_code_is_in_a_case(self):
        codes = {int(code) for code in re.findall(r"(?:: |, )(\d) ", re.search("Exit codes: .*", ask("--help"))[0])}
        self.assertEqual(codes, {0, 1, 2, 3, 4, 5, 6})
        self.assertEqual({case.exit for case in self.cases.values()}, codes)

    def test_every_failure_has_its_message(self):
        self.assertEqual([name for name, case in self.cases.items() if case.exit != 0 and not case.message], [])

    def test_every_case_protects_something_else(self):
        requirements = [case.requirement for case in self.cases.values()]
        self.assertGreaterEqual(len(requirements), 25)
        self.assertEqual(len(set(requirements)), len(requirements))
        self.assertEqual([name for name, case in self.cases.items() if not case.labels], [])

    def test_cases_read_only_what_is_installed_with_them(self):
        outside = [(path.name, name) for path in REGRESSION.glob("cases/*/*.xml") for name in re.findall(r'value="(\.\./[^"]*)"', path.read_text())
                   if not name.startswith("../../../decks/")]
        self.assertEqual(outside, [])

    def test_cases_are_small(self):
        sizes = {str(path): path.stat().st_size for path in REGRESSION.glob("cases/*/*")}
        self.assertEqual([path for path, size in sizes.items() if size > 110_000], [])
        self.assertLess(sum(sizes.values()), 3_400_000)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
