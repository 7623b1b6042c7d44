"""Reads results.csv of a sweep: its factors, and the value of each pair of games in each cell."""

import csv
from collections import defaultdict


class ResultsError(Exception):
    """The file is not the results.csv of a sweep."""


class SweepResults:
    """The pairs of a sweep whose two legs are both valid.

    factors      paths such as "b.robots", in the sweep's order
    differences  by cell, a tuple of the factors' numbers: goals of a minus b by pair number, the mean of both legs
    goals        likewise, the goals of both teams together
    """

    def __init__(self, file):
        self.factors, rows = _factors_and_rows(file)
        self.differences = self._by_cell(file, rows, lambda row: int(row["goals_a"]) - int(row["goals_b"]))
        self.goals = self._by_cell(file, rows, lambda row: int(row["goals_a"]) + int(row["goals_b"]))

    def _by_cell(self, file, rows, value_of):
        legs = defaultdict(lambda: defaultdict(list))
        for row in rows:
            try:
                cell = tuple(float(row[factor]) for factor in self.factors)
            except ValueError as error:
                raise ResultsError(f"{file}: the factors must be numbers ({error})") from error
            if row["status"] == "ok":
                legs[cell][int(row["pair"])].append(value_of(row))
        return {
            cell: {pair: sum(values) / 2 for pair, values in pairs.items() if len(values) == 2}
            for cell, pairs in legs.items()
        }


def _factors_and_rows(file):
    with open(file, newline="", encoding="utf-8") as opened:
        rows = list(csv.DictReader(opened))
    columns = list(rows[0]) if rows else []
    if "leg" not in columns or "team_a" not in columns:
        raise ResultsError(f"{file}: expected the results.csv of a sweep with at least one game")
    factors = columns[columns.index("leg") + 1 : columns.index("team_a")]
    if not factors:
        raise ResultsError(f"{file}: this experiment has no factors; expected the results.csv of a sweep")
    return factors, rows


def changes(before, after):
    """after - before, of the pair numbers that both have, in their order."""
    return [after[pair] - before[pair] for pair in sorted(before.keys() & after.keys())]


def number_text(number):
    """6 for 6.0, and 0.8 for 0.8."""
    return f"{number:g}"
