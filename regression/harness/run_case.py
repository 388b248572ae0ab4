"""Runs one case on some ranks and judges exit code, message and files."""

import dataclasses
import os
import pathlib
import shutil
import signal
import subprocess
import time

from .case import GOLD_FILES, REQUIRED_FILES
from .errors import Error
from .nddiff import differ

# MPI may run as root, as in containers; threads would only disturb runs side by side.
ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OPENBLAS_NUM_THREADS": "1",
}

OK, DIFFERENT, WRONG_EXIT, NO_MESSAGE, NO_GOLD, TIMEOUT, SKIPPED = (
    "ok", "DIFFERENT", "WRONG EXIT", "NO MESSAGE", "NO GOLD", "TIMEOUT", "SKIPPED")


@dataclasses.dataclass(frozen=True)
class Result:
    """What became of a run; `details` are lines for the reader, `outputs` the folder it ran in."""

    case: object
    ranks: int
    status: str
    seconds: float
    details: str
    outputs: pathlib.Path

    @property
    def name(self):
        return run_name(self.case, self.ranks)

    @property
    def failed(self):
        return self.status not in (OK, SKIPPED)


def run_name(case, ranks):
    return case.name if ranks == 1 else f"{case.name}.np{ranks}"


class Runner:
    """Where the programs are, which rules hold, where outputs go."""

    def __init__(self, programs, rules, work, timeout):
        self.programs, self.rules, self.work, self.timeout = programs, rules, work, timeout

    def run(self, case, ranks):
        outputs = self.work / run_name(case, ranks)
        if case.program not in self.programs:
            return Result(case, ranks, SKIPPED, 0.0, f"say where it is: --program {case.program}=FILE", outputs)
        shutil.rmtree(outputs, ignore_errors=True)
        outputs.mkdir(parents=True)
        start = time.monotonic()
        status, details = self._judge(case, ranks, outputs)
        if status == OK:
            shutil.rmtree(outputs)
        return Result(case, ranks, status, time.monotonic() - start, details, outputs)

    def execute(self, case, ranks, outputs):
        """Exit code, None when it took too long; what the program says is in screen.txt and errors.txt."""
        command = [self.programs[case.program], "-i", str(case.deck), *case.arguments]
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command]
        with open(outputs / "screen.txt", "wb") as screen, open(outputs / "errors.txt", "wb") as errors:
            process = subprocess.Popen(command, cwd=outputs, env=ENVIRONMENT | os.environ, start_new_session=True,
                                       stdin=subprocess.DEVNULL, stdout=screen, stderr=errors)
            try:
                return process.wait(self.timeout)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)  # with the ranks that mpirun started
                process.wait()
                return None

    def _judge(self, case, ranks, outputs):
        code = self.execute(case, ranks, outputs)
        status, details = self.judge_end(case, code, outputs)
        if status != OK:
            return status, details
        if not case.gold() and REQUIRED_FILES.keys() & written(outputs):
            return NO_GOLD, "a new case? --bless makes its gold files"
        reports = self.reports(case, ranks, outputs)
        (outputs / "diff.txt").write_text("\n".join(reports) + "\n")
        return (DIFFERENT if reports else OK), "\n".join(reports)

    def judge_end(self, case, code, outputs):
        """Whether the program ended as it should."""
        errors = (outputs / "errors.txt").read_text(errors="replace")
        if code is None:
            return TIMEOUT, f"not ended after {self.timeout:g} s"
        if code != case.exit:
            return WRONG_EXIT, f"exit code {code} instead of {case.exit}\n{tail(errors)}"
        if case.message not in errors:
            return NO_MESSAGE, f'the error stream does not say "{case.message}", but\n{tail(errors)}'
        return OK, ""

    def reports(self, case, ranks, outputs):
        """Texts of the differences between gold and outputs, one a file."""
        found = written(outputs)
        texts = [] if case.gold() else [f"{name} was written by a case without gold" for name in strays(outputs)]
        for name in GOLD_FILES:
            gold, new = case.folder / name, found.get(name)
            if gold.exists() and new is not None:
                texts += self._difference(gold, new, self.rules_of(case, ranks))
            elif gold.exists():
                texts.append(f"{name} has no counterpart: the run did not write it")
            elif new is not None and name in REQUIRED_FILES:
                texts.append(f"{new.name} was written, but there is no {name}")
        return texts

    @staticmethod
    def _difference(gold, new, rules):
        try:
            report = differ(gold, new, rules)
        except Error as error:  # the run left a file that cannot be read
            return [str(error)]
        return [] if report.same() else [f"{gold.name} and {new.name} differ:\n{report.text()}"]

    def rules_of(self, case, ranks):
        """Rules of all cases, of several ranks, of this case; the last that matches holds."""
        of_ranks = self.rules["ranks"] if ranks > 1 else {"exodus": [], "summary": []}
        return {kind: self.rules[kind] + of_ranks[kind] + case.rules[kind] for kind in ("exodus", "summary")}


def written(outputs):
    """Gold name -> file that the run left."""
    found = {name: sorted(outputs.glob("*" + ending)) for name, ending in GOLD_FILES.items()}
    return {name: paths[0] for name, paths in found.items() if paths}


def strays(outputs):
    """Names of the files that a run left which need no gold counterpart, such as the contact table."""
    endings = ("screen.txt", "errors.txt", *REQUIRED_FILES.values())
    return [path.name for path in sorted(outputs.iterdir()) if not path.name.endswith(endings)]


def tail(text, lines=12):
    """The end of an error stream, indented."""
    return "\n".join("  " + line for line in text.splitlines()[-lines:])
