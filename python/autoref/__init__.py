"""Teams, games and results of AutoRef, the simulator of RoboCup Small Size League games."""
from importlib import import_module

from .game import Game
from .messages import Abilities, Ball, Command, End, Field, Next, Output, Play, Robot, Start, View
from .play import AutorefError, GameResult, Run, play, program, run
from .random_stream import RandomStream
from .results import LogMessage, events, log, results, rows
from .team import Team

__all__ = [
    "Abilities",
    "AutorefError",
    "Ball",
    "Command",
    "End",
    "Field",
    "Game",
    "GameResult",
    "LogMessage",
    "Next",
    "Output",
    "Play",
    "RandomStream",
    "Robot",
    "Run",
    "Start",
    "Team",
    "View",
    "events",
    "log",
    "play",
    "program",
    "results",
    "rows",
    "run",
]

_WITH_NUMPY = {
    "GymnasiumEnv": "environments",
    "ParallelEnv": "environments",
    "gymnasium_env": "environments",
    "parallel_env": "environments",
    "VectorEnv": "vector",
}


def __getattr__(name: str) -> object:
    """Imports the modules that need numpy only when they are used."""
    if name in _WITH_NUMPY:
        return getattr(import_module("." + _WITH_NUMPY[name], __name__), name)
    raise AttributeError(f"module 'autoref' has no attribute {name!r}")
