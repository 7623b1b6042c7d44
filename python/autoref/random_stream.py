"""The team's random numbers: the same as in other languages with the same seed."""
from __future__ import annotations

import random
from typing import Any

_MASK = 2**64 - 1
_STEP = 0x9E3779B97F4A7C15


def _mix(x: int) -> int:
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9 & _MASK
    x = (x ^ (x >> 27)) * 0x94D049BB133111EB & _MASK
    return x ^ (x >> 31)


class RandomStream(random.Random):
    """The stream that docs/team-programs.md describes, with all methods of random.Random.

    next_bits() and random() give the same numbers in every language. The other methods, such as
    choice(), are built on them by Python.
    """

    def __init__(self, seed: int = 0) -> None:
        super().__init__(seed)

    def seed(self, a: object = 0, version: int = 2) -> None:
        """Restarts the stream with a seed, which must be a whole number."""
        if not isinstance(a, int):
            raise TypeError("the seed of a RandomStream is a whole number")
        self._key = _mix((a + _STEP) & _MASK)
        self._counter = 0
        self.gauss_next = None

    def next_bits(self) -> int:
        """The next number of the stream, 0 to 2^64 - 1."""
        self._counter += 1
        return _mix((self._key + self._counter * _STEP) & _MASK)

    def random(self) -> float:
        """The next random number, uniform in [0, 1)."""
        number = 1.0
        while number >= 1.0:
            number = self.next_bits() * 2.0**-64
        return number

    def getrandbits(self, k: int, /) -> int:
        """A number of k bits."""
        if k < 0:
            raise ValueError("the number of bits is negative")
        bits = 0
        for _ in range((k + 63) // 64):
            bits = bits << 64 | self.next_bits()
        return bits >> (-k % 64)

    def getstate(self) -> tuple[Any, ...]:
        """Returns the state for setstate()."""
        return self._key, self._counter, self.gauss_next

    def setstate(self, state: tuple[Any, ...]) -> None:
        """Continues from the point where getstate() was called."""
        self._key, self._counter, self.gauss_next = state
