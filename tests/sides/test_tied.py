"""Tied sides: test_tied.py NDFRAME.

Uniform stress passes whatever the meshes; what was cut and tied is what it was before, exactly with the same cells,
within the bounds with others; rings of two materials that are meshed apart; a tied body in contact; mistakes are told.
"""

import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "accuracy"))
import side_scenes
from runs import Program

PROGRAM = Program(sys.argv[1])
TIED = {"Tied": ("bool", "true")}
QUIET = ("Output/Exodus=false", "Output/Contact Table=false")
GLOBAL = "Error Estimation/Estimators={Global}"


def solve(first, second, *settings, interface=None):
    with tempfile.TemporaryDirectory() as folder:
        return PROGRAM.run(side_scenes.write_scene(folder, first, second, interface or TIED), *QUIET, *settings)


def halves(upper, lower, place=(side_scenes.box(0, 0, 1, 0.5), side_scenes.box(0, -0.5, 1, 0)), young=(2.0, 1.0),
           pressure="1", held=None):
    first = side_scenes.Block("upper", upper, 4, place[0], "bottom", young[0], 0.3, held or {}, pressure)
    second = side_scenes.Block("lower", lower, 4, place[1], "top", young[1], 0.2, {"bottom": "Clamp", **(held or {})})
    return first, second


def lame_energy(a, b, c, inner, outer, poisson):
    """a(u, u) of a quarter of two bonded rings under the inner pressure 1, plane strain, by radial compliances."""
    def constants(young):
        return young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))

    def moved(r, p_in, p_out, r_in, r_out, young):
        shear, lame = constants(young)
        A = (p_in * r_in**2 - p_out * r_out**2) / (r_out**2 - r_in**2)
        B = (p_in - p_out) * r_in**2 * r_out**2 / (r_out**2 - r_in**2)
        return A * r / (2 * (lame + shear)) + B / (2 * shear * r)

    gap = lambda q: moved(b, 1.0, q, a, b, inner) - moved(b, q, 0.0, b, c, outer)
    q = gap(0.0) / (gap(0.0) - gap(1.0))
    return math.pi / 2 * a * moved(a, 1.0, q, a, b, inner)


def sector(inner, outer):
    def place(u, v):
        r, angle = inner + (outer - inner) * v, (1.0 - u) * math.pi / 2
        return r * math.cos(angle), r * math.sin(angle)

    return place


class Tied(unittest.TestCase):
    def test_uniform_stress_passes(self):
        held = {"left": "Roller"}
        for upper, lower in ((2, 3), (1, 4), (4, 1), (5, 5)):
            for turn in (0.0, 0.4):
                place = side_scenes.box(0, 0, 1, 0.5, turn), side_scenes.box(0, -0.5, 1, 0, turn)
                first = side_scenes.Block("upper", side_scenes.even(upper), 2, place[0], "bottom", 1.0, 0.3, held, "1")
                second = side_scenes.Block("lower", side_scenes.even(lower), 3, place[1], "top", 1.0, 0.3,
                                           {"bottom": "Roller", **held})
                run = solve(first, second, GLOBAL)
                self.assertEqual(run.code, 0, run.screen)
                self.assertAlmostEqual(run.summary["energy"], 0.91, delta=1e-12)  # sigma^2 (1 - nu^2) / E
                self.assertLess(run.summary["errors"]["global"]["relative"], 1e-11)

    def test_the_same_cells_are_the_same_body(self):
        pressure = ("Bodies/upper/Loads/press/Type=Traction", "Bodies/upper/Loads/press/X=0.3+x",
                    "Bodies/lower/Loads/weight/Type=Body Force", "Bodies/lower/Loads/weight/Y=-0.4")
        box = lambda low, high, rows: (f"Lower={{0, {low}}}", f"Upper={{1, {high}}}", f"Cells={{6, {rows}}}")
        apart = [f"Bodies/upper/Mesh/{one}" for one in ("Type=Box", *box(0, 0.5, 3))] + \
                [f"Bodies/lower/Mesh/{one}" for one in ("Type=Box", *box(-0.5, 0, 3))]
        with tempfile.TemporaryDirectory() as folder:
            deck = side_scenes.write_scene(folder, *halves([0, 1], [0, 1]), TIED)
            text = deck.read_text()
            for name in ("upper", "lower"):
                text = text.replace(f'<Parameter name="File" type="string" value="{name}.msh"/>', "")
            text = text.replace('<Parameter name="Value" type="string" value="1"/>', "")
            deck.write_text(text)
            two = PROGRAM.run(deck, *apart, *pressure, *QUIET)
            self.assertEqual(two.code, 0, two.screen)
            one = pathlib.Path(folder) / "one.xml"
            one.write_text(f"""<ParameterList name="one"><ParameterList name="Bodies"><ParameterList name="whole">
                <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
                <Parameter name="Lower" type="Array(double)" value="{{0, -0.5}}"/>
                <Parameter name="Upper" type="Array(double)" value="{{1, 0.5}}"/>
                <Parameter name="Cells" type="Array(int)" value="{{6, 6}}"/><ParameterList name="Parts">
                <ParameterList name="upper"><Parameter name="Lower" type="Array(double)" value="{{0, 0}}"/>
                <Parameter name="Upper" type="Array(double)" value="{{1, 0.5}}"/></ParameterList>
                <ParameterList name="lower"><Parameter name="Lower" type="Array(double)" value="{{0, -0.5}}"/>
                <Parameter name="Upper" type="Array(double)" value="{{1, 0}}"/></ParameterList></ParameterList>
                </ParameterList><ParameterList name="Regions">
                <ParameterList name="upper"><ParameterList name="Material"><Parameter name="Young Modulus" type="double"
                value="2.0"/><Parameter name="Poisson Ratio" type="double" value="0.3"/></ParameterList></ParameterList>
                <ParameterList name="lower"><ParameterList name="Material"><Parameter name="Young Modulus" type="double"
                value="1.0"/><Parameter name="Poisson Ratio" type="double" value="0.2"/></ParameterList></ParameterList>
                </ParameterList><ParameterList name="Supports"><ParameterList name="ground"><Parameter name="Type"
                type="string" value="Clamp"/><Parameter name="Side" type="string" value="bottom"/></ParameterList>
                </ParameterList><ParameterList name="Loads"><ParameterList name="shear"><Parameter name="Type" type="string"
                value="Traction"/><Parameter name="Side" type="string" value="top"/><Parameter name="X" type="string"
                value="0.3+x"/></ParameterList><ParameterList name="weight"><Parameter name="Type" type="string"
                value="Body Force"/><Parameter name="Y" type="double" value="-0.4"/><Parameter name="Cells"
                type="Array(string)" value="{{lower}}"/></ParameterList></ParameterList></ParameterList></ParameterList>
                </ParameterList>""")
            whole = PROGRAM.run(one, *QUIET)
            self.assertEqual(whole.code, 0, whole.screen)
        self.assertAlmostEqual(two.summary["energy"] / whole.summary["energy"], 1.0, delta=1e-11)

    def test_other_cells_are_the_same_body_within_the_bounds(self):
        settings = ("Error Estimation/Estimators={Global}", "Bodies/upper/Loads/press/Value=1+x")
        runs = [solve(*halves(side_scenes.even(a), side_scenes.even(b)), *settings) for a, b in ((8, 8), (8, 12), (5, 7))]
        brackets = []
        for run in runs:
            self.assertEqual(run.code, 0, run.screen)
            self.assertTrue(run.summary["errors"]["global"]["guaranteed"])
            brackets.append(run.summary["errors"]["energy_bracket"])
        self.assertLess(max(b["lower"] for b in brackets), min(b["upper"] for b in brackets))

    def test_rings_meshed_apart_are_one_ring_to_second_order(self):
        exact, before = lame_energy(1.0, 1.5, 2.0, 1.0, 3.0, 0.3), None
        held = {"left": "Roller", "right": "Roller"}
        for inner, outer in ((4, 6), (8, 12), (16, 24)):
            parts = (side_scenes.Block("inner", side_scenes.even(inner), max(2, inner // 4), sector(1, 1.5), "top", 1.0,
                                       0.3, held, "1"),
                     side_scenes.Block("outer", side_scenes.even(outer), max(2, outer // 4), sector(1.5, 2), "bottom", 3.0,
                                       0.3, held))
            run = solve(*parts)
            self.assertEqual(run.code, 0, run.screen)
            off = abs(run.summary["energy"] / exact - 1.0)
            self.assertLess(off, 0.05 if before is None else 0.3 * before)
            before = off

    def refused(self, message, *settings, place=None, interface=None):
        run = solve(*halves(side_scenes.even(4), side_scenes.even(4), *([place] if place else [])), *settings,
                    interface=interface)
        self.assertEqual(run.code, 2, run.screen)
        self.assertIn(message, run.screen)

    def test_mistakes_are_told(self):
        contact = "Interfaces/contact/"
        self.refused("has no meaning where sides are tied", contact + "Gap=0.1")
        self.refused("there is no body \"uper\"", contact + "Dirichlet Body=uper")
        self.refused("there is no side \"botom\"", contact + "Dirichlet Side=botom")
        self.refused("the sides are apart by 0.1",
                     place=(side_scenes.box(0, 0.1, 1, 0.5), side_scenes.box(0, -0.5, 1, 0)))
        self.refused("no part of", contact + "Neumann Side=bottom")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
