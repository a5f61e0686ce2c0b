"""How fast a vehicle may turn, with and without a gyro."""
from experiment_envelope import TRACKED_DEG, TRACKED_M, WAYS, largest, sweep_flags, tracks
from experiment_runs import OUT, table

RATE_HZ = 5.5  # of an RPLidar at its slowest, as in the slambot logs
YAW_RATES_DPS = [60, 90, 120, 150, 180, 210, 240, 300, 360, 450, 540, 630, 720, 810, 900, 990,
                 1080, 1260]


def fastest(has_gyro, deskew, options):
    def is_tracked(yaw_rate_dps, seed):
        flags = ["--yaw-rate", yaw_rate_dps, "--rate", RATE_HZ, "--duration", 20]
        return tracks("spin.yaml", seed, OUT / "gyro", flags, sweep_flags(RATE_HZ, deskew),
                      laser_only=not has_gyro)

    return largest(YAW_RATES_DPS, is_tracked, options.seeds)


def experiment(options):
    yield (f"Largest yaw rate at {RATE_HZ} Hz at which none of {options.seeds} seeds was LOST, more "
           f"than {TRACKED_M} m RMS or more than {TRACKED_DEG} degrees RMS off; tried: "
           f"{YAW_RATES_DPS} deg/s.")
    yield from table(
        ["way", *(f"deg/s, {way}" for way, _ in WAYS)],
        [[name, *(fastest(has_gyro, deskew, options) for _, deskew in WAYS)]
         for name, has_gyro in (("laser alone", False), ("with a gyro", True))])
