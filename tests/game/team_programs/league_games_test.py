#!/usr/bin/env python3
"""Plays games of a team that knows only the league's messages.

usage: league_games_test.py AUTOREF SCENARIO LEAGUE_TEAM LEAGUE_ADAPTER

By the pipe, and by UDP through the adapter, the same team must play the same game, and win it.
"""
import json
import random
import shlex
import socket
import subprocess
import sys

GROUPS = "224.5.23.2", "224.5.23.1", "127.0.0.1"


def bind_to_free_port(udp):
    """The port is below those that Linux gives to sockets without a port of their own."""
    while True:
        try:
            return udp.bind(("", random.randrange(21_000, 30_000)))
        except OSError:
            continue


def free_addresses():
    """An address of each group whose port nobody uses at the moment."""
    sockets = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in GROUPS]
    for udp in sockets:
        bind_to_free_port(udp)
    addresses = [f"{host}:{udp.getsockname()[1]}" for host, udp in zip(GROUPS, sockets)]
    for udp in sockets:
        udp.close()
    return addresses


def played(autoref, scenario, side, command):
    settings = [
        f"a.command={shlex.join(command)}",
        f"match.a_plays={side}",
        "a.answer_s=120",
        "b.strategy=dummy",
        "match.half_s=10",
        "sim.vision.cameras=1",
    ]
    arguments = [autoref, "play", scenario, "--json"]
    for setting in settings:
        arguments += ["--set", setting]
    game = json.loads(subprocess.run(arguments, stdout=subprocess.PIPE, timeout=240).stdout)
    assert game["status"] == "ok", game["void_reason"]
    return game


def check(side, autoref, scenario, team, adapter):
    by_pipe = played(autoref, scenario, side, ["python3", team, "pipe"])
    addresses = free_addresses()
    by_udp = played(
        autoref, scenario, side, ["python3", adapter, *addresses, "python3", team, "udp", "COLOUR", *addresses]
    )
    print(
        f"{side}: {by_pipe['goals_a']} to {by_pipe['goals_b']} by pipe, "
        f"{by_udp['goals_a']} to {by_udp['goals_b']} by UDP"
    )
    assert by_pipe["goals_a"] > by_pipe["goals_b"]
    assert by_pipe["state_hash"] == by_udp["state_hash"]


for end in ("west", "east"):
    check(end, *sys.argv[1:])
