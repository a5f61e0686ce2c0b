"""A moved cupboard: how long the pose is pulled towards where it stood."""
import trajectories
from experiment_runs import OUT, WORLDS, call, density_flags, run, simulate, table

DENSITIES = ["uniform", "window", "forgetting", "revisit"]
MRPT = ["mrpt-stock", "mrpt-dense"]
CHANGE_S = 60  # share/worlds/cupboard.yaml
SETTLED_CM = 1.0
FORGETTING_S = 20
MEAN_OVER_S = 2.0


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
        curve.append((time_s - CHANGE_S, 100 * abs(sum(window) / len(window))))
    return curve


def settled_after(curve):
    """Seconds from which on the bias stays below the limit; None: never."""
    above = [time_s for time_s, cm in curve if cm >= SETTLED_CM]
    if not above:
        return 0.0
    return None if above[-1] >= curve[-1][0] - MEAN_OVER_S else above[-1]


def row_of(name, curves):
    times = [settled_after(curve) for curve in curves]
    worst = "never" if None in times else f"{max(times):.0f}"
    largest = max(cm for curve in curves for _, cm in curve)
    last = max(curve[-1][1] for curve in curves)
    return [name, worst, f"{largest:.2f}", f"{last:.2f}"]


def experiment(options):
    folder = OUT / "cupboard"
    curves = {name: [] for name in [*DENSITIES, *("paper " + d for d in DENSITIES), *MRPT]}
    for seed in range(1, options.seeds + 1):
        log, truth = simulate(WORLDS / "cupboard.yaml", seed, folder)
        for density in DENSITIES:
            results = run(log, seed, folder / f"{density}-{seed}", *density_flags(density, FORGETTING_S))
            curves[density].append(bias(results, truth))
            results = run(
                log, seed, folder / f"paper-{density}-{seed}", "-c", "config/paper.ini",
                *density_flags(density, FORGETTING_S))
            curves["paper " + density].append(bias(results, truth))
        if seed > 1:
            continue  # MRPT's has no seeds; its log does
        flags = [flag for variant in MRPT for flag in ("--variant", variant)]
        call("compare", log, "--truth", truth, "-o", folder / "compare", "--overwrite",
             "--no-odometry", "--repeats", 1, "--seeds", 1, "--quiet", *flags)
        for variant in MRPT:
            for results in sorted((folder / "compare" / "runs").glob(f"{variant}-*")):
                curves[variant].append(bias(results, truth))
    yield (f"Seconds after the change until the mean error over {MEAN_OVER_S:.0f} s stays below "
           f"{SETTLED_CM:.0f} cm; worst of {options.seeds} seeds (MRPT: of one log).")
    yield from table(
        ["density", "s until below 1 cm", "largest, cm", "at the end, cm"],
        [row_of(name, each) for name, each in curves.items() if each])
