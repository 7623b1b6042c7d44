"""Plays the games of a rule book, and reads and writes their rows."""

import csv
import shutil
import subprocess
import tempfile
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

import logged_game

SCENARIO = "scenarios/realism.yaml"
LONGEST_RUN_S = 6 * 3600
LONGEST_REPLAY_S = 600


class GamesError(Exception):
    """Games could not be played or read; the text says what to do."""


def _autoref(program, *arguments, limit_s):
    try:
        subprocess.run([program, *arguments], check=True, stdout=subprocess.DEVNULL, timeout=limit_s)
    except (OSError, subprocess.SubprocessError) as error:
        raise GamesError(f"playing games failed: {error}") from error


def play(program, settings, games, runs, to):
    """Plays the missing games in the folder `runs`, with these KEY=VALUE, and copies their results.csv to `to`."""
    options = [word for setting in settings for word in ("--set", setting)]
    options += ["--pairs", str(games // 2), "-o", str(runs), "--quiet"]
    _autoref(program, "run", SCENARIO, *options, limit_s=LONGEST_RUN_S)
    to.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(runs / "results.csv", to / "results.csv")


def _measure(program, runs, game):
    with tempfile.TemporaryDirectory() as folder:
        log, events = Path(folder) / "game.log", Path(folder) / "events.jsonl"
        _autoref(
            program,
            "results",
            "replay",
            str(runs),
            game,
            "--log",
            str(log),
            "--events",
            str(events),
            limit_s=LONGEST_REPLAY_S,
        )
        return {"game_id": game, **logged_game.read(log, events)}


def measure(program, runs, to, games, workers):
    """Plays the first games of results.csv again, with a log each, and writes logged.csv."""
    ids = [row["game_id"] for row in rows_of(to / "results.csv")[:games]]
    with ProcessPoolExecutor(workers) as pool:
        rows = list(pool.map(partial(_measure, program, runs), ids))
    with open(to / "logged.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: _cell(value) for name, value in row.items()} for row in rows)


def _cell(value):
    return f"{value:.6g}" if isinstance(value, float) else value


def _value(text):
    try:
        return float(text) if text else None
    except ValueError:
        return text


def rows_of(file):
    """The valid games of results.csv or logged.csv: numbers, texts, and None for empty cells, by column."""
    try:
        with open(file, newline="", encoding="utf-8") as opened:
            rows = [{name: _value(text) for name, text in row.items()} for row in csv.DictReader(opened)]
    except OSError as error:
        raise GamesError(f"cannot read {file}: {error.strerror}; leave out 'draw' to play the games") from error
    rows = [row for row in rows if row.get("status", "ok") == "ok"]
    if not rows:
        raise GamesError(f"{file} has no valid game")
    return rows
