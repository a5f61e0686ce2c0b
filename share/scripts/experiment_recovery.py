"""Being lost on the real logs, and found again: rtob-slam recovery at length."""
import os
import pathlib
import subprocess

from experiment_runs import PROGRAM

# name, log, times to wake up, to be carried away, to be covered
LOGS = [("intel", "intel/intel.clf.bz2", 1000, 100, 50),
        ("fr079", "fr079/fr079.clf.bz2", 1000, 100, 50)]


def experiment(_):
    datasets = os.environ.get("RTOB_DATASETS")
    if not datasets:
        yield "SKIPPED: RTOB_DATASETS is not set"
        return
    for name, log, trials, kidnaps, covers in LOGS:
        yield f"## {name}"
        result = subprocess.run(
            [PROGRAM, "recovery", pathlib.Path(datasets) / log, "--trials", str(trials),
             "--kidnaps", str(kidnaps), "--covers", str(covers)],
            check=True, stdout=subprocess.PIPE, text=True)
        yield from result.stdout.splitlines()
