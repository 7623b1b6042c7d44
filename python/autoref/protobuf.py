"""Protobuf: TeamInput and TeamOutput of league/messages/team.proto. Needs python3-protobuf."""
from __future__ import annotations

import functools
import operator
import struct
from typing import Any, BinaryIO

from .messages import Abilities, Ball, End, Field, Next, Output, Play, Robot, Robots, Start, View, ball_from, robot_from
from .team_proto import TeamFrame, TeamInput, TeamRobot

_FRAME_TAG = 0x12
_BYTES = [bytes([number]) for number in range(256)]
_PLAYS = list(Play)
_NEXT = list(Next)
_ball_values = operator.attrgetter(*Ball._fields)
_field_values = operator.attrgetter(*Field._fields)
_ability_values = operator.attrgetter(*Abilities._fields)
_motion = operator.attrgetter(*Robot._fields)
_frame_values = operator.attrgetter(
    "frame", "time_s", "latency_s", "stage_time_left_s", "goals_own", "goals_opponent", "play", "ours", "next_is_ours"
)

# A tracked robot has all members of TeamRobot, in their order, each with its tag before it.
_ROBOT = struct.Struct("<xB" + "xd" * 7 + "x?")

# An answer is written without the library, several times as fast: a command is 42 bytes, each value
# with its tag before it; then the scalars of TeamOutput.
_COMMAND = "BBBB" + "Bd" * 4 + "B?" * 2
_OUTPUTS = [struct.Struct("<" + _COMMAND * commands) for commands in range(17)]


def _robot(data: bytes) -> Robot:
    if len(data) != _ROBOT.size:  # a detection
        return Robot._make(_motion(TeamRobot.FromString(data)))._replace(is_seen=True)
    (number, x_m, y_m, heading_x, heading_y, vx_mps, vy_mps, turn_radps, is_seen) = _ROBOT.unpack(data)
    return robot_from((x_m, y_m, heading_x, heading_y, vx_mps, vy_mps, turn_radps, number, is_seen))


def _robots(frame: Any) -> Robots:
    return [_robot(data) for data in frame.own], [_robot(data) for data in frame.opponents]


def _ball(frame: Any) -> Ball | None:
    if not frame.HasField("ball"):
        return None
    message = frame.ball
    ball = ball_from(_ball_values(message))
    if message.HasField("is_height_known"):
        return ball
    if message.HasField("height_m"):
        return ball._replace(is_height_known=True)
    return ball._replace(height_m=None)


def _view(frame: Any) -> View:
    has = frame.HasField
    is_placed = has("placement_x_m")
    (number, time_s, latency_s, stage_time_left_s, goals_own, goals_opponent, play, ours, next_is_ours) = _frame_values(
        frame
    )
    return View(
        number,
        time_s,
        latency_s,
        stage_time_left_s,
        frame.placement_x_m if is_placed else None,
        frame.placement_y_m if is_placed else None,
        goals_own,
        goals_opponent,
        _PLAYS[play],
        ours,
        frame.placing_is_ours if has("placing_is_ours") else None,
        _NEXT[frame.next] if has("next") else None,
        next_is_ours,
        _ball(frame),
        list(frame.ball_in_dribbler_zone),
        functools.partial(_robots, frame),
    )


def _start(start: Any) -> Start:
    def numbers(entries: Any) -> dict[str, float]:
        return {entry.name.decode(errors="replace"): entry.value for entry in entries}

    return Start(
        ("west", "east")[start.side],
        start.random_seed,
        start.frame_rate_hz,
        start.latency_s,
        Field._make(_field_values(start.field)),
        [Abilities._make(_ability_values(robot)) for robot in start.robots],
        start.rules.decode(errors="replace"),
        numbers(start.rule_numbers),
        numbers(start.params),
    )


def _varint(number: int) -> bytes:
    if 0 <= number < 128:
        return _BYTES[number]
    number &= 2**64 - 1
    return _BYTES[number & 127 | 128] + _varint(number >> 7)


def read(stream: BinaryIO) -> bytes:
    """The next message; empty at the end of the stream."""
    length = shift = 0
    while byte := stream.read(1):
        bits = byte[0]
        if bits < 128:
            return stream.read(length | bits << shift)
        length |= (bits & 127) << shift
        shift += 7
    return b""


def decode(data: bytes) -> Start | View | End:
    """The message in these bytes."""
    if data[0] == _FRAME_TAG:
        begin = 2
        while data[begin - 1] > 127:  # the frame's length
            begin += 1
        return _view(TeamFrame.FromString(data[begin:]))
    message = TeamInput.FromString(data)
    if message.HasField("start"):
        return _start(message.start)
    end = message.end
    return End(end.goals_own, end.goals_opponent, end.reason.decode(errors="replace"))


def encode(output: Output) -> bytes:
    """The bytes of an answer."""
    values: list[float] = []
    for robot, command in output.commands.items():
        values += (
            0x12,
            42,
            0x08,
            robot,
            0x11,
            command.vx_mps,
            0x19,
            command.vy_mps,
            0x21,
            command.angular_velocity_radps,
            0x29,
            command.kick_mps,
            0x30,
            command.chip,
            0x38,
            command.dribble,
        )
    data = b"\x08" + _varint(output.frame) + _OUTPUTS[len(output.commands)].pack(*values)
    if output.keeper:
        data += b"\x18" + _varint(output.keeper)
    if output.leaves is not None:
        data += b"\x20" + _varint(output.leaves)
    if output.timeout:
        data += b"\x28\x01"
    if output.text:
        text = output.text.encode()
        data += b"\x32" + _varint(len(text)) + text
    return _varint(len(data)) + data
