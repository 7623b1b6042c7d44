"""Whole games and experiments with teams in Python, played by the program in AUTOREF."""
import os
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import autoref

_TEAM = str(Path(__file__).with_name("turning_team.py"))
_EXAMPLES = Path(__file__).resolve().parents[2] / "python" / "examples"
_SHORT = {"match.half_s": 5}
_START = (208).to_bytes(4, "little") + b"\x01" + bytes(203)  # in flat records, without robots


def _command(*arguments):
    return [sys.executable, _TEAM, *arguments]


def _play(a, **options):
    game = autoref.play(a, "basic", seed=3, settings=_SHORT, **options)
    return game.status, game.void_reason, game.state_hash


@unittest.skipUnless(os.environ.get("AUTOREF"), "AUTOREF is not set")
class Games(unittest.TestCase):
    """Each test plays short games."""

    def test_are_the_same_in_all_encodings(self):
        for motion in ("tracked", "detections"):
            games = {_play(_command(encoding, motion)) for encoding in ("flat", "json")}
            self.assertEqual(len(games), 1, games)
            self.assertEqual(games.pop()[:2], ("ok", None))

    def test_differ_from_a_game_without_the_team(self):
        self.assertNotEqual(_play(_command())[2], _play("dummy")[2])

    def test_a_class_an_object_and_its_file_are_the_same_team(self):
        sys.path.insert(0, str(Path(_TEAM).parent))
        from turning_team import TurningTeam

        self.assertEqual(_play(TurningTeam), _play(_TEAM))
        self.assertEqual(_play(TurningTeam()), _play(_TEAM))

    def test_team_runs_without_its_own_main(self):
        self.assertEqual(_play([sys.executable, "-m", "autoref", "team", _TEAM]), _play(_TEAM))

    def test_of_a_team_that_fails_are_void_and_say_why(self):
        with tempfile.TemporaryDirectory() as folder:
            os.chmod(folder, 0o755)  # programs that root starts run as another user
            file = Path(folder, "failing.py")
            file.write_text(
                "import autoref\n\n\nclass Failing(autoref.Team):\n    pass\n\n\n" "Failing.run()\n", encoding="utf-8"
            )
            game = autoref.play(file, "basic", settings=_SHORT)
        self.assertEqual(game.status, "void")
        self.assertIn("a team needs the method decide(self, view)", game.void_reason)

    def test_write_events_and_logs_that_can_be_read(self):
        with tempfile.TemporaryDirectory() as folder:
            events, log = Path(folder, "events"), Path(folder, "game.log.gz")
            _play("basic", events=events, log=log)
            first = next(autoref.events(events))
            kinds = {message.kind for message in autoref.log(log)}
        self.assertEqual(first["event"], "begin")
        self.assertLessEqual({3, 4}, kinds)

    def test_wrong_settings_are_errors(self):
        with self.assertRaisesRegex(autoref.AutorefError, "half_ss"):
            autoref.play("basic", "basic", settings={"match.half_ss": 5})

    def test_example_plays(self):
        game = autoref.play(_EXAMPLES / "team.py", "dummy", settings={"match.half_s": 30})
        self.assertEqual(game.status, "ok")
        self.assertGreater(game.goals_a, 0)


@unittest.skipUnless(os.environ.get("AUTOREF"), "AUTOREF is not set")
class Experiments(unittest.TestCase):
    """One experiment of four games."""

    def test_give_rows_with_numbers(self):
        scenario = {
            "schema": 1,
            "kind": "sweep",
            "seed": 1,
            "pairs": 2,
            "base": {"teams": {"a": {"strategy": "chaser"}, "b": {"strategy": "dummy"}}, "match": {"half_s": 10}},
            "factors": {"b.robots": [6]},
        }
        with tempfile.TemporaryDirectory() as folder:
            done = autoref.run(scenario, Path(folder, "run"), workers=1)
            rows = autoref.rows(done.folder)
        self.assertEqual([row["leg"] for row in rows], [1, 2, 1, 2])
        self.assertTrue(all(row["goals_a"] - row["goals_b"] == row["goal_diff"] for row in rows))
        self.assertIsNone(rows[0]["shootout_a"])


class Rows(unittest.TestCase):
    """Tables of a folder."""

    def test_do_not_wait_for_a_pipe_that_has_the_name_of_a_table(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkfifo(Path(folder, "results.csv"))
            signal.alarm(60)  # ends a test that waits for ever
            with self.assertRaisesRegex(ValueError, "results.csv: is not a regular file"):
                autoref.rows(folder)
            signal.alarm(0)


class CommandLine(unittest.TestCase):
    """python3 -m autoref."""

    def test_explains_itself_without_a_verb(self):
        done = subprocess.run([sys.executable, "-m", "autoref"], stdout=subprocess.PIPE, text=True, check=True)
        for verb in ("check", "team", "play"):
            self.assertRegex(done.stdout, rf"\n +{verb} +[a-z]+")

    def test_shows_where_a_team_failed(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "failing.py")
            file.write_text(
                "import autoref\n\n\nclass Failing(autoref.Team):\n"
                "    def prepare(self):\n        raise ValueError('no playbook')\n",
                encoding="utf-8",
            )
            done = subprocess.run(
                [sys.executable, "-m", "autoref", "team", file], input=_START, capture_output=True, check=False
            )
        self.assertEqual(done.stdout, b"autoref-team 1 flat tracked\n")
        self.assertIn(b"in prepare\n", done.stderr)

    def test_says_that_the_program_is_missing(self):
        environment = dict(os.environ, AUTOREF="/nowhere/autoref")
        done = subprocess.run(
            [sys.executable, "-m", "autoref", "check"], env=environment, stderr=subprocess.PIPE, text=True, check=False
        )
        self.assertEqual(
            (done.returncode, done.stderr), (1, "autoref: AUTOREF is /nowhere/autoref, which is not a program\n")
        )


if __name__ == "__main__":
    unittest.main()
