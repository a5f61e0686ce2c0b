# SPDX-License-Identifier: BSD-3-Clause
"""The scripts behind ./dev evaluate: what they put into docs/evaluation.md.

usage: test_evaluate.py SOURCE_FOLDER
"""
import argparse
import json
import pathlib
import sys
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(SOURCE / "share/scripts"))

import evaluate_document  # noqa: E402
import evaluate_logs  # noqa: E402
import evaluate_runs  # noqa: E402
import evaluate_tables  # noqa: E402

PEERS = [{"program": "Peer", "intel": "0.5", "fr079": "", "killian": "", "intel_cpu_ms": "4"}]


def run(variant, error_m, cpu_s, failure=""):
    if failure:
        return {"variant": variant, "map_unit": "", "failure": failure}
    return {"variant": variant, "failure": "", "map_unit": "points", "error_mean_m": error_m,
            "error_std_m": 0.01, "turn_error_mean_deg": 0.25, "scan_cpu_p50_ms": 1.5,
            "scan_cpu_p99_ms": 2.5, "first_tenth_ms": 1, "last_tenth_ms": 3, "cpu_s": cpu_s,
            "peak_memory_mb": 100}


def result(*runs):
    return {"command": "rtob-slam compare x", "commit": "abc", "runs": list(runs)}


class Tables(unittest.TestCase):
    def test_the_worst_run_is_shown_and_the_median_beside_it(self):
        shown = list(evaluate_tables.section("intel", result(
            run("rtob-revisit", 0.1, 5), run("rtob-revisit", 0.3, 7), run("rtob-revisit", 0.2, 6)),
            []))
        row = next(line for line in shown if "RTOB-SLAM" in line)
        self.assertIn("| 3 | 0.3 ± 0.01 | 0.2 | 0.25 | 1.5 | 2.5 | 1 → 3 | 6 | 100 |", row)

    def test_every_row_has_all_columns(self):
        shown = list(evaluate_tables.section("intel", result(
            run("rtob-revisit", 0.1, 5), run("odometry", 7, 0),
            run("mrpt-dense", 0, 0, failure="too slow")), PEERS))
        bars = [line.count("|") for line in shown if line.startswith("|")]
        self.assertEqual(len(bars), 6)
        self.assertEqual(set(bars), {bars[0]})
        self.assertTrue(any("too slow" in line for line in shown))

    def test_peers_are_marked_as_quoted_and_only_where_they_were_measured(self):
        judged = result(run("rtob-revisit", 0.1, 5))
        quoted = [line for line in evaluate_tables.section("intel", judged, PEERS)
                  if "Peer" in line]
        self.assertEqual(len(quoted), 1)
        self.assertIn("*quoted* | 0.5 |", quoted[0])
        self.assertFalse(any("Peer" in line
                             for line in evaluate_tables.section("fr079", judged, PEERS)))

    def test_the_summary_asks_for_the_worst_seed_against_the_rivals_best(self):
        measured = {"intel": result(
            run("rtob-revisit", 0.1, 5), run("rtob-revisit", 0.3, 7), run("mrpt-stock", 0.4, 8),
            run("mrpt-stock", 0.35, 5), run("mrpt-dense", 0.2, 9))}
        row = list(evaluate_tables.summary(measured))[-1]
        self.assertIn("yes (0.35 m) / NO (0.2 m)", row)
        self.assertIn("NO (5 s) / yes (9 s)", row)  # the median of 5 and 7 s is 6 s

    def test_numbers_have_three_digits_that_mean_something(self):
        for value, text in ((0.017654, "0.0177"), (213.4, "213"), (1234.5, "1230"), (0, "0"),
                            (None, "-")):
            self.assertEqual(evaluate_tables.short(value), text)


class Commands(unittest.TestCase):
    @staticmethod
    def options(**changed):
        return argparse.Namespace(**{"repeats": 1, "seeds": 10, "time_limit": 60, "variant": None,
                                     **changed})

    def test_ten_seeds_and_one_run_of_the_others_are_one_comparison(self):
        command = evaluate_runs.shown_command(
            evaluate_logs.LOGS["malaga"], self.options(time_limit=5))
        self.assertTrue(command.startswith("rtob-slam compare '/usr/share/mrpt/"), command)
        self.assertTrue(command.endswith("--repeats 1 --seeds 10 --time-limit 5"), command)

    def test_chosen_variants_replace_those_of_the_log(self):
        command = evaluate_runs.shown_command(
            evaluate_logs.LOGS["killian"], self.options(variant=["rtob-revisit", "mrpt-dense"]))
        self.assertIn("$RTOB_DATASETS/mit-killian/", command)
        self.assertTrue(
            command.endswith("--variant rtob-revisit --variant mrpt-dense"), command)


class Document(unittest.TestCase):
    PAGE = ("hand-written\n<!-- measured: intel -->\nold\n<!-- end -->\nmore\n"
            "<!-- measured: fr079 -->\nkept\n<!-- end -->\n")

    def test_only_places_of_measured_logs_change(self):
        page = evaluate_document.filled(
            self.PAGE, {"intel": result(run("rtob-revisit", 0.1, 5))}, [])
        self.assertIn("hand-written\n", page)
        self.assertIn("\nmore\n", page)
        self.assertIn("\nkept\n", page)
        self.assertNotIn("\nold\n", page)
        self.assertIn("0.1 ± 0.01", page)
        again = evaluate_document.filled(
            page, {"intel": result(run("rtob-revisit", 0.1, 5))}, [])
        self.assertEqual(again, page)

    def test_markers_that_do_not_fit_are_named(self):
        measured = {"killian": result(run("rtob-revisit", 0.1, 5))}
        for page, what in ((self.PAGE, "killian"),
                           ("<!-- measured: nowhere -->\n<!-- end -->\n", "nowhere"),
                           ("<!-- measured: intel -->\nno end\n", "no <!-- end -->")):
            with self.assertRaises(SystemExit) as refused:
                evaluate_document.filled(page, measured, [])
            self.assertIn(what, str(refused.exception))

    def test_the_page_is_up_to_date_with_the_figures(self):
        folder = SOURCE / "docs/evaluation"
        page = (SOURCE / evaluate_document.DOCUMENT).read_text()
        peers = evaluate_tables.read_peers(folder / "peers.csv")
        self.assertEqual(
            evaluate_document.filled(page, evaluate_document.results(folder), peers), page,
            "run ./dev evaluate --tables")

    def test_every_picture_is_small_enough(self):
        for picture in (SOURCE / "docs/pictures").glob("*.png"):
            self.assertLessEqual(picture.stat().st_size, 300_000, picture)

    def test_figures_are_of_known_logs(self):
        for file in (SOURCE / "docs/evaluation").glob("*.json"):
            self.assertIn(file.stem, evaluate_logs.LOGS)
            self.assertIn("command", json.loads(file.read_text()))


if __name__ == "__main__":
    unittest.main()
