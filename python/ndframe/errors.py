"""What goes wrong, in sentences that say what, where and how to mend it."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class Error(Exception):
    """Everything that this module raises."""


class ReadError(Error):
    """A file of a run that is missing or damaged, or a name that is not in it."""


class RunError(Error):
    """The program did not end with a code that the caller accepts.

    `code`: exit code of the program (README, exit codes; -n: ended by signal n); `screen`: what it said on the error stream;
    `results`: the Run or Study where the program wrote one all the same (codes 3 to 6), else None.
    """

    def __init__(self, message: str, code: int, screen: str, results: object = None):
        super().__init__(message)
        self.code, self.screen, self.results = code, screen, results


def unknown(place: str, what: str, name: str, known: Iterable[str]) -> ReadError:
    """The error for a name that is not among the known ones, with the nearest of them."""
    known = list(known)
    near = difflib.get_close_matches(name, known, 1)
    hint = f' Did you mean "{near[0]}"?' if near else ""
    return ReadError(f'{place}: there is no {what} "{name}"; there {"are " + ", ".join(known) if known else "is none"}.{hint}')
