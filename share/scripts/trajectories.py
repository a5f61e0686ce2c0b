"""Trajectories in TUM files, and figures of them that `rtob-slam eval` does not give."""
import cmath
import math


class Pose:
    """A pose in the plane: position as a complex number, m; heading, rad."""

    __slots__ = ("time_s", "at", "yaw")

    def __init__(self, time_s, at, yaw):
        self.time_s, self.at, self.yaw = time_s, at, yaw

    def seen_from(self, other):
        """Position in the other's axes, and the turn against it."""
        turn = math.remainder(self.yaw - other.yaw, 2 * math.pi)
        return (self.at - other.at) * cmath.exp(-1j * other.yaw), turn


def read_tum(file):
    poses = []
    with open(file, encoding="ascii") as lines:
        for line in lines:
            if line.startswith("#") or not line.strip():
                continue
            t, x, y, _, _, _, qz, qw = map(float, line.split())
            poses.append(Pose(t, complex(x, y), 2 * math.atan2(qz, qw)))
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


def revisit_error(pairs, near_m=0.5, apart_s=30.0, step_s=1.0):
    """The largest error, in m, of one pose seen from an earlier one at the same place: what a map
    that comes back shifted would show. None where no place is seen again."""
    chosen, last = [], -math.inf
    for estimate, true in pairs:
        if estimate.time_s - last >= step_s:
            chosen.append((estimate, true))
            last = estimate.time_s
    worst = None
    for i, (late, true_late) in enumerate(chosen):
        for early, true_early in chosen[:i]:
            if late.time_s - early.time_s < apart_s or abs(true_late.at - true_early.at) > near_m:
                continue
            error = abs(late.seen_from(early)[0] - true_late.seen_from(true_early)[0])
            worst = error if worst is None else max(worst, error)
    return worst
