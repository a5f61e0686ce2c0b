"""How fast a vehicle may turn and fly without odometry."""
import json

from experiment_runs import OUT, WORLDS, call, run, simulate, table

RATES_HZ = [5, 10, 15]
YAW_RATES_DPS = [30, 60, 90, 120, 150, 180, 240, 300, 360]
SPEEDS_MPS = [0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6]
# RMS that still counts as tracked: a vehicle that turns on the spot shows only in its heading.
TRACKED_M, TRACKED_DEG = 0.2, 5


def tracks(world, seed, folder, flags, run_flags=(), laser_only=True):
    log, truth = simulate(WORLDS / world, seed, folder, *flags, laser_only=laser_only)
    results = run(log, seed, folder / "run", *run_flags)
    summary = json.loads((results / "summary.json").read_text())
    evaluation = json.loads(call("eval", results / "trajectory.tum", truth, "--json").stdout)
    return (summary["states"]["LOST"] == 0 and
            evaluation["ate"]["translation_m"]["rmse"] < TRACKED_M and
            evaluation["ate"]["rotation_deg"]["rmse"] < TRACKED_DEG)


def largest(world, values, flag, rate_hz, options):
    """The last value before the first at which any seed is lost."""
    best = 0
    for value in values:
        for seed in range(1, options.seeds + 1):
            flags = [flag, value, "--rate", rate_hz, "--duration", 30]
            if not tracks(world, seed, OUT / "envelope", flags):
                return best
        best = value
    return best


def experiment(options):
    rows = []
    for rate_hz in RATES_HZ:
        rows.append([
            f"{rate_hz} Hz",
            f"{largest('spin.yaml', YAW_RATES_DPS, '--yaw-rate', rate_hz, options)}",
            f"{largest('race.yaml', SPEEDS_MPS, '--speed', rate_hz, options)}"])
    yield (f"Largest value at which none of {options.seeds} seeds was LOST or more than "
           f"{TRACKED_M} m or {TRACKED_DEG} degrees RMS off; tried: {YAW_RATES_DPS} deg/s, {SPEEDS_MPS} m/s.")
    yield from table(["laser", "yaw rate, deg/s", "speed, m/s"], rows)
