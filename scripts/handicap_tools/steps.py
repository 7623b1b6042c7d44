"""The steps between neighbouring cells of a sweep: does a larger value ever hurt the team that has it?

Pairs with the same number have the same seeds in all cells, so a step is measured pair by pair, as the program's
column "from the first": mean difference, Student's interval.

A grid has the same factor of both teams, such as a.robots and b.robots. If both have the same strategy, a cell and its
mirror image measure the same, and are taken together. That halves the variance, so that also values farther apart are
compared: two steps that each hurt by less than their interval can together hurt by more.
"""

from dataclasses import dataclass
from itertools import combinations
from statistics import mean

from student import LEVEL, holm, interval_of_mean, p_of_no_harm, text_of
from sweep_results import ResultsError, changes, number_text

SIGNIFICANT = 1 - LEVEL


@dataclass
class Step:
    factor: str  # such as b.robots
    low: float  # its values before and after the step
    high: float
    others: dict  # the values of the other factors
    gains: list  # goals per game that the factor's team gains by the step, of each pair number

    @property
    def is_wrong(self):
        return mean(self.gains) < 0

    @property
    def is_wrong_beyond_interval(self):
        bounds = interval_of_mean(self.gains)
        return bounds is not None and bounds[1] < 0


def _sign_of(factor):
    """1 if a larger value helps team a, -1 if it helps team b."""
    if factor.startswith("a."):
        return 1
    if factor.startswith("b."):
        return -1
    raise ResultsError(f"{factor} is not a factor of one team; expected one such as a.robots or b.handicap")


def _steps_along(results, position):
    factor = results.factors[position]
    lines = {}
    for cell in results.differences:
        lines.setdefault(cell[:position] + cell[position + 1 :], []).append(cell)
    for others, cells in lines.items():
        cells.sort(key=lambda cell: cell[position])
        for low, high in zip(cells, cells[1:]):
            gains = [
                _sign_of(factor) * change for change in changes(results.differences[low], results.differences[high])
            ]
            if gains:
                names = results.factors[:position] + results.factors[position + 1 :]
                yield Step(factor, low[position], high[position], dict(zip(names, others)), gains)


def steps_of(results):
    """All steps of a sweep's factors, each of one team, such as a.robots and b.handicap."""
    return [step for position in range(len(results.factors)) for step in _steps_along(results, position)]


def _leads_by_numbers(results):
    """Of a grid, by (own value, opponents' value): the lead by pair number, the mean of both teams' cells."""
    leads = {}
    for own, other in results.differences:
        mirrored = results.differences.get((other, own), {})
        leads[own, other] = {
            pair: (lead - mirrored[pair]) / 2
            for pair, lead in results.differences[own, other].items()
            if pair in mirrored
        }
    return leads


def larger_values_of(results):
    """Every smaller value compared with every larger one, against the same opponents; empty unless it is a grid.

    A team and its mirror image draw by definition. So 3 to 4 against 4 would be the same number as 3 to 4 against 3,
    and is left out.
    """
    names = [factor.partition(".")[2] for factor in results.factors]
    if results.factors != [f"a.{names[0]}", f"b.{names[0]}"]:
        return []
    leads = _leads_by_numbers(results)
    compared = []
    for other in sorted({other for _, other in leads}):
        for low, high in combinations(sorted(own for own, against in leads if against == other), 2):
            if high == other:
                continue
            gains = changes(leads[low, other], leads[high, other])
            if gains:
                compared.append(Step(names[0], low, high, {"against": other}, gains))
    return compared


def _wrong_after_correction(steps):
    p_values = [p_of_no_harm(step.gains) for step in steps]
    return sum(p <= SIGNIFICANT for p in holm([p for p in p_values if p is not None]))


def _row_of(step):
    others = ", ".join(f"{name} {number_text(value)}" for name, value in step.others.items())
    name = f"{step.factor} {number_text(step.low)} to {number_text(step.high)}"
    mark = "beyond its interval" if step.is_wrong_beyond_interval else ""
    return name, others, text_of(step.gains), mark


def _summary_of(steps):
    wrong = [step for step in steps if step.is_wrong]
    beyond = [step for step in steps if step.is_wrong_beyond_interval]
    tested = sum(interval_of_mean(step.gains) is not None for step in steps)
    return (
        f"{len(steps)} steps to the next larger value; {len(wrong)} hurt the team that has it, "
        f"{len(beyond)} of them beyond their 95 % interval.\n"
        f"If no step had an effect, chance would give about {len(steps) / 2:g}, "
        f"and {tested * SIGNIFICANT / 2:.1f} beyond their interval.\n"
        f"With Holm's correction over all steps (one-sided, p at most {SIGNIFICANT:.2f}), "
        f"{_wrong_after_correction(steps)} hurt beyond chance.\n"
    )


def _table_of(steps):
    rows = [("step", "at", "goals gained per game [95 %]", "")] + [_row_of(step) for step in steps]
    widths = [max(len(row[column]) for row in rows) for column in range(4)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths) if width).rstrip() for row in rows)


def _worst_first(steps):
    return sorted(steps, key=lambda step: mean(step.gains))


def _report_of_larger_values(compared):
    """Of a grid: the larger values that hurt, of both teams' cells together."""
    beyond = [step for step in compared if step.is_wrong_beyond_interval]
    wrong = sum(step.is_wrong for step in compared)
    text = (
        f"\nBoth teams' cells together, each smaller value compared with each larger one: {len(compared)} comparisons; "
        f"in {wrong}\nthe larger one hurts, in {len(beyond)} of them beyond the 95 % interval, "
        f"in {_wrong_after_correction(compared)} beyond chance (Holm).\n"
    )
    return text + ("\n" + _table_of(_worst_first(beyond)) + "\n" if beyond else "")


def report(results):
    """The text that says which steps go in the wrong direction, worst first, and how many chance alone would give."""
    steps = steps_of(results)
    if not steps:
        raise ResultsError("no two neighbouring values have complete pairs of games")
    wrong = _worst_first(step for step in steps if step.is_wrong)
    text = _summary_of(steps)
    if wrong:
        text += "\n" + _table_of(wrong) + "\n"
    compared = larger_values_of(results)
    return text + (_report_of_larger_values(compared) if compared else "")
