"""autoref.Game: games in this process."""
import json
import os
import subprocess
import unittest

import numpy as np

import autoref

AUTOREF = os.environ["AUTOREF"]
SETTINGS = {"match.half_s": 5, "a.strategy": "counter", "b.strategy": "basic", "sim.camera": "realistic"}


def still() -> np.ndarray:
    return np.zeros((6, 6))


def curves() -> np.ndarray:
    commands = still()
    commands[:, 0] = 0.5
    commands[:, 2] = 1.0
    return commands


def played(seed: int, commands: np.ndarray, external: str = "a") -> str:
    game = autoref.Game(external).reset(seed, SETTINGS)
    while game.step(**{team: commands for team in external}):
        pass
    return game.record["state_hash"]


class GameTest(unittest.TestCase):
    def test_plays_built_in_teams_as_the_program_does(self) -> None:
        game = autoref.Game("").reset(7, SETTINGS)
        game.run()
        words = [AUTOREF, "play", os.environ["SCENARIO"], "--seed", "7", "--json"]
        for path, value in {"match.rules": "paper", **SETTINGS}.items():
            words += ["--set", f"{path}={value}"]
        printed = json.loads(subprocess.run(words, check=True, capture_output=True).stdout)
        self.assertEqual(game.record["state_hash"], printed["state_hash"])
        self.assertEqual(game.record["goals_b"], printed["goals_b"])

    def test_repeats_a_game(self) -> None:
        self.assertEqual(played(3, curves()), played(3, curves()))
        self.assertNotEqual(played(3, curves()), played(4, curves()))
        self.assertNotEqual(played(3, curves()), played(3, still()))

    def test_steps_like_run(self) -> None:
        game = autoref.Game("a").reset(3, SETTINGS)
        game.step(curves())
        game.run()
        self.assertTrue(game.is_over)
        self.assertEqual(game.record["state_hash"], played(3, curves()))

    def test_games_do_not_affect_one_another(self) -> None:
        games = [autoref.Game("a").reset(3, SETTINGS) for _ in range(3)]
        while all([game.step(curves()) for game in games]):
            pass
        self.assertEqual({game.record["state_hash"] for game in games}, {played(3, curves())})

    def test_shows_each_team_its_own_goal_in_the_west(self) -> None:
        game = autoref.Game("ab").reset(3, {"match.half_s": 5})
        game.step()
        self.assertEqual(game.a.own.shape, (6, 8))
        np.testing.assert_allclose(game.a.own, game.b.own, atol=1e-6)
        self.assertLess(game.b.own[:, 1].max(), 0)
        self.assertEqual(game.a.play, "STOP")

    def test_robots_obey(self) -> None:
        game = autoref.Game("a").reset(3, {"match.half_s": 5})
        before = game.a.own.copy()
        for _ in range(60):
            game.step(curves())
        self.assertGreater(np.abs(game.a.own - before)[:, 1:3].max(), 0.1)

    def test_places_ball_and_robots(self) -> None:
        game = autoref.Game("a").reset(3, {"match.half_s": 5})
        game.place(ball=(1.0, 0.5, 0.0, 0.0), robots={("a", 1): (0.4, 0.2, 0.0, 1.0)})
        for _ in range(10):
            game.step()
        np.testing.assert_allclose(game.a.own[1, 1:5], [0.4, 0.2, 0.0, 1.0], atol=0.02)

    def test_lists_decisions(self) -> None:
        game = autoref.Game("").reset(3, {"match.half_s": 1})
        labels = [entry["transition"] for entry in game.decisions]
        while game.step():
            labels += [entry["transition"] for entry in game.decisions]
        labels += [entry["transition"] for entry in game.decisions]
        self.assertEqual(labels[0], "begin")
        self.assertEqual(labels[-1], "game_over")

    def test_says_what_is_wrong(self) -> None:
        game = autoref.Game("a")
        with self.assertRaisesRegex(ValueError, "reset"):
            game.step()
        for settings, text in [
            ({"match.hlaf_s": 1}, "match.half_s"),
            ({"b.strategy": "no"}, "cobalt"),
            ({"match.half_s": -1}, "half_s"),
        ]:
            with self.assertRaisesRegex(ValueError, text):
                game.reset(1, settings)
        game.reset(1)
        for commands in [
            np.zeros((6, 5)),
            np.zeros(6),
            np.zeros((17, 6)),
            np.full((6, 6), np.nan),
            np.full((6, 6), np.inf),
        ]:
            with self.assertRaises(ValueError):
                game.step(commands)
        with self.assertRaises(ValueError):
            game.step(None, still())
        with self.assertRaises(ValueError):
            game.b
        for ball in [(np.nan, 0), (0, 9), (1e300, 0), (0, 0, np.nan, 0), (0, 0, 1e300, 0), (0, 0, 0, -21)]:
            with self.assertRaises(ValueError, msg=str(ball)):
                game.place(ball=ball)
        for robots in [
            {("a", 12): (0, 0)},
            {("c", 1): (0, 0)},
            {("a", 1): (99, 0)},
            {("a", 1): (0, -3)},
            {("a", 1): (0, np.inf)},
            {("a", 1): (0, 0, 0, 0)},
        ]:
            with self.assertRaises(ValueError, msg=str(robots)):
                game.place(robots=robots)
        with self.assertRaises(ValueError):
            autoref.Game("c")


if __name__ == "__main__":
    unittest.main()
