"""The figures of ./dev evaluate as Markdown tables."""
import csv
import statistics

import evaluate_logs
import program_names

RIVALS = ("mrpt-stock", "mrpt-dense")  # what RTOB-SLAM is asked to beat


def read_peers(file):
    with open(file, encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def table(header, rows):
    yield "| " + " | ".join(header) + " |"
    yield "|" + "---|" * len(header)
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def short(value):
    """Three digits that mean something: 0.0176, 3.73, 213."""
    if value is None:
        return "-"
    digits = f"{value:.3g}"
    return f"{float(digits):.0f}" if "e" in digits else digits


class Variant:
    """The runs of one program on one log."""

    def __init__(self, name, runs):
        self.name = name
        self.title = program_names.title(name)
        self.runs = [run for run in runs if not run["failure"]]
        self.failure = next((run["failure"] for run in runs if run["failure"]), "")
        self.is_rtob = program_names.is_rtob(name)

    def all(self, key):
        return [run[key] for run in self.runs if key in run]

    def median(self, key):
        values = self.all(key)
        return statistics.median(values) if values else None

    def worst(self):
        """The run of the largest error; None where there is no truth."""
        judged = [run for run in self.runs if "error_mean_m" in run]
        return max(judged, key=lambda run: run["error_mean_m"]) if judged else None

    def lost(self):
        values = self.all("lost_scans")
        return f"{max(values):.0f}" if values else "-"


def variants(result):
    """In the order of the comparison."""
    names = dict.fromkeys(run["variant"] for run in result["runs"])
    return [Variant(name, [run for run in result["runs"] if run["variant"] == name])
            for name in names]


def section(name, result, peers):
    """What stands at a log's place: the picture, the command, the table."""
    log = evaluate_logs.LOGS[name]
    yield f"![{log.title}](pictures/evaluation-{name}.png)"
    yield ""
    yield f"    {result['command']}"
    yield ""
    yield from (maps_tables(result) if "pairs" in result else
                programs_table(name, result, peers))
    yield ""
    yield f"Measured with the programs of commit {result['commit']}."


def accuracy_cells(variant, judged, returns):
    cells = []
    if judged:
        worst = variant.worst()
        cells += [f"{short(worst['error_mean_m'])} ± {short(worst['error_std_m'])}" if worst
                  else "-", short(variant.median("error_mean_m")),
                  short(variant.median("turn_error_mean_deg"))]
    if returns:
        values = variant.all("end_to_start_m")
        cells.append(short(max(values)) if values else "-")
    return cells


def cost_cells(variant):
    if variant.name == "odometry":
        return ["-"] * 5
    growth = (f"{short(variant.median('first_tenth_ms'))} → "
              f"{short(variant.median('last_tenth_ms'))}")
    return [short(variant.median("scan_cpu_p50_ms")), short(variant.median("scan_cpu_p99_ms")),
            growth, short(variant.median("cpu_s")), short(variant.median("peak_memory_mb"))]


def programs_table(name, result, peers):
    shown = variants(result)
    judged = any(variant.worst() for variant in shown)
    returns = any(variant.all("end_to_start_m") for variant in shown)
    header = ["program", "runs"]
    header += ["error m, worst run", "median run", "turn deg"] if judged else []
    header += ["end to start m, worst"] if returns else []
    header += ["CPU ms p50", "p99", "first → last tenth", "CPU s in all", "MB", "scans LOST"]
    rows = []
    for variant in shown:
        if not variant.runs:
            rows.append([variant.title, variant.failure] + ["-"] * (len(header) - 2))
            continue
        rows.append([variant.title, str(len(variant.runs)),
                     *accuracy_cells(variant, judged, returns), *cost_cells(variant),
                     variant.lost()])
    if judged:
        rows += quoted_rows(name, peers, len(header))
    yield from table(header, rows)
    if any(variant.failure and variant.runs for variant in shown):
        yield ""
        yield from (f"{variant.title}: a run failed: {variant.failure}" for variant in shown
                    if variant.failure and variant.runs)


def quoted_rows(name, peers, columns):
    """Peers, measured elsewhere: only the mean error is known, and the time on Intel."""
    for peer in peers:
        if peer.get(name):
            cells = ["*quoted*", peer[name], "-", "-"]
            cells += ["-"] * (columns - 1 - len(cells))
            if name == "intel" and peer["intel_cpu_ms"]:
                cells[6] = f"mean {peer['intel_cpu_ms']}"
            yield [f"*{peer['program']}*", *cells]


def maps_tables(result):
    runs = result["runs"]
    yield from table(
        ["run", "scans", "LOST", "ms p50", "ms p99"],
        [[run["run"], str(run["scans"]), str(run["lost"]), short(run["p50_ms"]),
          short(run["p99_ms"])] for run in runs])
    yield ""
    yield from table(
        ["maps", "cells of A on B", "of B on A", "mean distance m"],
        [[f"{pair['a']} on {pair['b']}", f"{100 * pair['estimate_share']:.1f} %",
          f"{100 * pair['reference_share']:.1f} %", short(pair["mean_distance_m"])]
         for pair in result["pairs"]])


def summary(measured):
    """A line a log with a truth: RTOB-SLAM's seeds against both settings of MRPT's ICP-SLAM."""
    rows = []
    for name, result in measured.items():
        if "pairs" in result:
            continue
        shown = {variant.name: variant for variant in variants(result)}
        rtob = next((variant for variant in shown.values() if variant.is_rtob), None)
        if rtob is None or rtob.worst() is None:
            continue
        errors = rtob.all("error_mean_m")
        rivals = [shown[rival] for rival in RIVALS if rival in shown]
        rows.append([
            evaluate_logs.LOGS[name].title, str(len(errors)),
            f"{short(max(errors))} ± {short(rtob.worst()['error_std_m'])}",
            short(statistics.median(errors)), short(min(errors)), rtob.lost(),
            verdict(max(errors), rivals, "error_mean_m", "m"),
            verdict(rtob.median("cpu_s"), rivals, "cpu_s", "s")])
    if not rows:
        yield "No log with a truth was measured yet."
        return
    yield from table(
        ["log", "seeds", "worst m", "median m", "best m", "scans LOST",
         "more accurate than MRPT's shipped / dense", "less CPU than MRPT's shipped / dense"],
        rows)


def verdict(own, rivals, key, unit):
    """'yes (3.73 m), no (0.08 m)': against each rival's best run."""
    said = []
    for rival in rivals:
        values = rival.all(key)
        said.append(f"{'yes' if own < min(values) else 'NO'} ({short(min(values))} {unit})"
                    if values else f"no result ({rival.failure})")
    return " / ".join(said) or "-"
