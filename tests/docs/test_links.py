"""The links of the Markdown pages lead to files and headings that are there: test_links.py SOURCES.

Needs nothing but Python, so that CI checks links without the packages of the site (test_site.py follows those of the built pages).
"""

import pathlib
import re
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCES = pathlib.Path(sys.argv.pop(1)).resolve()
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)")


def pages(root):
    return [*root.glob("*.md"), *(root / "docs").rglob("*.md")]


def anchors(text):
    """Those that GitHub and MyST give to headings."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def wrong_links(root):
    """PAGE: LINK of those that lead nowhere. Links to a network are not followed."""
    for page in pages(root):
        for link in LINK.findall(CODE.sub("", page.read_text())):
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            if re.match(r"[a-z]+:", link):
                continue
            if not target.exists() or (anchor and target.suffix == ".md" and anchor not in anchors(target.read_text())):
                yield f"{page.relative_to(root)}: {link}"


class Links(unittest.TestCase):
    def test_all_lead_somewhere(self):
        self.assertGreater(len(pages(SOURCES)), 20)
        self.assertEqual(list(wrong_links(SOURCES)), [])

    def test_what_is_wrong_is_found(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name).resolve()
            (root / "docs").mkdir()
            (root / "docs/b.md").write_text("# What it is: `b`\n```sh\n# no heading\n```\n")
            (root / "a.md").write_text("[x](docs/b.md) [x](docs/b.md#what-it-is-b) [x](docs/c.md) [x](docs/b.md#no-heading)\n"
                                       "`[x](d.md)` [x](https://example.org) [x](#top)\n")
            self.assertEqual(list(wrong_links(root)), ["a.md: docs/c.md", "a.md: docs/b.md#no-heading", "a.md: #top"])


if __name__ == "__main__":
    unittest.main()
