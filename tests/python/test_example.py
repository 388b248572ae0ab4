"""The example of docs/python.md: test_example.py NDFRAME SOURCES."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image

PROGRAM, SOURCES = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))


class Example(unittest.TestCase):
    def test_draws_all_three_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "PYTHONPATH": str(SOURCES / "python"), "NDFRAME_PROGRAM": str(PROGRAM)}
            command = [sys.executable, "-B", SOURCES / "docs/examples/bearing.py", SOURCES / "decks/bearing.xml", "bearing.png"]
            done = subprocess.run(command, cwd=folder, env=environment, text=True, capture_output=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("A pin in a hole with clearance: largest pressure 0.007", done.stdout)
            picture = matplotlib.image.imread(f"{folder}/bearing.png")
        width = picture.shape[1] // 3
        for part in range(3):
            self.assertGreater(picture[:, part * width : (part + 1) * width, :3].std(axis=(0, 1)).max(), 0.02, part)

    def test_page_names_the_file(self):
        self.assertIn("docs/examples/bearing.py", (SOURCES / "docs/python.md").read_text())


if __name__ == "__main__":
    unittest.main()
