"""ndregress with a program that does as its deck says: test_ndregress.py REGRESSION."""

import json
import os
import pathlib
import sys
import textwrap
import unittest
import xml.etree.ElementTree as ElementTree

REGRESSION = pathlib.Path(sys.argv[1]).resolve()
sys.path[:0] = [str(REGRESSION), str(pathlib.Path(__file__).parent)]

from called import Called  # noqa: E402
from harness.ndregress import main  # noqa: E402
from small_exodus import SmallExodus  # noqa: E402

# Writes the summary that the deck contains, says and returns what the other arguments ask for.
PROGRAM = """\
    #!/usr/bin/python3
    import pathlib, sys, time
    deck = pathlib.Path(sys.argv[sys.argv.index("-i") + 1])
    for argument in sys.argv[3:]:
        word, _, value = argument.partition("=")
        if word == "--say":
            print(value, file=sys.stderr)
        if word == "--write":
            pathlib.Path(value).touch()
        if word == "--copy":
            pathlib.Path(value).write_text((deck.parents[2] / value).read_text())
        if word == "--sleep":
            time.sleep(float(value))
        if word == "--exit":
            sys.exit(int(value))
    if deck.read_text():
        pathlib.Path(deck.stem + ".summary.json").write_text(deck.read_text())
    """


class Regression(Called):
    def setUp(self):
        super().setUp()
        self.cases, self.keep, self.script = self.folder / "cases", self.folder / "keep", self.folder / "program"
        self.script.write_text(textwrap.dedent(PROGRAM))
        self.script.chmod(0o755)

    def case(self, name, energy=1.0, gold=1.0, **keys):
        """A case whose run gives `energy`; None: no summary, no gold."""
        folder = self.cases / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.xml").write_text("" if energy is None else json.dumps({"energy": energy}))
        if gold is not None:
            (folder / "gold.summary.json").write_text(json.dumps({"energy": gold}))
        keys = {"requirement": f"What {name} protects.", "labels": ["fast"]} | keys
        (folder / "case.toml").write_text("".join(f"{key} = {json.dumps(value)}\n" for key, value in keys.items()))
        return folder

    def program(self, arguments):
        fixed = ["--cases", self.cases, "--program", self.script, "--keep", self.keep]
        return main(REGRESSION, self.script, [*arguments, *map(str, fixed)])

    def test_cases_that_are_right_are_one_line_each_and_leave_nothing(self):
        self.case("one")
        self.case("two", energy=1 + 1e-15)
        code, screen, _ = self.call()
        self.assertEqual(code, 0, screen)
        self.assertRegex(screen, r"^ok +\d+\.\d\d s  one +What one protects\.\nok +.* two .*\n\n2 cases, 2 runs: 2 ok ")
        self.assertFalse(self.keep.exists())

    def test_a_failure_keeps_its_outputs_and_says_where(self):
        self.case("right")
        self.case("wrong", energy=2.0)
        self.assert_failure(["DIFFERENT", "energy", f"{self.keep}/NAME for wrong"])
        self.assertEqual([path.name for path in self.keep.iterdir()], ["wrong"])
        kept = self.keep / "wrong"
        self.assertEqual(json.loads((kept / "wrong.summary.json").read_text()), {"energy": 2.0})
        self.assertIn("energy", (kept / "diff.txt").read_text())
        self.assertTrue((kept / "screen.txt").exists() and (kept / "errors.txt").exists())

    def test_exit_code_and_message_are_judged(self):
        self.case("right", None, None, exit=3, message="why", arguments=["--say=this is why it ended", "--exit=3"])
        self.assertEqual(self.call()[0], 0)
        self.case("code", None, None, exit=3, arguments=["--say=other reasons", "--exit=4"])
        self.assert_failure(["WRONG EXIT", "exit code 4 instead of 3", "other reasons"], "code")
        self.case("words", None, None, exit=3, message="why", arguments=["--say=other reasons", "--exit=3"])
        self.assert_failure(["NO MESSAGE", 'does not say "why"', "other reasons"], "words")
        self.case("killed", None, None, arguments=["--sleep=60"])
        self.assert_failure(["TIMEOUT"], "killed", "--timeout", "0.5")

    def test_files_must_be_those_of_the_gold(self):
        self.case("silent", energy=None)
        self.assert_failure("gold.summary.json has no counterpart")
        folder = self.case("silent")
        SmallExodus().write(folder / "gold.e")
        self.assert_failure("gold.e has no counterpart")
        self.case("new", gold=None)
        self.assert_failure(["NO GOLD", "--bless"], "new")
        self.case("stray", None, None, arguments=["--write=stray.contact.csv"])
        self.assert_failure(["stray.contact.csv was written by a case without gold"], "stray")

    def test_a_contact_table_is_compared_where_it_is_gold(self):
        head = "interface,x,y,u_dirichlet\n"
        folder = self.case("table", arguments=["--copy=table.contact.csv"])
        (self.folder / "table.contact.csv").write_text(head + "a,0,0,1\n")
        self.assert_success()  # written, but not asked for
        (folder / "gold.contact.csv").touch()
        self.assert_failure("gold.contact.csv: is not a contact table")
        self.assertEqual(self.call("--bless", "table")[0], 0)
        self.assertEqual((folder / "gold.contact.csv").read_text(), head + "a,0,0,1\n")
        self.assert_success()
        (self.folder / "table.contact.csv").write_text(head + "a,0,0,1.001\n")
        self.assert_failure(["gold.contact.csv and table.contact.csv differ", "u_dirichlet"])
        self.case("table")
        self.assert_failure("gold.contact.csv has no counterpart")

    def test_blessing_shows_the_difference_and_mends_it(self):
        folder = self.case("wrong", energy=2.0)
        code, screen, _ = self.call("--bless", "wrong")
        self.assertEqual(code, 0)
        for word in ("wrong: blessed", "energy", "1", "2"):
            self.assertIn(word, screen)
        self.assertEqual(json.loads((folder / "gold.summary.json").read_text()), {"energy": 2.0})
        self.assertEqual(self.call()[0], 0)
        self.assertIn("nothing to bless", self.call("--bless", "wrong")[1])

    def test_blessing_makes_gold_of_new_cases_and_removes_what_is_no_longer_written(self):
        new, silent = self.case("new", gold=None), self.case("silent", energy=None)
        self.assertEqual(self.call("--bless", "new", "silent")[0], 0)
        self.assertTrue((new / "gold.summary.json").exists())
        self.assertFalse((silent / "gold.summary.json").exists())

    def test_blessing_is_for_cases_named_that_end_as_they_should(self):
        folder = self.case("wrong", energy=2.0, exit=3)
        self.assert_refused("name the cases", "--bless")
        code, screen, _ = self.call("--bless", "wrong")
        self.assertEqual(code, 1)
        self.assertIn("not blessed, WRONG EXIT", screen)
        self.assertEqual(json.loads((folder / "gold.summary.json").read_text()), {"energy": 1.0})

    def test_junit_is_xml_that_counts_failures(self):
        self.case("right")
        self.case("wrong", energy=2.0)
        self.case("bell", None, None, exit=3, arguments=["--say=\a<&", "--exit=4"])
        self.case("other", program="other")
        path = self.folder / "junit.xml"
        self.assertEqual(self.call("--junit", path)[0], 1)
        suite = ElementTree.parse(path).getroot().find("testsuite")
        self.assertEqual({key: suite.get(key) for key in ("tests", "failures", "skipped")},
                         {"tests": "4", "failures": "2", "skipped": "1"})
        cases = {case.get("name"): case for case in suite}
        self.assertIn("energy", cases["wrong"].find("failure").text)
        self.assertIn("?<&", cases["bell"].find("failure").text)
        self.assertIsNone(cases["right"].find("failure"))
        self.assertEqual(cases["right"].find("system-out").text, "What right protects.")

    def test_names_patterns_and_labels_choose(self):
        self.case("one-a", labels=["slow"])
        self.case("one-b")
        self.case("two")
        for arguments, chosen in ((["two"], 1), (["one-*"], 2), (["--label", "fast"], 2),
                                  (["one-*", "--label", "slow"], 1)):
            self.assertIn(f"\n{chosen} cases, ", self.call(*arguments)[1])
        self.assert_refused('there is no case "one-c"; did you mean', "one-c")
        self.assert_refused('no case has the label "loud"', "--label", "loud")

    def test_listing_runs_nothing(self):
        self.case("wrong", energy=2.0)
        code, screen, _ = self.call("--list")
        self.assertEqual((code, screen), (0, "wrong  What wrong protects.  [fast]\n1 cases\n"))

    def test_a_relative_folder_of_cases_counts_from_the_working_directory(self):
        self.case("one")
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        self.cases = self.cases.relative_to(self.folder)
        code, screen, _ = self.call()
        self.assertEqual(code, 0, screen)

    def test_every_number_of_ranks_is_a_run(self):
        self.case("both", np=[1, 2])
        self.assertIn("1 cases, 1 runs", self.call("--np", "1")[1])
        self.assertIn("both.np2", self.call("--np", "2")[1])
        self.assert_refused("runs on 3 ranks", "--np", "3")
        self.assertIn("both.np3", self.call("--ranks", "3")[1])
        self.assertIn("1 cases, 1 runs", self.call("--ranks", "1")[1])
        self.assert_refused("at least 1", "--ranks", "0")

    def test_side_by_side_gives_the_same_lines(self):
        for i in range(5):
            self.case(f"case{i}", energy=1.0 + i % 2)
        names = [[line.split()[3] for line in self.call(*jobs)[1].splitlines() if " s  " in line]
                 for jobs in ([], ["-j", "3"])]
        self.assertEqual(names[0], [f"case{i}" for i in range(5)])
        self.assertEqual(names[0], names[1])

    def test_programs_that_are_not_there_are_refused(self):
        self.case("one")
        self.assert_refused("is not a program", "--program", "other=/nowhere")

    def test_wrong_cases_are_refused(self):
        for keys, words in (({"requirment": "x"}, '"requirment" is not a key'),
                            ({"labels": "fast"}, "labels is not a list"),
                            ({"np": [0]}, "np is a list"), ({"requirement": ""}, "requirement is not"),
                            ({"exit": "3"}, "exit is not a int")):
            self.case("one", **keys)
            self.assert_refused(words)
        folder = self.case("one")
        (folder / "case.toml").write_text('labels = ["fast"]\n')
        self.assert_refused("requirement is missing")
        (folder / "case.toml").write_text("requirement\n")
        self.assert_refused("case.toml")
        folder = self.case("one")
        (folder / "one.xml").unlink()
        self.assert_refused("the deck one.xml is missing")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
