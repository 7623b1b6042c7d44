"""Means and ratios over games, with their 95 % confidence intervals."""

from dataclasses import dataclass
from math import sqrt

from student import LEVEL, quantile_within


@dataclass
class Estimate:
    value: float
    low: float  # bounds of the interval; both equal the value if there is no interval
    high: float


def ratio_over_games(numerators, denominators):
    """Sum of the numerators by sum of the denominators, one of each per game; None if there is nothing to divide by.

    The interval is Student's for the games' residuals (W. G. Cochran, Sampling Techniques, 1977, 2.11). With
    denominators of 1 it is the mean's.
    """
    games, total = len(numerators), sum(denominators)
    if games == 0 or total == 0:
        return None
    ratio = sum(numerators) / total
    if games == 1:
        return Estimate(ratio, ratio, ratio)
    residuals = [above - ratio * below for above, below in zip(numerators, denominators)]
    deviation = sqrt(sum(residual**2 for residual in residuals) / (games - 1))
    half = quantile_within(LEVEL, games - 1) * deviation * sqrt(games) / total
    return Estimate(ratio, ratio - half, ratio + half)
