"""Compares sweeps over one handicap that differ in one setting each, the conditions, with the first one, the base.

All conditions have the same seeds, so each is compared with the base pair by pair.
"""

from dataclasses import dataclass
from statistics import mean

from student import LEVEL, holm, interval_of_mean, p_of_zero_mean, text_of
from sweep_results import ResultsError, changes, number_text

PER = 0.1  # slopes are per this change of the handicap
COMPARED = (1.0, 0.8)  # values of the handicap at which goals are compared


@dataclass
class Condition:
    name: str
    settings: str  # its changes to the base, as text
    results: object  # its SweepResults

    @property
    def values(self):
        """The values of the handicap, full strength first."""
        return sorted((cell[0] for cell in self.results.differences), reverse=True)

    def slopes(self):
        """Goals of "a minus b" gained per 0.1 of handicap, by pair number: least squares over all values."""
        by_value = [self.results.differences[(value,)] for value in self.values]
        centre = mean(self.values)
        spread = sum((value - centre) ** 2 for value in self.values)
        complete = set.intersection(*(set(pairs) for pairs in by_value))
        return {
            pair: -PER * sum((value - centre) * pairs[pair] for value, pairs in zip(self.values, by_value)) / spread
            for pair in sorted(complete)
        }


def check(conditions):
    """Raises ResultsError unless all conditions vary the same factor over the same two or more values."""
    base = conditions[0]
    for condition in conditions:
        if len(condition.results.factors) != 1 or len(condition.values) < 2:
            raise ResultsError(f"{condition.name}: expected a sweep over one factor with two or more values")
        if condition.results.factors != base.results.factors or condition.values != base.values:
            raise ResultsError(f"{condition.name}: factor or values differ from those of {base.name}")
        if not condition.slopes():
            raise ResultsError(f"{condition.name}: no pair of games is complete at all values; play the missing games")


def _markdown(rows):
    header, *body = ("| " + " | ".join(row) + " |" for row in rows)
    return "\n".join([header, "|---" * 2 + "|--:" * (len(rows[0]) - 2) + "|", *body]) + "\n"


def _identity(condition):
    return [condition.name, f"`{condition.settings}`" if condition.settings else ""]


def effects_table(conditions):
    """A row per condition: a minus b at each value, and the slope."""
    values = conditions[0].values
    factor = conditions[0].results.factors[0]
    rows = [["condition", "changes"] + [f"a minus b at {number_text(value)} [95 %]" for value in values]]
    rows[0].append(f"goals per {PER} of `{factor}` [95 %]")
    for condition in conditions:
        differences = [text_of(list(condition.results.differences[(value,)].values())) for value in values]
        rows.append(_identity(condition) + differences + [text_of(list(condition.slopes().values()))])
    return _markdown(rows)


def _slope_p_values(conditions):
    """The p values of "the slope is the base's", corrected over all conditions but the base; None without interval."""
    base = conditions[0].slopes()
    p_values = [p_of_zero_mean(changes(base, condition.slopes())) for condition in conditions[1:]]
    corrected = iter(holm([p for p in p_values if p is not None]))
    return [None if p is None else next(corrected) for p in p_values]


def _p_text(p):
    if p is None:
        return ""
    return "<0.001" if p < 0.001 else f"{p:.3f}"


def comparison_table(conditions):
    """A row per condition but the base: what it changes at equal teams, with the handicap, and of the slope."""
    base, *others = conditions
    values = [value for value in COMPARED if value in base.values]
    rows = [["condition", "changes"]]
    for value in values:
        at = f"at {number_text(value)} [95 %]"
        rows[0] += [f"goals of both {at}", f"a minus b {at}"]
    rows[0] += ["slope [95 %]", "p of the slope"]
    for condition, p in zip(others, _slope_p_values(conditions)):
        cells = []
        for value in values:
            for of_base, own in (
                (base.results.goals, condition.results.goals),
                (base.results.differences, condition.results.differences),
            ):
                cells.append(text_of(changes(of_base[(value,)], own[(value,)])))
        cells.append(text_of(changes(base.slopes(), condition.slopes())))
        rows.append(_identity(condition) + cells + [_p_text(p)])
    return _markdown(rows)


def verdict(conditions):
    """In how many conditions the gap grows with the handicap, and in how many it grows otherwise than in the base."""
    intervals = [interval_of_mean(list(condition.slopes().values())) for condition in conditions]
    grows = sum(bounds is not None and bounds[0] > 0 for bounds in intervals)
    differs = sum(p is not None and p <= 1 - LEVEL for p in _slope_p_values(conditions))
    return (
        f"The gap grows with the handicap, beyond the 95 % interval, in {grows} of {len(conditions)} conditions. "
        f"Its slope differs from the base's in {differs} of {len(conditions) - 1} "
        f"(p at most {1 - LEVEL:.2f} with Holm's correction).\n"
    )


def report(conditions):
    """Both tables and the verdict, as Markdown."""
    check(conditions)
    goals = ", ".join(
        f"{mean(conditions[0].results.goals[(value,)].values()):.2f} at {number_text(value)}"
        for value in conditions[0].values
    )
    return (
        f"{verdict(conditions)}\n{effects_table(conditions)}\n"
        f"Changes from the base, in which both teams together score per game: {goals}.\n\n"
        f"{comparison_table(conditions)}"
    )
