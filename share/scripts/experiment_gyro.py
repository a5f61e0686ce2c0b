"""How fast a vehicle may turn, with and without a gyro."""
from experiment_envelope import tracks
from experiment_runs import OUT, table

RATE_HZ = 5.5  # of an RPLidar at its slowest, as in the slambot logs
YAW_RATES_DPS = [60, 90, 120, 150, 180, 210, 240, 300, 360, 450, 540, 630, 720, 810, 900, 990,
                 1080, 1260]

# name, whether the log has the gyro, options
WAYS = [
    ("laser alone", False, ["--set", "Scan.deskew=false"]),
    ("laser alone, deskewed", False, []),
    ("gyro", True, ["--set", "Scan.deskew=false"]),
    ("gyro, deskewed", True, []),
]


def largest(has_gyro, run_flags, options):
    """The last yaw rate before the first at which any seed is lost."""
    best = 0
    for yaw_rate_dps in YAW_RATES_DPS:
        flags = ["--yaw-rate", yaw_rate_dps, "--rate", RATE_HZ, "--duration", 20]
        sweep = ["--set", f"Scan.sweep_s={1 / RATE_HZ:.6f}", *run_flags]
        for seed in range(1, options.seeds + 1):
            if not tracks("spin.yaml", seed, OUT / "gyro", flags, sweep, laser_only=not has_gyro):
                return best
        best = yaw_rate_dps
    return best


def experiment(options):
    yield (f"Largest yaw rate at {RATE_HZ} Hz at which none of {options.seeds} seeds was LOST, more "
           f"than 0.2 m RMS or more than 5 degrees RMS off; tried: {YAW_RATES_DPS} deg/s.")
    yield from table(
        ["way", "yaw rate, deg/s"],
        [[name, str(largest(has_gyro, flags, options))] for name, has_gyro, flags in WAYS])
