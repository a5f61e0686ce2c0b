"""Time a scan takes, over an hour of flight."""
import csv
import itertools
import math
import statistics

import program_names
from experiment_runs import OUT, WORLDS, call, run, simulate, table

ROW_SCANS = 3600  # six minutes
SPAN_SCANS = 600  # the slope goes through the medians of these
# Enough to see MRPT grow: its whole hour would take hours.
VARIANTS = {"rtob-revisit": None, "mrpt-stock": 10800, "mrpt-dense": 3600}
PARTS = ["draw", "align", "anchor", "search"]


def column(timing_file, name):
    with open(timing_file, newline="", encoding="ascii") as file:
        return [float(row[name]) for row in csv.DictReader(file)]


def spans(times, length):
    """Parts of this many scans; what is left over at the end, if it is at least half a part."""
    return [times[start:start + length] for start in range(0, len(times) - length // 2, length)]


def percentile(times, share):
    return sorted(times)[int(share * len(times))]


def slope_ms_per_hour(times):
    """Least squares through the medians of every minute, and its standard error."""
    medians = [statistics.median(span) for span in spans(times, SPAN_SCANS)]
    n = len(medians)
    if n < 3:
        return math.nan, math.nan
    x = [(i + 0.5) * SPAN_SCANS / 36000 for i in range(n)]
    mean_x, mean_y = sum(x) / n, sum(medians) / n
    sxx = sum((each - mean_x) ** 2 for each in x)
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, medians)) / sxx
    residual = sum((b - mean_y - slope * (a - mean_x)) ** 2 for a, b in zip(x, medians))
    return slope, (residual / (n - 2) / sxx) ** 0.5


def compared(variant, scans, log, truth, folder):
    """Milliseconds of processor time of each scan."""
    call("compare", log, "--truth", truth, "-o", folder, "--overwrite", "--quiet",
         "--no-odometry", "--repeats", 1, "--seeds", 1, "--variant", variant,
         *(["--first", scans] if scans else []))
    return column(next((folder / "runs").glob(f"{variant}-*")) / "timing.csv", "cpu_ms")


def parts_table(timing_file):
    """Where RTOB-SLAM's time goes: mean wall time of each part, per six minutes."""
    parts = {part: spans(column(timing_file, f"{part}_ms"), ROW_SCANS) for part in PARTS}
    rows = [[f"{6 * i} to {6 * (i + 1)} min", *(f"{statistics.mean(part[i]):.3f}"
                                                for part in parts.values())]
            for i in range(len(parts["draw"]))]
    return table(["mean ms", *PARTS], rows)


def experiment(_):
    folder = OUT / "hour"
    log, truth = simulate(WORLDS / "garage.yaml", 1, folder, "--duration", 3600)
    times = {program_names.title(variant): compared(variant, scans, log, truth, folder / variant)
             for variant, scans in VARIANTS.items()}
    yield "Milliseconds of processor time a scan, median / 99th percentile, without odometry."
    cells = [[f"{statistics.median(span):.2f} / {percentile(span, 0.99):.2f}"
              for span in spans(each, ROW_SCANS)] for each in times.values()]
    yield from table(
        ["time", *times],
        [[f"{6 * i} to {6 * (i + 1)} min", *row]
         for i, row in enumerate(itertools.zip_longest(*cells, fillvalue="-"))])
    for name, each in times.items():
        for what, part in (("", each), (" after the first ten minutes", each[6000:])):
            slope, error = slope_ms_per_hour(part)
            if math.isnan(slope):
                continue  # too few scans
            yield (f"Slope of the median, {name}{what}: {slope:+.3f} ms an hour, standard error"
                   f" {error:.3f}")
    yield from parts_table(run(log, 1, folder / "parts") / "timing.csv")
