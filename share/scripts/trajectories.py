"""Trajectories in TUM files, and figures of them that `rtob-slam eval` does not give."""
import math


class Pose:
    """A place in the plane as a complex number, m, and a heading, rad."""

    __slots__ = ("time_s", "at", "yaw_rad")

    def __init__(self, time_s, at, yaw_rad):
        self.time_s, self.at, self.yaw_rad = time_s, at, yaw_rad


def read_tum(file):
    poses = []
    with open(file, encoding="ascii") as lines:
        for line in lines:
            if line.startswith("#") or not line.strip():
                continue
            time_s, x, y, _, _, _, qz, qw = map(float, line.split()[:8])
            poses.append(Pose(time_s, complex(x, y), 2 * math.atan2(qz, qw)))
    return poses


def matched(estimate, truth):
    """Pairs of poses with the same stamp."""
    by_stamp = {round(pose.time_s * 1e4): pose for pose in truth}
    pairs = [(pose, by_stamp.get(round(pose.time_s * 1e4))) for pose in estimate]
    return [(pose, true) for pose, true in pairs if true]


def position_errors(pairs, align_until_s=math.inf):
    """(seconds since the start, error vector in m), the estimate laid over the truth by least
    squares over the pairs up to this second."""
    start = pairs[0][0].time_s
    used = [(e.at, t.at) for e, t in pairs if e.time_s - start <= align_until_s]
    mean_e = sum(e for e, _ in used) / len(used)
    mean_t = sum(t for _, t in used) / len(used)
    turn = sum((e - mean_e).conjugate() * (t - mean_t) for e, t in used)
    turn = turn / abs(turn) if abs(turn) > 0 else 1
    return [(e.time_s - start, turn * (e.at - mean_e) + mean_t - t.at) for e, t in pairs]


def mean_errors(pairs, over_s=2.0, step_s=1.0):
    """Every second: the truth in the middle, and the mean error vector over 2 s. What a single
    scan is off averages out; what the map is off stays."""
    errors = position_errors(pairs)
    means, first, due = [], 0, over_s / 2
    for i, (time_s, _) in enumerate(errors):
        if time_s < due:
            continue
        due = time_s + step_s
        while errors[first][0] < time_s - over_s / 2:
            first += 1
        window = [e for t, e in errors[first:i + 60] if t <= time_s + over_s / 2]
        means.append((time_s, pairs[i][1].at, sum(window) / len(window)))
    return means


def revisit_shift(pairs, near_m=0.5, apart_s=30.0, from_share=0.0):
    """The largest shift, in m, between what is found at a place and what was found there at least
    30 s before: what a map that comes back shifted shows. None where no place is seen again. Only
    returns after this share of the time count."""
    means = mean_errors(pairs)
    shifts = [
        abs(late_error - early_error)
        for i, (late_s, late_at, late_error) in enumerate(means)
        for early_s, early_at, early_error in means[:i]
        if late_s >= from_share * means[-1][0] and late_s - early_s >= apart_s and abs(late_at - early_at) <= near_m]
    return max(shifts, default=None)
