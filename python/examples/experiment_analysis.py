#!/usr/bin/env python3
"""An experiment in cells: does a slower team win less often? Takes about ten seconds.

    python3 python/examples/experiment_analysis.py [FOLDER]
"""
# %% The experiment: 2 values with 10 pairs of games each; the second leg of a pair swaps the sides.
import sys
import tempfile
from collections import defaultdict
from math import sqrt
from pathlib import Path
from statistics import NormalDist

import autoref

PAIRS = 10
FACTOR = "b.handicap"
EXPERIMENT = {
    "schema": 1,
    "kind": "sweep",
    "seed": 2014,
    "pairs": PAIRS,
    "base": {
        "teams": {"a": {"strategy": "cobalt"}, "b": {"strategy": "cobalt"}},
        "match": {"rules": "paper", "half_s": 120},
    },
    "factors": {FACTOR: [1.0, 0.5]},
}

# %% Play it. The same command continues after an interruption.
folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(tempfile.mkdtemp(prefix="autoref-"))
run = autoref.run(EXPERIMENT, folder)
games = autoref.rows(run.folder)  # run.results() returns them as a numpy array
print(f"{len(games)} games in {folder}")


# %% Points of team a: 1 for a win, 1/2 for a draw. The legs of a pair are not independent, so the
# mean of a pair counts as one observation.
def points(game: dict) -> float:
    return 0.5 if game["goal_diff"] == 0 else float(game["goal_diff"] > 0)


def share_interval(share: float, count: int, level: float = 0.95) -> tuple[float, float]:
    """Wilson's score interval. For values between 0 and 1 it is at least as wide as needed."""
    z = NormalDist().inv_cdf((1 + level) / 2)
    centre = (share + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * sqrt(share * (1 - share) / count + (z / (2 * count)) ** 2)
    return centre - half, centre + half


pairs = defaultdict(list)
for game in games:
    if game["status"] == "ok":
        pairs[game[FACTOR], game["pair"]].append(points(game))

shares = {}
for value in EXPERIMENT["factors"][FACTOR]:
    means = [sum(legs) / len(legs) for (at, _), legs in pairs.items() if at == value]
    share = sum(means) / len(means)
    shares[value] = (share, *share_interval(share, len(means)))

# %% The table.
print(f"{FACTOR}  share of points of a [95 %]")
for value, (share, low, high) in shares.items():
    print(f"{value:10}  {share:.2f} [{low:.2f}, {high:.2f}]")

# %% A drawing, if matplotlib is installed.
try:
    from matplotlib import pyplot
except ImportError:
    print("no drawing: Debian's python3-matplotlib is missing")
else:
    errors = [[share - low for share, low, _ in shares.values()], [high - share for share, _, high in shares.values()]]
    pyplot.errorbar(list(shares), [share for share, _, _ in shares.values()], errors, fmt="o")
    pyplot.xlabel(FACTOR)
    pyplot.ylabel("share of points of team a")
    pyplot.savefig(folder / "shares.svg")
