"""Checks the summaries that write_summaries writes against docs/summary.schema.json: check_schema.py WRITE_SUMMARIES SCHEMA."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

WRITE_SUMMARIES, SCHEMA = sys.argv[1:3]
#: Keys that not every summary has, by the path of their object.
OPTIONAL = {(): {"probes"}}


def objects(node, path=()):
    """All JSON objects below `node` whose keys the schema fixes, with the path to each."""
    if isinstance(node, dict) and path[-1:] not in (("deck",), ("counts",)):
        yield path
        for key, value in node.items():
            yield from objects(value, path + (key,))
    elif isinstance(node, list):
        for index, value in enumerate(node):
            yield from objects(value, path + (index,))


def at(node, path):
    for key in path:
        node = node[key]
    return node


class SummaryFollowsItsSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        schema = json.loads(pathlib.Path(SCHEMA).read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        cls.validator = jsonschema.Draft7Validator(schema)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([WRITE_SUMMARIES, folder], check=True)
            cls.samples = [json.loads(path.read_text()) for path in sorted(pathlib.Path(folder).glob("*.summary.json"))]

    def test_samples_are_valid(self):
        self.assertEqual(len(self.samples), 3)
        for sample in self.samples:
            self.validator.validate(sample)

    def test_every_key_is_required(self):
        for sample in self.samples:
            for path in objects(sample):
                for key in at(sample, path).keys() - OPTIONAL.get(path, set()):
                    broken = copy.deepcopy(sample)
                    del at(broken, path)[key]
                    self.assertFalse(self.validator.is_valid(broken), (path, key))

    def test_every_type_is_checked(self):
        for sample in self.samples:
            for path in objects(sample):
                for key in at(sample, path):
                    broken = copy.deepcopy(sample)
                    at(broken, path)[key] = {"of": "another type"}
                    if (path, key) != ((), "deck"):
                        self.assertFalse(self.validator.is_valid(broken), (path, key))

    def test_no_key_is_left_out_of_the_schema(self):
        for sample in self.samples:
            for path in objects(sample):
                broken = copy.deepcopy(sample)
                at(broken, path)["unheard of"] = 1
                self.assertFalse(self.validator.is_valid(broken), path)

    def test_not_a_number_is_null(self):
        contact = next(sample for sample in self.samples if sample["coupling"])
        self.assertIsNone(contact["coupling"]["history"][1]["eps_tau"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
