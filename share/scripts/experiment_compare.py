"""Other programs on a simulated flight: a row each of the table of --compare."""
import csv
import json
import statistics

import program_names
import trajectories
from experiment_runs import call, table, text


def runs_on(log, truth, folder):
    """The figures of each program by its name; of those that failed, the reason."""
    call("compare", log, "--truth", truth, "-o", folder, "--overwrite", "--no-odometry",
         "--repeats", 1, "--seeds", 1, "--quiet")
    with open(folder / "results.csv", newline="", encoding="utf-8") as rows:
        return {row["variant"]: row["failure"] or
                figures(row, folder / "runs" / f"{row['variant']}-{row['round']}", truth)
                for row in csv.DictReader(rows) if row["variant"] != "odometry"}


def figures(row, results, truth):
    """Lengths in cm, times in ms of processor time."""
    evaluation = json.loads(call("eval", results / "trajectory.tum", truth, "--json").stdout)
    pairs = trajectories.matched(
        trajectories.read_tum(results / "trajectory.tum"), trajectories.read_tum(truth))
    revisit_m = trajectories.revisit_shift(pairs)
    return {
        "rms_cm": 100 * evaluation["ate"]["translation_m"]["rmse"],
        "max_cm": 100 * evaluation["ate"]["translation_m"]["max"],
        "jump_cm": 100 * evaluation["rpe"][0]["translation_m"]["max"],
        "revisit_cm": None if revisit_m is None else 100 * revisit_m,
        **{key: float(row[key]) for key in ("scan_cpu_p50_ms", "first_tenth_ms", "last_tenth_ms")},
    }


def comparison_table(flights):
    """Of several flights the worst errors and the median times."""
    yield ""
    yield f"Beside other programs, without odometry; worst of {len(flights)} flight(s), median times."
    rows = []
    for variant in flights[0]:
        name = program_names.title(variant)
        failures = [flight[variant] for flight in flights if isinstance(flight[variant], str)]
        if failures:
            rows.append([name, failures[0], *["-"] * 5])
            continue
        rows.append([name, *row_of([flight[variant] for flight in flights])])
    yield from table(
        ["program", "RMS, cm", "largest, cm", "jump, cm", "revisited, cm", "CPU ms p50",
         "first → last tenth"], rows)


def row_of(runs):
    for key in ("rms_cm", "max_cm", "jump_cm", "revisit_cm"):
        values = [run[key] for run in runs if run[key] is not None]
        yield text(max(values, default=None))
    p50, first, last = (statistics.median(run[key] for run in runs)
                        for key in ("scan_cpu_p50_ms", "first_tenth_ms", "last_tenth_ms"))
    yield text(p50)
    yield f"{text(first)} → {text(last)}"
