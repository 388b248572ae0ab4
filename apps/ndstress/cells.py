"""The cells of the matrix: row x value x method, each run once in a folder of its own."""

import concurrent.futures
import dataclasses
import functools
import os
import pathlib
import shutil
import subprocess
import time

import decks
import judge as judging
from methods import METHODS, SHORT_METHODS, SHORT_VARIANTS, VARIANTS
from rows import ROWS

# The largest scenes take some ten seconds alone; anything longer counts as a hang.
TIME_LIMIT = 120.0


@dataclasses.dataclass(frozen=True)
class Cell:
    row: int
    value: object
    method: str

    @property
    def folder(self):
        return f"{ROWS[self.row].name}/{self.value}/{self.method}".replace(" ", "_").replace(":", "")


@dataclasses.dataclass(frozen=True)
class Result:
    cell: Cell
    verdict: judging.Verdict
    seconds: float

    @property
    def finding(self):
        """Why this cell is not what it must be; empty if it is."""
        if self.verdict.outcome == judging.FINDING:
            return self.verdict.text
        must = ROWS[self.cell.row].must.get(self.cell.value, self.verdict.outcome)
        return "" if must == self.verdict.outcome else f"{self.verdict.outcome} instead of {must}: {self.verdict.text}"


def cells(short, only):
    """All cells, or those of the short form; `only`: a part of the row's name."""
    for number, row in enumerate(ROWS):
        if only.lower() not in row.name.lower():
            continue
        methods = row.methods or tuple(METHODS)
        for value in row.short if short else row.values:
            for method in methods:
                if not short or method in SHORT_METHODS or len(methods) == 1:
                    yield Cell(number, value, method)
        few = [value for value in row.variants if value in row.short][:1]
        for value in few if short else row.variants:
            for method in SHORT_VARIANTS if short else VARIANTS:
                yield Cell(number, value, method)


def merged(settings, more):
    """Nested dictionaries, the second on top of the first."""
    result = dict(settings)
    for key, value in more.items():
        nested = isinstance(value, dict) and isinstance(result.get(key), dict)
        result[key] = merged(result[key], value) if nested else value
    return result


@functools.lru_cache(maxsize=64)
def known(row, value, order):
    """The reference of a scene, once for all methods; an Unheld is raised anew."""
    return ROWS[row].answer(dataclasses.replace(ROWS[row].make(value), order=order))


def launch(program, ranks, folder):
    command = [program, "-i", "deck.xml"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks)] + command
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OPENBLAS_NUM_THREADS": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
    try:
        return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True,
                              timeout=TIME_LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return None


def run(cell, program, root, keep):
    """Runs and judges one cell; its folder stays only when `keep`."""
    row, method = ROWS[cell.row], (METHODS | VARIANTS)[cell.method]
    folder = pathlib.Path(root) / cell.folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scene = dataclasses.replace(row.make(cell.value), **method.scene)
    decks.write_scene(scene, merged(method.lists, row.settings(cell.value)), folder)
    start = time.monotonic()
    process = launch(program, max(row.ranks(cell.value), method.ranks), folder)
    seconds = time.monotonic() - start
    (folder / "screen.txt").write_text(process.stdout + process.stderr if process else "killed")
    answer = functools.partial(known, cell.row, cell.value, scene.order)
    result = Result(cell, judging.judge(process, scene, answer, folder, row.floor), seconds)
    if not keep:
        shutil.rmtree(folder)
    return result


def run_all(chosen, program, root, jobs, keep, report):
    """Runs the cells, `jobs` at a time; report(result) after each, in order."""
    run_one = functools.partial(run, program=program, root=root, keep=keep)
    results = []
    with concurrent.futures.ProcessPoolExecutor(jobs) as pool:
        for result in pool.map(run_one, chosen, chunksize=1 if jobs == 1 else 8):
            report(result)
            results.append(result)
    return results
