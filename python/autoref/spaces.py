"""Boxes of numbers: Gymnasium's Box if it is installed, otherwise a small stand-in with the same members."""
from __future__ import annotations

from typing import Any

import numpy as np


class PlainBox:
    """Arrays between `low` and `high`, like gymnasium.spaces.Box."""

    def __init__(self, low: Any, high: Any, shape: tuple[int, ...] | None = None, dtype: Any = np.float64) -> None:
        self.shape = np.shape(low) if shape is None else shape
        self.dtype = np.dtype(dtype)
        self.low = np.broadcast_to(np.asarray(low, dtype), self.shape)
        self.high = np.broadcast_to(np.asarray(high, dtype), self.shape)
        self._random = np.random.default_rng()

    def seed(self, seed: int | None = None) -> None:
        """Begins a new stream of samples."""
        self._random = np.random.default_rng(seed)

    def sample(self) -> np.ndarray:
        """A random array; unbounded numbers are drawn from a normal distribution."""
        bounded = np.isfinite(self.low) & np.isfinite(self.high)
        low, high = np.where(bounded, self.low, 0), np.where(bounded, self.high, 1)
        normal = self._random.standard_normal(self.shape)
        return np.where(bounded, self._random.uniform(low, high), normal).astype(self.dtype)

    def contains(self, x: Any) -> bool:
        """Whether x is an array of this space."""
        x = np.asarray(x)
        return x.shape == self.shape and bool(np.all(x >= self.low) and np.all(x <= self.high))

    __contains__ = contains

    def __repr__(self) -> str:
        return f"PlainBox(shape={self.shape}, dtype={self.dtype})"


def box(low: Any, high: Any, shape: tuple[int, ...] | None = None) -> Any:
    """Returns a gymnasium.spaces.Box if Gymnasium is installed, otherwise a PlainBox."""
    try:
        from gymnasium.spaces import Box  # type: ignore[import-not-found]
    except ImportError:
        return PlainBox(low, high, shape)
    if shape is None:
        shape = np.shape(low)
    return Box(
        np.broadcast_to(np.asarray(low, np.float64), shape),
        np.broadcast_to(np.asarray(high, np.float64), shape),
        dtype=np.float64,
    )
