"""Sides that find each other: test_automatic.py NDFRAME DECKS MPIEXEC.

Shipped decks whose Interfaces are left to Automatic have the energy that they have as written; what the deck says counts;
what cannot be found is told.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
from runs import Program

SAME = 1e-10
SOLIDS = ("contact-loss-3d", "punch-3d", "stamp-3d")  # whose sides have the same nodes
WRITTEN = ("stack", "chain", "ring", "wall", "drawn-punch", "bearing", "hertz-drawn", *SOLIDS)


def without(name, deck):
    """The deck without one of its lists."""
    return re.sub(f'  <ParameterList name="{name}">.*?\n  </ParameterList>\n', "", deck, flags=re.S)


def automatic(entries="", others=""):
    return f'<ParameterList name="Interfaces"><ParameterList name="Automatic">{entries}</ParameterList>{others}</ParameterList>'


def entry(name, value, kind="string"):
    return f'<Parameter name="{name}" type="{kind}" value="{value}"/>'


def pair(name, first, second, more=""):
    sides = "".join(entry(key, value) for key, value in zip(
        ("Dirichlet Body", "Dirichlet Side", "Neumann Body", "Neumann Side"), (*first, *second)))
    return f'<ParameterList name="{name}">{sides}{more}</ParameterList>'


def box(name, low, high, cells, **held):
    """A solid with rollers on two sides and what else holds it."""
    listed = lambda called, *entries: f'<ParameterList name="{called}">{"".join(entries)}</ParameterList>'
    mesh = [entry(key, value, f"Array({kind})") for key, value, kind in
            (("Lower", low, "double"), ("Upper", high, "double"), ("Cells", cells, "int"))]
    material = [entry("Young Modulus", "1", "double"), entry("Poisson Ratio", "0.3", "double"), entry("Hypothesis", "Three Dimensional")]
    supports = [listed(side, entry("Type", kind), entry("Side", side))
                for side, kind in {"left": "Roller", "front": "Roller", **held}.items()]
    return listed(name, listed("Mesh", entry("Type", "Box"), *mesh), listed("Material", *material), listed("Supports", *supports))


class Automatic(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, interfaces=None):
        """A shipped deck without what it expects, with other interfaces."""
        deck = without("Expect", (DECKS / f"{name}.xml").read_text()).replace("meshes/", f"{DECKS}/meshes/")
        if interfaces is not None:
            deck = without("Interfaces", deck).replace('  <ParameterList name="Bodies">',
                                                       f'  {interfaces}\n  <ParameterList name="Bodies">', 1)
        path = self.folder / f"{name}{'' if interfaces is None else '-found'}.xml"
        path.write_text(deck)
        return path

    def run_deck(self, deck, *settings, ranks=1, code=0):
        done = PROGRAM.run(deck, "Output/Exodus=false", "Output/Contact Table=false", *settings, ranks=ranks)
        self.assertEqual(done.code, code, done.screen)
        return done

    def test_found_interfaces_are_those_that_were_written(self):
        for name in WRITTEN:
            with self.subTest(name):
                written = self.run_deck(self.write(name)).summary
                found = self.run_deck(self.write(name, automatic())).summary
                self.assertLess(abs(found["energy"] / written["energy"] - 1.0), SAME)
                pairs = lambda summary: {frozenset(((one["Dirichlet Body"], one["Dirichlet Side"]),
                                                    (one["Neumann Body"], one["Neumann Side"])))
                                         for one in summary["deck"]["Interfaces"].values()}
                self.assertEqual(pairs(found), pairs(written))

    def test_solids_that_do_not_match_are_told(self):
        deck = self.write("punch-3d", automatic(entry("Distance", "0.1", "double")))
        self.assertIn("Distance has no meaning in 3D", self.run_deck(deck, code=2).screen)
        deck = self.write("punch-3d", automatic())
        self.assertIn("sides that lie on each other", self.run_deck(deck).screen)
        moved = deck.read_text().replace("{1.0, 1.0, 1.0}", "{1.0, 1.0, 1.1}").replace("{0.0, 0.0, 0.0}", "{0.0, 0.0, 0.1}")
        deck.write_text(moved)
        self.assertIn("no two named sides lie on each other", self.run_deck(deck, code=2).screen)

    def test_solids_that_were_meshed_apart_are_found(self):
        bodies = "".join((box("lower", "{0, 0, -1}", "{2, 1, 0}", "{4, 2, 2}", bottom="Roller"),
                          box("short", "{0, 0, 0}", "{1, 1, 1}", "{3, 2, 2}", back="Clamp"),
                          box("upper", "{0, 0, 1}", "{1, 1, 2}", "{2, 2, 2}")))
        deck = self.folder / "boxes.xml"
        deck.write_text(f'<ParameterList name="boxes"><ParameterList name="Bodies">{bodies}</ParameterList>{automatic()}</ParameterList>')
        done = self.run_deck(deck)
        self.assertEqual(list(done.summary["deck"]["Interfaces"]), ["lower top - short bottom", "short top - upper bottom"])
        self.assertEqual([one for one in done.summary["warnings"] if one["kind"] == "unnamed facets"], [])

    def test_the_text_on_the_screen_is_a_deck_of_the_same_scene(self):
        found = self.run_deck(self.write("bearing", automatic(entry("Corner Angle", "30", "double"))))
        text = re.search(r'<ParameterList name="pin round.*?</ParameterList>', found.screen, re.S)[0]
        written = self.run_deck(self.write("bearing", f'<ParameterList name="Interfaces">{text}</ParameterList>'))
        self.assertEqual(written.summary["energy"], found.summary["energy"])
        self.assertEqual(written.summary["deck"]["Interfaces"], found.summary["deck"]["Interfaces"])

    def test_meshes_are_read_once(self):
        for name, count in (("bearing", 2), ("stack", 3)):
            counts = self.run_deck(self.write(name, automatic())).summary["ledger"]["counts"]
            self.assertEqual(counts["meshes reused"], count)
            self.assertEqual(counts.get("scripts meshed", 0), 1 if name == "bearing" else 0)

    def test_targets_are_reached_as_with_written_interfaces(self):
        for name in ("bearing", "stack", "drawn-punch"):
            with self.subTest(name):
                written, found = (self.run_deck(self.write(name, interfaces), "Accuracy/Target=0.02")
                                  for interfaces in (None, automatic()))
                self.assertTrue(found.accuracy["reached"])
                if name != "stack":  # whose first side is the other one, with other admissible tractions and meshes
                    levels = lambda done: [(level["dofs"], level["bound"]) for level in done.levels]
                    self.assertEqual(levels(found), levels(written))

    def test_every_number_of_processes_finds_the_same(self):
        deck = self.write("bearing", automatic())
        one, *others = (self.run_deck(deck, ranks=ranks) for ranks in (1, 2, 3))
        for other in others:
            self.assertEqual(other.summary["deck"]["Interfaces"], one.summary["deck"]["Interfaces"])
            self.assertLess(abs(other.summary["energy"] / one.summary["energy"] - 1.0), SAME)

    def test_what_the_deck_says_of_two_sides_counts(self):
        gap = entry("Gap", "0.001")
        for first, second in ((("upper", "bottom"), ("middle", "top")), (("middle", "top"), ("upper", "bottom"))):
            deck = self.write("stack", automatic("", pair("by hand", first, second, gap)))
            interfaces = self.run_deck(deck).summary["deck"]["Interfaces"]
            self.assertEqual(sorted(interfaces), ["by hand", "lower top - middle bottom"])
            self.assertEqual(interfaces["by hand"]["Gap"], "0.001")

    def test_a_name_that_is_taken_gets_a_number(self):
        name = "lower top - middle bottom"
        deck = self.write("stack", automatic("", pair(name, ("upper", "bottom"), ("middle", "top"))))
        self.assertEqual(sorted(self.run_deck(deck).summary["deck"]["Interfaces"]), [name, f"{name} (2)"])

    def test_rigid_bodies_are_named_by_hand(self):
        given = re.search(r'<ParameterList name="Interfaces">(.*?)\n  </ParameterList>', (DECKS / "rigid-cylinder.xml").read_text(), re.S)[1]
        written = self.run_deck(self.write("rigid-cylinder")).summary["energy"]
        found = self.run_deck(self.write("rigid-cylinder", automatic("", given))).summary["energy"]
        self.assertEqual(found, written)
        self.assertIn("not two named sides of elastic bodies", self.run_deck(self.write("rigid-cylinder", automatic()), code=2).screen)

    def test_sides_that_are_tied_are_no_contact(self):
        tie = pair("tie", ("middle", "bottom"), ("lower", "top"), entry("Tied", "true", "bool"))
        contact = pair("contact", ("middle", "top"), ("upper", "bottom"))
        written = self.run_deck(self.write("stack", f'<ParameterList name="Interfaces">{tie}{contact}</ParameterList>')).summary
        found = self.run_deck(self.write("stack", automatic("", tie))).summary
        self.assertLess(abs(found["energy"] / written["energy"] - 1.0), SAME)
        self.assertEqual(len(found["interfaces"]), 1)

    def test_studies_vary_what_is_found(self):
        deck = self.write("stack", automatic())
        text = deck.read_text().replace("{0.0, 1.0}", "{0.0, 1.004}").replace("{1.0, 1.5}", "{1.0, 1.504}")
        deck.write_text(text)
        command = [str(PROGRAM.path), "-i", str(deck), "--set", "Coupling/Type=Monolithic", "--set", "Output/Exodus=false",
                   "--study", "Interfaces/Automatic/Distance=0.02; 0.001", "--study", "Bodies/lower/Material/Young Modulus=1; 2"]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        rows = (self.folder / "stack-found.study.csv").read_text().splitlines()
        self.assertEqual(len(rows), 5, done.stdout + done.stderr)
        self.assertNotIn("supports nor contact", "".join(rows[1:3]))
        self.assertIn("upper", "".join(rows[3:]))  # which nothing holds any more
        alone = [self.run_deck(deck, "Coupling/Type=Monolithic", f"Bodies/lower/Material/Young Modulus={young}").summary["energy"]
                 for young in (1, 2)]
        header = rows[0].split(",")
        for row, energy in zip(rows[1:3], alone):
            self.assertLess(abs(float(row.split(",")[header.index("energy")]) / energy - 1.0), SAME)

    def test_check_and_plan_know_the_list(self):
        deck = self.write("bearing", automatic())
        for option, wanted in (("--check", "pin round - housing hole"), ("--plan", "as Automatic finds them"),
                               ("--yardstick", "housing")):
            done = subprocess.run([str(PROGRAM.path), "-i", str(deck), option], cwd=self.folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn(wanted, done.stdout)

    def test_nothing_found_names_the_nearest_sides(self):
        deck = self.write("stack", automatic(entry("Distance", "0.1", "double")))
        deck.write_text(deck.read_text().replace("{0.0, 0.5}", "{0.0, 0.7}").replace("{0.0, 1.0}", "{0.0, 1.3}")
                        .replace("{1.0, 1.5}", "{1.0, 1.8}"))
        screen = self.run_deck(deck, code=2).screen
        self.assertIn("Interfaces/Automatic: no two named sides face each other within 0.1: the nearest "
                      'are "top" of "lower" and "bottom" of "middle", 0.2 apart at ', screen)
        self.assertIn("raise Distance if they are to touch", screen)

    def test_facets_without_a_name_are_warned_of(self):
        script = (DECKS / "meshes/bearing.geo").read_text()
        self.assertIn('"hole") = {1, 2}', script)
        (self.folder / "bearing.geo").write_text(script.replace('"hole") = {1, 2}', '"hole") = {1}'))
        deck = self.write("bearing", automatic())
        deck.write_text(deck.read_text().replace(f"{DECKS}/meshes/", ""))
        done = self.run_deck(deck)
        warnings = [one["message"] for one in done.summary["warnings"] if one["kind"] == "unnamed facets"]
        self.assertEqual(len(warnings), 1, done.screen)
        self.assertRegex(warnings[0], r'facets of "housing" near \(.*\) belong to no named side.* and face "pin"')
        self.assertIn(warnings[0], done.screen)
        self.assertIn(warnings[0], self.run_deck(deck, "Strict Input=true", code=2).screen)

    def test_facets_of_solids_without_a_name_are_warned_of(self):
        script = (DECKS / "meshes/stamp.geo").read_text()
        for old, new in (("BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }",  # of the disc only the middle has the name
                          "Cylinder(3) = {0, 0, 0, 0, 0, 1, 0.4, Pi / 2};\n"
                          "BooleanFragments{ Volume{1}; Delete; }{ Volume{2, 3}; Delete; }"),
                         ('"stamp") = {2}', '"stamp") = Volume In BoundingBox {-0.1, -0.1, -0.1, 1, 1, 2}'),
                         ("{-e, -e, -e, 0.8 + e, 0.8 + e, e}", "{-e, -e, -e, 0.4 + e, 0.4 + e, e}")):
            self.assertIn(old, script)
            script = script.replace(old, new)
        (self.folder / "stamp.geo").write_text(script)
        deck = self.write("stamp-3d", automatic())
        deck.write_text(deck.read_text().replace(f"{DECKS}/meshes/", ""))
        done = self.run_deck(deck)
        self.assertEqual(list(done.summary["deck"]["Interfaces"]), ["stamp disc - plate disc"])
        warnings = [one["message"] for one in done.summary["warnings"] if one["kind"] == "unnamed facets"]
        self.assertEqual(len(warnings), 1, done.screen)
        self.assertRegex(warnings[0], r'facets of "stamp" near \(.*, .*, 0\) belong to no named side.* and face "plate"')
        self.assertIn(warnings[0], done.screen)
        self.assertIn(warnings[0], self.run_deck(deck, "Strict Input=true", code=2).screen)

    def test_left_out_sides_must_exist(self):
        deck = self.write("stack", automatic(entry("Leave Out", "{upper/bottm}", "Array(string)")))
        self.assertIn('there is no "upper/bottm"; write the names of a body and of its side as BODY/SIDE.',
                      self.run_deck(deck, code=2).screen)

    def test_sides_that_are_left_out_face_nothing(self):
        found = automatic(entry("Leave Out", "{block 3/left}", "Array(string)"))
        done = self.run_deck(self.write("automatic", found))
        self.assertNotIn("block 2 right - block 3 left", done.summary["deck"]["Interfaces"])
        self.assertEqual(len(done.summary["deck"]["Interfaces"]), 7)


if __name__ == "__main__":
    program, decks, mpiexec = sys.argv[1:4]
    PROGRAM, DECKS = Program(program, mpiexec), pathlib.Path(decks).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
