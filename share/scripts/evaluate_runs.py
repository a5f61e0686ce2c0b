"""Runs rtob-slam on one log and keeps its figures as docs/evaluation/LOG.json."""
import csv
import itertools
import json
import os
import pathlib
import shlex
import subprocess

import evaluate_logs
import evaluate_pictures
import trajectories
from evaluate_document import RESULTS

PROGRAM = os.environ.get("RTOB_PROGRAM", "build/bin/rtob-slam")
OUT = pathlib.Path("out/evaluate")
LOST = 3  # the program's exit code
SOURCES = ("libs", "apps", "config")
TEXT_COLUMNS = {"variant", "map_unit", "failure"}


def git(*arguments):
    return subprocess.run(["git", *arguments], capture_output=True, text=True, check=False)


def commit():
    """The last commit that changed the programs; "+" where they were changed since."""
    last = git("log", "-1", "--format=%h", "--", *SOURCES).stdout.strip() or "unknown"
    return last + ("+" if git("diff", "--quiet", "HEAD", "--", *SOURCES).returncode else "")


def call(arguments, allow=(0,)):
    """Runs rtob-slam without a terminal; its progress and its errors are shown."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode not in allow:
        raise SystemExit(f"evaluate: rtob-slam {shlex.join(map(str, arguments))}:"
                         f" exit code {done.returncode}")
    return done.stdout


def measure(log, options):
    """Leaves the log's JSON and picture; nothing where they are there already."""
    work = compare_log if isinstance(log, evaluate_logs.Log) else compare_maps
    command = shown_command(log, options)
    file = RESULTS / f"{log.name}.json"
    version = commit()
    if not options.fresh and file.exists():
        kept = json.loads(file.read_text())
        if (kept["command"], kept["commit"]) == (command, version):
            print(f"{log.name}: there already, from commit {version}; --fresh measures again")
            return
    print(f"{log.name}: {command}", flush=True)
    result = {"command": command, "commit": version, **work(log, options)}
    RESULTS.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")


def shown_command(log, options):
    if isinstance(log, evaluate_logs.Runs):
        folder = log.files[0].parent
        return f"rtob-slam run $RTOB_DATASETS/{folder}/*.gz; rtob-slam eval A/map.ply B/map.ply"
    truth = f" --truth {log.shown(log.truth)}" if log.truth else ""
    if log.truth_is_odometry:
        truth = f" --truth {log.name}.tum"
    flags = shlex.join(common_flags(log, options))
    return f"rtob-slam compare {log.shown(log.file)}{truth} {flags}"


def common_flags(log, options):
    flags = ["--repeats", str(options.repeats), "--seeds", str(options.seeds),
             "--time-limit", str(options.time_limit)]
    for variant in options.variant or log.variants:
        if variant != "pcl" or has_pcl():
            flags += ["--variant", variant]
    return flags


def has_pcl():
    """Whether the variant that needs libpcl-dev was built, beside the program."""
    return (pathlib.Path(PROGRAM).parent / "rtob-compare-pcl").exists()


def truth_flags(log):
    if log.truth:
        return ["--truth", evaluate_logs.resolved(log.truth)]
    if not log.truth_is_odometry:
        return []
    file = OUT / f"{log.name}.tum"
    file.parent.mkdir(parents=True, exist_ok=True)
    call(["convert", evaluate_logs.resolved(log.file), file, "--overwrite"])
    return ["--truth", file]


def compare_log(log, options):
    folder = OUT / log.name
    call(["compare", evaluate_logs.resolved(log.file), *truth_flags(log),
          *common_flags(log, options), "-o", folder, "--overwrite"])
    rows = [numbers(row) for row in csv.DictReader((folder / "results.csv").open())]
    for row in rows:
        run = folder / "runs" / f"{row['variant']}-{row['round']}"
        if log.returns and not row["failure"]:
            row["end_to_start_m"] = end_to_start(run / "trajectory.tum")
    picture(log, folder, rows)
    return {"runs": rows}


def numbers(row):
    """Numbers as numbers, short enough to be read; what is empty is left out."""
    def number(text):
        return int(text) if text.isdigit() else float(f"{float(text):.5g}")

    return {key: value if key in TEXT_COLUMNS else number(value)
            for key, value in row.items() if value != "" or key in TEXT_COLUMNS}


def end_to_start(file):
    poses = trajectories.read_tum(file)
    return round(abs(poses[-1].at - poses[0].at), 4)


def picture(log, folder, rows):
    """RTOB-SLAM's own map, of its worst run where the truth is known."""
    runs = [row for row in rows if row["variant"].startswith("rtob") and not row["failure"]]
    if runs:
        worst = max(runs, key=lambda row: row.get("error_mean_m", 0))
        evaluate_pictures.keep(
            folder / "runs" / f"{worst['variant']}-{worst['round']}" / "map.png", log.name)


def compare_maps(log, _options):
    folders, runs, pairs = [], [], []
    for file in log.files:
        folder = OUT / log.name / file.name.split(".")[0]
        call(["run", evaluate_logs.resolved(file), "-o", folder, "--overwrite", "--quiet"],
             allow=(0, LOST))
        folders.append(folder)
        summary = json.loads((folder / "summary.json").read_text())
        runs.append({"run": folder.name, "scans": summary["scans"]["total"],
                     "lost": summary["states"]["LOST"],
                     "p50_ms": summary["time"]["scan_p50_ms"],
                     "p99_ms": summary["time"]["scan_p99_ms"]})
    for a, b in itertools.combinations(folders, 2):
        folder = OUT / log.name / f"{a.name}-{b.name}"
        agreement = json.loads(
            call(["eval", a / "map.ply", b / "map.ply", "--json", "-o", folder]))
        pairs.append({"a": a.name, "b": b.name,
                      **{key: round(agreement[key], 4)
                         for key in ("estimate_share", "reference_share", "mean_distance_m")}})
    least = min(pairs, key=lambda pair: pair["estimate_share"] + pair["reference_share"])
    evaluate_pictures.keep(
        OUT / log.name / f"{least['a']}-{least['b']}" / "eval_maps.png", log.name)
    return {"runs": runs, "pairs": pairs}
