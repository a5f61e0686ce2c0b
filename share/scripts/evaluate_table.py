#!/usr/bin/env python3
"""Turns the runs that evaluate.sh left in a folder into results.csv and a Markdown table.

usage: evaluate_table.py FOLDER
"""
import csv
import json
import pathlib
import statistics
import sys

COLUMNS = {
    "translation_m": lambda error, run: error["translation_m"]["mean"],
    "translation_std_m": lambda error, run: error["translation_m"]["std"],
    "rotation_deg": lambda error, run: error["rotation_deg"]["mean"],
    "scans": lambda error, run: run["scans"]["total"],
    "lost_scans": lambda error, run: run["states"]["LOST"],
    "scan_p50_ms": lambda error, run: run["time"]["scan_p50_ms"],
    "scan_p99_ms": lambda error, run: run["time"]["scan_p99_ms"],
    "scan_max_ms": lambda error, run: run["time"]["scan_max_ms"],
    "total_s": lambda error, run: run["time"]["total_s"],
    "peak_mb": lambda error, run: run["memory"]["peak_mb"],
}


def read_runs(folder):
    """One row a run, by log and seed; runs without a summary are left out by name."""
    for errors in sorted(folder.glob("*.json")):
        log, seed = errors.stem.rsplit("-", 1)
        summary = folder / errors.stem / "summary.json"
        if not summary.exists() or errors.stat().st_size == 0:
            print(f"no result of {errors.stem}", file=sys.stderr)
            continue
        error, run = json.loads(errors.read_text()), json.loads(summary.read_text())
        row = {"log": log, "seed": int(seed)}
        row.update({name: figure(error, run) for name, figure in COLUMNS.items()})
        yield row


def table(rows):
    """The worst and the median of the seeds, a line a log."""
    yield "| log | seeds | worst m | median m | best m | worst deg | lost scans | ms p50 | ms p99 | s in all | MB |"
    yield "|---|---|---|---|---|---|---|---|---|---|---|"
    for log in dict.fromkeys(row["log"] for row in rows):
        runs = [row for row in rows if row["log"] == log]

        def median(key):
            return statistics.median(run[key] for run in runs)

        worst = max(runs, key=lambda run: run["translation_m"])
        yield (
            f"| {log} | {len(runs)} | {worst['translation_m']:.4f} ± {worst['translation_std_m']:.4f}"
            f" | {median('translation_m'):.4f} | {min(run['translation_m'] for run in runs):.4f}"
            f" | {max(run['rotation_deg'] for run in runs):.3f} | {max(run['lost_scans'] for run in runs)}"
            f" | {median('scan_p50_ms'):.2f} | {median('scan_p99_ms'):.2f}"
            f" | {median('total_s'):.1f} | {median('peak_mb'):.0f} |"
        )


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = sorted(read_runs(folder), key=lambda row: (row["log"], row["seed"]))
    with open(folder / "results.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=["log", "seed", *COLUMNS])
        writer.writeheader()
        writer.writerows(rows)
    print("\n".join(table(rows)))


if __name__ == "__main__":
    main()
