"""Environments: the interfaces of Gymnasium and PettingZoo, and many environments at once."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import autoref
from autoref import interfaces
from autoref.environments import PLAYS, observation_size
from autoref.spaces import PlainBox

SETTINGS = {"b.strategy": "basic", "match.half_s": 3}


def actions(seed: int, steps: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    return random.uniform(-1, 1, (steps, 6, 6))


class GymnasiumTest(unittest.TestCase):
    def test_obeys_the_interface(self) -> None:
        env = autoref.gymnasium_env(settings=SETTINGS)
        observation, info = env.reset(seed=3)
        self.assertEqual(info, {})
        self.assertTrue(env.observation_space.contains(observation))
        self.assertEqual(observation.shape, (observation_size(6),))
        for _ in range(20):
            result = env.step(env.action_space.sample())
            self.assertEqual([type(part) for part in result], [np.ndarray, float, bool, bool, dict])
            self.assertTrue(env.observation_space.contains(result[0]))

    def test_repeats_an_episode(self) -> None:
        env = autoref.gymnasium_env(settings=SETTINGS)
        runs = []
        for _ in range(2):
            env.reset(seed=3)
            runs.append([env.step(action)[0] for action in actions(1, 100)])
        np.testing.assert_array_equal(*runs)

    def test_ends_with_the_game(self) -> None:
        env = autoref.gymnasium_env(settings=SETTINGS, frames_per_step=10)
        env.reset(seed=3)
        rewards, terminated = 0.0, False
        while not terminated:
            _, reward, terminated, truncated, info = env.step(np.zeros((6, 6)))
            rewards += reward
            self.assertFalse(truncated)
        self.assertEqual(rewards, info["goals_a"] - info["goals_b"])
        self.assertEqual(info["status"], "ok")

    def test_truncates(self) -> None:
        env = autoref.gymnasium_env(settings=SETTINGS, most_s=1)
        env.reset(seed=3)
        steps, truncated = 0, False
        while not truncated:
            truncated = env.step(np.zeros((6, 6)))[3]
            steps += 1
        self.assertLess(abs(steps - 60), 6)

    def test_shows_the_state_of_play_and_missing_robots(self) -> None:
        env = autoref.gymnasium_env(settings={**SETTINGS, "b.robots": 4})
        observation, _ = env.reset(seed=3)
        self.assertEqual(PLAYS[int(np.argmax(observation[-2 - len(PLAYS) : -2]))], "STOP")
        opponents = observation[5 + 42 : 5 + 84].reshape(6, 7)
        self.assertTrue(np.all(opponents[4:] == 0))
        self.assertTrue(np.all(np.any(opponents[:4] != 0, axis=1)))


def episode(env: autoref.GymnasiumEnv, seed: int | None = None) -> bytes:
    """What an episode shows."""
    shown = [env.reset(seed=seed)[0].tobytes()]
    while True:
        observation, _, over, late, _ = env.step(np.zeros((6, 6)))
        shown.append(observation.tobytes())
        if over or late:
            return b"".join(shown)


class SeedsTest(unittest.TestCase):
    """With the seeds 1 to 8, as Gymnasium's vectors of environments give them."""

    OPTIONS = {"settings": {**SETTINGS, "sim.camera": "realistic"}, "frames_per_step": 20, "most_s": 1}

    def env(self) -> autoref.GymnasiumEnv:
        return autoref.gymnasium_env(**self.OPTIONS)

    def test_no_environment_replays_another_ones_episodes(self) -> None:
        shown = set()
        for seed in range(1, 9):
            env = self.env()
            shown |= {episode(env, seed), *(episode(env) for _ in range(7))}
        self.assertEqual(len(shown), 64)

    def test_a_seed_repeats_the_episodes_after_it(self) -> None:
        env = self.env()
        first = [episode(env, 5), episode(env), episode(env)]
        other = self.env()
        self.assertEqual([episode(other, 5), episode(other), episode(other)], first)
        self.assertEqual([episode(env, 5), episode(env), episode(env)], first)

    def test_without_a_seed_every_environment_plays_other_games(self) -> None:
        self.assertNotEqual(episode(self.env()), episode(self.env()))
        options = {"settings": self.OPTIONS["settings"], "frames_per_step": 20}
        first = []
        for _ in range(2):
            env = autoref.parallel_env(**options)
            first.append(env.reset()[0]["a"].tobytes())
        self.assertNotEqual(*first)

    def test_the_environments_of_a_vector_play_other_games(self) -> None:
        shown = []
        for seed in (None, None, 3, 3):
            with autoref.VectorEnv(2, 2, **self.OPTIONS) as envs:
                seen = [envs.reset(seed=seed)[0].copy()]
                for _ in range(8):
                    seen.append(envs.step(np.zeros((2, 6, 6)))[0].copy())
                seen.append(envs.reset()[0].copy())
                seen.append(envs.step(np.zeros((2, 6, 6)))[0].copy())
                shown.append(np.array(seen))
        self.assertFalse(np.array_equal(shown[0], shown[1]))
        np.testing.assert_array_equal(shown[2], shown[3])
        self.assertFalse(np.array_equal(shown[2][:, 0], shown[2][:, 1]))


class BaseClassesTest(unittest.TestCase):
    """The classes derive from those of the libraries: here, from small libraries of that name."""

    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        for library, base, plain in (
            ("gymnasium", "Env", "PlainEnv"),
            ("pettingzoo", "ParallelEnv", "PlainParallelEnv"),
        ):
            (Path(self.folder.name) / library).mkdir()
            (Path(self.folder.name) / library / "__init__.py").write_text(
                f"exec(open({interfaces.__file__!r}).read().split('try:')[0])\n{base} = {plain}\n"
            )

    def tearDown(self) -> None:
        self.folder.cleanup()

    def test_are_those_of_the_installed_libraries(self) -> None:
        code = (
            "import gymnasium, pettingzoo, autoref\n"
            "env = autoref.gymnasium_env(settings={'match.half_s': 1})\n"
            "assert isinstance(env, gymnasium.Env), type(env).__mro__\n"
            "env.reset(seed=3)\n"
            "assert env.unwrapped is env and env.np_random is not None\n"
            "games = autoref.parallel_env(settings={'match.half_s': 1})\n"
            "assert isinstance(games, pettingzoo.ParallelEnv)\n"
            "games.reset(seed=3)\n"
            "assert games.num_agents == games.max_num_agents == 2 and games.unwrapped is games\n"
        )
        paths = [self.folder.name, str(Path(autoref.__file__).parent.parent)]
        done = subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            capture_output=True,
            text=True,
            timeout=120,
        )
        self.assertEqual(done.returncode, 0, done.stderr)


class InstalledLibrariesTest(unittest.TestCase):
    """The checks that come with Gymnasium and PettingZoo, where these are installed."""

    def test_gymnasium_accepts_the_environment(self) -> None:
        try:
            import gymnasium
            from gymnasium.utils.env_checker import check_env
        except ImportError:
            self.skipTest("Gymnasium is not installed")
        env = autoref.gymnasium_env(settings=SETTINGS)
        check_env(env, skip_render_check=True)
        gymnasium.wrappers.RecordEpisodeStatistics(gymnasium.wrappers.TimeLimit(env, 100)).reset(seed=1)

    def test_pettingzoo_accepts_the_environment(self) -> None:
        try:
            from pettingzoo.test import parallel_api_test
        except ImportError:
            self.skipTest("PettingZoo is not installed")
        parallel_api_test(autoref.parallel_env(settings=SETTINGS), num_cycles=100)


class ParallelTest(unittest.TestCase):
    def test_obeys_the_interface(self) -> None:
        env = autoref.parallel_env(settings={"match.half_s": 1}, frames_per_step=5)
        observations, infos = env.reset(seed=3)
        self.assertEqual(env.agents, ["a", "b"])
        self.assertEqual(set(infos), {"a", "b"})
        steps = 0
        while env.agents:
            moves = {agent: env.action_space(agent).sample() for agent in env.agents}
            observations, rewards, terminated, truncated, infos = env.step(moves)
            self.assertEqual(rewards["a"], -rewards["b"])
            for agent, observation in observations.items():
                self.assertTrue(env.observation_space(agent).contains(observation))
            steps += 1
        self.assertTrue(all(terminated.values()) and steps > 10)
        self.assertEqual(infos["a"]["status"], "ok")

    def test_may_have_one_agent(self) -> None:
        env = autoref.parallel_env(settings={"match.half_s": 1}, teams="b")
        self.assertEqual(list(env.reset(seed=3)[0]), ["b"])
        self.assertEqual(list(env.step({"b": np.zeros((6, 6))})[1]), ["b"])


class VectorTest(unittest.TestCase):
    def test_plays_like_single_environments(self) -> None:
        moves = actions(2, 30)
        env = autoref.gymnasium_env(settings=SETTINGS, frames_per_step=3)
        singles = []
        for i in range(3):
            env.reset(seed=5 + i)
            singles.append([env.step(move)[0] for move in moves])
        for workers in (1, 2):
            with autoref.VectorEnv(3, workers, settings=SETTINGS, frames_per_step=3) as envs:
                envs.reset(seed=5)
                for step, move in enumerate(moves):
                    observations = envs.step(np.broadcast_to(move, (3, 6, 6)))[0]
                    for i in range(3):
                        np.testing.assert_array_equal(observations[i], singles[i][step])

    def test_begins_the_next_episode_by_itself(self) -> None:
        with autoref.VectorEnv(2, 2, settings={"match.half_s": 1}, frames_per_step=20) as envs:
            envs.reset(seed=1)
            records: list[dict] = []
            for _ in range(200):
                infos = envs.step(np.zeros((2, 6, 6)))[4]
                records += infos.values()
        self.assertGreater(len(records), 2)
        self.assertEqual({record["status"] for record in records}, {"ok"})

    def test_raises_what_a_worker_raises(self) -> None:
        with autoref.VectorEnv(2, 2, settings=SETTINGS) as envs:
            envs.reset(seed=1)
            with self.assertRaisesRegex(RuntimeError, "not finite"):
                envs.step(np.full((2, 6, 6), np.nan))


class PlainBoxTest(unittest.TestCase):
    def test_samples_are_in_it(self) -> None:
        space = PlainBox(np.array([0.0, -1.0]), np.array([1.0, np.inf]))
        space.seed(3)
        self.assertTrue(space.contains(np.array([0.5, 7.0])))
        self.assertFalse(space.contains(np.array([1.5, 7.0])))
        self.assertFalse(space.contains(np.zeros(3)))
        self.assertEqual(space.sample().shape, (2,))
        self.assertTrue(0 <= space.sample()[0] <= 1)


if __name__ == "__main__":
    unittest.main()
