# SPDX-License-Identifier: BSD-3-Clause
"""The scripts behind ./dev experiment: what they make of the runs.

usage: test_experiments.py SOURCE_FOLDER
"""
import pathlib
import sys
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(SOURCE / "share/scripts"))

import experiment_changes  # noqa: E402
import experiment_compare  # noqa: E402
import experiment_envelope  # noqa: E402
import experiment_hour  # noqa: E402
import experiment_loops  # noqa: E402
import trajectories  # noqa: E402


def run(rms_cm, p50_ms=1.0, revisit_cm=2.0):
    return {"rms_cm": rms_cm, "max_cm": 3.0, "jump_cm": 1.5, "revisit_cm": revisit_cm,
            "scan_cpu_p50_ms": p50_ms, "first_tenth_ms": 0.5, "last_tenth_ms": 0.75}


class Comparison(unittest.TestCase):
    def test_of_several_flights_the_worst_error_and_the_median_time_are_shown(self):
        flights = [{"rtob-revisit": run(1.0, 0.3), "mrpt-dense": run(9.0)},
                   {"rtob-revisit": run(2.5, 0.1), "mrpt-dense": run(8.0)},
                   {"rtob-revisit": run(2.0, 0.2), "mrpt-dense": run(8.5)}]
        lines = list(experiment_compare.comparison_table(flights))
        self.assertIn("| **RTOB-SLAM** (revisit) | 2.50 | 3.00 | 1.50 | 2.00 | 0.20 | 0.50 → 0.75 |",
                      lines)
        self.assertIn("| MRPT icp-slam, dense | 9.00 |", lines[-1])

    def test_a_program_that_failed_once_has_its_reason_in_all_columns(self):
        lines = list(experiment_compare.comparison_table(
            [{"pcl": run(1.0, revisit_cm=None)}, {"pcl": "crashed"}]))
        self.assertIn("crashed", lines[-1])
        bars = {line.count("|") for line in lines if line.startswith("|")}
        self.assertEqual(len(bars), 1)


class Envelope(unittest.TestCase):
    def test_it_ends_at_the_first_value_that_any_seed_loses(self):
        def is_tracked(value, seed):
            return value < 3 or (value == 3 and seed == 1) or value > 4

        self.assertEqual(experiment_envelope.largest([1, 2, 3, 5], is_tracked, 1),
                         "5, the fastest tried")
        self.assertEqual(experiment_envelope.largest([1, 2, 3, 5], is_tracked, 2), "2")
        self.assertEqual(experiment_envelope.largest([4], is_tracked, 1), "below 4")


class Loops(unittest.TestCase):
    def test_the_worst_seed_and_the_median_of_both_figures(self):
        self.assertEqual(experiment_loops.cell([[10, 1], [30, 2], [20, 9]]),
                         "30.0 (20.0), 9.0 (2.0)")

    def test_what_is_left_of_a_shift_that_was_put_right(self):
        # Along x and back, a minute each way; 1 m off to the side until 20 s after the turn.
        poses = [(t, complex(t if t <= 60 else 120 - t, 0)) for t in range(121)]
        pairs = [(trajectories.Pose(t, at + (1j if 60 < t < 80 else 0), 0),
                  trajectories.Pose(t, at, 0)) for t, at in poses]
        whole = trajectories.revisit_shift(pairs, near_m=1.0, apart_s=20)
        left = trajectories.revisit_shift(pairs, near_m=1.0, apart_s=20, from_share=0.9)
        self.assertAlmostEqual(whole, 1, delta=0.05)
        self.assertLess(left, 0.1)


class Hour(unittest.TestCase):
    def test_a_constant_time_has_no_slope(self):
        slope, error = experiment_hour.slope_ms_per_hour([0.5] * 36000)
        self.assertAlmostEqual(slope, 0)
        self.assertAlmostEqual(error, 0)

    def test_a_time_that_grows_has_its_slope(self):
        slope, error = experiment_hour.slope_ms_per_hour([1 + i / 36000 for i in range(36000)])
        self.assertAlmostEqual(slope, 1, 3)
        self.assertAlmostEqual(error, 0, 3)

    def test_less_than_half_a_part_at_the_end_is_left_out(self):
        self.assertEqual([len(part) for part in experiment_hour.spans(list(range(24)), 10)],
                         [10, 10])
        self.assertEqual([len(part) for part in experiment_hour.spans(list(range(26)), 10)],
                         [10, 10, 6])


class Settling(unittest.TestCase):
    def test_it_settles_where_the_bias_last_was_too_large(self):
        curve = [(t, 3.0 if t < 7 or t == 20 else 0.5) for t in range(2, 60)]
        self.assertEqual(experiment_changes.settled_after(curve), 20)

    def test_never_and_always_are_told_apart(self):
        self.assertEqual(experiment_changes.settled_after([(t, 0.5) for t in range(60)]), 0)
        self.assertIsNone(experiment_changes.settled_after([(t, 1.5) for t in range(60)]))

    def test_a_frame_that_has_moved_rests_where_it_is(self):
        curve = [(t, 5.0 if t < 10 else 2.0 + 1.5j) for t in range(2, 60)]
        end = experiment_changes.shift_at_end(curve)
        self.assertEqual(end, 2.0 + 1.5j)
        self.assertIsNone(experiment_changes.settled_after(curve))
        self.assertEqual(experiment_changes.settled_after(curve, end), 9)
        self.assertEqual(experiment_changes.row_of("x", [curve]), ["x", "never", "9", "5.0", "2.50"])


if __name__ == "__main__":
    unittest.main()
