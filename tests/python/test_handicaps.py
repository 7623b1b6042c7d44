"""The statistics of scripts/handicaps: steps in the wrong direction, and conditions compared with a base."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

_CHECKOUT = Path(__file__).resolve().parents[2]
_TOOLS = _CHECKOUT / "scripts" / "handicap_tools"
_FIGURE5 = _CHECKOUT / "results" / "figure5"
sys.path.insert(0, str(_TOOLS))

import instrument  # noqa: E402
import steps  # noqa: E402
import student  # noqa: E402
from sweep_results import ResultsError, SweepResults  # noqa: E402


def _results(factors, leads, status="ok"):
    """The results of a sweep with these leads of team a: {values: [lead of pair 1, of pair 2, ...]}."""
    lines = ["game_id,pair,leg," + ",".join(factors) + ",team_a,goals_a,goals_b,status"]
    for values, pairs in leads.items():
        for number, lead in enumerate(pairs, start=1):
            goals = f"{max(lead, 0)},{max(-lead, 0)}"
            for leg, of_leg in ((1, "ok"), (2, status)):
                lines.append(f"id,{number},{leg}," + ",".join(map(str, values)) + f",cobalt,{goals},{of_leg}")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "results.csv"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return SweepResults(file)


def _run(script, *arguments):
    return subprocess.run([_CHECKOUT / "scripts" / script, *arguments], capture_output=True, text=True, timeout=60)


class Student(unittest.TestCase):
    def test_quantiles_are_those_of_printed_tables(self):
        for freedom, t in ((1, 12.706), (2, 4.303), (9, 2.262), (10, 2.228), (19, 2.093), (120, 1.980)):
            self.assertAlmostEqual(student.quantile_within(0.95, freedom), t, places=3)

    def test_interval_of_two_values(self):
        low, high = student.interval_of_mean([1, 2])  # standard error 0.5
        self.assertAlmostEqual(low, 1.5 - 12.7062 / 2, places=4)
        self.assertAlmostEqual(high, 1.5 + 12.7062 / 2, places=4)

    def test_equal_values_have_no_interval(self):
        self.assertIsNone(student.interval_of_mean([2, 2, 2]))
        self.assertIsNone(student.p_of_zero_mean([2]))

    def test_p_of_a_mean_at_the_end_of_its_interval_is_five_percent(self):
        half = student.quantile_within(0.95, 1) / 2
        self.assertAlmostEqual(student.p_of_zero_mean([half - 0.5, half + 0.5]), 0.05, places=6)
        self.assertAlmostEqual(student.p_of_no_harm([half - 0.5, half + 0.5]), 0.975, places=6)

    def test_holm_multiplies_by_the_number_of_tests_left(self):
        self.assertEqual(student.holm([0.04, 0.01, 0.03]), [0.06, 0.03, 0.06])


class Steps(unittest.TestCase):
    def test_a_larger_value_helps_the_team_that_has_it(self):
        of_a = _results(["a.robots"], {(6,): [2, 3], (5,): [1, 1]})
        of_b = _results(["b.robots"], {(6,): [2, 3], (5,): [1, 1]})
        self.assertEqual([step.gains for step in steps.steps_of(of_a)], [[1, 2]])
        self.assertEqual([step.gains for step in steps.steps_of(of_b)], [[-1, -2]])

    def test_a_grid_of_six_by_six_has_sixty(self):
        cells = {(a, b): [a - b, a - b + 1] for a in range(1, 7) for b in range(1, 7)}
        found = steps.steps_of(_results(["a.robots", "b.robots"], cells))
        self.assertEqual(len(found), 60)
        self.assertFalse([step for step in found if step.is_wrong])

    def test_chance_alone_would_put_half_in_the_wrong_direction_and_a_fortieth_beyond_the_interval(self):
        cells = {(a, b): [a - b, 2 * (a - b)] for a in range(1, 7) for b in range(1, 7)}
        text = steps.report(_results(["a.robots", "b.robots"], cells))
        self.assertIn("60 steps to the next larger value; 0 hurt", text)
        self.assertIn("chance would give about 30, and 1.5 beyond", text)

    def test_of_a_grid_are_also_compared_with_both_teams_cells_together(self):
        cells = {(a, b): [a - b, 2 * (a - b)] for a in (1, 2, 3) for b in (1, 2, 3)}
        cells[3, 1] = [0, -1]  # the mirror image stays at -2 and -4
        compared = steps.larger_values_of(_results(["a.robots", "b.robots"], cells))
        self.assertEqual(len(compared), 6)  # of nine, three would be the same numbers again
        gains = {(step.low, step.high, step.others["against"]): step.gains for step in compared}
        self.assertEqual(gains[1, 3, 1], [1, 1.5])  # from the mean of 0 and 2, and of -1 and 4
        self.assertEqual(gains[1, 2, 3], [0, -0.5])  # from -1 and -1.5 to -1 and -2
        self.assertEqual(gains[2, 3, 2], [1, 2])

    def test_of_other_sweeps_are_compared_with_the_next_value_only(self):
        cells = {(6, 1): [1, 2], (6, 2): [1, 1], (5, 1): [0, 1], (5, 2): [0, 0]}
        self.assertEqual(steps.larger_values_of(_results(["a.robots", "b.handicap"], cells)), [])
        self.assertEqual(steps.larger_values_of(_results(["b.robots"], {(6,): [1, 2], (5,): [2, 3]})), [])

    def test_lead_to_the_next_value_whatever_the_order_of_the_rows(self):
        results = _results(["b.handicap"], {(0.8,): [1, 1], (1.0,): [0, 0], (0.6,): [3, 3]})
        self.assertEqual([(step.low, step.high) for step in steps.steps_of(results)], [(0.6, 0.8), (0.8, 1.0)])

    def test_report_names_the_wrong_one_and_what_chance_would_give(self):
        leads = {(a, b): [a - b, a - b + 1, a - b] for a in (1, 2) for b in (1, 2)}
        leads[2, 1] = [-9, -8, -8]
        text = steps.report(_results(["a.robots", "b.robots"], leads))
        self.assertIn("4 steps to the next larger value; 2 hurt", text)
        self.assertIn("chance would give about 2, and 0.1 beyond", text)
        self.assertRegex(text, r"a.robots 1 to 2 +b.robots 1 +-8.67 .* beyond its interval\n")

    def test_no_interval_is_not_beyond_it(self):
        step = steps.steps_of(_results(["a.robots"], {(1,): [2, 2], (2,): [1, 1]}))[0]
        self.assertTrue(step.is_wrong)
        self.assertFalse(step.is_wrong_beyond_interval)

    def test_wrong_one_within_its_interval_is_not_beyond_it(self):
        step = steps.steps_of(_results(["a.robots"], {(1,): [2, 2, 2], (2,): [0, 1, 3]}))[0]
        self.assertTrue(step.is_wrong)
        self.assertFalse(step.is_wrong_beyond_interval)

    def test_pairs_with_a_void_leg_do_not_count(self):
        with self.assertRaisesRegex(ResultsError, "no two neighbouring values"):
            steps.report(_results(["a.robots"], {(1,): [2], (2,): [1]}, status="void"))

    def test_factors_of_both_teams_are_refused(self):
        with self.assertRaisesRegex(ResultsError, "sim.substeps is not a factor of one team"):
            steps.report(_results(["sim.substeps"], {(1,): [2, 2], (2,): [1, 1]}))

    def test_command_refuses_other_files(self):
        for file, words in (
            ("missing.csv", "cannot read missing.csv"),
            (_FIGURE5 / "README.md", "expected the results"),
        ):
            answer = _run("handicap-steps", file)
            self.assertEqual(answer.returncode, 2)
            self.assertIn(words, answer.stderr)


class Instrument(unittest.TestCase):
    def test_slope_is_that_of_the_program(self):
        text = (_FIGURE5 / "speed" / "table.txt").read_text(encoding="utf-8")
        expected = re.search(r"by (\S+) per unit .*interval (\S+) to ([^)]+)\)", text).groups()
        results = SweepResults(_FIGURE5 / "speed" / "results.csv")
        slopes = list(instrument.Condition("base", "", results).slopes().values())
        low, high = student.interval_of_mean(slopes)
        for found, printed in zip((sum(slopes) / len(slopes), high, low), expected):
            self.assertAlmostEqual(-found / instrument.PER, float(printed), places=2)

    def _conditions(self):
        base = {(1.0,): [0, 1, 0], (0.8,): [2, 3, 3], (0.6,): [4, 6, 5]}
        steeper = {(1.0,): [0, 1, 0], (0.8,): [12, 13, 13], (0.6,): [24, 26, 25]}
        return [
            instrument.Condition("base", "", _results(["b.handicap"], base)),
            instrument.Condition("steep", "sim.latency_s=0", _results(["b.handicap"], steeper)),
        ]

    def test_changes_are_paired_with_the_base(self):
        base, steep = self._conditions()
        self.assertEqual([round(slope, 9) for slope in base.slopes().values()], [1.0, 1.25, 1.25])
        self.assertEqual([round(slope, 9) for slope in steep.slopes().values()], [6.0, 6.25, 6.25])
        row = instrument.comparison_table([base, steep]).splitlines()[-1]
        self.assertIn("| steep | `sim.latency_s=0` | +0.00 (all pairs equal) |", row)
        self.assertIn("| +10.00 (all pairs equal) |", row)

    def test_report_says_in_how_many_the_gap_grows(self):
        self.assertIn("beyond the 95 % interval, in 2 of 2 conditions", instrument.report(self._conditions()))

    def test_other_values_than_the_base_are_refused(self):
        base = self._conditions()[0]
        other = instrument.Condition("other", "", _results(["b.handicap"], {(1.0,): [1], (0.5,): [1]}))
        with self.assertRaisesRegex(ResultsError, "other: factor or values differ from those of base"):
            instrument.report([base, other])


class QuotedTables(unittest.TestCase):
    """A block after <!-- from: FILE --> in a README of results/ is in that file, beside the README."""

    def test_are_in_their_files(self):
        pattern = re.compile(r"<!-- from: (\S+) -->\n```\n(.*?)```", re.DOTALL)
        for readme in sorted((_CHECKOUT / "results").glob("*/README.md")):
            text = readme.read_text(encoding="utf-8")
            quotes = pattern.findall(text)
            self.assertEqual(len(quotes), text.count("<!-- from: "), readme)
            for file, quote in quotes:
                with self.subTest(readme=readme.parent.name, file=file):
                    self.assertIn(quote, (readme.parent / file).read_text(encoding="utf-8"))

    def test_exist_where_tables_are_committed(self):
        readme = (_FIGURE5 / "README.md").read_text(encoding="utf-8")
        for panel in ("speed", "robots"):
            self.assertIn(f"<!-- from: {panel}/table.txt -->", readme)


class Handicaps(unittest.TestCase):
    """The command, without games."""

    def test_refuses_what_it_does_not_know(self):
        for arguments, words in (
            ([], "unknown experiment ''"),
            (["grit"], "expected figure5, grid, factorial or instrument"),
            (["grid", "2014"], "unknown argument '2014'"),
            (["figure5", "2015"], "a book of"),
        ):
            answer = _run("handicaps", *arguments)
            self.assertEqual(answer.returncode, 2, arguments)
            self.assertIn(words, answer.stderr)

    def test_cameras_keep_the_delay_of_the_base(self):
        script = (_CHECKOUT / "scripts" / "handicaps").read_text(encoding="utf-8")
        settings = (_CHECKOUT / "docs" / "reference" / "settings.md").read_text(encoding="utf-8")
        default = re.search(r"\| `latency_s` \| `([^`]+)` \|", settings).group(1)
        self.assertEqual(re.search(r"^base_delay_s=(\S+)", script, re.MULTILINE).group(1), default)


if __name__ == "__main__":
    unittest.main()
