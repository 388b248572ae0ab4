"""`ndframe new`, decks to begin with: test_new.py NDFRAME DECKS."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAM, DECKS = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
TEMPLATES = ("two-bodies", "hertz", "obstacle", "from-geo")

# A block above a plate, {gap} apart; the plate is meshed more coarsely.
TWO_BODIES = """
Point(1) = {{0, 0, 0, 0.5}}; Point(2) = {{2, 0, 0, 0.5}}; Point(3) = {{2, 1, 0, 0.5}}; Point(4) = {{0, 1, 0, 0.5}};
Line(1) = {{1, 2}}; Line(2) = {{2, 3}}; Line(3) = {{3, 4}}; Line(4) = {{4, 1}};
Curve Loop(1) = {{1, 2, 3, 4}}; Plane Surface(1) = {{1}};
h = {gap};
Point(11) = {{0.5, 1 + h, 0, 0.3}}; Point(12) = {{1.5, 1 + h, 0, 0.3}}; Point(13) = {{1.5, 2, 0, 0.3}}; Point(14) = {{0.5, 2, 0, 0.3}};
Line(11) = {{11, 12}}; Line(12) = {{12, 13}}; Line(13) = {{13, 14}}; Line(14) = {{14, 11}};
Curve Loop(11) = {{11, 12, 13, 14}}; Plane Surface(11) = {{11}};
Physical Surface("plate") = {{1}}; Physical Surface("block") = {{11}};
Physical Curve("below") = {{1}}; Physical Curve("table") = {{3}};
Physical Curve("sole") = {{11}}; Physical Curve("head") = {{13}};
"""
ONE_BODY = """
Point(1) = {0, 0, 0, 0.5}; Point(2) = {1, 0, 0, 0.5}; Point(3) = {1, 1, 0, 0.5}; Point(4) = {0, 1, 0, 0.5};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
"""
ALL_TOUCH = TWO_BODIES.format(gap=0).replace('Physical Curve("below") = {1};', "").replace('Physical Curve("head") = {13};', "")
# A disc that lies on a plate: nothing but contact carries it.
ROLL = """
SetFactory("OpenCASCADE"); Rectangle(1) = {0, 0, 0, 4, 1}; Disk(2) = {2, 1.5, 0, 0.5}; Mesh.MeshSizeMax = 0.3;
Physical Surface("plate") = {1}; Physical Surface("roll") = {2};
Physical Curve("top") = {3}; Physical Curve("bottom") = {1}; Physical Curve("rim") = {5};
"""
# A pad between a base and a beam.
STACK = """
SetFactory("OpenCASCADE"); Mesh.MeshSizeMax = 0.4;
Rectangle(1) = {0, 0, 0, 3, 1}; Rectangle(2) = {0.5, 1, 0, 1, 0.5}; Rectangle(3) = {0, 1.5, 0, 2, 0.7};
Physical Surface("base") = {1}; Physical Surface("pad") = {2}; Physical Surface("beam") = {3};
Physical Curve("foot") = {1}; Physical Curve("base top") = {3}; Physical Curve("pad bottom") = {5};
Physical Curve("pad top") = {7}; Physical Curve("beam bottom") = {9}; Physical Curve("beam top") = {11};
"""
# A pin that is smaller than its hole, and lies in it.
PIN = """
SetFactory("OpenCASCADE"); Rectangle(1) = {-20, -20, 0, 40, 40}; Disk(2) = {0, 0, 0, 5.1};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Disk(4) = {0, -0.1, 0, 5}; Mesh.MeshSizeMax = 4; Mesh.MeshSizeFromCurvature = 20;
Physical Surface("plate") = {3}; Physical Surface("pin") = {4};
all() = Boundary{ Surface{3}; };
Physical Curve("rim") = Boundary{ Surface{4}; }; Physical Curve("hole") = {all(4)}; Physical Curve("foot") = {all(0)};
"""
# A tail with clearance in its groove: as the tail goes up, its flanks meet those of the groove by less than half of the way.
DOVETAIL = """
s = 4; c = 0.1;
Point(1) = {-30, 0, 0, s}; Point(2) = {30, 0, 0, s}; Point(3) = {30, 20, 0, s}; Point(4) = {8, 20, 0, s}; Point(5) = {14, 8, 0, s};
Point(6) = {-14, 8, 0, s}; Point(7) = {-8, 20, 0, s}; Point(8) = {-30, 20, 0, s};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8};
Line(8) = {8, 1}; Curve Loop(1) = {1:8}; Plane Surface(1) = {1};
Point(11) = {-14 + c, 8 + c, 0, s}; Point(12) = {14 - c, 8 + c, 0, s}; Point(13) = {8 - c, 20, 0, s}; Point(14) = {8 - c, 35, 0, s};
Point(15) = {c - 8, 35, 0, s}; Point(16) = {c - 8, 20, 0, s};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 15}; Line(15) = {15, 16}; Line(16) = {16, 11};
Curve Loop(11) = {11:16}; Plane Surface(11) = {11};
Physical Surface("groove") = {1}; Physical Surface("tail") = {11}; Physical Curve("bottom") = {1};
Physical Curve("flanks") = {4, 6}; Physical Curve("tail flanks") = {12, 16}; Physical Curve("pulled") = {14};
"""
# A wedge between two blocks that stand on the ground.
WEDGE = """
s = 4;
Point(1) = {-30, 0, 0, s}; Point(2) = {-6, 0, 0, s}; Point(3) = {-10, 20, 0, s}; Point(4) = {-30, 20, 0, s};
Point(5) = {30, 0, 0, s}; Point(6) = {6, 0, 0, s}; Point(7) = {10, 20, 0, s}; Point(8) = {30, 20, 0, s};
Point(9) = {-5.7, 0, 0, s}; Point(10) = {5.7, 0, 0, s}; Point(11) = {10.7, 25, 0, s}; Point(12) = {-10.7, 25, 0, s};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1}; Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Line(5) = {6, 5}; Line(6) = {5, 8}; Line(7) = {8, 7}; Line(8) = {7, 6}; Curve Loop(2) = {5:8}; Plane Surface(2) = {2};
Line(9) = {9, 10}; Line(10) = {10, 11}; Line(11) = {11, 12}; Line(12) = {12, 9}; Curve Loop(3) = {9:12}; Plane Surface(3) = {3};
Physical Surface("left") = {1}; Physical Surface("right") = {2}; Physical Surface("wedge") = {3}; Physical Curve("top") = {11};
Physical Curve("left foot") = {1}; Physical Curve("left flank") = {2}; Physical Curve("right foot") = {5}; Physical Curve("right flank") = {8};
Physical Curve("wedge right") = {10}; Physical Curve("wedge left") = {12};
"""
POST = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 2, 0.5};
Cylinder(2) = {1.1, 0.9, 0.5, 0, 0, 0.8, 0.5};
Physical Volume("slab") = {1}; Physical Volume("post") = {2};
Physical Surface("base") = {5}; Physical Surface("table") = {6}; Physical Surface("head") = {8}; Physical Surface("foot") = {9};
Mesh.MeshSizeMax = 0.4;
"""
SIDES = 'Physical Curve("below") = {1}; Physical Curve("above") = {3};\n'
BODY = 'Physical Surface("plate & <co>") = {1};\n'


class New(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def call(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True, timeout=120)

    def write(self, *arguments):
        done = self.call("new", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def refused(self, words, *arguments):
        done = self.call("new", *arguments)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(words, done.stderr)

    def run_certified(self, name):
        """The summary of a run with exit code 0, a guaranteed bound and no warning."""
        done = self.call(f"{name}.xml")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        summary = json.loads((self.folder / f"{pathlib.Path(name).name}.summary.json").read_text())
        self.assertTrue(summary["errors"]["global"]["guaranteed"])
        self.assertGreater(summary["energy"], 0.0)
        self.assertEqual(summary["warnings"], [])
        return summary

    def drawn(self, text, name="scene"):
        (self.folder / f"{name}.geo").write_text(text)
        self.write("from-geo", f"{name}.geo")
        return xml.etree.ElementTree.parse(self.folder / f"{name}.xml").getroot()

    def test_every_template_runs_and_is_certified(self):
        for name in TEMPLATES[:-1]:
            self.assertEqual(self.write(name), f"  wrote {name}.xml; run it: ndframe {name}.xml\n")
            self.assertGreater((self.folder / f"{name}.xml").read_text().count("<!--"), 4)
            summary = self.run_certified(name)
            self.assertTrue(summary["accuracy"]["reached"])
            self.assertGreater(summary["interfaces"][0]["contact_force"], 0.0)

    def test_two_drawn_bodies(self):
        deck = self.drawn(TWO_BODIES.format(gap=0.01))
        interface = deck.find("*[@name='Interfaces']/*")
        self.assertEqual(interface.get("name"), "plate table - block sole")
        self.assertIn("Sides: below, table.", (self.folder / "scene.xml").read_text())
        summary = self.run_certified("scene")
        self.assertEqual([body["name"] for body in summary["bodies"]], ["plate", "block"])
        self.assertGreater(summary["interfaces"][0]["contact_force"], 0.0)  # the gap of the drawing is closed
        self.assertEqual(summary["bodies"][0]["supports"][0]["description"], "clamp at below")

    def test_planes_of_symmetry_and_a_body_without_a_free_side(self):
        (self.folder / "bearing.geo").write_text((DECKS / "meshes/bearing.geo").read_text())
        self.write("from-geo", "bearing.geo")
        held = {b["name"]: [s["description"] for s in b["supports"]] for b in self.run_certified("bearing")["bodies"]}
        self.assertEqual(held, {"housing": ["roller at middle", "clamp at ground"], "pin": ["roller at middle"]})

    def test_a_body_on_another_one(self):
        self.drawn(ROLL, "roll")
        force = self.run_certified("roll")["interfaces"][0]["contact_force"]
        self.assertGreater(force, 0.0)

    def test_a_body_between_others_carries_what_passes_through_it(self):
        self.drawn(STACK, "stack")
        summary = self.run_certified("stack")
        self.assertEqual([s["description"] for b in summary["bodies"] for s in b["supports"] if "hold" not in s["name"]],
                         ["clamp at foot", "displacement at beam top"])
        below, above = (interface["contact_force"] for interface in summary["interfaces"])
        self.assertAlmostEqual(below, above, delta=1e-6 * above)

    def test_a_body_in_another_one_needs_no_hold(self):
        deck = self.drawn(PIN, "pin")
        lists = [one.get("name") for one in deck.iter("ParameterList")]
        self.assertNotIn("hold", lists)
        self.assertIn("still", lists)
        self.assertNotIn("Refinement", lists)  # the vertex must stay
        done = self.call("pin.xml")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        summary = json.loads((self.folder / "pin.summary.json").read_text())
        self.assertGreater(summary["interfaces"][0]["contact_force"], 0.0)

    def test_bodies_that_nothing_but_their_feet_can_hold_stand_on_them(self):
        self.drawn(WEDGE, "wedge")
        summary = self.run_certified("wedge")
        held = {b["name"]: [s["description"] for s in b["supports"]] for b in summary["bodies"]}
        self.assertEqual(held, {"left": ["clamp at left foot"], "right": ["clamp at right foot"], "wedge": ["displacement at top"]})
        self.assertTrue(all(interface["contact_force"] > 0.0 for interface in summary["interfaces"]))

    def test_curved_sides_that_touch_follow_the_curve(self):
        for name, text, curved in (("roll", ROLL, True), ("stack", STACK, False)):
            entries = [entry.get("value") for entry in self.drawn(text, name).iter("Parameter")]
            self.assertEqual("Remesh" in entries, curved)

    def test_a_body_is_moved_until_inclined_sides_meet(self):
        self.drawn(DOVETAIL, "dovetail")
        self.assertGreater(self.run_certified("dovetail")["interfaces"][0]["contact_force"], 0.0)

    def test_a_deck_that_does_not_run_yet_is_written_and_says_so(self):
        (self.folder / "in.geo").write_text(TWO_BODIES.format(gap=-0.01))
        done = self.call("new", "from-geo", "in.geo")
        self.assertEqual((done.returncode, done.stdout), (2, "  wrote in.xml, which does not run yet:\n"))
        self.assertRegex(done.stderr, r"^in.xml:\d+: Interfaces/plate table - block sole: the bodies overlap at the start: by 0.01 at ")
        self.assertEqual(self.call("in.xml").stderr.splitlines()[0], done.stderr.splitlines()[0])

    def test_names_of_files_are_those_that_a_shell_takes(self):
        (self.folder / "my part's.geo").write_text(TWO_BODIES.format(gap=0))
        said = self.write("from-geo", "my part's.geo")
        self.assertEqual(said, "  wrote my part's.xml; run it: ndframe 'my part'\\''s.xml'\n")
        self.run_certified("my part's")

    def test_one_body(self):
        for names in (SIDES + BODY, SIDES):
            deck = self.drawn(ONE_BODY + names, "alone")
            self.assertIsNone(deck.find("*[@name='Interfaces']"))
            given = [entry.get("value") for entry in deck.iter("Parameter") if entry.get("name") == "Side"]
            self.assertEqual(given, ["below", "above"])
            self.run_certified("alone")
            (self.folder / "alone.xml").unlink()

    def test_solids(self):
        self.write("from-geo", DECKS / "meshes/stamp.geo")
        text = (self.folder / "stamp.xml").read_text()
        self.assertIn('name="plate disc - stamp disc"', text)
        self.assertEqual(text.count('value="Roller"'), 4)
        self.assertEqual(self.call("--check", "stamp.xml").returncode, 0)

    def test_solids_that_are_meshed_apart(self):
        """A post on a slab, drawn as two volumes that share no surface."""
        self.drawn(POST, "post")
        self.assertIn('name="slab table - post foot"', (self.folder / "post.xml").read_text())
        self.run_certified("post")

    def test_files_are_named_from_the_folder_of_the_deck(self):
        (self.folder / "decks").mkdir()
        (self.folder / "meshes").mkdir()
        (self.folder / "meshes/two.geo").write_text(TWO_BODIES.format(gap=0))
        self.write("from-geo", "meshes/two.geo", "--output", "decks/two.xml")
        self.assertIn('value="../meshes/two.geo"', (self.folder / "decks/two.xml").read_text())
        self.run_certified("decks/two")

    def test_a_mesh(self):
        self.write("from-geo", DECKS / "meshes/punch-foundation.msh", "-o", "mesh.xml")
        self.run_certified("mesh")

    def test_nothing_is_replaced_without_a_word(self):
        (self.folder / "hertz.xml").write_text("mine")
        self.refused("hertz.xml exists already; name another file with --output, or use --force to replace it.", "hertz")
        self.assertEqual((self.folder / "hertz.xml").read_text(), "mine")
        self.write("hertz", "--output", "other.xml")
        self.write("hertz", "--force")
        self.assertEqual((self.folder / "hertz.xml").read_text(), (self.folder / "other.xml").read_text())

    def test_mistakes(self):
        all_names = "two-bodies, hertz, obstacle, from-geo"
        self.refused(f'there is no template "herz"; did you mean "hertz"; there are {all_names}.', "herz")
        self.refused(f'there is no template "bolt"; there are {all_names}.', "bolt")
        self.refused("say which deck: ndframe new two-bodies|hertz|obstacle|from-geo.")
        self.refused("from-geo needs a file: ndframe new from-geo FILE.geo", "from-geo")
        self.refused("a deck for a drawing is made by ndframe new from-geo 'my part.geo'.", "my part.geo")
        self.refused("no.geo: there is no such file", "from-geo", "no.geo")
        self.refused("body.stl: from-geo reads .geo and .msh files of gmsh", "from-geo", "body.stl")
        self.refused("hertz takes no file; from-geo does", "hertz", "a.geo")
        self.refused("nowhere/hertz.xml", "hertz", "--output", "nowhere/hertz.xml")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_drawings_without_a_scene(self):
        nearest = ('no two named sides face each other within 0.02828: the nearest are "table" of "plate" and "sole" of '
                   '"block", 0.5 apart')
        two = TWO_BODIES.format(gap=0)
        label = " gmsh shows their numbers: Tools, Options, Geometry, Curve labels."
        nameless = 'no side has a name: write Physical Curve("table") = {3}; for the curves that are held, loaded or may touch'
        cases = {"apart": (TWO_BODIES.format(gap=0.5), nearest),
                 "nameless": (ONE_BODY, nameless + ', and Physical Surface("block") = {1}; for each body.' + label),
                 "bodies": (ONE_BODY + BODY, nameless + "." + label),
                 "in each other": (TWO_BODIES.format(gap=-0.5), 'within 0.02828: "plate" and "block" overlap at ('),
                 "unnamed": (two.replace('Physical Curve("sole") = {11};', ""), '"plate" and "block" do at (1, 1), where the curve of "block" has no '
                                                                                "name; name it as Physical Curve."),
                 "no bodies": (two.replace('Physical Surface("plate") = {1}; Physical Surface("block") = {11};', ""),
                               "the drawing has no Physical Surface, and 2 parts that share no edge, at ("),
                 "one name": (two.replace('Physical Surface("plate") = {1}; Physical Surface("block") = {11};',
                                          'Physical Surface("parts") = {1, 11};'),
                              '): write Physical Surface("block") = {1}; with a separate name for each.'),
                 "lists": (two.replace('"block"', '"a, b"'), 'the name "a, b" of a body has a comma or a brace, which stand for lists in a deck'),
                 "all touch": (ALL_TOUCH, "every named side touches another body or is a plane of symmetry: name one more"),
                 "empty": ("// nothing", "empty.geo: "),
                 "unended": (ONE_BODY + SIDES.rstrip(), "unended.geo: the last line has several statements and no line feed, and gmsh would read only the "
                                                        "first of them; end the file with a line feed."),
                 "wrong": ("Point(1) = {0, 0", "wrong.geo: gmsh cannot read the script")}
        for name, (text, words) in cases.items():
            (self.folder / f"{name}.geo").write_text(text)
            self.refused(words, "from-geo", f"{name}.geo")
            self.assertNotIn(f"{name}.xml", self.call("new", "from-geo", f"{name}.geo").stderr)
            self.assertFalse((self.folder / f"{name}.xml").exists())

    def test_what_is_no_deck_has_a_way_out(self):
        for arguments, words in ((["a b.geo"], "a b.geo: is a drawing, not a deck; ndframe new from-geo 'a b.geo' makes a deck of it."),
                                 (["run", "a.xml"], "Did you mean: ndframe a.xml\n"),
                                 (["from-geo", "a.geo"], "Did you mean: ndframe new from-geo a.geo\n"),
                                 (["a.xml", "b.xml"], "`ndframe --help` shows the options.\n")):
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)

    def test_help_names_all_templates(self):
        for arguments in (("new", "--help"), ("--help", "new")):
            text = self.call(*arguments).stdout
            self.assertEqual([name for name in TEMPLATES if not re.search(rf"^  {name} ", text, re.MULTILINE)], [])
            self.assertIn("--force", text)
        self.assertIn("new", self.call("--help").stdout.split("Subcommands:")[1])
        self.assertIn("from\\-geo", self.call("--man").stdout)


if __name__ == "__main__":
    unittest.main()
