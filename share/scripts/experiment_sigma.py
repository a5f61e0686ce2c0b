"""Whether two standard deviations cover the errors, where the truth is known."""
import csv
import math

from experiment_runs import OUT, WORLDS, run, simulate, table
from trajectories import read_tum

SCENES = ["long-corridor", "corridor", "room", "hall", "door", "people", "repeated", "cylinders"]
AXES = ["x", "y", "yaw"]
VARIANCE = {"x": "x_x_m2", "y": "y_y_m2", "yaw": "yaw_yaw_rad2"}
# The map begins with the first scan, which has the laser's noise itself: smaller errors are its.
FIRST_SCAN = {"x": 0.01, "y": 0.01, "yaw": 0.003}


def errors(row, start, truth):
    """Of x, y, yaw: the pose in map against the truth seen from where the map begins."""
    away = (truth.at - start.at) * complex(math.cos(start.yaw_rad), -math.sin(start.yaw_rad))
    turn = float(row["yaw_rad"]) - (truth.yaw_rad - start.yaw_rad)
    return {"x": float(row["x_m"]) - away.real, "y": float(row["y_m"]) - away.imag,
            "yaw": math.remainder(turn, 2 * math.pi)}


def judged(results, truth_file):
    """For each axis: share of the scans within two sigma in map, largest error, largest sigma;
    and the median ratio of the long to the short sigma of the place in the local map."""
    truth = {round(pose.time_s * 1e4): pose for pose in read_tum(truth_file)}
    with open(results / "poses.csv", encoding="ascii") as file:
        rows = [row for row in csv.DictReader(file) if round(float(row["stamp_s"]) * 1e4) in truth]
    seen = [truth[round(float(row["stamp_s"]) * 1e4)] for row in rows]
    off = [errors(row, seen[0], pose) for row, pose in zip(rows, seen)]
    judgement = {}
    for axis in AXES:
        sigma = [math.sqrt(float(row["map_cov_" + VARIANCE[axis]])) for row in rows]
        inside = [abs(o[axis]) < max(2 * s, FIRST_SCAN[axis]) for o, s in zip(off, sigma)]
        judgement[axis] = (sum(inside) / len(rows), max(abs(o[axis]) for o in off), max(sigma))
    ratios = sorted(long_to_short(row) for row in rows[1:])
    return judgement, ratios[len(ratios) // 2]


def long_to_short(row):
    """Of the ellipse of the place in the local map."""
    xx, xy, yy = (float(row[f"cov_{axes}_m2"]) for axes in ("x_x", "x_y", "y_y"))
    middle, half = (xx + yy) / 2, math.hypot((xx - yy) / 2, xy)
    return math.sqrt((middle + half) / max(middle - half, 1e-12))


def experiment(options):
    yield (f"Laser alone, {options.seeds} seeds: the least share of scans whose error in map lies "
           "within two reported sigma, the largest error and the largest sigma; and the median "
           "ratio of the long to the short sigma of the place in the local map.")
    rows = []
    for scene in SCENES:
        folder = OUT / "sigma"
        flown = []
        for seed in range(1, options.seeds + 1):
            log, truth = simulate(WORLDS / f"{scene}.yaml", seed, folder)
            flown.append(judged(run(log, seed, folder / f"{scene}-{seed}"), truth))
        cells = []
        for axis, unit in zip(AXES, (100, 100, math.degrees(1))):
            share, error, sigma = (
                pick(judgement[axis][i] for judgement, _ in flown)
                for i, pick in enumerate((min, max, max)))
            cells.append(f"{100 * share:.0f} %, {unit * error:.1f} of {unit * sigma:.1f}")
        rows.append([scene, *cells, f"{max(ratio for _, ratio in flown):.0f}"])
    yield from table(["world", "x, cm", "y, cm", "yaw, degrees", "long to short"], rows)
