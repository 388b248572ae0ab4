"""What the libraries alone need for a deck's bodies: `ndframe --yardstick`, ordering, factorisation and one solve."""

import json
import pathlib
import tempfile

from bench.child import cost_of
from bench.program import arguments


def processor_seconds(program, deck, settings):
    """Processor seconds of all bodies together."""
    with tempfile.TemporaryDirectory(prefix="ndbench-") as folder:
        cost, text = cost_of([program, "--yardstick", *arguments(deck, settings)], folder)
        if cost.exit != 0:
            raise SystemExit(f"ndbench: {program} --yardstick returned {cost.exit} on {deck}:\n{text}")
        return json.loads(next(pathlib.Path(folder).glob("*.yardstick.json")).read_text())["all"]["total"]["processor"]
