"""How the commands of pages are run and compared."""

import os
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
from pages import blocks_of, file_of, missing_line  # noqa: E402
from run_page import run_page  # noqa: E402

SCREEN = "head\n\n  a   1.5 s   x\n  b   2.5 s   y\n  end\n"


class Shown(unittest.TestCase):
    def assert_shown(self, *lines):
        self.assertIsNone(missing_line("\n".join(lines), SCREEN))

    def assert_missing(self, line, *lines):
        self.assertEqual(missing_line("\n".join(lines), SCREEN), line)

    def test_spaces_and_dots(self):
        self.assert_shown("head", "a 1.5 s x", "b ... y")
        self.assert_shown("a ...", "b 2.5 s y", "end")
        self.assert_shown("head", "...", "end")

    def test_first_line_may_be_anywhere_the_others_follow_it(self):
        self.assert_shown("b 2.5 s y", "end")
        self.assert_missing("end", "head", "end")
        self.assert_missing("a 1.5 s x", "b 2.5 s y", "a 1.5 s x")

    def test_numbers_and_whole_lines_count(self):
        self.assert_missing("a 1.6 s x", "a 1.6 s x")
        self.assert_missing("a 1.5 s", "a 1.5 s")
        self.assert_missing("1.5 s x", "1.5 s x")
        self.assert_missing("more", "head", "...", "more")


class Pages(unittest.TestCase):
    def run_text(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(text)
            return run_page(page, pathlib.Path(folder), dict(os.environ))

    def test_files_commands_and_what_they_show(self):
        page = "```c\n// some.txt: a file\nok\n```\nand\n```sh\ncat some.txt\n```\n```text\nok\n```\n"
        self.assertEqual([block.language for block in blocks_of(page)], ["c", "sh", "text"])
        self.assertEqual(file_of(blocks_of(page)[0]), "some.txt")
        self.assertEqual(self.run_text(page), [])
        self.assertIn('page.md:9: the screen does not show "not ok"', self.run_text(page.replace("```text\nok", "```text\nnot ok"))[0])

    def test_commands_that_fail(self):
        self.assertIn("page.md:1: ended with 3", self.run_text("```sh\nexit 3\n```\n")[0])
        self.assertIn("ended with 1", self.run_text("```sh\nfalse\necho on\n```\n")[0])
        self.assertEqual(self.run_text("```\nfalse\n```\n"), [])


if __name__ == "__main__":
    unittest.main()
