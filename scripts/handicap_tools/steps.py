"""The steps between neighbouring cells of a sweep: does a larger value ever hurt the team that has it?

Pairs with the same number have the same seeds in all cells, so a step is measured pair by pair, as the program's
column "from the first": mean difference, Student's interval.
"""

from dataclasses import dataclass
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


def report(results):
    """The text that says which steps go in the wrong direction, worst first, and how many chance alone would give."""
    steps = steps_of(results)
    if not steps:
        raise ResultsError("no two neighbouring values have complete pairs of games")
    wrong = sorted((step for step in steps if step.is_wrong), key=lambda step: mean(step.gains))
    if not wrong:
        return _summary_of(steps)
    rows = [("step", "at", "goals gained per game [95 %]", "")] + [_row_of(step) for step in wrong]
    widths = [max(len(row[column]) for row in rows) for column in range(4)]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths) if width).rstrip() for row in rows]
    return _summary_of(steps) + "\n" + "\n".join(lines) + "\n"
