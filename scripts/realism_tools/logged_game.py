"""What results.csv does not say about a game: measured in its log and its referee's decisions."""

import json

import motion
from motion import percentile
from play_spells import length_s, number_of_stops, periods_without_halt, spells_of_play
from ssl_log import positions_in

MAXIMUM_SHARE = 0.9999  # the "maximum" of the published analysis


def _kick_columns(kicks):
    flat_mps = [speed_mps for speed_mps, is_chip in kicks if not is_chip]
    return {
        "kicks": len(kicks),
        "chips": len(kicks) - len(flat_mps),
        "flat_kick_median_mps": percentile(flat_mps, 0.5),
        "flat_kick_p95_mps": percentile(flat_mps, 0.95),
    }


def _possession_columns(lengths_s):
    return {
        "possessions": len(lengths_s),
        "possessions_s": sum(lengths_s),
        "possession_median_s": percentile(lengths_s, 0.5),
    }


def _robot_columns(all_but_halt, in_play):
    return {
        "robot_p95_mps": percentile(all_but_halt.speeds_mps, 0.95),
        "robot_p99_mps": percentile(all_but_halt.speeds_mps, 0.99),
        "robot_max_mps": percentile(all_but_halt.speeds_mps, MAXIMUM_SHARE),
        "robot_in_play_p95_mps": percentile(in_play.speeds_mps, 0.95),
        "robot_in_play_p99_mps": percentile(in_play.speeds_mps, 0.99),
        "speed_up_p95_mps2": percentile(all_but_halt.speed_ups_mps2, 0.95),
        "speed_up_p99_mps2": percentile(all_but_halt.speed_ups_mps2, 0.99),
        "brake_p95_mps2": percentile(all_but_halt.brakes_mps2, 0.95),
        "brake_p99_mps2": percentile(all_but_halt.brakes_mps2, 0.99),
    }


def columns_of(positions, decisions):
    """A row of logged.csv without the game's id. Empty numbers are None."""
    spells = spells_of_play(decisions)
    periods = periods_without_halt(decisions, positions.times_s[-1])
    return {
        "without_halt_s": length_s(periods),
        "play_s": length_s(spells),
        "restarts": len(spells),
        "stops": number_of_stops(decisions),
        **_kick_columns(motion.kicks(positions, spells)),
        **_possession_columns(motion.possessions_s(positions, spells)),
        **_robot_columns(motion.robot_motion(positions, periods), motion.robot_motion(positions, spells)),
    }


def read(log, events):
    """The columns of a game that was written to these two files."""
    with open(events, encoding="utf-8") as lines:
        decisions = [json.loads(line) for line in lines]
    return columns_of(positions_in(log.read_bytes()), decisions)
