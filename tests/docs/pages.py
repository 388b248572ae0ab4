"""Pages whose commands are run.

Blocks ```sh are run in order, in one folder a page, and stop at the first command that fails. A block ```text after them is what the
screen shows: its lines come in this order, with any spaces; `...` on a line of its own stands for lines left out, inside a line for
anything. Without it the first line of the block is looked for, and the others follow it line by line, empty ones left out.
A block of another language whose first line is a comment with a file's name, `// two.geo: ...`, is that file.
"""

import dataclasses
import re

FILE = re.compile(r"(?://|#|<!--) ([\w-]+\.\w+): ")


@dataclasses.dataclass(frozen=True)
class Block:
    language: str
    text: str
    line: int


def blocks_of(page):
    """All fenced blocks of a page; `line` is that of the fence."""
    found, begin = [], None
    lines = page.splitlines()
    for number, line in enumerate(lines, 1):
        if begin is None and (match := re.match(r"```(\S+)", line)):
            begin = match[1], number
        elif begin is None and line.startswith("```"):
            begin = "", number
        elif begin is not None and line == "```":
            language, first = begin
            found.append(Block(language, "\n".join(lines[first : number - 1]) + "\n", first))
            begin = None
    return found


def file_of(block):
    """The name of the file that a block is, None if it is none."""
    match = FILE.match(block.text)
    return match[1] if match and block.language not in ("sh", "text", "") else None


def pattern(line):
    return re.compile(r"\s+".join(".*?".join(map(re.escape, word.split("..."))) for word in line.split()) + r"\s*$")


def find(wanted, lines, start, anywhere):
    """Index of the line, from `start` on; only there unless anywhere. None if it is not found."""
    expression = pattern(wanted)
    for index in range(start, len(lines) if anywhere else min(start + 1, len(lines))):
        if expression.match(lines[index].strip()):
            return index
    return None


def missing_line(shown, screen):
    """The first line of a text block that the screen does not show at its place; None if all are there."""
    lines = [line for line in screen.splitlines() if line.strip()]
    place, anywhere = 0, True
    for wanted in shown.splitlines():
        if not wanted.strip():
            continue
        if wanted.strip() == "...":
            anywhere = True
            continue
        found = find(wanted, lines, place, anywhere)
        if found is None:
            return wanted
        place, anywhere = found + 1, False
    return None
