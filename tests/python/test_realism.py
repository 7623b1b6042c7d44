"""The arithmetic of scripts/realism, on small made-up games, and its table against the committed games."""

import struct
import subprocess
import sys
import unittest
from math import pi
from pathlib import Path

_CHECKOUT = Path(__file__).resolve().parents[2]
_RESULTS = _CHECKOUT / "results" / "realism"
for _tools in ("realism_tools", "handicap_tools"):
    sys.path.insert(0, str(_CHECKOUT / "scripts" / _tools))

import estimates  # noqa: E402
import games  # noqa: E402
import logged_game  # noqa: E402
import motion  # noqa: E402
import play_spells  # noqa: E402
import ssl_log  # noqa: E402
import student  # noqa: E402
import table  # noqa: E402

_FRAME_S = 0.02
_FAR = (9.0, 9.0, 0.0)


def _positions(frames, ball, **robots):
    """A game of so many frames. Each argument: from a frame's number to (x_m, y_m, height_m or heading_rad)."""
    positions = ssl_log.Positions()
    for frame in range(frames):
        positions.begin_frame(frame * _FRAME_S)
        positions.ball.set_last(*ball(frame))
        for side, path in robots.items():
            positions.robot((side, 0)).set_last(*path(frame))
    return positions


def _all_of(positions):
    return [(positions.times_s[0], positions.times_s[-1])]


def _stands(x_m, y_m=0.0, heading_rad=0.0):
    return lambda frame: (x_m, y_m, heading_rad)


def _decision(time_s, before, after, command=None, transition="start"):
    return {"time_s": time_s, "from": before, "to": after, "command": command, "transition": transition}


class Percentiles(unittest.TestCase):
    def test_are_interpolated(self):
        self.assertEqual(motion.percentile([4, 1, 3, 2], 0.5), 2.5)
        self.assertAlmostEqual(motion.percentile(list(range(101)), 0.95), 95)
        self.assertEqual(motion.percentile([7], 0.99), 7)

    def test_of_nothing_are_missing(self):
        self.assertIsNone(motion.percentile([], 0.5))


class Ratios(unittest.TestCase):
    def test_with_denominators_of_one_are_the_mean_with_students_interval(self):
        sample = [1, 2, 4, 9]
        estimate = estimates.ratio_over_games(sample, [1] * 4)
        self.assertEqual(estimate.value, 4)
        for found, expected in zip((estimate.low, estimate.high), student.interval_of_mean(sample)):
            self.assertAlmostEqual(found, expected)

    def test_weigh_games_by_their_denominators(self):
        self.assertEqual(estimates.ratio_over_games([1, 9], [1, 3]).value, 2.5)

    def test_of_games_with_the_same_ratio_have_no_width(self):
        estimate = estimates.ratio_over_games([1, 2, 4], [2, 4, 8])
        self.assertEqual((estimate.low, estimate.high), (0.5, 0.5))

    def test_by_zero_are_missing(self):
        self.assertIsNone(estimates.ratio_over_games([0, 0], [0, 0]))
        self.assertIsNone(estimates.ratio_over_games([], []))


class Spells(unittest.TestCase):
    DECISIONS = [
        _decision(0, "INIT", "WAIT_START", "STOP"),
        _decision(5, "WAIT_STOP", "RUN", "NORMAL_START"),
        _decision(7, "RUN", "RUN"),  # a foul that does not stop play
        _decision(9, "RUN", "WAIT_STOP", "STOP", "throw_in"),
        _decision(10, "WAIT_STOP", "RUN", "DIRECT_FREE_BLUE"),
        _decision(16, "RUN", "DELAY_WAIT", "HALT", "half_over"),
        _decision(18, "DELAY_WAIT", "WAIT_STOP", "STOP"),
        _decision(20, "WAIT_STOP", "OVER", "HALT", "game_over"),
    ]

    def test_last_from_the_signal_until_play_ends(self):
        self.assertEqual(play_spells.spells_of_play(self.DECISIONS), [(5, 9), (10, 16)])

    def test_ends_of_halves_are_not_stops(self):
        self.assertEqual(play_spells.number_of_stops(self.DECISIONS), 1)

    def test_halts_are_left_out(self):
        self.assertEqual(play_spells.periods_without_halt(self.DECISIONS, 30), [(0, 16), (18, 20)])
        self.assertEqual(play_spells.periods_without_halt(self.DECISIONS[:3], 30), [(0, 30)])


class Possessions(unittest.TestCase):
    def test_last_from_a_touch_to_the_other_sides_touch_or_the_end_of_play(self):
        positions = _positions(
            101,
            lambda frame: (0.04 * frame, 0.0, 0.0),  # 2 m/s
            yellow=_stands(0.8 - 0.115),  # touched until frame 20
            blue=_stands(2.1),  # from frame 50
        )
        lengths_s = motion.possessions_s(positions, _all_of(positions))
        yellow_s, blue_s = lengths_s
        first_touch = 15  # the ball's path comes within 0.115 m of 0.685 m on the way from 0.56 m
        self.assertAlmostEqual(yellow_s, (50 - first_touch) * _FRAME_S)
        self.assertAlmostEqual(blue_s, 50 * _FRAME_S)

    def test_the_wait_for_a_restart_does_not_count(self):
        positions = _positions(
            100, lambda frame: (0.0 if frame < 60 else 0.1 * (frame - 59), 0.0, 0.0), yellow=_stands(-0.1)
        )
        lengths_s = motion.possessions_s(positions, _all_of(positions))
        self.assertEqual(len(lengths_s), 1)
        self.assertAlmostEqual(lengths_s[0], 39 * _FRAME_S)

    def test_touches_by_both_sides_at_once_change_nothing(self):
        positions = _positions(
            50,
            lambda frame: (0.02 * frame, 0.0, 0.0),
            yellow=lambda frame: (0.02 * frame - 0.1, 0.0, 0.0),
            blue=lambda frame: (0.02 * frame + 0.1 if frame > 25 else 9.0, 0.0, 0.0),
        )
        self.assertEqual(len(motion.possessions_s(positions, _all_of(positions))), 1)

    def test_a_ball_above_the_robots_is_not_touched(self):
        positions = _positions(50, lambda frame: (0.1 * frame, 0.0, 0.3), yellow=_stands(2.0))
        self.assertEqual(motion.possessions_s(positions, _all_of(positions)), [])


class Kicks(unittest.TestCase):
    def _found(self, heading_rad=0.0, x_m=-0.1, speed_mps=3.0, climb_mps=0.0):
        def ball(frame):
            since_s = max(0, frame - 50) * _FRAME_S
            return speed_mps * since_s, 0.0, climb_mps * since_s

        positions = _positions(100, ball, yellow=_stands(x_m, 0.0, heading_rad))
        return motion.kicks(positions, _all_of(positions))

    def test_are_found_once_with_their_speed(self):
        ((speed_mps, is_chip),) = self._found()
        self.assertAlmostEqual(speed_mps, 3.0)
        self.assertFalse(is_chip)

    def test_that_rise_are_chips(self):
        self.assertEqual([is_chip for _, is_chip in self._found(climb_mps=2.0)], [True])

    def test_need_a_robot_that_faces_the_ball(self):
        self.assertEqual(self._found(heading_rad=pi), [])
        self.assertEqual(self._found(x_m=-0.3), [])

    def test_are_not_seen_in_what_happens_to_the_ball_after_play(self):
        positions = _positions(100, lambda frame: (0.0 if frame <= 60 else 3.0, 0.0, 0.0), yellow=_stands(-0.1))
        self.assertEqual(motion.kicks(positions, [(0, 60 * _FRAME_S)]), [])
        self.assertEqual(len(motion.kicks(positions, [(0, 70 * _FRAME_S)])), 1)

    def test_slower_than_one_metre_per_second_are_pushes(self):
        self.assertEqual(self._found(speed_mps=0.9), [])


class Robots(unittest.TestCase):
    def test_speed_and_acceleration_along_the_motion(self):
        def drives(frame):  # from 3 m/s down at 4 m/s^2
            time_s = frame * _FRAME_S
            return 3 * time_s - 2 * time_s**2, 0.0, 0.0

        positions = _positions(26, lambda frame: _FAR, yellow=drives)
        found = motion.robot_motion(positions, _all_of(positions))
        self.assertAlmostEqual(max(found.speeds_mps), 3 - 4 * 2 * _FRAME_S)  # two frames before the first sample
        self.assertEqual(found.speed_ups_mps2, [])
        self.assertTrue(found.brakes_mps2)
        for brake_mps2 in found.brakes_mps2:
            self.assertAlmostEqual(brake_mps2, 4.0)

    def test_that_are_moved_by_hand_or_unseen_do_not_count(self):
        positions = _positions(
            26,
            lambda frame: _FAR,
            yellow=lambda frame: (0.0 if frame < 13 else 5.0, 0.0, 0.0),
            blue=_stands(float("nan")),
        )
        self.assertEqual(max(motion.robot_motion(positions, _all_of(positions)).speeds_mps), 0.0)


class Logs(unittest.TestCase):
    """A log of one packet, byte by byte."""

    def _log(self, ball):
        def tagged(layout, tag, value):
            return struct.pack("<B" + layout, tag, value)

        robot = tagged("f", 0x0D, 1.0) + tagged("B", 0x10, 3)
        for tag, value in ((0x1D, -500.0), (0x25, 250.0), (0x2D, 0.5), (0x35, 0.0), (0x3D, 0.0)):
            robot += tagged("f", tag, value)
        spot = b"".join(tagged("f", tag, value) for tag, value in ball)
        frame = tagged("B", 0x08, 7) + tagged("d", 0x11, 1.5) + tagged("d", 0x19, 1.5) + tagged("B", 0x20, 0)
        frame += bytes([0x2A, len(spot)]) + spot + bytes([0x3A, len(robot)]) + robot
        packet = bytes([0x0A, len(frame)]) + frame
        return b"SSL_LOG_FILE\x00\x00\x00\x01" + struct.pack(">qii", 0, 4, len(packet)) + packet

    def test_positions_are_read_in_metres(self):
        ball = ((0x0D, 1.0), (0x1D, 1000.0), (0x25, -2000.0), (0x2D, 100.0), (0x35, 0.0), (0x3D, 0.0))
        positions = ssl_log.positions_in(self._log(ball))
        self.assertEqual(list(positions.times_s), [1.5])
        track = positions.ball
        for found, expected in zip((track.x_m[0], track.y_m[0], track.third[0]), (1.0, -2.0, 0.1)):
            self.assertAlmostEqual(found, expected)
        robot = positions.robots["blue", 3]
        for found, expected in zip((robot.x_m[0], robot.y_m[0], robot.third[0]), (-0.5, 0.25, 0.5)):
            self.assertAlmostEqual(found, expected)

    def test_without_the_balls_height_are_refused(self):
        with self.assertRaisesRegex(ssl_log.LogError, "lacks the ball's height"):
            ssl_log.positions_in(self._log(((0x0D, 1.0), (0x1D, 0.0), (0x25, 0.0), (0x35, 0.0), (0x3D, 0.0))))

    def test_other_files_are_refused(self):
        with self.assertRaisesRegex(ssl_log.LogError, "not an uncompressed SSL log"):
            ssl_log.positions_in(b"\x1f\x8b")

    def test_damaged_ones_are_refused(self):
        ball = ((0x0D, 1.0), (0x1D, 0.0), (0x25, 0.0), (0x2D, 0.0), (0x35, 0.0), (0x3D, 0.0))
        with self.assertRaisesRegex(ssl_log.LogError, "damaged"):
            ssl_log.positions_in(self._log(ball)[:-60])

    def test_a_game_without_a_kick_has_no_kick_speeds(self):
        positions = _positions(101, lambda frame: (0.0, 0.0, 0.0), yellow=_stands(1.0))
        columns = logged_game.columns_of(positions, Spells.DECISIONS[:2])
        self.assertEqual(columns["kicks"], 0)
        self.assertIsNone(columns["flat_kick_median_mps"])


class Table(unittest.TestCase):
    MEASURE = table.Measure("stops_per_min", "stops", lambda row: row["stops"])  # published: 6 to 9

    def _cell(self, *values):
        return table._cell(self.MEASURE, table.estimate_of(self.MEASURE, [{"stops": value} for value in values]))

    def test_is_bold_only_where_the_whole_interval_is_outside(self):
        self.assertEqual(self._cell(10, 10, 10), "**10.0 [10.0, 10.0]**")
        self.assertEqual(self._cell(5, 5, 5), "**5.0 [5.0, 5.0]**")
        self.assertFalse(self._cell(9, 10, 11).startswith("**"))  # from 7.5
        self.assertEqual(self._cell(9, 9), "9.0 [9.0, 9.0]")

    def test_games_without_a_value_do_not_count(self):
        self.assertEqual(self._cell(None, 8, 8), "8.0 [8.0, 8.0]")
        self.assertEqual(self._cell(None), "")

    def test_every_published_figure_has_a_row(self):
        keys = [measure.key for measure in table.OF_RESULTS + table.OF_LOGGED]
        self.assertEqual(len(keys), len(set(keys)))
        self.assertFalse(table.PUBLISHED.keys() - set(keys))


class CommittedResults(unittest.TestCase):
    def test_table_is_that_of_the_games(self):
        written = (_RESULTS / "table.md").read_text(encoding="utf-8")
        books = [part.strip(" `") for part in written.splitlines()[0].split("|")[2:-2]]
        rows = (
            {book: games.rows_of(_RESULTS / book / file) for book in books} for file in ("results.csv", "logged.csv")
        )
        self.assertEqual(table.markdown(*rows), written)

    def test_page_has_the_table(self):
        page = (_CHECKOUT / "docs" / "realism.md").read_text(encoding="utf-8")
        self.assertIn((_RESULTS / "table.md").read_text(encoding="utf-8"), page)

    def test_page_discusses_every_row_outside(self):
        page = (_CHECKOUT / "docs" / "realism.md").read_text(encoding="utf-8").lower()
        section = page.split("## where we are outside\n")[1].split("\nnot outside")[0]
        lines = [line for line in (_RESULTS / "table.md").read_text(encoding="utf-8").splitlines() if "**" in line]
        self.assertTrue(lines)
        for line in lines:
            self.assertIn(line.split("|")[1].split(",")[0].strip(), section)

    def test_possessions_last_as_long_as_by_the_ground_truth(self):
        for folder in filter(Path.is_dir, _RESULTS.iterdir()):
            truth = {row["game_id"]: row for row in games.rows_of(folder / "results.csv")}
            for row in games.rows_of(folder / "logged.csv"):
                expected_s = sum(truth[row["game_id"]][f"possession_s_{team}"] for team in "ab")
                self.assertAlmostEqual(row["possessions_s"] / expected_s, 1, delta=0.01, msg=row["game_id"])


class Command(unittest.TestCase):
    def _refusal(self, *arguments):
        script = _CHECKOUT / "scripts" / "realism"
        answer = subprocess.run([script, *arguments], capture_output=True, text=True, timeout=60)
        self.assertEqual(answer.returncode, 2)
        return answer.stderr

    def test_refuses_what_it_cannot_do(self):
        self.assertIn("expected an even number of 2 or more", self._refusal("--games", "3"))
        self.assertIn("invalid", self._refusal("--games", "many"))
        self.assertIn("--set needs --output", self._refusal("--set", "match.half_s=60"))
        self.assertIn("nowhere is missing; build it", self._refusal("--autoref", "nowhere"))
        self.assertIn("leave out 'draw' to play the games", self._refusal("draw", "--output", "nowhere"))


if __name__ == "__main__":
    unittest.main()
