"""The messages of league/messages/team.proto as classes of the protobuf library.

They are built from this table instead of by protoc, so that nothing has to be generated. Fields are
numbered from 1 in this order; a star marks repeated fields. Enumerations are read as their numbers,
and the robots of a frame as bytes, so that they are decoded only if the team reads them. A test
compares the table with team.proto.
"""
from __future__ import annotations

from typing import Any

from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

_PACKAGE = "autoref.team"
_MESSAGES = {
    "TeamInput": "TeamStart start, TeamFrame frame, TeamEnd end",
    "TeamStart": """uint32 side, fixed64 random_seed, double frame_rate_hz, double latency_s,
        TeamField field, TeamAbilities* robots, bytes rules, TeamNumber* rule_numbers,
        TeamNumber* params""",
    "TeamField": """double length_m, double width_m, double run_off_m, double line_width_m,
        double centre_circle_radius_m, double penalty_mark_m, double defence_area_depth_m,
        double defence_area_straight_m, double goal_width_m, double goal_depth_m,
        double goal_opening_height_m, double goal_bar_radius_m, double goal_wall_thickness_m,
        bool defence_area_is_box""",
    "TeamAbilities": """double speed_mps, double acceleration_mps2, double braking_mps2,
        double kick_mps, double chip_mps""",
    "TeamNumber": "bytes name, double value",
    "TeamFrame": """int64 frame, double time_s, double latency_s, int32 play, bool ours,
        double placement_x_m, double placement_y_m, bool placing_is_ours, int32 next,
        bool next_is_ours, int32 goals_own, int32 goals_opponent, double stage_time_left_s,
        TeamBall ball, bytes* own, bytes* opponents, uint32* ball_in_dribbler_zone""",
    "TeamBall": """double x_m, double y_m, double vx_mps, double vy_mps, double height_m,
        double height_deviation_m, bool is_height_known, double camera_x_m, double camera_y_m,
        double camera_height_m""",
    "TeamRobot": """uint32 number, double x_m, double y_m, double heading_x, double heading_y,
        double vx_mps, double vy_mps, double angular_velocity_radps, bool is_seen""",
    "TeamEnd": "bytes reason, int32 goals_own, int32 goals_opponent",
    "TeamOutput": """int64 frame, TeamCommand* commands, int32 keeper, uint32 leaves, bool timeout,
        bytes text""",
    "TeamCommand": """uint32 robot, double vx_mps, double vy_mps, double angular_velocity_radps,
        double kick_mps, bool chip, bool dribble""",
}
_Field = descriptor_pb2.FieldDescriptorProto


def _add_field(message: descriptor_pb2.DescriptorProto, kind: str, name: str) -> None:
    field = message.field.add(name=name, number=len(message.field) + 1)
    field.label = _Field.LABEL_REPEATED if kind.endswith("*") else _Field.LABEL_OPTIONAL
    kind = kind.rstrip("*")
    if kind in _MESSAGES:
        field.type = _Field.TYPE_MESSAGE
        field.type_name = f".{_PACKAGE}.{kind}"
    else:
        field.type = _Field.Type.Value("TYPE_" + kind.upper())


def file_description() -> descriptor_pb2.FileDescriptorProto:
    """What protoc would make of the table."""
    file = descriptor_pb2.FileDescriptorProto(name="autoref_team.proto", package=_PACKAGE)
    for name, fields in _MESSAGES.items():
        message = file.message_type.add(name=name)
        for field in fields.split(","):
            _add_field(message, *field.split())
    return file


_pool = descriptor_pool.DescriptorPool()
_pool.Add(file_description())
_factory = message_factory.MessageFactory(_pool)


def _message_class(name: str) -> Any:
    return _factory.GetPrototype(_pool.FindMessageTypeByName(f"{_PACKAGE}.{name}"))


TeamInput = _message_class("TeamInput")
TeamFrame = _message_class("TeamFrame")
TeamRobot = _message_class("TeamRobot")
TeamOutput = _message_class("TeamOutput")
