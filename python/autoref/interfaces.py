"""The base classes of environments: those of Gymnasium and PettingZoo if they are installed, otherwise
stand-ins with the members that users of environments expect."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np


class PlainEnv:
    """Like gymnasium.Env."""

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode: str | None = None
    spec: Any = None
    _random: np.random.Generator | None = None

    def reset(self, *, seed: int | None = None, options: Mapping[str, Any] | None = None) -> Any:
        """Begins a new stream of random numbers if a seed is given."""
        if seed is not None:
            self._random = np.random.default_rng(seed)

    @property
    def np_random(self) -> np.random.Generator:
        """The environment's random numbers, seeded from the system's entropy if reset() was never given a seed."""
        if self._random is None:
            self._random = np.random.default_rng()
        return self._random

    @property
    def unwrapped(self) -> Any:
        """This environment."""
        return self

    def render(self) -> None:
        """Does nothing: there is no display."""

    def close(self) -> None:
        """Does nothing: there is nothing to close."""

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


class PlainParallelEnv:
    """Like pettingzoo.ParallelEnv."""

    metadata: dict[str, Any] = {"render_modes": []}
    agents: list[str]
    possible_agents: list[str]

    @property
    def num_agents(self) -> int:
        """Number of agents that are playing."""
        return len(self.agents)

    @property
    def max_num_agents(self) -> int:
        """Number of all agents."""
        return len(self.possible_agents)

    @property
    def unwrapped(self) -> Any:
        """This environment."""
        return self

    def render(self) -> None:
        """Does nothing: there is no display."""

    def close(self) -> None:
        """Does nothing: there is nothing to close."""


try:
    from gymnasium import Env  # type: ignore[import-not-found]
except ImportError:
    Env = PlainEnv

try:
    from pettingzoo import ParallelEnv as ParallelBase  # type: ignore[import-not-found]
except ImportError:
    ParallelBase = PlainParallelEnv
