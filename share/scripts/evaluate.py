#!/usr/bin/env python3
"""Measures RTOB-SLAM beside other programs on real logs and writes the result into the docs.

Each log's figures go to docs/evaluation/LOG.json, its picture to docs/pictures/evaluation-LOG.png,
and the tables between the markers of docs/evaluation.md are made anew from all such files. Full
reports stay in out/evaluate/LOG. A log whose figures are there for the same commands and the same commit is
passed over, so an evaluation that was stopped goes on where it was.
"""
import argparse
import os
import pathlib
import sys

import evaluate_document
import evaluate_logs
import evaluate_runs


def parsed_arguments():
    parser = argparse.ArgumentParser(
        prog="./dev evaluate", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="Logs: " + ", ".join(evaluate_logs.LOGS)
        + ".\nMalaga and simulated are in Debian's mrpt-common; the others are looked for in"
          " RTOB_DATASETS.")
    parser.add_argument("logs", nargs="*", metavar="LOG", help="default: all")
    parser.add_argument("--seeds", type=int, default=10, help="of programs that draw at random")
    parser.add_argument("--repeats", type=int, default=1, help="runs of the other programs")
    parser.add_argument("--variant", action="append", metavar="NAME",
                        help="run these of rtob-slam compare only; may be given again")
    parser.add_argument("--time-limit", type=int, default=60, metavar="MIN",
                        help="of one run of one program; its row says so (default: 60)")
    parser.add_argument("--fresh", action="store_true", help="measure again what is there")
    parser.add_argument("--tables", action="store_true",
                        help="measure nothing, write the tables from docs/evaluation/*.json")
    options = parser.parse_args()
    unknown = [name for name in options.logs if name not in evaluate_logs.LOGS]
    if unknown:
        parser.error(f"no log '{unknown[0]}'; there are: {', '.join(evaluate_logs.LOGS)}")
    return options


def chosen_logs(options):
    """Those named, or all that are there; a named one that is missing is an error."""
    datasets = pathlib.Path(os.environ.get("RTOB_DATASETS", ""))
    chosen = []
    for name, log in evaluate_logs.LOGS.items():
        if options.logs and name not in options.logs:
            continue
        missing = log.missing_file(datasets)
        if missing is None:
            chosen.append(log)
        elif options.logs:
            sys.exit(f"evaluate: {missing} is missing. Set RTOB_DATASETS to the folder with the"
                     " real logs (see datasets/README.md); Debian's mrpt-common holds the others.")
        else:
            print(f"passed over: {name}, {missing} is missing", file=sys.stderr)
    if not chosen:
        sys.exit("evaluate: none of the logs is there; set RTOB_DATASETS (see datasets/README.md)")
    return chosen


def main():
    options = parsed_arguments()
    if not options.tables:
        for log in chosen_logs(options):
            evaluate_runs.measure(log, options)
            evaluate_document.update()
    evaluate_document.update()
    print(f"{evaluate_document.DOCUMENT} is up to date with {evaluate_document.RESULTS}/")


if __name__ == "__main__":
    main()
