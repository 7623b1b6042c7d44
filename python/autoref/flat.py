"""Flat records: the fastest encoding."""
from __future__ import annotations

import functools
import struct
from typing import BinaryIO

from .messages import Abilities, End, Field, Next, Output, Play, Robots, Start, View, ball_from, robot_from

_FRAME = 2
_START = struct.Struct("<6xHQ15d?3x3I56s")
_ABILITIES = struct.Struct("<5d")
_NUMBER = struct.Struct("<56sd")
_VIEW = struct.Struct("<6xHq14d2iB??BB???BBH4x")
_ROBOT = struct.Struct("<7di?3x")
_END = struct.Struct("<8xii56s")
_OUTPUTS = [struct.Struct("<IHHqiiHHI" + "4di??H" * commands) for commands in range(17)]
_PLAYS = list(Play)
_NEXT: dict[int, Next] = dict(enumerate(Next))
_PLACING = (None, False, True)


def _text(raw: bytes) -> str:
    return raw[: raw.index(b"\0")].decode(errors="replace")


def _robots(data: bytes, own: int) -> Robots:
    robots = list(map(robot_from, _ROBOT.iter_unpack(data[_VIEW.size :])))
    return robots[:own], robots[own:]


def _view(data: bytes) -> View:
    (
        is_detections,
        frame,
        time_s,
        latency_s,
        stage_time_left_s,
        placement_x_m,
        placement_y_m,
        ball_x_m,
        ball_y_m,
        ball_vx_mps,
        ball_vy_mps,
        height_m,
        deviation_m,
        camera_x_m,
        camera_y_m,
        camera_height_m,
        goals_own,
        goals_opponent,
        play,
        ours,
        has_placement,
        placing,
        following,
        next_is_ours,
        has_ball,
        is_height_known,
        own,
        _,
        in_zone,
    ) = _VIEW.unpack_from(data)
    ball = None
    if has_ball:
        ball = ball_from(
            (
                ball_x_m,
                ball_y_m,
                ball_vx_mps,
                ball_vy_mps,
                None if is_detections and not is_height_known else height_m,
                deviation_m,
                camera_x_m,
                camera_y_m,
                camera_height_m,
                is_height_known,
            )
        )
    return View(
        frame,
        time_s,
        latency_s,
        stage_time_left_s,
        placement_x_m if has_placement else None,
        placement_y_m if has_placement else None,
        goals_own,
        goals_opponent,
        _PLAYS[play],
        ours,
        _PLACING[placing],
        _NEXT.get(following),
        next_is_ours,
        ball,
        [robot for robot in range(16) if in_zone >> robot & 1] if in_zone else [],
        functools.partial(_robots, data, own),
    )


def _start(data: bytes) -> Start:
    side, seed, frame_rate_hz, latency_s, *lengths = _START.unpack_from(data)
    *field, robots, rule_numbers, _, rules = lengths
    end = _START.size + robots * _ABILITIES.size
    abilities = [Abilities(*values) for values in _ABILITIES.iter_unpack(data[_START.size : end])]
    numbers = [(_text(name), value) for name, value in _NUMBER.iter_unpack(data[end:])]
    return Start(
        ("west", "east")[side],
        seed,
        frame_rate_hz,
        latency_s,
        Field(*field),
        abilities,
        _text(rules),
        dict(numbers[:rule_numbers]),
        dict(numbers[rule_numbers:]),
    )


def _end(data: bytes) -> End:
    goals_own, goals_opponent, reason = _END.unpack(data)
    return End(goals_own, goals_opponent, _text(reason))


def read(stream: BinaryIO) -> bytes:
    """The next message; empty at the end of the stream."""
    length = stream.read(4)
    return length + stream.read(int.from_bytes(length, "little") - 4) if length else b""


def decode(data: bytes) -> Start | View | End:
    """The message in these bytes."""
    kind = data[4]
    if kind == _FRAME:
        return _view(data)
    return _start(data) if kind < _FRAME else _end(data)


def encode(output: Output) -> bytes:
    """The bytes of an answer."""
    commands = output.commands
    values: list[float] = []
    for robot, command in commands.items():
        values += (
            command.vx_mps,
            command.vy_mps,
            command.angular_velocity_radps,
            command.kick_mps,
            robot,
            command.chip,
            command.dribble,
            0,
        )
    text = output.text.encode() if output.text else b""
    record = _OUTPUTS[len(commands)]
    return (
        record.pack(
            record.size + len(text),
            4,
            output.timeout,
            output.frame,
            output.keeper,
            -1 if output.leaves is None else output.leaves,
            len(commands),
            len(text),
            0,
            *values,
        )
        + text
    )
