"""The arithmetic of scripts/rule-numbers, on small made-up counts."""

import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

_SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "rule-numbers"


def _loaded():
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("rule_numbers", str(_SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("rule_numbers", loader))
    loader.exec_module(module)
    return module


rule_numbers = _loaded()


class Values(unittest.TestCase):
    def test_a_number_is_doubled_and_halved_or_moved_less(self):
        up, down = rule_numbers.wanted_values(0.5)
        self.assertEqual((up[0], up[-1]), (1.0, 0.55))
        self.assertEqual((down[0], down[-1]), (0.25, 0.45))

    def test_whole_numbers_have_whole_neighbours(self):
        up, down = rule_numbers.wanted_values(3)
        self.assertEqual(up[-1], 4)
        self.assertEqual(down[-2:], [1, 2])

    def test_zero_can_only_be_raised_and_a_flag_only_be_changed(self):
        self.assertEqual(rule_numbers.wanted_values(0), [[1, 1], []])
        self.assertEqual(rule_numbers.wanted_values(True), [[False]])


class Tests(unittest.TestCase):
    # Fisher's tea tasting: 3 of 4 against 1 of 4.
    def test_fisher(self):
        self.assertAlmostEqual(rule_numbers.fisher_p(3, 4, 1, 4), 34 / 70)
        self.assertAlmostEqual(rule_numbers.fisher_p(4, 4, 0, 4), 2 / 70)
        self.assertEqual(rule_numbers.fisher_p(5, 5, 7, 7), 1)

    def test_rates(self):
        self.assertEqual(rule_numbers.rate_p(0, 0), 1)
        self.assertAlmostEqual(rule_numbers.rate_p(60, 40), 0.0455, places=4)  # two standard deviations

    def test_holm(self):
        self.assertEqual(rule_numbers.holm([0.01, 0.5, 0.02]), [0.03, 0.5, 0.04])

    def test_f1_as_a_proportion(self):
        self.assertEqual(rule_numbers.trials_of(happened=10, calls=12, right=9), 11)
        self.assertEqual(rule_numbers.trials_of(happened=0, calls=0, right=0), 0)


class Table(unittest.TestCase):
    official = {"goal": [48, 48, 48], "bot_pushed_bot": [100, 100, 95]}

    def _table(self, counts):
        one = rule_numbers.Comparison("pushing_m", 0.2, 0.4, counts)
        same_games = {"goal": [12, 12, 12], "bot_pushed_bot": [25, 25, 24]}
        refused = [("retakes", "lowered", "why")]
        return rule_numbers.markdown("2026-b", [one], refused, same_games, self.official, 12, 48)

    def test_names_the_event_that_changed(self):
        table = self._table({"goal": [12, 12, 12], "bot_pushed_bot": [2, 2, 2]})
        self.assertIn("| `pushing_m` | 0.2 | 0.4 | `bot_pushed_bot` | 25 → 2 | 25 → 2 | 1.000 |", table)
        self.assertIn("2 comparisons of an event's F1", table)
        self.assertIn("0 with p below 0.05, 0 of them", table)
        self.assertIn("`retakes` cannot be lowered: why", table)

    # The referee keeps calling what the ground truth no longer sees.
    def test_names_an_event_whose_f1_changed(self):
        table = self._table({"goal": [12, 12, 12], "bot_pushed_bot": [2, 24, 2]})
        self.assertIn("- `pushing_m` 0.4: F1 of `bot_pushed_bot` 0.950 → 0.154", table)


if __name__ == "__main__":
    unittest.main()
