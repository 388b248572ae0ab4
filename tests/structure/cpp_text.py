"""Finds the functions of a C++ text by its braces: an estimate that needs no compiler and copes with our formatted code."""

import dataclasses
import re

# Comments and literals. A raw string comes first: its inside may look like anything.
_TOKEN = re.compile(
    r'R"(?P<mark>[^()\\\s]{0,16})\((?:.|\n)*?\)(?P=mark)"'
    r'|"(?:[^"\\\n]|\\.)*"'
    r"|(?<![0-9a-fA-F])'(?:[^'\\\n]|\\.)+'"
    r"|//[^\n]*"
    r"|/\*(?:.|\n)*?\*/"
)


@dataclasses.dataclass(frozen=True)
class Function:
    name: str
    line: int
    num_lines: int
    code: str  # comments and the insides of literals blanked
    text: str  # the same characters as written


def blanked(text):
    """The text with comments, literals' insides and preprocessor lines as spaces; line breaks and quotes stay."""

    def blank(match):
        inside = re.sub(r"[^\n]", " ", match[0])
        is_string = match[0][0] in "R\""
        return '"' + inside[1:-1] + '"' if is_string else inside

    text = _TOKEN.sub(blank, text)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.MULTILINE)


def _opens_scope(head):
    return re.search(r"\b(namespace|class|struct|enum|union|extern)\b", re.sub(r"template\s*<[^{}]*?>", "", head)) and not (
        re.search(r"\)\s*(const|noexcept|override|final|->.*)*\s*$", head)
    )


def _opens_initializer(head):
    """`x = {`, `member_{` or `member_([] {` in a class or in a constructor's list of initialisers."""
    if ")" not in head or head.count("(") > head.count(")") or re.search(r"[=,]\s*$", head):
        return True
    in_initialisers = re.search(r"\)\s*(noexcept\s*)?:(?!:)", head)
    return bool(in_initialisers and re.search(r"[\w>]\s*$", head))


def _name(head):
    match = re.search(r"(operator[^\s(]*|[~\w:]+)\s*(?:<[^<>()]*>)?\s*\(", head)
    return match[1] if match else "a function"


def functions(text):
    """Every function with a body, lambdas at namespace level included; a function's own lambdas belong to it."""
    code = blanked(text)
    found, scopes, start = [], [], 0
    position = 0
    while position < len(code):
        char = code[position]
        if char in ";" or (char == "}" and not scopes):
            start = position + 1
        elif char == "{":
            head = code[start:position]
            if _opens_scope(head):
                start = position + 1
                scopes.append("scope")
            elif _opens_initializer(head):
                position = _closing(code, position)
            else:
                end = _closing(code, position)
                found.append(_function(text, code, start, end))
                position, start = end, end + 1
        elif char == "}":
            scopes.pop()
            start = position + 1
        position += 1
    return found


def _closing(code, opening):
    """The place of the brace that closes the one at `opening` (the text's end if there is none)."""
    depth = 0
    for match in re.compile(r"[{}]").finditer(code, opening):
        depth += 1 if match[0] == "{" else -1
        if depth == 0:
            return match.start()
    return len(code) - 1


def _function(text, code, start, end):
    begin = start + re.search(r"\S", code[start:]).start()
    head = code[begin : code.index("{", begin)]
    as_written = text[begin : end + 1]
    # The lines of a raw string are data, not code.
    data_lines = sum(token[0].count("\n") for token in _TOKEN.finditer(as_written) if token[0].startswith("R"))
    num_lines = as_written.count("\n") + 1 - data_lines
    return Function(_name(head), code.count("\n", 0, begin) + 1, num_lines, code[begin : end + 1], as_written)


def has_product(code, start):
    """True if `code` from `start` to the parenthesis that closes before it has a product outside of its brackets, of no
    doubles."""
    depth, found = 0, False
    for place in range(start, len(code)):
        letter = code[place]
        depth += (letter in "([{") - (letter in ")]}")
        if depth < 0:
            return found and "double(" not in code[start:place]
        found = found or (depth == 0 and re.match(r"\s\*\s", code[place - 1 : place + 2]) is not None)
    return False
