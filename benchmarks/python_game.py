#!/usr/bin/env python3
"""Speed of games in Python, as ratios in one run: a call of Game.step for each frame against the loop in
C++, and two worker processes against one.

    PYTHONPATH=build/release/python python3 benchmarks/python_game.py
"""
import statistics
import time

import autoref
import numpy as np

SETTINGS = {"b.strategy": "basic", "match.half_s": 120}
FRAMES = 20000
ROUNDS = 7


def per_frame_us(is_stepped: bool) -> float:
    game = autoref.Game("a").reset(7, {**SETTINGS, "match.half_s": 3000})
    commands = np.zeros((6, 6))
    commands[:, 0] = 0.2
    game.step(commands)
    began = time.perf_counter()
    if is_stepped:
        for _ in range(FRAMES):
            game.step(commands)
    else:
        game.run(FRAMES)
    return (time.perf_counter() - began) / FRAMES * 1e6


def steps_per_s(workers: int) -> float:
    options = {"settings": SETTINGS, "frames_per_step": 10}
    actions = np.zeros((16, 6, 6))
    with autoref.VectorEnv(16, workers, **options) as envs:
        envs.reset(seed=1)
        envs.step(actions)
        began = time.perf_counter()
        for _ in range(100):
            envs.step(actions)
        return 100 * 16 / (time.perf_counter() - began)


def main() -> None:
    loops, steps, alone, together = [], [], [], []
    for _ in range(ROUNDS):
        loops.append(per_frame_us(False))
        steps.append(per_frame_us(True))
        alone.append(steps_per_s(1))
        together.append(steps_per_s(2))
    ratio = statistics.median(step / loop for step, loop in zip(steps, loops))
    print(f"loop in C++       {statistics.median(loops):8.2f} us per frame")
    print(f"Game.step         {statistics.median(steps):8.2f} us per frame")
    print(f"ratio             {ratio:8.3f}   (median of {ROUNDS} rounds)")
    speedup = statistics.median(two / one for two, one in zip(together, alone))
    print(f"one worker        {statistics.median(alone):8.0f} environment steps of ten frames per second")
    print(f"two workers       {statistics.median(together):8.0f}")
    print(f"ratio             {speedup:8.3f}   (median of {ROUNDS} rounds)")


if __name__ == "__main__":
    main()
