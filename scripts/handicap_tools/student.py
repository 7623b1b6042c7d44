"""Student's t distribution with a whole number of degrees of freedom, and what is made from it. Standard library only.

Formulas: M. Abramowitz and I. Stegun, Handbook of Mathematical Functions, 1964, 26.7.3 and 26.7.4.
"""

from math import atan, cos, pi, sin, sqrt
from statistics import mean, stdev

LEVEL = 0.95
_LARGEST_T = 1e6
_BISECTIONS = 100


def probability_within(t, freedom):
    """The probability that a value of this distribution lies between -t and t, for t >= 0."""
    angle = atan(t / sqrt(freedom))
    is_odd = freedom % 2 == 1
    power = cos(angle) if is_odd else 1.0
    total = 0.0
    for i in range(1 if is_odd else 0, freedom - 1, 2):
        total += power
        power *= cos(angle) ** 2 * (i + 1) / (i + 2)
    if is_odd:
        return 2 / pi * (angle + sin(angle) * total)
    return sin(angle) * total


def quantile_within(level, freedom):
    """The t with this probability between -t and t."""
    low, high = 0.0, _LARGEST_T
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if probability_within(middle, freedom) < level else (low, middle)
    return (low + high) / 2


def interval_of_mean(sample):
    """The 95 % confidence interval of the mean as (low, high); None for one value, or if all values are equal."""
    if len(sample) < 2 or len(set(sample)) == 1:
        return None
    half = quantile_within(LEVEL, len(sample) - 1) * stdev(sample) / sqrt(len(sample))
    return mean(sample) - half, mean(sample) + half


def p_of_zero_mean(sample):
    """The two-sided p value of the t test of "the mean is 0"; None without an interval."""
    if interval_of_mean(sample) is None:
        return None
    t = mean(sample) / (stdev(sample) / sqrt(len(sample)))
    return 1 - probability_within(abs(t), len(sample) - 1)


def p_of_no_harm(sample):
    """The one-sided p value of the t test of "the mean is not below 0"; None without an interval."""
    two_sided = p_of_zero_mean(sample)
    if two_sided is None:
        return None
    return two_sided / 2 if mean(sample) < 0 else 1 - two_sided / 2


def holm(p_values):
    """The p values with Holm's correction, in the same order."""
    order = sorted(range(len(p_values)), key=p_values.__getitem__)
    corrected, largest = [0.0] * len(p_values), 0.0
    for rank, index in enumerate(order):
        largest = max(largest, min(1.0, (len(p_values) - rank) * p_values[index]))
        corrected[index] = largest
    return corrected


def text_of(sample):
    """The mean with its interval: "+1.20 [+0.30, +2.10]"; without values an empty text."""
    if not sample:
        return ""
    bounds = interval_of_mean(sample)
    unknown = "(too few games)" if len(sample) < 2 else "(all pairs equal)"
    return f"{mean(sample):+.2f} " + (f"[{bounds[0]:+.2f}, {bounds[1]:+.2f}]" if bounds else unknown)
