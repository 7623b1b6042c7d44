"""python3 -m autoref: runs a team, plays a game, or checks the installation."""
from __future__ import annotations

import argparse
import importlib.util
import subprocess
import sys

import autoref


def _teams_in(file: str) -> list[type[autoref.Team]]:
    spec = importlib.util.spec_from_file_location("autoref_team", file)
    if spec is None or spec.loader is None:
        sys.exit(f"{file}: not a file of Python code")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return [
        value
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, autoref.Team) and value.__module__ == spec.name
    ]


def _team(arguments: argparse.Namespace) -> None:
    teams = _teams_in(arguments.file)
    if len(teams) != 1:
        sys.exit(f"{arguments.file}: has {len(teams)} subclasses of autoref.Team instead of one")
    teams[0].run(arguments.encoding, arguments.motion)


def _play(arguments: argparse.Namespace) -> None:
    settings = {key: value for key, _, value in (word.partition("=") for word in arguments.set)}
    game = autoref.play(arguments.a, arguments.b, seed=arguments.seed, settings=settings, view=arguments.view)
    print(f"{game.goals_a} : {game.goals_b}  ({game.end_reason})  state {game.state_hash}")
    if game.void_reason:
        sys.exit(game.void_reason)


def _check(_: argparse.Namespace) -> None:
    program = autoref.program()
    version = subprocess.run([program, "--version"], stdout=subprocess.PIPE, text=True, check=True)
    print(f"program   {program}\nversion   {version.stdout.strip()}")
    print(f"python    {sys.version.split()[0]}, {sys.executable}")
    for module, use in (("numpy", "results()"), ("pandas", "results(pandas=True)")):
        print(f"{module:<16} {_is_there(module)}, for {use}")


def _is_there(module: str) -> str:
    try:
        return "yes" if importlib.util.find_spec(module) else "no"
    except ModuleNotFoundError:
        return "no"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python3 -m autoref", description=__doc__)
    parser.set_defaults(function=lambda _: parser.print_help())
    verbs = parser.add_subparsers(metavar="VERB")
    check = verbs.add_parser("check", help="print where the program is, and versions")
    check.set_defaults(function=_check)
    team = verbs.add_parser("team", help="run the team in a file, as a game does")
    team.add_argument("file", metavar="FILE")
    team.add_argument("--encoding", choices=["flat", "json"], default="flat")
    team.add_argument("--motion", choices=["tracked", "detections"], default="tracked")
    team.set_defaults(function=_team)
    play = verbs.add_parser("play", help="play one game")
    play.add_argument("a", metavar="A", help="a file of Python code or the name of a strategy")
    play.add_argument("b", metavar="B", help="the same for the other team")
    play.add_argument("--seed", type=int, default=1)
    play.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    play.add_argument("--view", metavar="FILE", help="write the game as an HTML page")
    play.set_defaults(function=_play)
    return parser


def main() -> None:
    """Runs the verb of the command line."""
    arguments = _parser().parse_args()
    try:
        arguments.function(arguments)
    except autoref.AutorefError as error:
        text = str(error)
        sys.exit(text if text.startswith("autoref: ") else f"autoref: {text}")


if __name__ == "__main__":
    main()
