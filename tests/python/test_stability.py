"""The package still has the names that 1.0 promised (docs/stability.md). Names may be added, but not removed.

    PYTHONPATH=python python3 tests/python/test_stability.py --write     # writes the list anew
"""
import sys
import unittest
from pathlib import Path

import autoref

_LIST = Path(__file__).resolve().parents[1] / "stability" / "python.txt"


def _names():
    """Names of the package, and those of its classes' members."""
    for name in sorted(autoref.__all__):
        yield name
        value = getattr(autoref, name)
        if isinstance(value, type):
            members = {*vars(value), *getattr(value, "__annotations__", {})}
            yield from (f"{name}.{member}" for member in sorted(members) if member[0] != "_")


class Names(unittest.TestCase):
    """Of the package, compared with the list."""

    def test_of_the_list_are_there(self):
        promised = [line for line in _LIST.read_text("utf-8").splitlines() if line[0] != "#"]
        self.assertGreater(len(promised), 0)
        self.assertEqual(sorted(set(promised) - set(_names())), [], "promised by 1.x, but gone")


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        _LIST.write_text("# Kept by every 1.x: see docs/stability.md.\n" + "\n".join(_names()) + "\n", "utf-8")
    else:
        unittest.main()
