"""Loops: what forgetting costs when a place is seen again, by length of the loop."""
import math
import random
import statistics

import trajectories
from experiment_runs import OUT, density_flags, run, simulate, table

LENGTHS_M = [40, 100, 200, 400]
DENSITIES = ["revisit", "uniform", "window", "forgetting"]
CORRIDOR_M = 2.4  # wide
FORGETTING_S = 60


def ring(half_x, half_y, inset):
    x, y = half_x - inset, half_y - inset
    return [[-x, -y], [x, -y], [x, y], [-x, y]]


def pillars(half_x, half_y, rng):
    """Pillars and cupboards along the outer wall, at distances that do not repeat."""
    corners = ring(half_x, half_y, 0)
    things = []
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1]):
        side = math.hypot(x1 - x0, y1 - y0)
        ux, uy = (x1 - x0) / side, (y1 - y0) / side
        s = 1.5
        while s < side - 1.5:
            depth, width = rng.uniform(0.15, 0.4), rng.uniform(0.2, 1.0)
            # The outer wall lies to the right of the way round; its inside to the left.
            x, y = x0 + s * ux - depth / 2 * uy, y0 + s * uy + depth / 2 * ux
            things.append(
                f"  - {{box: {{at: [{x:.3f}, {y:.3f}], size_m: [{width:.3f}, {depth:.3f}], "
                f"yaw_deg: {math.degrees(math.atan2(uy, ux)):.1f}}}}}")
            s += rng.uniform(1.8, 4.0)
    return things


def world(length_m):
    """A rectangular corridor whose middle line is this long; once round, and the first side again."""
    half_x, half_y = 0.15 * length_m + CORRIDOR_M / 2, 0.1 * length_m + CORRIDOR_M / 2
    middle = ring(half_x, half_y, CORRIDOR_M / 2)
    # From a corner: what lies across the way holds the first metres (docs/experiments.md).
    route = [*middle[1:], *middle[:2]]
    lines = [
        f"# A corridor that leads round a block, {length_m} m a round.",
        f"name: loop of {length_m} m",
        "vehicle: {turbulence_mps2: 0.1, radius_m: 0.3}",
        f"start: {{at: {middle[0]}, altitude_m: 1}}",
        "flight:",
        f"  duration_s: {1.3 * length_m / 0.8 + 5:.0f}",
        "  speed_mps: 0.8",
        "  repeat: false",
        "  route:",
        *(f"    - {{to: [{x:.3f}, {y:.3f}]}}" for x, y in route),
        "objects:",
        f"  - {{name: outside, wall: {{points: {ring(half_x, half_y, 0)}, closed: true}}}}",
        f"  - {{name: block, wall: {{points: {ring(half_x, half_y, CORRIDOR_M)}, closed: true}}}}",
        *pillars(half_x, half_y, random.Random(length_m)),
    ]
    return "\n".join(lines) + "\n"


def closing_errors_cm(results, truth):
    """How far the places of the first side are off when they are seen again: the largest, which is
    how far off the return was noticed, and what is left of it in the last tenth of the flight."""
    pairs = trajectories.matched(
        trajectories.read_tum(results / "trajectory.tum"), trajectories.read_tum(truth))
    return [100 * (trajectories.revisit_shift(pairs, near_m=1.0, from_share=share) or 0)
            for share in (0, 0.9)]


def cell(errors_cm):
    """Of all seeds: the worst, and in brackets the median; of the largest and of what is left."""
    return ", ".join(f"{max(each):.1f} ({statistics.median(each):.1f})" for each in zip(*errors_cm))


def experiment(options):
    folder = OUT / "loops"
    rows = []
    for length_m in LENGTHS_M:
        file = folder / f"loop-{length_m}.yaml"
        file.write_text(world(length_m), encoding="utf-8")
        errors_cm = {density: [] for density in DENSITIES}
        for seed in range(1, options.seeds + 1):
            log, truth = simulate(file, seed, folder)
            for density in DENSITIES:
                results = run(log, seed, folder / f"{length_m}-{density}-{seed}",
                              *density_flags(density, FORGETTING_S))
                errors_cm[density].append(closing_errors_cm(results, truth))
        rows.append([f"{length_m} m", *(cell(errors_cm[density]) for density in DENSITIES)])
    yield (f"Shift of the revisited places, cm, worst of {options.seeds} seeds (median): the largest,"
           " and what is left of it in the last tenth of the flight.")
    yield from table(["loop", *DENSITIES], rows)
