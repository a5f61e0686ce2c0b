"""Time a scan takes, over an hour of flight."""
import csv
import itertools
import math
import statistics

from experiment_runs import OUT, WORLDS, call, run, simulate, table

SPAN_SCANS = 3600
MRPT_SCANS = 10800  # enough to see its growth; the whole hour would take hours


def spans(timing_file):
    """Median and 99th percentile, ms, of every 3600 scans."""
    with open(timing_file, newline="", encoding="ascii") as file:
        times = [float(row["total_ms"]) for row in csv.DictReader(file)]
    for start in range(0, len(times) - SPAN_SCANS // 2, SPAN_SCANS):
        span = sorted(times[start:start + SPAN_SCANS])
        yield statistics.median(span), span[int(0.99 * len(span))]


def slope_ms_per_hour(medians, span_h):
    """Least squares through the spans' medians, and its standard error."""
    n = len(medians)
    if n < 3:
        return math.nan, math.nan
    x = [(i + 0.5) * span_h for i in range(n)]
    mean_x, mean_y = sum(x) / n, sum(medians) / n
    sxx = sum((each - mean_x) ** 2 for each in x)
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, medians)) / sxx
    residual = sum((b - mean_y - slope * (a - mean_x)) ** 2 for a, b in zip(x, medians))
    return slope, (residual / (n - 2) / sxx) ** 0.5


def experiment(_):
    folder = OUT / "hour"
    log, truth = simulate(WORLDS / "garage.yaml", 1, folder, "--duration", 3600)
    columns = {"RTOB-SLAM": list(spans(run(log, 1, folder / "rtob") / "timing.csv"))}
    call("compare", log, "--truth", truth, "-o", folder / "compare", "--overwrite", "--quiet",
         "--no-odometry", "--repeats", 1, "--seeds", 1, "--variant", "mrpt-dense",
         "--first", MRPT_SCANS)
    timing = next((folder / "compare" / "runs").glob("mrpt-dense-*")) / "timing.csv"
    columns["MRPT dense"] = list(spans(timing))
    yield f"Milliseconds a scan, median / 99th percentile of every {SPAN_SCANS} scans."
    rows = [
        [f"{6 * i} to {6 * (i + 1)} min", *("-" if each is None else f"{each[0]:.2f} / {each[1]:.2f}"
                                            for each in spans_i)]
        for i, spans_i in enumerate(itertools.zip_longest(*columns.values()))]
    yield from table(["time", *columns], rows)
    for name, each in columns.items():
        slope, error = slope_ms_per_hour([p50 for p50, _ in each], SPAN_SCANS / 36000)
        yield f"Slope of the median, {name}: {slope:+.3f} ms an hour, standard error {error:.3f}"
