"""Builds the documentation site and follows its links: test_site.py SOURCES. Exit code 77 without what docs/site/packages.txt names."""

import html.parser
import pathlib
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

sys.dont_write_bytecode = True
SOURCES = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.append(str(SOURCES / "docs/site"))
import build

SKIPPED = 77
LOADS = {("a", "href"), ("link", "href"), ("img", "src"), ("script", "src"), ("source", "src"), ("iframe", "src")}
# Links to these are text on a page; everything that a browser loads by itself has to be in the folder.
CREDITS = ("https://www.sphinx-doc.org/", "https://pradyunsg.me", "https://github.com/pradyunsg/furo", "https://www.doxygen.org/")


class Page(html.parser.HTMLParser):
    """The links of a page, [(tag, target)], and its anchors."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors, self.formulas = [], set(), 0
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag, name) == ("a", "name"):
                self.anchors.add(value)
            elif (tag, name) in LOADS and value:
                self.links.append((tag, value))
        self.formulas += tag == "math"


def wrong_links(folder):
    """Sentences about links of the pages below a folder that lead nowhere, or to a network."""
    pages = {path: Page(path) for path in folder.rglob("*.html")}
    wrong = []
    for path, page in pages.items():
        for tag, link in page.links:
            address = urllib.parse.urlsplit(link)
            if address.scheme or address.netloc:
                if address.scheme != "data" and not (tag == "a" and link.startswith(CREDITS)):
                    wrong.append(f"{path.relative_to(folder)}: {tag} {link} is on a network")
                continue
            target = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
            if not target.is_file():
                wrong.append(f"{path.relative_to(folder)}: {link} is not there")
            elif address.fragment and target in pages and urllib.parse.unquote(address.fragment) not in pages[target].anchors:
                wrong.append(f"{path.relative_to(folder)}: {link} has no such anchor")
    return wrong, pages


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name).resolve()
        command = [sys.executable, "-B", SOURCES / "docs/site/build.py", cls.folder]
        cls.built = subprocess.run(command, text=True, capture_output=True)

    def test_is_built_without_warnings_and_its_links_lead_somewhere(self):
        self.assertEqual((self.built.returncode, self.built.stderr), (0, ""))
        wrong, pages = wrong_links(self.folder / "html")
        self.assertEqual(wrong, [])
        self.assertGreater(len(pages), 100)
        self.assertGreater(pages[self.folder / "html/formulas.html"].formulas, 40)
        self.assertTrue((self.folder / "html/_static/latinmodern-math.otf").exists())

    def test_every_public_header_has_a_page(self):
        pages = (self.folder / "html/api/files.html").read_text()
        headers = [path.name for path in SOURCES.glob("packages/*/include/**/*.hpp")]
        self.assertEqual([name for name in headers if f">{name}<" not in pages], [])

    def test_every_declaration_of_a_public_header_is_documented(self):
        self.assertEqual(build.undocumented(), [])


class Links(unittest.TestCase):
    def test_what_is_wrong_is_found(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name).resolve()
            (folder / "b.html").write_text('<h1 id="here">b</h1>')
            (folder / "a.html").write_text('<a href="b.html#here">x</a><a href="c.html">x</a><a href="b.html#there">x</a>'
                                           '<script src="https://cdn.org/x.js"></script><a href="#top">x</a>')
            self.assertEqual(sorted(wrong_links(folder)[0]), [
                "a.html: #top has no such anchor", "a.html: b.html#there has no such anchor", "a.html: c.html is not there",
                "a.html: script https://cdn.org/x.js is on a network"])


if __name__ == "__main__":
    if build.missing():
        print("the packages of docs/site/packages.txt are not installed")
        sys.exit(SKIPPED)
    unittest.main()
