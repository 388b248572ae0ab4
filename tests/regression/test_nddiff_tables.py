"""nddiff on summaries and tables altered on purpose: test_nddiff_tables.py REGRESSION."""

import json
import pathlib
import sys
import unittest

import numpy

REGRESSION = pathlib.Path(sys.argv[1]).resolve()
sys.path[:0] = [str(REGRESSION), str(pathlib.Path(__file__).parent)]

from called import Comparison  # noqa: E402

SUMMARY = {
    "version": "0.1.0", "ranks": 1, "deck": {"Title": "t", "Order": 2},
    "bodies": [{"name": "punch", "energy": 0.9, "solver": "Cholmod"}], "coupling": None,
    "errors": {"guaranteed": True, "absolute": 0.08},
    "ledger": {"counts": {"sweeps": 6, "bytes written": 10}, "total_seconds": 0.5, "peak_bytes": 7,
               "stages": [{"name": "read", "seconds": 0.1, "peak_bytes": 5}]},
}


class Summaries(Comparison):
    def pair(self, change):
        """The summary and its copy after `change(copy)`."""
        gold, new = self.folder / "gold.json", self.folder / "new.json"
        copy = json.loads(json.dumps(SUMMARY))
        change(copy)
        gold.write_text(json.dumps(SUMMARY))
        new.write_text(json.dumps(copy))
        return gold, new

    def test_what_differs_from_run_to_run_is_ignored(self):
        def change(new):
            new.update(version="0.2.0", ranks=3)
            new["ledger"].update(total_seconds=1.0, peak_bytes=9)
            new["ledger"]["counts"]["bytes written"] = 11
            new["ledger"]["counts"]["settled stresses"] = 1
            new["ledger"]["stages"][0].update(seconds=0.2, peak_bytes=6)
        self.assert_success(*self.pair(change))

    def test_summaries_of_load_cases_are_compared_as_if_they_stood_alone(self):
        def of_cases(summary):
            return {"cases": [{"name": "half", "seconds": 0.1, "results": summary}]}

        gold, new = self.pair(lambda copy: copy.update(version="0.2.0", ranks=3, deck={**copy["deck"], "New": 1}))
        for path in (gold, new):
            path.write_text(json.dumps(of_cases(json.loads(path.read_text()))))
        self.assert_success(gold, new)
        new.write_text(new.read_text().replace('"energy": 0.9', '"energy": 0.91'))
        self.assert_failure("cases/half/results/bodies/punch/energy", gold, new)

    def test_a_number_differs_by_its_path(self):
        pair = self.pair(lambda new: new["bodies"][0].update(energy=0.9 + 1e-8))
        self.assert_failure("bodies/punch/energy", *pair)
        self.assert_success(*pair, "--set", "bodies/*/energy=relative 1e-7")
        self.assert_success(*self.pair(lambda new: new["bodies"][0].update(energy=numpy.nextafter(0.9, 1))))

    def test_counts_are_exact_unless_a_rule_names_them(self):
        pair = self.pair(lambda new: new["ledger"]["counts"].update(sweeps=7))
        self.assert_failure(["ledger/counts/sweeps", "6", "7"], *pair)
        self.assert_failure("ledger/counts/sweeps", *pair, "--set", "default=relative 0.5")
        self.assert_success(*pair, "--set", "ledger/counts/*=absolute 1")

    def test_words_and_verdicts_are_exact(self):
        self.assert_failure("Mumps", *self.pair(lambda new: new["bodies"][0].update(solver="Mumps")))
        self.assert_failure("errors/guaranteed", *self.pair(lambda new: new["errors"].update(guaranteed=False)))
        self.assert_failure("errors/guaranteed", *self.pair(lambda new: new["errors"].update(guaranteed=1)))

    def test_missing_and_extra_entries_fail(self):
        self.assert_failure("entry errors/absolute is missing", *self.pair(lambda new: new["errors"].pop("absolute")))
        self.assert_failure("entry errors/more is extra", *self.pair(lambda new: new["errors"].update(more=1)))
        self.assert_failure("entry ledger/stages/read/name is missing",
                              *self.pair(lambda new: new["ledger"].pop("stages")))

    def test_a_number_instead_of_null_fails(self):
        self.assert_failure("coupling", *self.pair(lambda new: new.update(coupling=1.0)))

    def test_entries_of_the_same_name_are_all_compared(self):
        twice = [{"name": "a", "value": 1.0}, {"name": "a", "value": 2.0}]
        gold, new = self.folder / "gold.json", self.folder / "new.json"
        gold.write_text(json.dumps({"expect": twice}))
        new.write_text(json.dumps({"expect": [{"name": "a", "value": 3.0}, twice[1]]}))
        self.assert_failure("expect/0/value", gold, new)

    def test_a_new_parameter_is_no_difference_but_a_changed_one_is(self):
        self.assert_success(*self.pair(lambda new: new["deck"].update(New=1)))
        self.assert_failure("deck/Order", *self.pair(lambda new: new["deck"].update(Order=1)))
        self.assert_failure("deck/Order is missing", *self.pair(lambda new: new["deck"].pop("Order")))

    def test_files_that_cannot_be_read_are_refused(self):
        gold, new = self.pair(lambda _: None)
        new.write_text("{")
        self.assert_refused("is not JSON", gold, new)
        new.write_text("[]")
        self.assert_refused("not a summary", gold, new)
        self.assert_refused("No such file", gold, self.folder / "nowhere.json")
        (self.folder / "new.csv").write_bytes(b"case\n\xff\n")
        self.assert_refused("is not a table", gold, self.folder / "new.csv")


class StudyTables(Comparison):
    def pair(self, old, new):
        text = 'case,Cells,energy,seconds,reason\n1,"{4, 4}",0.9,0.1,\n2,"{8, 8}",,0.2,"no side ""a"""\n'
        for name, content in (("gold.study.csv", text), ("new.study.csv", text.replace(old, new))):
            (self.folder / name).write_text(content)
        return self.folder / "gold.study.csv", self.folder / "new.study.csv"

    def test_numbers_by_case_and_column_the_rest_as_text(self):
        self.assert_success(*self.pair("0.9,0.1", "0.90000000001,0.3"))
        for old, new, words in (
            ("0.9", "0.91", "1/energy"), (",,0.2", ",0.5,0.2", "2/energy"), ("{8, 8}", "{9, 9}", "2/Cells"),
            ('""a""', '""b""', "2/reason"), ("energy", "E", "1/energy is missing"), ("\n2", "\n3", "3/energy is extra"),
        ):
            self.assert_failure(words, *self.pair(old, new))

    def test_tables_without_cases_are_compared_row_by_row(self):
        for new, words in (("x,y\n1,2\n3,4\n5,9\n", "3/y"), ("x,y\n1,9\n3,4\n5,6\n", "1/y"),
                           ("x,y\n1,2\n3,4\n", "entry 3/x is missing"), ("x,z\n1,2\n3,4\n5,6\n", "1/z is extra")):
            (self.folder / "gold.csv").write_text("x,y\n1,2\n3,4\n5,6\n")
            (self.folder / "new.csv").write_text(new)
            self.assert_failure(words, self.folder / "gold.csv", self.folder / "new.csv")

    def test_probes_of_load_cases_are_compared_row_by_row(self):
        gold, new = self.folder / "gold.probes.csv", self.folder / "new.probes.csv"
        gold.write_text("case,probe,u_x\nhalf,a,1\nhalf,b,2\n")
        new.write_text("case,probe,u_x\nhalf,a,1\nhalf,b,3\n")
        self.assert_success(gold, gold)
        self.assert_failure("2/u_x", gold, new)

    def test_a_case_that_stands_there_twice_is_refused(self):
        self.assert_refused("two rows of the case 1", *self.pair("\n2,", "\n1,"))


class ContactTables(Comparison):
    ROWS = ["left,0,1,0.5,0.5,1e-17,-1,-1,-0.1,1", "left,1,1,0.25,0.2,0.05,0,0,0,0",
            "right,1,1,0.25,0.25,0,-2,-2,-0.2,1"]

    def table(self, name, rows):
        path = self.folder / f"{name}.contact.csv"
        head = "interface,x,y,u_dirichlet,u_neumann,gap,traction_dirichlet,traction_neumann,nodal_force,closed"
        path.write_text("\n".join([head, *rows, ""]))
        return path

    def pair(self, *rows):
        return self.table("gold", self.ROWS), self.table("new", rows)

    def test_order_of_rows_and_round_off_do_not_matter(self):
        self.assert_success(*self.pair(*self.ROWS))
        self.assert_success(*self.pair(*reversed(self.ROWS)))
        first = self.ROWS[0].replace("1e-17", "3e-17").replace("left,0,", "left,1e-15,")
        self.assert_success(*self.pair(first, *self.ROWS[1:]))

    def test_every_number_of_every_row_counts(self):
        for i, row in enumerate(self.ROWS):
            cells = row.split(",")
            for column in range(3, len(cells)):
                changed = [*cells[:column], repr(float(cells[column]) + 1e-6), *cells[column + 1:]]
                rows = [*self.ROWS[:i], ",".join(changed), *self.ROWS[i + 1:]]
                self.assert_failure([f"{cells[0]}, row {i + 1} at ({cells[1]}, {cells[2]})"], *self.pair(*rows))

    def test_rows_of_load_cases_are_those_of_their_case(self):
        def table(name, *rows):
            path = self.folder / f"{name}.contact.csv"
            path.write_text("\n".join(["case,interface,x,y,pressure", *rows, ""]))
            return path

        rows = ["half,left,0,1,0.5", "half,left,1,1,0.25", "all,left,0,1,1.0", "all,left,1,1,0.5"]
        self.assert_success(table("gold", *rows), table("new", *reversed(rows)))
        self.assert_failure("all, left, row 3 at (0, 1)", table("gold", *rows), table("new", *rows[:2], "all,left,0,1,1.1", rows[3]))

    def test_rows_and_columns_must_be_the_same(self):
        less, more = self.ROWS[1:], [*self.ROWS, "right,2,1,0,0,0,0,0,0,0"]
        self.assert_failure("3 rows in GOLD, 2 in NEW; 1 are missing, the first: row 1 at (0, 1)", *self.pair(*less))
        self.assert_failure("3 rows in GOLD, 4 in NEW; 0 are missing", *self.pair(*more))
        self.assert_failure("row 3 at (1, 1)", *self.pair(*self.ROWS[:2], self.ROWS[2].replace("right", "left")))
        gold, new = self.pair(*self.ROWS)
        new.write_text(new.read_text().replace("closed", "open"))
        self.assert_failure(["column closed is missing in NEW", "column open is extra in NEW"], gold, new)

    def test_what_is_no_contact_table_is_refused(self):
        gold, new = self.pair(*self.ROWS)
        for text in ("", "x,y\n1,2", "interface,x,y\na,1", "interface,x,y\na,1,b", "interface,x,y\na,1,2,3"):
            new.write_text(text)
            self.assert_refused("is not a contact table", gold, new)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
