#!/usr/bin/env python3
"""Measures autoref.Team: time per frame as a ratio to a bare echo of the same bytes in Python.

    benchmarks/python_team.py [FRAMES]

It records the frames of a game of 6 against 6 robots, then sends them to a process and waits for
each answer, as a game does. That process is either a team that sends 6 commands, constant ones or
after reading all robots, or an echo: os.read() and os.write() of constant bytes, as many as the
team sends. They run in turns on one processor, so that waking up another one does not
count; of each turn the median of its frames counts, and of the turns the least.
"""
from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))
import autoref  # noqa: E402
from autoref.team import codec_of  # noqa: E402

_TURNS = 7
_ENCODINGS = ("flat", "json")


class Constant(autoref.Team):
    """Costs nothing itself: the ratio is that of the package."""

    _commands = {number: autoref.Command(0.5, -0.25, 1.5, 6.0, False, True) for number in range(6)}

    def decide(self, view: autoref.View) -> dict[int, autoref.Command]:
        """Six commands, always the same objects."""
        return self._commands


class Reader(autoref.Team):
    """Reads the motion of all robots and makes a new command for each of its own."""

    def decide(self, view: autoref.View) -> dict[int, autoref.Command]:
        """About the least that a real team does."""
        own, _ = view.own, view.opponents
        return {robot.number: autoref.Command(0.5, -0.25, 1.5, 6.0, False, True) for robot in own}


_TEAMS = {"constant": Constant, "reader": Reader}


def _record(encoding: str, file: str) -> None:
    """A team that writes what it is sent into a file and never moves."""
    codec = codec_of(encoding)
    os.write(1, f"autoref-team 1 {encoding}\n".encode())
    source = sys.stdin.buffer
    with open(file, "wb") as copy:
        while data := codec.read(source):
            message = codec.decode(data)
            if isinstance(message, autoref.View):
                os.write(1, codec.encode(autoref.Output(message.frame, {})))
            copy.write(len(data).to_bytes(4, "little") + data)


def _echo(size: int) -> None:
    answer = bytes(size)
    while os.read(0, 1 << 16):
        os.write(1, answer)


def _frames(encoding: str, folder: str, count: int) -> list[bytes]:
    """START and frames as a game sends them."""
    file = os.path.join(folder, encoding)
    autoref.play([sys.executable, __file__, "record", encoding, file], "basic", settings={"match.half_s": 30})
    messages = []
    with open(file, "rb") as stream:
        while length := stream.read(4):
            messages.append(stream.read(int.from_bytes(length, "little")))
    return messages[:-1][: count + 1]


def _turn(arguments: list[str], messages: list[bytes]) -> tuple[float, int]:
    """Microseconds per frame, and bytes of one answer."""
    process = subprocess.Popen(
        [sys.executable, __file__, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0
    )
    assert process.stdin and process.stdout
    sink, source = process.stdin.fileno(), process.stdout.fileno()
    if arguments[0] == "team":
        os.read(source, 100)
        os.write(sink, messages[0])
    answer = b""
    times_ns = []
    for message in messages[1:]:
        begin_ns = time.perf_counter_ns()
        os.write(sink, message)
        answer = os.read(source, 1 << 16)
        times_ns.append(time.perf_counter_ns() - begin_ns)
    process.stdin.close()
    process.wait()
    process.stdout.close()
    return statistics.median(times_ns) / 1000, len(answer)


def _measure(encoding: str, messages: list[bytes]) -> None:
    _, size = _turn(["team", encoding, "reader"], messages)
    roles = [["team", encoding, "constant"], ["team", encoding, "reader"], ["echo", str(size)]]
    turns = [[_turn(role, messages)[0] for role in roles] for _ in range(_TURNS)]
    constant, reader, echo = (min(times) for times in zip(*turns))
    print(
        f"{encoding:<9} {len(messages[-1]):6} {size:7} {echo:8.1f} {constant:12.1f} "
        f"{constant / echo:6.2f} {reader:10.1f} {reader / echo:6.2f}"
    )


def main() -> None:
    """Prints the table, or is one of the processes."""
    role = sys.argv[1] if len(sys.argv) > 1 else ""
    if role == "team":
        _TEAMS[sys.argv[3]].run(sys.argv[2])
    elif role == "echo":
        _echo(int(sys.argv[2]))
    elif role == "record":
        _record(sys.argv[2], sys.argv[3])
    else:
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])
        print("encoding   frame  answer  echo us  constant us  ratio  reader us  ratio")
        with tempfile.TemporaryDirectory() as folder:
            os.chmod(folder, 0o777)  # if AutoRef runs as root, it starts programs as another user
            for encoding in _ENCODINGS:
                _measure(encoding, _frames(encoding, folder, int(role or 3000)))


if __name__ == "__main__":
    main()
