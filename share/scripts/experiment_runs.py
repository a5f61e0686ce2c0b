"""One simulated flight, one run over it, and its figures."""
import json
import os
import pathlib
import subprocess

import trajectories

PROGRAM = os.environ.get("RTOB_PROGRAM", "build/bin/rtob-slam")
WORLDS = pathlib.Path("share/worlds")
OUT = pathlib.Path("out/experiments")
LOST = 3  # the program's exit code


def call(*arguments, allow=(0,)):
    """Runs rtob-slam; its words are shown only when it fails."""
    done = subprocess.run(
        [PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
        check=False)
    if done.returncode not in allow:
        raise SystemExit(f"rtob-slam {' '.join(map(str, arguments))}:\n{done.stderr}")
    return done


def simulate(world, seed, folder, *flags, laser_only=True):
    """Returns log and truth. Without odometry or IMU, as in the paper, unless told otherwise."""
    folder.mkdir(parents=True, exist_ok=True)
    log = folder / f"{pathlib.Path(world).stem}-{seed}.rawlog"
    call("simulate", world, "-o", log, "--seed", seed, "--overwrite", "--quiet",
         *(["--laser-only"] if laser_only else []), *flags)
    return log, log.with_suffix(".truth.tum")


def run(log, seed, folder, *flags):
    """Returns the run's folder."""
    call("run", log, "--no-odometry", "--seed", seed, "-o", folder, "--overwrite", "--quiet",
         *flags, allow=(0, LOST))
    return folder


def density_flags(density, forgetting_s):
    return ["--density", density] + (
        ["--set", f"Density.forgetting_s={forgetting_s}"] if density == "forgetting" else [])


def figures(results, truth):
    """What the tables show. Lengths in cm, turns in degrees, times in ms."""
    evaluation = json.loads(
        call("eval", results / "trajectory.tum", truth, "-o", results, "--json").stdout)
    summary = json.loads((results / "summary.json").read_text())
    pairs = trajectories.matched(
        trajectories.read_tum(results / "trajectory.tum"), trajectories.read_tum(truth))
    revisit_m = trajectories.revisit_shift(pairs)
    position, turn = evaluation["ate"]["translation_m"], evaluation["ate"]["rotation_deg"]
    return {
        "scans": len(pairs),
        "lost": summary["states"]["LOST"],
        "rms_cm": 100 * position["rmse"],
        "max_cm": 100 * position["max"],
        "jump_cm": 100 * evaluation["rpe"][0]["translation_m"]["max"],
        "turn_deg": turn["rmse"],
        "revisit_cm": None if revisit_m is None else 100 * revisit_m,
        "p50_ms": summary["time"]["scan_p50_ms"],
        "p99_ms": summary["time"]["scan_p99_ms"],
    }


def text(value):
    return "-" if value is None else str(value) if isinstance(value, int) else f"{value:.2f}"


def table(header, rows):
    yield "| " + " | ".join(header) + " |"
    yield "|" + "---|" * len(header)
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def spread_table(name, runs):
    """A line a figure: worst, median and best of the seeds."""
    rows = []
    for key in runs[0]:
        values = sorted(run[key] for run in runs if run[key] is not None)
        if not values or key == "scans":
            continue
        rows.append([key, text(values[-1]), text(values[len(values) // 2]), text(values[0])])
    return table([name, f"worst of {len(runs)} seeds", "median", "best"], rows)
