"""Makes the outputs of a run the new gold, after showing what changes."""

import shutil

from .case import GOLD_FILES, REQUIRED_FILES
from .run_case import OK, written


def bless(runner, case, say):
    """Runs the case on its first number of ranks and rewrites its gold; false if the run did not end as it should."""
    outputs = runner.work / f"{case.name}.bless"
    shutil.rmtree(outputs, ignore_errors=True)
    outputs.mkdir(parents=True)
    if case.program not in runner.programs:
        say(f"{case.name}: not blessed; say where its program is: --program {case.program}=FILE")
        return False
    status, details = runner.judge_end(case, runner.execute(case, case.np[0], outputs), outputs)
    if status != OK:
        say(f"{case.name}: not blessed, {status}: {details}\noutputs are in {outputs}")
        return False
    changes = runner.reports(case, case.np[0], outputs)
    say("\n".join([f"{case.name}: {'blessed' if changes else 'nothing to bless'}", *changes]))
    if changes:
        replace_gold(case, written(outputs))
    shutil.rmtree(outputs)
    return True


def replace_gold(case, found):
    for name in GOLD_FILES:
        gold = case.folder / name
        if name not in found:
            gold.unlink(missing_ok=True)
        elif name in REQUIRED_FILES or gold.exists():
            shutil.copyfile(found[name], gold)
