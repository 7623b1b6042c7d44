#!/usr/bin/env python3
"""A keeper that learns to save shots by the cross-entropy method, with numpy only.

    python3 python/examples/keeper_learning.py

The keeper is a linear policy: its sideways velocity is a weighted sum of its observations. Each generation
draws keepers from a normal distribution, tries them on the same shots, and fits the distribution to
the best of them. Test shots, with other seeds, then show how much the keeper has improved.
"""
# %% The exercise: shots from two to three metres at a random point in the goal.
import argparse
from concurrent.futures import ProcessPoolExecutor
from math import sqrt

import autoref
import numpy as np

FEATURES = 5  # offset of the ball and of the keeper, the ball's velocity, and where it will cross
KEEPER_OFF_LINE_M = 0.12
SPEED_MPS = 2.5
MOST_FRAMES = 120


class Exercise:
    """One game, in which the ball and the keeper are put back for every shot."""

    def __init__(self) -> None:
        self.game = autoref.Game("a")
        self.reset()

    def reset(self) -> None:
        """Plays until the referee lets play run."""
        self.game.reset(
            1, {"a.robots": 1, "b.robots": 1, "b.strategy": "dummy", "match.half_s": 3000, "sim.camera": "realistic"}
        )
        self.wait_for_play()
        self.goal_x_m = -self.game.field_m[0] / 2

    def wait_for_play(self) -> None:
        """Waits until the ball is in play. If neither team takes a restart, a free ball follows after ten seconds."""
        while self.game.a.play != "RUNNING":
            if not self.game.step():
                self.reset()

    def is_saved(self, weights: np.ndarray, random: np.random.Generator) -> bool:
        """Whether a keeper with these weights saves one shot."""
        self.wait_for_play()
        keeper_x_m = self.goal_x_m + KEEPER_OFF_LINE_M
        from_m = np.array([self.goal_x_m + random.uniform(2.0, 3.0), random.uniform(-1.2, 1.2)])
        to_m = np.array([self.goal_x_m, random.uniform(-0.48, 0.48) * self.game.goal_width_m])
        velocity = (to_m - from_m) / np.linalg.norm(to_m - from_m) * random.uniform(3.0, 5.0)
        self.game.place(ball=(*from_m, *velocity), robots={("a", 0): (keeper_x_m, 0.0)})
        commands = np.zeros((1, 6))
        for frame in range(MOST_FRAMES):
            if not self.game.step(commands):
                self.reset()
                return False
            if frame < 4:  # the keeper still sees the previous state
                continue
            ball, keeper = self.game.a.ball, self.game.a.own[0]
            if ball[0] < self.goal_x_m + 0.02:
                return self.clear_away(False)
            if ball[2] > -0.3:
                return self.clear_away(True)
            commands[0, :3] = command(weights, ball, keeper, keeper_x_m)
        return self.clear_away(True)

    def clear_away(self, is_saved: bool) -> bool:
        """Puts the ball aside before the referee calls a goal."""
        self.game.place(ball=(0.0, 0.0))
        return is_saved


def command(weights: np.ndarray, ball: np.ndarray, keeper: np.ndarray, keeper_x_m: float) -> np.ndarray:
    """Forward, left and angular velocity: the keeper faces the field and stays on its line."""
    time_s = min((ball[0] - keeper[1]) / max(-ball[2], 0.1), 1.0)
    seen = np.array([ball[1], keeper[2], ball[3], ball[1] + time_s * ball[3], 0.1])
    left = np.clip(weights @ seen, -SPEED_MPS, SPEED_MPS)
    return np.array([3 * (keeper_x_m - keeper[1]), left, -5 * keeper[4]])


# %% Many shots, in several processes.
_exercise: Exercise | None = None


def saves(job: tuple[np.ndarray, int, int]) -> int:
    """Number of saves in `shots` shots that the seed chooses."""
    global _exercise
    if _exercise is None:
        _exercise = Exercise()
    weights, seed, shots = job
    random = np.random.default_rng(seed)
    return sum(_exercise.is_saved(weights, random) for _ in range(shots))


def interval(count: int, of: int) -> tuple[float, float]:
    """Wilson's 95 % confidence interval for a share."""
    share, z = count / of, 1.96
    centre = (share + z * z / (2 * of)) / (1 + z * z / of)
    half = z / (1 + z * z / of) * sqrt(share * (1 - share) / of + z * z / (4 * of * of))
    return centre - half, centre + half


def tested(pool: ProcessPoolExecutor, weights: np.ndarray, shots: int) -> int:
    """Number of saves in test shots, which have seeds above 10^6 and are not used for learning."""
    jobs = [(weights, 10**6 + i, 50) for i in range(shots // 50)]
    return sum(pool.map(saves, jobs))


# %% The cross-entropy method.
def learn(pool: ProcessPoolExecutor, generations: int, keepers: int, shots: int) -> np.ndarray:
    """The mean of the last generation's distribution."""
    random = np.random.default_rng(2014)
    mean, deviation = np.zeros(FEATURES), np.full(FEATURES, 3.0)
    for generation in range(generations):
        tried = mean + deviation * random.standard_normal((keepers, FEATURES))
        saved = np.array(list(pool.map(saves, [(one, generation, shots) for one in tried])))
        best = tried[np.argsort(-saved, kind="stable")[: keepers // 5]]
        mean, deviation = best.mean(axis=0), best.std(axis=0) + 0.5 * 0.8**generation
        print(
            f"generation {generation + 1:2}: the best saved {saved.max()} of {shots}, "
            f"all together {saved.mean():.1f}",
            flush=True,
        )
    return mean


def main() -> int:
    """Learns, then compares the result with a keeper that stands still."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--generations", type=int, default=12)
    parser.add_argument("--keepers", type=int, default=40)
    parser.add_argument("--shots", type=int, default=40)
    parser.add_argument("--tests", type=int, default=1000)
    options = parser.parse_args()
    with ProcessPoolExecutor(max_workers=2) as pool:
        before = tested(pool, np.zeros(FEATURES), options.tests)
        weights = learn(pool, options.generations, options.keepers, options.shots)
        after = tested(pool, weights, options.tests)
    for name, count in (("standing still", before), ("learnt", after)):
        low, high = interval(count, options.tests)
        print(
            f"{name:>14}: saves {count} of {options.tests} "
            f"({100 * count / options.tests:.1f} %, 95 % interval {100 * low:.1f} to {100 * high:.1f})"
        )
    print("weights:", np.round(weights, 2))
    return 0 if interval(after, options.tests)[0] > interval(before, options.tests)[1] else 1


if __name__ == "__main__":
    raise SystemExit(main())
