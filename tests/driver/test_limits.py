"""docs/limits.md against the program: test_limits.py NDFRAME ROOT. Messages are in the sources, words in quotes have an answer."""

import pathlib
import re
import subprocess
import sys
import unittest

PROGRAM, ROOT = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
TEXT = (ROOT / "docs/limits.md").read_text()


def literals():
    """The string literals of the sources, neighbours joined as the compiler does."""
    for path in sorted((ROOT / "packages").rglob("*.cpp")):
        source = re.sub(r'"\s*\n\s*"', "", path.read_text())
        yield from re.findall(r'"((?:[^"\\]|\\.)*)"', source)


class Limits(unittest.TestCase):
    def test_messages_are_those_of_the_program(self):
        known = "\n".join([*literals(), (ROOT / "tests/driver/wrong_decks.json").read_text()])
        messages = [code.removesuffix("...").strip() for code in re.findall(r"`([^`]+)`", TEXT) if len(code.split()) > 5]
        self.assertGreater(len(messages), 4)
        self.assertEqual([message for message in messages if message not in known and message != "ndframe --help WORD"], [])

    def test_words_in_quotes_have_an_answer(self):
        words = re.findall(r'"([^"]+)"', TEXT)
        self.assertGreater(len(words), 8)
        for word in [*words, "friction", "Friction", "GPU"]:
            done = subprocess.run([PROGRAM, "--help", word], text=True, capture_output=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("not in this version; nearest: ", done.stdout, word)

    def test_no_list_or_component_is_called_like_a_limit(self):
        listed = subprocess.run([PROGRAM, "--list"], text=True, capture_output=True).stdout.lower().split()
        self.assertEqual([word for word in re.findall(r'"([^"]+)"', TEXT) if word in listed], [])


if __name__ == "__main__":
    unittest.main()
