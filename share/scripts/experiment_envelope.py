"""How fast a vehicle may turn and fly without odometry."""
import json

from experiment_runs import OUT, WORLDS, call, run, simulate, table

RATES_HZ = [5, 10, 15]
YAW_RATES_DPS = [30, 60, 90, 120, 150, 180, 240, 300, 360, 450, 540]
SPEEDS_MPS = [0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8]
DURATION_S = 30
# RMS that still counts as tracked: a vehicle that turns on the spot shows only in its heading.
TRACKED_M, TRACKED_DEG = 0.2, 5
WAYS = [("as they are", "Scan.deskew=false"), ("deskewed", "Scan.deskew=true")]


def tracks(world, seed, folder, flags, run_flags=(), laser_only=True):
    log, truth = simulate(WORLDS / world, seed, folder, *flags, laser_only=laser_only)
    results = run(log, seed, folder / "run", *run_flags)
    summary = json.loads((results / "summary.json").read_text())
    evaluation = json.loads(call("eval", results / "trajectory.tum", truth, "--json").stdout)
    return (summary["states"]["LOST"] == 0 and
            evaluation["ate"]["translation_m"]["rmse"] < TRACKED_M and
            evaluation["ate"]["rotation_deg"]["rmse"] < TRACKED_DEG)


def sweep_flags(rate_hz, deskew):
    """The beams of a scan take the whole time until the next."""
    return ["--set", f"Scan.sweep_s={1 / rate_hz:.6f}", "--set", deskew]


def largest(values, is_tracked, seeds):
    """The last value before the first at which any seed is lost, as text."""
    best = f"below {values[0]}"
    for value in values:
        if not all(is_tracked(value, seed) for seed in range(1, seeds + 1)):
            return best
        best = str(value)
    return best + ", the fastest tried"


def rows(seeds):
    for rate_hz in RATES_HZ:
        row = [f"{rate_hz} Hz"]
        for world, flag, values in (("spin.yaml", "--yaw-rate", YAW_RATES_DPS),
                                    ("race.yaml", "--speed", SPEEDS_MPS)):
            for _, deskew in WAYS:
                def is_tracked(value, seed):
                    flags = [flag, value, "--rate", rate_hz, "--duration", DURATION_S]
                    return tracks(world, seed, OUT / "envelope", flags,
                                  sweep_flags(rate_hz, deskew))
                row.append(largest(values, is_tracked, seeds))
        yield row


def experiment(options):
    yield (f"Largest value at which none of {options.seeds} seeds was LOST or more than "
           f"{TRACKED_M} m or {TRACKED_DEG} degrees RMS off; tried: {YAW_RATES_DPS} deg/s, "
           f"{SPEEDS_MPS} m/s.")
    yield from table(
        ["laser", *(f"{what}, {way}" for what in ("yaw rate, deg/s", "speed, m/s")
                    for way, _ in WAYS)], rows(options.seeds))
