"""Every parameter of the deck has a sentence, and a number says its unit, or what it is that has none: test_reference.py SOURCES."""

import pathlib
import re
import sys
import unittest

SOURCES = pathlib.Path(sys.argv.pop(1)).resolve()
UNIT = re.compile(r"length|stress|second|\bMB\b|dimension|degree|relative|share|ratio|unit|energ|force|area|times|angle|fraction|factor|"
                  r"number of|strain|densit|order|% of|coordinate|GB|multipl|sum of|eps", re.IGNORECASE)


def parameters(text):
    """[name, type, default, range, sentence] of the tables; a bar inside a cell is escaped."""
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]
        if len(cells) == 5 and cells[0].startswith("`"):
            yield cells


class Reference(unittest.TestCase):
    def test_parameters_have_sentences_and_units(self):
        rows = list(parameters((SOURCES / "docs/reference.md").read_text()))
        self.assertGreater(len(rows), 150)
        self.assertEqual([row[0] for row in rows if not re.match(r".*\w.*[.)]$", row[4], re.DOTALL)], [])
        numbers = [row for row in rows if row[1] in ("double", "Array(double)", "expression")]
        self.assertGreater(len(numbers), 50)
        self.maxDiff = None
        self.assertEqual([row[0] + ": " + row[4] for row in numbers if not UNIT.search(row[4])], [])


if __name__ == "__main__":
    unittest.main()
