"""One JSON object per line: the encoding that people can read."""
from __future__ import annotations

import functools
import json
import operator
from typing import Any, BinaryIO

from .messages import Abilities, Ball, End, Field, Next, Output, Play, Robot, Robots, Start, View

_encode = json.JSONEncoder(separators=(",", ":"), check_circular=False, default=float).encode
_decode = json.JSONDecoder().decode
_PLAYS = {play.value: play for play in Play}
_NEXT: dict[str | None, Next] = {following.value: following for following in Next}
_motion = operator.itemgetter(*Robot._fields)


def _robot(members: dict[str, Any]) -> Robot:
    if "is_seen" in members:
        return Robot._make(_motion(members))
    return Robot(
        members["x_m"],
        members["y_m"],
        members["heading_x"],
        members["heading_y"],
        0.0,
        0.0,
        0.0,
        members["number"],
        True,
    )


def _robots(members: dict[str, Any]) -> Robots:
    return list(map(_robot, members["own"])), list(map(_robot, members["opponents"]))


def _ball(members: dict[str, Any] | None) -> Ball | None:
    if members is None:
        return None
    values = {name: members.get(name, 0.0) for name in Ball._fields}
    values["is_height_known"] = members.get("is_height_known", values["height_m"] is not None)
    return Ball(**values)


def _view(members: dict[str, Any]) -> View:
    return View(
        members["frame"],
        members["time_s"],
        members["latency_s"],
        members["stage_time_left_s"],
        members["placement_x_m"],
        members["placement_y_m"],
        members["goals_own"],
        members["goals_opponent"],
        _PLAYS[members["play"]],
        members["ours"],
        members["placing_is_ours"],
        _NEXT.get(members["next"]),
        members["next_is_ours"],
        _ball(members["ball"]),
        members["ball_in_dribbler_zone"],
        functools.partial(_robots, members),
    )


def _start(members: dict[str, Any]) -> Start:
    values = dict(members)
    values["random_seed"] = int(members["random_seed"])
    values["field"] = Field(**members["field"])
    values["robots"] = [Abilities(**robot) for robot in members["robots"]]
    return Start(**values)


def read(stream: BinaryIO) -> bytes:
    """The next message; empty at the end of the stream."""
    return stream.readline()


def decode(data: bytes) -> Start | View | End:
    """The message in these bytes."""
    message = _decode(data.decode(errors="replace"))
    if "frame" in message:
        return _view(message["frame"])
    return _start(message["start"]) if "start" in message else End(**message["end"])


def encode(output: Output) -> bytes:
    """The bytes of an answer."""
    commands = [
        {
            "robot": robot,
            "vx_mps": command.vx_mps,
            "vy_mps": command.vy_mps,
            "angular_velocity_radps": command.angular_velocity_radps,
            "kick_mps": command.kick_mps,
            "chip": bool(command.chip),
            "dribble": bool(command.dribble),
        }
        for robot, command in output.commands.items()
    ]
    members = {
        "frame": output.frame,
        "commands": commands,
        "keeper": output.keeper,
        "leaves": output.leaves,
        "timeout": bool(output.timeout),
    }
    if output.text:
        members["text"] = output.text
    return _encode(members).encode() + b"\n"
