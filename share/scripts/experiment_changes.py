"""A moved cupboard: how long the pose is pulled towards where it stood."""
import trajectories
from experiment_runs import OUT, WORLDS, call, density_flags, run, simulate, table

WORLD = WORLDS / "cupboard.yaml"
WORLD_SHIFT = "shift_m: [0, -0.2]"
SHIFTS_CM = [10, 20]
FORGETTING_S = 20
WAYS = {
    "uniform": density_flags("uniform", FORGETTING_S),
    "window, 30 s": density_flags("window", FORGETTING_S),
    "window, 60 s": [*density_flags("window", FORGETTING_S), "--set", "Density.window_s=60"],
    f"forgetting, {FORGETTING_S} s": density_flags("forgetting", FORGETTING_S),
    "revisit": density_flags("revisit", FORGETTING_S),
}
PAPER = ["-c", "config/paper.ini"]
MRPT = ["mrpt-stock", "mrpt-dense"]
MRPT_FLIGHTS = 3
CHANGE_S = 60  # share/worlds/cupboard.yaml
SETTLED_CM = 1.0
MEAN_OVER_S = 2.0
LAST_S = 30.0  # where the path has come to in the end


def bias(results, truth):
    """(seconds after the change, cm): the mean error vector over 2 s, laid over the truth before
    the change."""
    pairs = trajectories.matched(
        trajectories.read_tum(results / "trajectory.tum"), trajectories.read_tum(truth))
    errors = trajectories.position_errors(pairs, align_until_s=CHANGE_S)
    curve = []
    for i, (time_s, _) in enumerate(errors):
        if time_s < CHANGE_S + MEAN_OVER_S:
            continue
        window = [e for t, e in errors[max(0, i - 60):i + 1] if t > time_s - MEAN_OVER_S]
        curve.append((time_s - CHANGE_S, 100 * sum(window) / len(window)))
    return curve


def settled_after(curve, about=0):
    """Seconds from which on the bias stays within the limit about this vector; None: never."""
    above = [time_s for time_s, vector in curve if abs(vector - about) >= SETTLED_CM]
    if not above:
        return 0.0
    return None if above[-1] >= curve[-1][0] - MEAN_OVER_S else above[-1]


def shift_at_end(curve):
    """The mean error vector of the last half minute: how far the map's frame has moved."""
    last = [vector for time_s, vector in curve if time_s > curve[-1][0] - LAST_S]
    return sum(last) / len(last)


def worst_text(times):
    return "never" if None in times else f"{max(times):.0f}"


def row_of(name, curves):
    return [name, worst_text([settled_after(curve) for curve in curves]),
            worst_text([settled_after(curve, shift_at_end(curve)) for curve in curves]),
            f"{max(abs(vector) for curve in curves for _, vector in curve):.1f}",
            f"{max(abs(shift_at_end(curve)) for curve in curves):.2f}"]


def flights(shift_cm, seeds, folder):
    text = WORLD.read_text()
    if WORLD_SHIFT not in text:
        raise SystemExit(f"{WORLD}: expected '{WORLD_SHIFT}' in it")
    world = folder / f"cupboard-{shift_cm}cm.yaml"
    world.write_text(text.replace(WORLD_SHIFT, f"shift_m: [0, {-shift_cm / 100}]"))
    return [simulate(world, seed, folder) for seed in range(1, seeds + 1)]


def mrpt_curves(variant, logs, folder):
    for log, truth in logs:
        call("compare", log, "--truth", truth, "-o", folder / "compare", "--overwrite",
             "--no-odometry", "--repeats", 1, "--seeds", 1, "--quiet", "--variant", variant)
        yield bias(next((folder / "compare" / "runs").glob(f"{variant}-*")), truth)


def rows(logs, folder):
    for prefix, config in (("", []), ("paper.ini, ", PAPER)):
        for name, flags in WAYS.items():
            yield row_of(prefix + name, [
                bias(run(log, seed, folder / "run", *config, *flags), truth)
                for seed, (log, truth) in enumerate(logs, 1)])
    for variant in MRPT:
        yield row_of(variant, list(mrpt_curves(variant, logs[:MRPT_FLIGHTS], folder)))


def experiment(options):
    folder = OUT / "cupboard"
    yield (f"Mean error over {MEAN_OVER_S:.0f} s, worst of {options.seeds} seeds (MRPT: of up to"
           f" {MRPT_FLIGHTS}): seconds after the change until it stays below {SETTLED_CM:.0f} cm;"
           " until it stays that near to where it is in the last half minute; the largest; that of"
           " the last half minute.")
    for shift_cm in SHIFTS_CM:
        yield ""
        yield f"The cupboard is moved by {shift_cm} cm."
        yield from table(
            ["density", "s until below 1 cm", "s until it rests", "largest, cm", "at the end, cm"],
            rows(flights(shift_cm, options.seeds, folder), folder))
