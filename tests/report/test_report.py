"""Reports of the program: test_report.py NDFRAME DECKS [Written|Shown]. Exit code 77: Shown without a browser.

With a folder in NDFRAME_PAGES the pages stay there, with screenshots.
"""

import base64
import importlib.util
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image

sys.dont_write_bytecode = True
PROGRAM, DECKS = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
KEPT = pathlib.Path(os.environ["NDFRAME_PAGES"]).resolve() if "NDFRAME_PAGES" in os.environ else None

from browser import Browser, missing_programs  # noqa: E402
from report_runs import RUNS, Runs  # noqa: E402

TITLES = ("Scene", "Bodies", "Contact", "How wrong is it?", "Forces", "Residuals", "Time and memory", "The deck, with all defaults")


def text_of(page):
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", re.sub(r"<(style|svg)\b.*?</\1>", " ", page, flags=re.DOTALL)))


def verdict_of(page):
    return re.search(r'<p class="verdict (\w+)">(.*?)</p>', page, re.DOTALL).groups()


def setUpModule():
    """Computes all runs and writes their reports, once."""
    global RESULTS
    holder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(holder.cleanup)
    RESULTS = Runs(PROGRAM, DECKS, KEPT or holder.name)
    for name in RUNS:
        RESULTS.compute(name)
        RESULTS.report(name)


class Written(unittest.TestCase):
    """What stands in the files, without a browser."""

    @classmethod
    def setUpClass(cls):
        cls.runs = RESULTS
        cls.pages = {name: cls.runs.folder.joinpath(f"{name}.report.html").read_text(encoding="utf-8") for name in RUNS}

    def path(self, ending):
        return self.runs.folder / ending

    def summary(self, name):
        return json.loads(self.path(f"{name}.summary.json").read_text())

    def captions(self, name):
        return " ".join(re.findall(r"<figcaption>(.*?)</figcaption>", self.pages[name]))

    def test_every_section_of_a_run_is_there(self):
        for name in ("certificate", "levels", "solid", "drawn", "assembly"):
            heads = re.findall(r"<h[23]>(.*?)</h[23]>", self.pages[name])
            self.assertEqual([title for title in TITLES if title not in heads], [], name)

    def test_probes_have_tables_and_curves(self):
        found = {probe["name"]: probe for probe in self.summary("probes")["probes"]}
        text = text_of(self.pages["probes"])
        self.assertIn("sole: punch from (0, 0) to (1, 0).", self.captions("probes"))
        corner, ground = found["corner"], found["ground"]
        row = f"corner punch (1, 1) ({corner['displacement'][0]:.4g}, {corner['displacement'][1]:.4g})".replace("-", "\u2212")
        self.assertIn(row, text)
        self.assertIn(f"ground foundation: bottom {ground['measure']:.4g} ", text)
        self.assertIn("Probes", re.findall(r"<h2>(.*?)</h2>", self.pages["probes"]))
        self.assertNotIn("Probes", re.findall(r"<h2>(.*?)</h2>", self.pages["certificate"]))

    def test_the_verdict_says_peak_bound_and_what_helps(self):
        state, text = verdict_of(self.pages["certificate"])
        errors, contact = self.summary("certificate")["errors"], self.summary("certificate")["interfaces"][0]
        self.assertIn(f"Peak pressure {contact['largest_pressure']:.4g} at (1, 0), at an edge, where finer meshes show larger values;", text)
        self.assertIn(f"error in energy at most {100 * errors['global']['relative']:.3g} %, guaranteed", text)
        self.assertIn(errors["advice"], text)
        state, text = verdict_of(self.pages["levels"])
        self.assertEqual(state, "right" if all(e["met"] for e in self.summary("levels")["expectations"]) else "wrong")
        self.assertIn("the target of 5 % is reached", text)

    def test_the_peak_of_a_round_contact_is_a_number_of_the_solution(self):
        for name in ("drawn", "hertz"):
            text = verdict_of(self.pages[name])[1]
            self.assertIn("Peak pressure", text)
            self.assertNotIn("finer meshes show", text)

    def test_given_displacements_are_said_with_their_values(self):
        self.assertIn("displacement at top: y: -0.01", text_of(self.pages["moved"]))

    def test_a_run_without_estimate_claims_nothing(self):
        state, text = verdict_of(self.pages["without-bound"])
        self.assertEqual(state, "look")
        self.assertIn("the error was not estimated", text)
        self.assertNotIn("guaranteed", text)

    def test_a_bound_that_is_not_guaranteed_says_why(self):
        summary = self.summary("certificate")
        summary["expectations"] = []
        summary["errors"]["global"].update(guaranteed=False, reason="a load that cannot be enclosed.")
        self.path("unsure.summary.json").write_text(json.dumps(summary))
        state, text = verdict_of(self.runs.report("unsure").read_text())
        self.assertEqual(state, "look")
        self.assertIn("not guaranteed (a load that cannot be enclosed)", text)
        self.assertNotIn("at most", text)

    def test_a_large_bound_is_not_praised(self):
        summary = self.summary("certificate")
        summary["expectations"] = []
        for relative, state in ((0.05, "right"), (1.17, "look")):
            summary["errors"]["global"]["relative"] = relative
            self.path("large.summary.json").write_text(json.dumps(summary))
            shown, text = verdict_of(self.runs.report("large").read_text())
            self.assertEqual(shown, state)
            self.assertEqual("the bound of the error is above 100 %: it says nothing about the answer" in text, relative > 1.0)

    def test_no_solution_is_said_and_nothing_is_drawn(self):
        state, text = verdict_of(self.pages["no-solution"])
        self.assertEqual(state, "wrong")
        self.assertIn("There is no solution", text)
        self.assertNotIn("<h2>Forces</h2>", self.pages["no-solution"])

    def test_warnings_and_missed_expectations_are_in_the_verdict(self):
        summary = self.summary("without-bound")
        summary["warnings"] = [{"kind": "locking", "message": "order 1 <b>"}]
        summary["expectations"] = [{"name": "a number", "value": 1.0, "expected": 2.0, "tolerance": 0.1, "met": False}]
        self.path("wary.summary.json").write_text(json.dumps(summary))
        page = self.runs.report("wary").read_text()
        self.assertEqual(verdict_of(page)[0], "wrong")
        self.assertIn("1 expectation of the deck missed (a number)", verdict_of(page)[1])
        self.assertIn("order 1 &lt;b&gt;", page)

    def test_pictures_are_not_empty(self):
        for name, page in self.pages.items():
            for png in re.findall(r'href="data:image/png;base64,([^"]+)"', page):
                pixels = matplotlib.image.imread(io.BytesIO(base64.b64decode(png)), format="png")
                self.assertGreater(pixels.std(axis=(0, 1)).max(), 0.01, name)
        for name in ("certificate", "levels", "solid", "drawn", "assembly"):
            self.assertGreaterEqual(self.pages[name].count("<svg"), 4, name)
            self.assertIn("data:image/png", self.pages[name])

    def test_admissible_traction_bound_over_dofs_and_bracket_are_drawn(self):
        for name in ("certificate", "levels", "drawn"):
            self.assertIn("admissible pressure is the one of the error bound", self.captions(name), name)
        self.assertNotIn("admissible", self.captions("without-bound"))
        self.assertIn("Bound of the error and its parts on every level", self.captions("levels"))
        self.assertIn("exact energy lies", self.captions("levels"))
        self.assertIn("Stopping quantity after every sweep", self.captions("certificate"))

    def test_forces_of_every_body_add_up(self):
        for name in ("certificate", "assembly", "solid"):
            rests = re.findall(r"<td>sum</td><td[^>]*>0 to within ([\d.e−]+) of the largest", self.pages[name])
            self.assertGreaterEqual(len(rests), 2, name)
            self.assertLess(max(float(rest.replace("−", "-")) for rest in rests), 1e-9, name)

    def test_the_program_and_its_libraries_are_named(self):
        build, text = self.summary("levels")["build"], text_of(self.pages["levels"])
        self.assertIn(f"commit {build['commit']} ", text)
        self.assertIn(f"CHOLMOD {build['libraries']['CHOLMOD']}", text)

    def test_nothing_of_the_page_is_elsewhere(self):
        for name, page in self.pages.items():
            links = re.findall(r'(?:src|href|xlink:href)="([^"#][^"]*)"', page)
            self.assertEqual([link for link in links if not link.startswith("data:")], [], name)
            self.assertNotIn("<script", page)
            self.assertNotIn("@import", page)
            self.assertEqual(re.findall(r"url\((?!#)", page), [], name)

    def test_identifiers_of_the_pictures_are_all_different(self):
        for name, page in self.pages.items():
            ids = re.findall(r'\bid="([^"]+)"', page)
            self.assertEqual(len(ids), len(set(ids)), name)
            self.assertEqual([u for u in re.findall(r'(?:url\(|href=")#([^")]+)', page) if u not in ids], [], name)

    def test_the_deck_of_the_page_runs_and_gives_the_same(self):
        deck = re.search(r"<pre>(.*?)</pre>", self.pages["certificate"], re.DOTALL)[1]
        for escaped, char in (("&lt;", "<"), ("&gt;", ">"), ("&#34;", '"'), ("&#39;", "'"), ("&amp;", "&")):
            deck = deck.replace(escaped, char)
        self.path("again.xml").write_text(deck)
        done = self.runs.call("-q", "-i", "again.xml", "--set", "Output/Name=again")
        self.assertIn(done.returncode, (0, 4), done.stderr)
        self.assertEqual(self.summary("again")["energy"], self.summary("certificate")["energy"])
        self.assertEqual(self.summary("again")["errors"], self.summary("certificate")["errors"])

    def test_a_study_shows_its_trends_and_cases(self):
        state, text = verdict_of(self.pages["study"])
        self.assertEqual(state, "right")
        self.assertIn("6 cases over", text)
        for label in ("energy a(u,u) over", "bound of the error over", "sweeps over"):
            self.assertIn(f'aria-label="{label}', self.pages["study"])
        rows = re.search(r"<h2>Cases</h2>.*?<tbody>(.*?)</tbody>", self.pages["study"], re.DOTALL)[1]
        self.assertEqual(rows.count("<tr"), 6)

    def test_load_cases_show_their_trends_and_the_last_one(self):
        page = self.pages["cases"]
        state, text = verdict_of(page)
        self.assertEqual(state, "wrong")
        self.assertIn("4 cases over factors of loads", text)
        self.assertIn("1 case did not end with exit code 0", text)
        self.assertIn("A punch under four loads", page)
        self.assertIn("pulls off upper along +y", page)
        for label in ("energy a(u,u) over name", "largest contact pressure over name", "interfaces/contact/contact_force over name"):
            self.assertIn(f'aria-label="{label}', page)
        for section in ("Bodies, case with weight", "Contact, case with weight"):
            self.assertIn(f"<h2>{section}</h2>", page)
        rows = re.search(r"<h2>Cases</h2>.*?<tbody>(.*?)</tbody>", page, re.DOTALL)[1]
        self.assertEqual(rows.count("<tr"), 4)

    def test_one_load_case_has_the_page_of_a_run(self):
        done = self.runs.call("report", "cases", "--case", "full")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = self.path("cases.full.report.html").read_text()
        self.assertIn("0.5", page)
        for section in ("Bodies", "Contact", "How wrong is it?"):
            self.assertRegex(page, f"<h2[^>]*>{re.escape(section)}</h2>")
        self.assertIn('there is no load case "ful"; ', self.runs.call("report", "cases", "--case", "ful").stderr)
        self.assertIn("certificate has no load cases", self.runs.call("report", "certificate", "--case", "full").stderr)

    def test_a_case_that_failed_is_named(self):
        lines = self.path("study.study.csv").read_text().splitlines()
        heads, cells = lines[0].split(","), re.findall(r'"[^"]*"|[^,]*', lines[1])
        broken = lines[1][: lines[1].rindex(",")] + ",the sweeps gave up"
        place = heads.index("exit_code")
        parts = re.findall(r'(?:"[^"]*"|[^,"]+)?(?:,|$)', broken)
        parts[place] = "3,"
        self.path("failing.study.csv").write_text("\n".join([lines[0], "".join(parts), *lines[2:]]) + "\n")
        page = self.runs.report("failing.study.csv".removesuffix(".study.csv")).read_text()
        self.assertEqual(verdict_of(page)[0], "wrong")
        self.assertIn("the sweeps gave up", page)

    def test_what_is_missing_is_said(self):
        page = self.pages["hidden-fields"]
        self.assertIn("there is no hidden-fields.e (Output/Exodus is false)", page)
        self.assertIn("contact: pressure and gap along the side", page)

    def test_damaged_fields_leave_a_report_without_pictures(self):
        for content in (b"", b"not Exodus", self.path("certificate.e").read_bytes()[:9000]):
            for ending in (".summary.json", ".contact.csv"):
                self.path(f"broken{ending}").write_bytes(self.path(f"certificate{ending}").read_bytes())
            self.path("broken.e").write_bytes(content)
            page = self.runs.report("broken").read_text()
            self.assertIn("Not in this report: pictures of the bodies", page)

    def test_fields_of_another_run_are_not_drawn(self):
        self.path("mixed.summary.json").write_bytes(self.path("certificate.summary.json").read_bytes())
        self.path("mixed.e").write_bytes(self.path("without-bound.e").read_bytes())
        self.assertIn("belongs to another run", self.runs.report("mixed").read_text())

    def test_damaged_tables_are_said(self):
        self.path("torn.summary.json").write_bytes(self.path("certificate.summary.json").read_bytes())
        self.path("torn.contact.csv").write_text("interface,x\ncontact,zero\n")
        self.assertIn("torn.contact.csv is damaged", self.runs.report("torn").read_text())

    def refused(self, *arguments):
        done = self.runs.call("report", *arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def test_wrong_names_and_damaged_summaries_are_refused(self):
        self.assertIn("there is no nothing.summary.json and no nothing.study.csv; run the deck first", self.refused("nothing"))
        self.path("cut.summary.json").write_bytes(self.path("certificate.summary.json").read_bytes()[:500])
        self.assertIn("cut.summary.json cannot be read as an ndframe summary", self.refused("cut"))
        self.path("other.summary.json").write_text('{"version": 1}')
        self.assertIn("other.summary.json cannot be read as an ndframe summary", self.refused("other"))
        summary = self.summary("certificate")
        del summary["residuals"]
        self.path("older.summary.json").write_text(json.dumps(summary))
        self.assertIn("cannot be read as an ndframe summary (KeyError: 'residuals')", self.refused("older"))
        self.path("empty.study.csv").write_text("case,dofs\n")
        self.assertIn("is not the table of a study", self.refused("empty"))
        self.assertIn("usage: ndframe report", self.refused())
        self.assertIn("cannot write", self.refused("certificate", "--output", "nowhere/page.html"))

    def test_any_of_the_files_names_the_run(self):
        for name in ("certificate.e", "certificate.summary.json", "certificate.report.html", "./certificate", "decks/certificate.xml"):
            self.path("certificate.report.html").unlink(missing_ok=True)
            done = self.runs.call("report", name)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(self.path("certificate.report.html").exists(), name)
        self.assertEqual([p.name for p in self.runs.folder.iterdir() if p.name.startswith(".")], [])

    def test_the_deck_can_ask_for_it(self):
        settings = ["--set", "Output/Name=asked", "--set", "Output/Report=true"]
        done = self.runs.call("-i", DECKS / "punch.xml", *settings)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("asked.report.html", done.stdout)
        self.assertIn("<h2>Scene</h2>", self.path("asked.report.html").read_text())
        done = self.runs.call("-i", DECKS / "punch.xml", *settings, "--set", "Output/Summary=false")
        self.assertEqual(done.returncode, 2)
        self.assertIn("a report is made from the summary; Summary must not be false", done.stderr)
        done = self.runs.call("-q", "-i", DECKS / "study.xml", *settings)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("6 cases over", self.path("asked.report.html").read_text())

    def test_without_scripts_or_packages_it_says_what_to_install(self):
        done = subprocess.run([PROGRAM, "report", "x"], env={"NDFRAME_SHARE": "/nowhere"}, text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("the report's scripts are not in /nowhere/ndreport", done.stderr)
        start = DECKS.parent / "apps/ndreport/__main__.py"
        spec = importlib.util.spec_from_file_location("start", start)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        self.assertEqual(module.missing_packages(lambda name: None if name == "jinja2" else name), ["python3-jinja2"])
        done = subprocess.run([sys.executable, "-S", "-I", start, "--check"], text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("apt-get install python3-netcdf4 python3-matplotlib python3-jinja2", done.stderr)


TEXTS = """return [...document.querySelectorAll('figure svg')].map(svg => [...svg.querySelectorAll('text')]
  .filter(t => t.textContent.trim()).map(t => { const b = t.getBoundingClientRect(), m = t.getScreenCTM();
    return [t.textContent.trim(), parseFloat(getComputedStyle(t).fontSize) * Math.hypot(m.a, m.b),
            b.left, b.top, b.right, b.bottom]; }))"""
FRAMES = """return [...document.querySelectorAll('figure svg')].map(svg => { const b = svg.getBoundingClientRect();
  return [b.left, b.top, b.right, b.bottom]; })"""
INKS = """const s = getComputedStyle(document.body); return [s.color, s.backgroundColor]"""


def luminance(colour):
    channels = [int(c) / 255.0 for c in re.findall(r"\d+", colour)[:3]]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


class Shown(unittest.TestCase):
    """What a browser makes of the pages."""

    @classmethod
    def setUpClass(cls):
        cls.browser = cls.enterClassContext(Browser())

    def look(self, width, dark):
        for name in RUNS:
            with self.subTest(name=name, width=width, dark=dark):
                self.browser.open(RESULTS.folder / f"{name}.report.html", width, dark)
                if KEPT:
                    self.browser.picture(KEPT / f"{name}.{width}{'.dark' if dark else ''}.png")
                self.check(RESULTS.folder / f"{name}.report.html", width, dark)

    def check(self, path, width, dark):
        self.assertEqual(self.browser.logs("browser"), [], "console")
        asked = [url for url in self.browser.requests() if not url.startswith("data:")]
        self.assertEqual(asked, [path.resolve().as_uri()], "network")
        ink, paper = (luminance(colour) for colour in self.browser.run(INKS))
        self.assertEqual(paper < ink, dark, "light on dark")
        self.assertGreater((max(ink, paper) + 0.05) / (min(ink, paper) + 0.05), 7.0, "contrast")
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width, "page is too wide")
        self.check_labels()

    def check_labels(self):
        for frame, texts in zip(self.browser.run(FRAMES), self.browser.run(TEXTS)):
            for text, size, left, top, right, bottom in texts:
                self.assertGreater(size, 8.5, f"\"{text}\" is tiny")
                inside = left > frame[0] - 2 and right < frame[2] + 2 and top > frame[1] - 2 and bottom < frame[3] + 2
                self.assertTrue(inside, f"\"{text}\" is cut off")
            for i, (one, _, *a) in enumerate(texts):
                for other, _, *b in texts[i + 1 :]:
                    across = min(a[2], b[2]) - max(a[0], b[0])
                    along = min(a[3], b[3]) - max(a[1], b[1])
                    self.assertFalse(across > 1.5 and along > 4.0, f"\"{one}\" and \"{other}\" overlap")

    def test_wide_and_light(self):
        self.look(1280, False)

    def test_wide_and_dark(self):
        self.look(1280, True)

    def test_narrow_and_light(self):
        self.look(420, False)

    def test_on_paper(self):
        for name in RUNS:
            self.browser.open(RESULTS.folder / f"{name}.report.html", 1280, True)
            target = RESULTS.folder / f"{name}.pdf"
            self.browser.printed(target)
            self.assertTrue(target.read_bytes().startswith(b"%PDF"))


if __name__ == "__main__":
    if "Shown" in sys.argv and missing_programs():
        print(f"skipped: not installed: {', '.join(missing_programs())} (Debian: chromium, chromium-driver)")
        sys.exit(77)
    unittest.main()
