"""Which sources of one program or library can be compiled as one: source_groups.py SOURCES...

Prints a line for each group of two and more, its sources separated by semicolons; what is in no group is compiled alone.

Sources of one group mean the same together as apart: a name that one of them has to itself, in an unnamed namespace,
occurs in no other of them, not even as a local name. So no definition clashes, and no call finds another function.
Sources with macros or with instructions to the compiler itself - attributes, pragmas, intrinsics; also in a header beside them -
stay alone, so that kernels are compiled as ever, and so do those that use another namespace than ours as a whole. The groups
depend on nothing but the texts and their order.
"""

import pathlib
import re
import sys

MOST_SOURCES = 10
FOR_THE_COMPILER = re.compile(r"__attribute__|#\s*pragma\s+(?!once)|immintrin|\busing\s+namespace\s+(?!ndframe\b|test\b)")
DROPPED = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'", re.S)
PARTS = re.compile(r"[{};]|[^{};]+")
WORD = re.compile(r"[A-Za-z_]\w*")
# What can stand last before a bracket without being the name.
KEYWORDS = {"const", "constexpr", "noexcept", "int", "double", "bool", "void", "auto"}


def without_text(source):
    """The source without comments and literals."""
    return DROPPED.sub(lambda found: " " if found[0].startswith("/") else '""', source)


def heads(code):
    """What stands before a block or a semicolon directly in an unnamed namespace: declarations without their bodies."""
    depth, unnamed, head = 0, [], ""
    for token in PARTS.findall(code):
        if token not in "{};":
            head = token
            continue
        is_direct = bool(unnamed) and unnamed[-1] == depth
        if token == "{":
            depth += 1
            if re.search(r"\bnamespace\s*$", head):
                unnamed.append(depth)
                is_direct = False
        elif token == "}":
            if is_direct:
                unnamed.pop()
            depth -= 1
            is_direct = False
        if is_direct:
            yield head
        head = ""


def declarators(head):
    """The parts of a declaration between its commas, each up to its bracket or value, without template arguments."""
    parts, angles, others, is_over = [""], 0, 0, False
    for c in head:
        if c in "<>" and others == 0 and not is_over:
            angles += 1 if c == "<" else -1
        elif angles == 0 and others == 0 and c == ",":
            parts.append("")
            is_over = False
        elif angles == 0 and others == 0 and not is_over:
            is_over = c in "(=["
            parts[-1] += "" if is_over else c
        others += (c in "([") - (c in ")]")
    return parts


def own_names(code):
    """Names that the source has to itself: all that its unnamed namespaces declare but operators and tests."""
    names = set()
    for head in heads(re.sub(r"^\s*#[^\n]*", "", code, flags=re.M)):
        if re.search(r"\boperator\b|\busing\s+namespace\b|^\s*(?:[A-Z]+_)*TEST(?:_[A-Z]+)*\s*\(", head):
            continue
        for declarator in declarators(head):
            type_name = re.search(r"\b(?:struct|class|enum|union)\s+(?:class\s+|struct\s+)?(\w+)", declarator)
            words = [word for word in WORD.findall(declarator) if word not in KEYWORDS]
            names.update([type_name[1]] if type_name else words[-1:])
        names.update(WORD.findall("".join(re.findall(r"\bauto\s*&*\s*\[([^]]*)\]", head))))
    return names


class Source:
    """A source with the words in it and the names that it has to itself."""

    def __init__(self, path):
        text = pathlib.Path(path).read_text(encoding="utf-8")
        code = without_text(text)
        beside = [pathlib.Path(path).parent / name for name in re.findall(r'^#include "([^"]+)"', text, re.M)]
        headers = [without_text(header.read_text(encoding="utf-8")) for header in beside if header.is_file()]
        self.path = path
        self.is_alone = any(FOR_THE_COMPILER.search(part) for part in [code, *headers]) or "#define" in code
        self.words = set(WORD.findall(code))
        self.own = own_names(code)

    def goes_with(self, other):
        return not (self.own & other.words or other.own & self.words)


def groups(sources):
    """Every source goes to the first group that it fits in."""
    result = []
    for source in sources:
        if source.is_alone:
            continue
        fitting = (g for g in result if len(g) < MOST_SOURCES and all(source.goes_with(other) for other in g))
        group = next(fitting, None)
        if group is None:
            result.append([source])
        else:
            group.append(source)
    return [group for group in result if len(group) > 1]


def main():
    for group in groups([Source(path) for path in sys.argv[1:]]):
        print(";".join(source.path for source in group))


if __name__ == "__main__":
    main()
