"""Games as environments for reinforcement learning, with the interfaces of Gymnasium and PettingZoo.

You need neither of them; if they are installed, the classes derive from their base classes. An observation is an
array of float64 in the team's own coordinates, with its own goal at -x:

    ball (5)            x, y, vx, vy, height
    own (robots * 7)    x, y, heading_x, heading_y, vx, vy, angular velocity; 0 for robots off the field
    opponents           the same for the opponents
    play (9)            1 for the current state of play, in the order of PLAYS
    ours, score         1 if the team takes the restart; its goals minus the opponents' goals

An action is an array (robots, 6): forward and left velocity, angular velocity, kick speed, chip,
dribble, within ACTION_LOW and ACTION_HIGH. The reward is 1 for a goal and -1 for a goal conceded.
"""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .game import Game
from .interfaces import Env, ParallelBase
from .spaces import box

PLAYS = (
    "HALT",
    "STOP",
    "PREPARE_KICKOFF",
    "PREPARE_PENALTY",
    "KICKOFF",
    "PENALTY",
    "DIRECT_FREE",
    "INDIRECT_FREE",
    "RUNNING",
)
ACTION_LOW = np.array([-3.0, -3.0, -10.0, 0.0, 0.0, 0.0])
ACTION_HIGH = np.array([3.0, 3.0, 10.0, 6.5, 1.0, 1.0])
_ROBOT = 7


def observation_size(robots: int) -> int:
    """Length of an observation with this many robots in each team."""
    return 5 + 2 * robots * _ROBOT + len(PLAYS) + 2


def observe(view: Any, robots: int, out: np.ndarray) -> np.ndarray:
    """Fills `out`, which has observation_size() numbers, with a team's view."""
    out[:] = 0
    out[:5] = view.ball
    for first, rows in ((5, view.own), (5 + robots * _ROBOT, view.opponents)):
        table = out[first : first + robots * _ROBOT].reshape(robots, _ROBOT)
        numbers = rows[:, 0].astype(int)
        on = numbers < robots
        table[numbers[on]] = rows[on, 1:]
    play = 5 + 2 * robots * _ROBOT
    out[play + PLAYS.index(view.play)] = 1
    out[-2:] = view.ours, view.goals_own - view.goals_opponent
    return out


class _Episodes:
    """A game that is reset for each episode, and the current lead."""

    def __init__(
        self, external: str, settings: Mapping[str, Any] | None, robots: int, frames_per_step: int, most_s: float | None
    ) -> None:
        self.game = Game(external)
        self.robots = robots
        self.frames_per_step = frames_per_step
        self.most_s = most_s
        self._settings = {"a.robots": robots, "b.robots": robots, **(settings or {})}
        self._lead = 0

    def begin(self, seed: int | None, random: np.random.Generator) -> None:
        """Begins an episode with this seed, or with one drawn from `random`."""
        self.game.reset(int(random.integers(2**63)) if seed is None else seed, self._settings)
        self._lead = 0

    def step(self, **commands: Any) -> tuple[float, bool, bool]:
        """Returns team a's reward, whether the game has ended, and whether the time is up."""
        for _ in range(self.frames_per_step):
            if not self.game.step(**commands):
                break
        view = self.view(self.game.external[0])
        lead = view.goals_own - view.goals_opponent
        if self.game.external[0] == "b":
            lead = -lead
        reward, self._lead = float(lead - self._lead), lead
        late = self.most_s is not None and view.time_s >= self.most_s
        return reward, self.game.is_over, late and not self.game.is_over

    def view(self, team: str) -> Any:
        """An external team's view of the game."""
        return self.game.a if team == "a" else self.game.b


class GymnasiumEnv(Env):
    """One team's game as an environment of Gymnasium: you command all robots of team a.

    reset(seed=n) begins the game with that seed and restarts the random stream that chooses the games
    of later episodes; an environment that was never given a seed plays different games every time.
    `settings` are those of autoref.Game, each step lasts `frames_per_step` camera frames, and an episode is
    truncated after `most_s` seconds of game time.
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None
    spec = None

    def __init__(
        self,
        settings: Mapping[str, Any] | None = None,
        robots: int = 6,
        frames_per_step: int = 1,
        most_s: float | None = None,
    ) -> None:
        self._episodes = _Episodes("a", settings, robots, frames_per_step, most_s)
        size = observation_size(robots)
        self.observation_space = box(-np.inf, np.inf, (size,))
        self.action_space = box(np.tile(ACTION_LOW, (robots, 1)), np.tile(ACTION_HIGH, (robots, 1)))
        self._observation = np.zeros(size)

    @property
    def game(self) -> Game:
        """The game, for anything that the interface does not offer."""
        return self._episodes.game

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode."""
        super().reset(seed=seed)
        self._episodes.begin(seed, self.np_random)
        return self._observe(), {}

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Returns observation, reward, terminated, truncated and info."""
        reward, over, late = self._episodes.step(a=action)
        info = self.game.record if over or late else {}
        return self._observe(), reward, over, late, info

    def close(self) -> None:
        """Does nothing: there is nothing to close."""

    def _observe(self) -> np.ndarray:
        view = self._episodes.view("a")
        return observe(view, self._episodes.robots, self._observation).copy()


class ParallelEnv(ParallelBase):
    """A game of two teams as a parallel environment of PettingZoo. The agents are "a" and "b", or one
    of them; each commands all robots of its team. Seeds work as in GymnasiumEnv."""

    metadata: dict[str, Any] = {"render_modes": [], "name": "autoref"}

    def __init__(
        self,
        settings: Mapping[str, Any] | None = None,
        teams: str = "ab",
        robots: int = 6,
        frames_per_step: int = 1,
        most_s: float | None = None,
    ) -> None:
        self._episodes = _Episodes(teams, settings, robots, frames_per_step, most_s)
        self.possible_agents = list(teams)
        self.agents: list[str] = []
        self._spaces = GymnasiumEnv(settings, robots)
        self._random = np.random.default_rng()

    @property
    def game(self) -> Game:
        """The game, for anything that the interface does not offer."""
        return self._episodes.game

    def observation_space(self, agent: str) -> Any:
        """An agent's observation space."""
        return self._spaces.observation_space

    def action_space(self, agent: str) -> Any:
        """An agent's action space."""
        return self._spaces.action_space

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], dict[str, dict[str, Any]]]:
        """Begins an episode."""
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self._episodes.begin(seed, self._random)
        self.agents = list(self.possible_agents)
        return self._observe(), {agent: {} for agent in self.agents}

    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[dict[str, np.ndarray], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Returns observations, rewards, terminations, truncations and infos, each by agent."""
        reward, over, late = self._episodes.step(**actions)
        agents = self.agents
        result = (
            self._observe(),
            {agent: reward if agent == "a" else -reward for agent in agents},
            dict.fromkeys(agents, over),
            dict.fromkeys(agents, late),
            {agent: self.game.record if over or late else {} for agent in agents},
        )
        if over or late:
            self.agents = []
        return result

    def close(self) -> None:
        """Does nothing: there is nothing to close."""

    def _observe(self) -> dict[str, np.ndarray]:
        robots = self._episodes.robots
        size = observation_size(robots)
        return {team: observe(self._episodes.view(team), robots, np.empty(size)) for team in self.agents}


def gymnasium_env(**options: Any) -> GymnasiumEnv:
    """An environment with the interface of Gymnasium; GymnasiumEnv describes the options."""
    return GymnasiumEnv(**options)


def parallel_env(**options: Any) -> ParallelEnv:
    """An environment with the parallel interface of PettingZoo; ParallelEnv describes the options."""
    return ParallelEnv(**options)
