"""The table: a row per measure, a column per rule book, and what is published about real games."""

from dataclasses import dataclass
from typing import Callable

from estimates import ratio_over_games
from published import NOT_FOUND, PUBLISHED

PER_GAME_S = 20 * 60  # the playing time of the games that the paper simulates


@dataclass
class Measure:
    key: str
    name: str
    above: Callable  # takes a game's row; returns None if the row has no value
    below: Callable = lambda row: 1
    is_share: bool = False
    digits: int = 1


def _sum_of(column):
    return lambda row: row[column + "_a"] + row[column + "_b"]


def _half_of(column):
    return lambda row: (row[column + "_a"] + row[column + "_b"]) / 2


def _of(column, factor=1.0):
    return lambda row: None if row[column] is None else row[column] * factor


_SHOTS, _PASSES = _sum_of("shots"), _sum_of("passes_tried")
_SHARE = {"is_share": True, "digits": 0}

# Measures of all games, from results.csv.
OF_RESULTS = [
    Measure("length", "length of a game with its stops, min", _of("sim_s", 1 / 60)),
    Measure("goals", "goals", _sum_of("goals"), digits=2),
    Measure(
        "goals_per_20", "goals in 20 min, stops included", _sum_of("goals"), _of("sim_s", 1 / PER_GAME_S), digits=2
    ),
    Measure("shots", "shots", _SHOTS),
    Measure("shots_on_goal", "shots on goal", _sum_of("shots_on_goal")),
    Measure("shots_scored", "shots that score", _of("calls_goal"), _SHOTS, **_SHARE),
    Measure("passes", "passes tried", _PASSES, digits=0),
    Measure("passes_per_team", "passes tried, by each team", _half_of("passes_tried")),
    Measure("passes_completed", "passes completed", _sum_of("passes_completed"), _PASSES, **_SHARE),
    Measure("fouls", "fouls called", _sum_of("fouls")),
]

# Measures of some games, from logged.csv.
OF_LOGGED = [
    Measure("play_share", "share of time in play, halts left out", _of("play_s"), _of("without_halt_s"), **_SHARE),
    Measure("play", "time in play, min", _of("play_s", 1 / 60)),
    Measure("restarts", "restarts", _of("restarts"), digits=0),
    Measure("stops_per_min", "stops per minute of play", _of("stops"), _of("play_s", 1 / 60), digits=2),
    Measure("spell", "mean spell of play, s", _of("play_s"), _of("restarts")),
    Measure("possession_mean", "possession, mean, s", _of("possessions_s"), _of("possessions"), digits=2),
    Measure("possession_median", "possession, median, s", _of("possession_median_s"), digits=2),
    Measure("kicks", "kicks", _of("kicks"), digits=0),
    Measure("kicks_per_min", "kicks per minute of play", _of("kicks"), _of("play_s", 1 / 60)),
    Measure("flat_kick_median", "flat kicks, median, m/s", _of("flat_kick_median_mps"), digits=2),
    Measure("flat_kick_p95", "flat kicks, 95th percentile, m/s", _of("flat_kick_p95_mps"), digits=2),
    Measure("chips", "kicks that are chips", _of("chips"), _of("kicks"), **_SHARE),
    Measure("robot_p95", "robots' speed, 95th percentile, m/s", _of("robot_p95_mps"), digits=2),
    Measure("robot_p99", "robots' speed, 99th percentile, m/s", _of("robot_p99_mps"), digits=2),
    Measure("robot_max", "robots' speed, 99.99th percentile, m/s", _of("robot_max_mps"), digits=2),
    Measure("robot_in_play_p95", "the same only in play, 95th percentile, m/s", _of("robot_in_play_p95_mps"), digits=2),
    Measure("robot_in_play_p99", "the same only in play, 99th percentile, m/s", _of("robot_in_play_p99_mps"), digits=2),
    Measure("speed_up_p95", "speeding up, 95th percentile, m/s²", _of("speed_up_p95_mps2"), digits=2),
    Measure("speed_up_p99", "speeding up, 99th percentile, m/s²", _of("speed_up_p99_mps2"), digits=2),
    Measure("brake_p95", "braking, 95th percentile, m/s²", _of("brake_p95_mps2"), digits=2),
    Measure("brake_p99", "braking, 99th percentile, m/s²", _of("brake_p99_mps2"), digits=2),
]


def estimate_of(measure, rows):
    """The measure's estimate over the games that have a value; None without any."""
    pairs = [(measure.above(row), measure.below(row)) for row in rows]
    pairs = [pair for pair in pairs if pair[0] is not None]
    return ratio_over_games([pair[0] for pair in pairs], [pair[1] for pair in pairs])


def _cell(measure, estimate):
    """The estimate with its interval; bold if the whole interval lies outside the published range."""
    if estimate is None:
        return ""
    factor = 100 if measure.is_share else 1
    value, low, high = (
        f"{factor * number:.{measure.digits}f}" for number in (estimate.value, estimate.low, estimate.high)
    )
    text = f"{value}{' %' if measure.is_share else ''} [{low}, {high}]"
    real = PUBLISHED.get(measure.key)
    is_outside = real and (estimate.high < real.low or estimate.low > real.high)
    return f"**{text}**" if is_outside else text


def _row(measure, rows_by_book):
    cells = [_cell(measure, estimate_of(measure, rows)) for rows in rows_by_book.values()]
    real = PUBLISHED[measure.key].text if measure.key in PUBLISHED else NOT_FOUND
    return [measure.name, *cells, real]


def markdown(results, logged):
    """The table. Both arguments: rows of games, with numbers by column, by the name of the rule book."""
    rows = [["", *(f"`{book}`" for book in results), "real games"]]
    rows.append(["games", *(str(len(games)) for games in results.values()), ""])
    rows += [_row(measure, results) for measure in OF_RESULTS]
    rows.append(["games with a log", *(str(len(games)) for games in logged.values()), ""])
    rows += [_row(measure, logged) for measure in OF_LOGGED]
    header, *body = ("| " + " | ".join(row) + " |" for row in rows)
    return "\n".join([header, "|---" + "|--:" * len(results) + "|---|", *body]) + "\n"
