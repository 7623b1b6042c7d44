"""The base class of teams: derive from it, write decide() and call run()."""
from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Mapping
from typing import Any, BinaryIO

from .messages import Command, End, Output, Start, View
from .random_stream import RandomStream

_MODULES = {"flat": "flat", "json": "json_lines"}
_MOTIONS = ("tracked", "detections")
_MAX_TEXT_BYTES = 1000


def codec_of(encoding: str) -> Any:
    """The module with read(), decode() and encode() for "flat" or "json"."""
    if encoding not in _MODULES:
        raise ValueError(f"unknown encoding {encoding!r}; there are {', '.join(_MODULES)}")
    return importlib.import_module(f".{_MODULES[encoding]}", __package__)


class Team:
    """A team: one object plays one side of one game.

    You can set the requests at any time. `keeper` and `leaves` keep their values; `timeout` and
    `text` apply to one answer.
    """

    start: Start  # set before prepare()
    params: dict[str, float]  # the team's parameters: start.params
    random: RandomStream  # the team's random numbers: the same seed gives the same game

    keeper: int = 0  # robot number of the keeper; -1 if unknown
    leaves: int | None = None  # the robot to remove first after a card
    timeout: bool = False  # request a timeout as soon as play is stopped
    text: str = ""  # for the log, at most 1000 bytes

    def prepare(self) -> None:
        """Called once before the first frame. Does nothing unless you override it."""

    def decide(self, view: View) -> Mapping[int, Command] | None:
        """Returns the commands by robot number. A robot without a command stands still."""
        raise NotImplementedError("a team needs the method decide(self, view)")

    def finish(self, end: End) -> None:
        """Called once after the last frame. Does nothing unless you override it."""

    @classmethod
    def run(cls, encoding: str = "flat", motion: str = "tracked") -> None:
        """Plays one game over standard input and output, and returns after its end.

        encoding: "flat" or "json"; motion: "tracked" or "detections". Anything the team prints
        appears on standard error. Start it with autoref.play(), not from a terminal.
        """
        if motion not in _MOTIONS:
            raise ValueError(f"unknown motion {motion!r}; there are {', '.join(_MOTIONS)}")
        codec = codec_of(encoding)
        if os.isatty(0):
            sys.exit("This is a team; AutoRef starts it. Try: python3 -m autoref play " f"{sys.argv[0]} basic")
        source, sink = _take_standard_streams()
        _write(sink, f"autoref-team 1 {encoding} {motion}\n".encode())
        cls()._play(codec, source, sink)

    def _play(self, codec: Any, source: BinaryIO, sink: int) -> None:
        # These are looked up once, because the loop runs a hundred thousand times in a game.
        read, decode, encode, decide = codec.read, codec.decode, codec.encode, self.decide
        write = os.write
        while data := read(source):
            message = decode(data)
            if type(message) is View:
                commands = decide(message)
                output = Output(message.frame, commands or {}, self.keeper, self.leaves, self.timeout, self.text)
                if output.timeout or output.text:
                    self._end_requests(output)
                data = encode(output)
                sent = write(sink, data)
                if sent < len(data):
                    _write(sink, data[sent:])
            elif type(message) is Start:
                self._begin(message)
            else:
                self.finish(message)
                return

    def _begin(self, start: Start) -> None:
        self.start = start
        self.params = start.params
        self.random = RandomStream(start.random_seed)
        self.prepare()

    def _end_requests(self, output: Output) -> None:
        output.text = output.text.encode()[:_MAX_TEXT_BYTES].decode(errors="ignore")
        self.timeout = False
        self.text = ""


def _write(sink: int, data: bytes) -> None:
    while data:
        data = data[os.write(sink, data) :]


def _take_standard_streams() -> tuple[BinaryIO, int]:
    """Reserves the standard streams for messages: print() then goes to standard error, and input() is empty."""
    source, sink = os.dup(0), os.dup(1)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    return open(source, "rb", buffering=1 << 16), sink
