"""Teams, games and results of AutoRef, the simulator of RoboCup Small Size League games."""
from .game import Game
from .messages import Abilities, Ball, Command, End, Field, Next, Output, Play, Robot, Start, View
from .play import AutorefError, GameResult, Run, play, program, run
from .random_stream import RandomStream
from .results import LogMessage, events, log, results, rows
from .team import Team

__all__ = ["Abilities", "AutorefError", "Ball", "Command", "End", "Field", "Game", "GameResult",
           "LogMessage", "Next", "Output", "Play", "RandomStream", "Robot", "Run", "Start", "Team",
           "View", "events", "log", "play", "program", "results", "rows", "run"]
