"""Games that run in this process, including the referee, and that you advance step by step."""
from __future__ import annotations

import json
from types import ModuleType
from typing import Any, Mapping, Sequence

from .play import AutorefError


def _core() -> ModuleType:
    try:
        from . import _core as core  # type: ignore[attr-defined]
    except ImportError as error:
        raise AutorefError(
            "the compiled half of the package is not here; build AutoRef with "
            f"pybind11 (scripts/setup --tests installs it): {error}"
        ) from error
    return core


class Game:
    """One simulated, refereed game, stepped frame by frame.

    `external` names the teams for which you decide: "a", "b" or "ab". The settings choose a
    built-in team or a program for the others. Games in one process do not affect one another; step
    them from one thread at a time.
    """

    def __init__(self, external: str = "a") -> None:
        self._game = _core().Game(external)
        self.external = external

    def reset(self, seed: int = 42, settings: Mapping[str, Any] | None = None) -> "Game":
        """Begins a game. The settings are keys of scenarios, written as paths, such as {"match.half_s": 60,
        "b.strategy": "basic"}. Raises ValueError with the setting's name if one is wrong."""
        self._game.reset(seed, dict(settings or {}))
        return self

    def step(self, a: Any = None, b: Any = None) -> bool:
        """Plays one frame with these commands. Returns whether the game goes on.

        The commands of an external team are an array (robots, 6): forward and left velocity in
        m/s, angular velocity in rad/s, kick speed in m/s (0: no kick), chip and dribble (above 0.5:
        yes). A row's index is the robot's number. Robots without a row, and all robots of a team
        without an array, stand still.
        """
        return bool(self._game.step(a, b))

    def run(self, most_frames: int = 1 << 40) -> int:
        """Continues with the last commands, without a call for each frame. Returns the number of frames
        played."""
        return int(self._game.run(most_frames))

    def place(
        self, ball: Sequence[float] | None = None, robots: Mapping[tuple[str, int], Sequence[float]] | None = None
    ) -> None:
        """Puts the ball at (x, y) or (x, y, vx, vy), and robots, given as ("a", number), at (x, y) or
        (x, y, heading_x, heading_y), at rest. The coordinates are those of the field: the west goal is
        at -x. The teams see the change in the next frame."""
        if ball is not None:
            x, y, vx, vy = [*ball, 0.0, 0.0][:4]
            self._game.place_ball(x, y, vx, vy)
        for (team, number), where in (robots or {}).items():
            at = [*where, 1.0, 0.0][:4] if len(where) == 2 else list(where)
            self._game.place_robot(team, number, at)

    @property
    def a(self) -> Any:
        """Team a's view, in its own coordinates (its goal at -x), if it is external. `own` and
        `opponents` are arrays (robots, 8): number, x, y, heading_x, heading_y, vx, vy, angular
        velocity. `ball` is an array (5): x, y, vx, vy, height. They are valid until the next step.
        The other members are frame, time_s, latency_s, play, ours, goals_own, goals_opponent and
        stage_time_left_s."""
        return self._game.view("a")

    @property
    def b(self) -> Any:
        """Team b's view, with the same members as that of team a."""
        return self._game.view("b")

    @property
    def decisions(self) -> list[dict[str, Any]]:
        """The referee's decisions since the last step, with the keys of `autoref play --events`."""
        return [json.loads(line) for line in self._game.decisions()]

    @property
    def record(self) -> dict[str, Any]:
        """The game's record so far: goals_a, goals_b, status, end_reason, void_reason, frames, sim_s,
        state_hash."""
        return dict(self._game.record())

    @property
    def is_over(self) -> bool:
        """Whether the game has ended."""
        return bool(self._game.is_over)

    @property
    def frame_rate_hz(self) -> float:
        """Camera frames per second."""
        return float(self._game.frame_rate_hz)

    @property
    def field_m(self) -> tuple[float, float]:
        """Length and width of the field."""
        length_m, width_m = self._game.field_m
        return length_m, width_m

    @property
    def goal_width_m(self) -> float:
        """Distance between the posts."""
        return float(self._game.goal_width_m)
