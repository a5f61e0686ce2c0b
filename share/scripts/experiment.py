#!/usr/bin/env python3
"""The experiments of docs/experiments.md.

usage: experiment.py NAME... [--seeds N] [--compare [N]]

Each writes its logs, runs and pictures below out/experiments/NAME and its table to
out/experiments/NAME/table.md, and prints the table.
"""
import argparse
import pathlib
import shutil
import sys

import experiment_changes
import experiment_compare
import experiment_envelope
import experiment_gyro
import experiment_hour
import experiment_loops
import experiment_recovery
import experiment_sigma
from experiment_runs import OUT, WORLDS, figures, run, simulate, spread_table

PAPER = ["cylinders", "room", "garage"]
DYNAMIC = ["people", "door", "corridor", "hall", "repeated"]

# What the issue of each experiment allows; "must hold" for the worst seed.
LIMITS = {
    "cylinders": {"rms_cm": 2, "max_cm": 6},
    "room": {"rms_cm": 2, "jump_cm": 5},
    "garage": {"rms_cm": 5, "revisit_cm": 5},
}


def flight(name, options):
    """One world, flown and run once a seed. Seed 1's pictures stay for people to look at."""
    folder = OUT / name
    runs, compared = [], []
    for seed in range(1, options.seeds + 1):
        log, truth = simulate(WORLDS / f"{name}.yaml", seed, folder)
        results = run(log, seed, folder / f"seed-{seed}")
        runs.append(figures(results, truth))
        if seed == 1:
            shutil.copy(results / "map.png", folder / "map.png")
            shutil.copy(results / "eval_path.png", folder / "error_path.png")
        if seed <= options.compare:
            compared.append(experiment_compare.runs_on(log, truth, folder / f"compare-{seed}"))
    yield from spread_table(name, runs)
    for figure, limit in LIMITS.get(name, {}).items():
        worst = max(run[figure] for run in runs)
        yield f"{'holds' if worst <= limit else 'DOES NOT HOLD'}: {figure} {worst:.2f}, at most {limit}"
    if compared:
        yield from experiment_compare.comparison_table(compared)


EXPERIMENTS = {
    **{name: flight for name in PAPER + DYNAMIC},
    "loops": lambda _, options: experiment_loops.experiment(options),
    "cupboard": lambda _, options: experiment_changes.experiment(options),
    "envelope": lambda _, options: experiment_envelope.experiment(options),
    "gyro": lambda _, options: experiment_gyro.experiment(options),
    "sigma": lambda _, options: experiment_sigma.experiment(options),
    "hour": lambda _, options: experiment_hour.experiment(options),
    "recovery": lambda _, options: experiment_recovery.experiment(options),
}


def main():
    parser = argparse.ArgumentParser(
        prog="./dev experiment", description="The paper's experiments and more, in simulation.",
        epilog="Names: all (the paper's three), " + ", ".join(EXPERIMENTS))
    parser.add_argument("names", nargs="+", metavar="NAME")
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--compare", type=int, nargs="?", const=1, default=0, metavar="N",
                        help="run the other programs of rtob-slam compare, too, on the flights of"
                             " the first N seeds (1)")
    options = parser.parse_args()
    names = [each for name in options.names for each in (PAPER if name == "all" else [name])]
    for name in names:
        if name not in EXPERIMENTS:
            parser.error(f"no experiment '{name}'; there are: all, {', '.join(EXPERIMENTS)}")
    for name in names:
        (OUT / name).mkdir(parents=True, exist_ok=True)
        lines = []
        for line in EXPERIMENTS[name](name, options):
            print(line, flush=True)
            lines.append(line)
        pathlib.Path(OUT / name / "table.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
