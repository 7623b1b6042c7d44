"""Games and experiments, played by the program `autoref`."""
from __future__ import annotations

import inspect
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Union

from .results import PathLike, results
from .team import Team

# A strategy's name, a file of Python code, a subclass of Team or an instance of one, the words of a
# command, or the keys of a team in a scenario.
Player = Union[PathLike, type[Team], Team, list[str], Mapping[str, Any]]

_PACKAGE_FOLDER = Path(__file__).resolve().parent


class AutorefError(RuntimeError):
    """The program failed or was not found; the text is its message."""


@dataclass(frozen=True)
class GameResult:
    """The result of one game. `details` has all keys of `play --json` in docs/schemas.md."""

    goals_a: int
    goals_b: int
    end_reason: str  # "time", "goals", "shootout", "forfeit_a", "forfeit_b" or "void"
    status: str  # "ok", "forfeit" or "void"
    void_reason: str | None  # why the game is void or forfeited
    seed: int
    state_hash: str  # equal hashes mean identical games
    details: dict[str, Any]


@dataclass(frozen=True)
class Run:
    """An experiment that has been played."""

    folder: Path

    def results(self, **options: Any) -> Any:
        """The table of its games: calls autoref.results() with the folder."""
        return results(self.folder, **options)


def _candidates() -> Iterator[Path]:
    for folder in _PACKAGE_FOLDER.parents:
        yield folder / "bin" / "autoref"
        yield folder / "build" / "release" / "bin" / "autoref"


def program() -> str:
    """Path of the program: $AUTOREF, or else bin/ or build/release/bin/ in a folder above the package, or else PATH.

    Raises AutorefError if it is in none of these.
    """
    given = os.environ.get("AUTOREF")
    if given:
        if not os.access(given, os.X_OK) or os.path.isdir(given):
            raise AutorefError(f"AUTOREF is {given}, which is not a program")
        return os.path.abspath(given)
    for candidate in _candidates():
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return str(candidate)
    found = shutil.which("autoref")
    if found is None:
        raise AutorefError(
            "the program autoref was not found; build it with scripts/build, or set " "AUTOREF to its path"
        )
    return found


def _file_of(team: type[Team]) -> str:
    try:
        return os.path.abspath(inspect.getfile(team))
    except (TypeError, OSError):
        raise AutorefError(f"{team.__name__} is not defined in a file; a game runs it in another " "process") from None


def team_settings(player: Player) -> dict[str, Any]:
    """The keys of a team in a scenario."""
    if isinstance(player, Mapping):
        return dict(player)
    if isinstance(player, list):
        return {"command": player}
    if isinstance(player, Team):
        player = type(player)
    if isinstance(player, type):
        return {"command": [sys.executable, _file_of(player)]}
    name = os.fspath(player)
    if name.endswith(".py"):
        return {"command": [sys.executable, os.path.abspath(name)]}
    return {"strategy": name}


def _environment() -> dict[str, str]:
    """Lets teams import this package even if it is not installed."""
    environment = dict(os.environ)
    paths = [str(_PACKAGE_FOLDER.parent), environment.get("PYTHONPATH", "")]
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, paths))
    return environment


def _run_program(arguments: list[str], good_codes: tuple[int, ...] = (0,)) -> str:
    done = subprocess.run(
        [program(), *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        env=_environment(),
        check=False,
    )
    if done.returncode not in good_codes:
        raise AutorefError(done.stderr.strip() or f"autoref ended with code {done.returncode}")
    return done.stdout


def _options(settings: Mapping[str, Any], options: Mapping[str, Any]) -> list[str]:
    """Turns settings into --set KEY=VALUE, and other options into options of the same name."""
    words = []
    for name, value in options.items():
        if value is not None:
            words += ["--" + name.replace("_", "-"), os.fspath(value) if isinstance(value, os.PathLike) else str(value)]
    for key, value in settings.items():
        words += ["--set", f"{key}={json.dumps(value) if isinstance(value, bool) else value}"]
    return words


@contextmanager
def _scenario_file(scenario: Mapping[str, Any] | PathLike) -> Iterator[str]:
    """The scenario's file; a dictionary becomes a temporary one. JSON is also YAML."""
    if not isinstance(scenario, Mapping):
        yield os.fspath(scenario)
        return
    with tempfile.TemporaryDirectory(prefix="autoref-") as folder:
        file = Path(folder, "scenario.yaml")
        file.write_text(json.dumps(dict(scenario)), encoding="utf-8")
        yield str(file)


def play(
    a: Player,
    b: Player,
    *,
    seed: int = 1,
    settings: Mapping[str, Any] | None = None,
    events: PathLike | None = None,
    log: PathLike | None = None,
    view: PathLike | None = None,
    record: PathLike | None = None,
) -> GameResult:
    """Plays one game of a against b.

    a, b: a strategy such as "basic", a .py file, a subclass of Team (its file must call run() at
        the end), the words of a command, or a dictionary of a team's keys.
    settings: keys and values, such as {"match.half_s": 60}; docs/scenarios.md lists the keys.
    events, log, view, record: files to write, as in `autoref play --help`.

    Raises AutorefError if the input is wrong. A game in which a team fails is void.
    """
    scenario = {"schema": 1, "kind": "game", "seed": seed, "teams": {"a": team_settings(a), "b": team_settings(b)}}
    files = {"events": events, "log": log, "view": view, "record": record}
    with _scenario_file(scenario) as file:
        words = ["play", file, "--json", *_options(settings or {}, files)]
        details = json.loads(_run_program(words, good_codes=(0, 3)))
    names = [name for name in GameResult.__dataclass_fields__ if name != "details"]
    return GameResult(**{name: details[name] for name in names}, details=details)


def run(
    experiment: Mapping[str, Any] | PathLike,
    output: PathLike,
    *,
    settings: Mapping[str, Any] | None = None,
    workers: int | None = None,
    pairs: int | None = None,
    seed: int | None = None,
) -> Run:
    """Plays an experiment's games and writes its tables into the folder `output`.

    experiment: a scenario file or a dictionary with its keys.
    workers: games in parallel; one per processor unless given.
    pairs, seed: override those of the experiment.

    Raises AutorefError if the input is wrong or too many games are void. After an interruption,
    call it again to continue.
    """
    options = {"output": output, "workers": workers, "pairs": pairs, "seed": seed}
    with _scenario_file(experiment) as file:
        _run_program(["run", file, "--quiet", *_options(settings or {}, options)])
    return Run(Path(output))
