"""Two processes end together, with one voice and the exit code of one: exit_codes_on_ranks.py MPIEXEC NDFRAME DECK."""

import subprocess
import sys
import tempfile

MPIEXEC, NDFRAME, DECK = sys.argv[1:]

CASES = [
    (2, "--yardstick", "--yardstick measures one process; run it without mpirun"),
    (2, "Linear Solver/Type=Cholmod", "Cholmod"),
    (2, "Coupling/Stopping/Tolerence=1", 'did you mean "Tolerance"?'),
    (2, "Interfaces/contact/Neumann Side=roof", 'has no side "roof"'),
    (2, "Output/Directory=/dev/null", "is not a writable folder"),
    (3, "Coupling/Stopping/Maximum Sweeps=2", "has not fallen below 0.1 in 2 sweeps"),
    (3, "Bodies/punch/Loads/press/Value=-1", "the load does not press the bodies together"),
    (5, "Accuracy/Absolute Target=1e-3 && Accuracy/Maximum Levels=1", "missed: Maximum Levels = 1"),
    (4, "Expect/the punch is in equilibrium/Value=2", "MISSED the punch is in equilibrium"),
]

for code, change, message in CASES:
    arguments = [change] if change.startswith("--") else [f"--set={setting}" for setting in change.split(" && ")]
    with tempfile.TemporaryDirectory() as folder:
        command = [MPIEXEC, "--oversubscribe", "-np", "2", NDFRAME, "-q", "-i", DECK, *arguments]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
        assert done.returncode == code, f"{change}: exit code {done.returncode}\n{done.stdout}{done.stderr}"
        assert done.stderr.count(message) == 1, f"{change}: one rank speaks\n{done.stderr}"
