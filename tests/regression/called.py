"""What the tests of nddiff and ndregress share: the program called in this process, with its screen caught."""

import contextlib
import io
import pathlib
import tempfile
import unittest


class Called(unittest.TestCase):
    """A folder a test. Subclasses say what `program(arguments)` is: texts -> exit code."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, *arguments):
        """(exit code, screen, errors)."""
        screen, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(screen), contextlib.redirect_stderr(errors):
            code = self.program([str(argument) for argument in arguments])
        return code, screen.getvalue(), errors.getvalue()

    def assert_success(self, *arguments):
        code, screen, _ = self.call(*arguments)
        self.assertEqual(code, 0, screen)

    def assert_failure(self, words, *arguments):
        """Exit code 1; `words`: a text, or several, that the screen shows."""
        code, screen, _ = self.call(*arguments)
        self.assertEqual(code, 1, screen)
        for word in [words] if isinstance(words, str) else words:
            self.assertIn(word, screen)

    def assert_refused(self, words, *arguments):
        code, _, errors = self.call(*arguments)
        self.assertEqual(code, 2)
        self.assertIn(words, errors)


class Comparison(Called):
    """Calls nddiff; its package is on the path of whoever runs the test."""

    @staticmethod
    def program(arguments):
        from harness.nddiff import main

        return main(arguments)
