"""Runs a program as a child process and says what it cost, by the operating system's own account."""

import dataclasses
import os
import subprocess
import tempfile
import time

# One thread unless a measurement is about threads: a ratio of two runs must not depend on what the other core does.
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
MPI_AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


@dataclasses.dataclass(frozen=True)
class Cost:
    """Seconds on the wall, processor seconds (user and system, all threads), largest resident bytes, exit code."""

    wall: float
    cpu: float
    peak: int
    exit: int


def cost_of(command, folder, environment=None):
    """Runs `command` in `folder`; returns its cost and what it printed on both streams.

    A child starts with the resident size of the process that forked it, so whoever calls this imports neither numpy nor
    matplotlib before the last measurement (a test looks at that). Under mpirun the peak is that of the largest process.
    """
    with tempfile.TemporaryFile() as printed:
        start = time.perf_counter()
        child = subprocess.Popen(
            command, cwd=folder, stdout=printed, stderr=printed, stdin=subprocess.DEVNULL,
            env={**os.environ, **ONE_THREAD, **MPI_AS_ROOT, **(environment or {})},
        )
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)  # reaped here: Popen must not wait for it again
        printed.seek(0)
        text = printed.read().decode(errors="replace")
    return Cost(wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, child.returncode), text
