"""Reads the positions in an SSL log that autoref wrote, seen by a camera that reports the ball's height.

Standard library only.
"""

import struct
from array import array
from math import nan

_MAGIC = b"SSL_LOG_FILE\x00\x00\x00\x01"
_RECORD = struct.Struct(">qii")  # time in ns, type, size
_VISION_2014 = 4
# Messages of the league's vision as AutoRef writes them: each number with its tag before it.
_BALL = struct.Struct("<x4x" + "xf" * 3 + "x4x" * 2)  # x, y, height in mm
_ROBOT = struct.Struct("<x4x" + "xB" + "xf" * 3 + "x4x" * 2)  # number; x, y in mm, heading in rad
_BALLS, _ROBOTS = 5, {6: "yellow", 7: "blue"}
_T_CAPTURE = 2
_M_PER_MM = 1e-3


class LogError(Exception):
    """The file is not such a log."""


class Track:
    """Positions of one robot or the ball, one per frame; NaN where it was not seen."""

    def __init__(self, frames=0):
        self.x_m, self.y_m, self.third = (array("d", [nan]) * frames for _ in range(3))  # heading_rad or height_m

    def add_frame(self):
        for column in (self.x_m, self.y_m, self.third):
            column.append(nan)

    def set_last(self, x_m, y_m, third):
        self.x_m[-1], self.y_m[-1], self.third[-1] = x_m, y_m, third


class Positions:
    """Frame by frame: times_s; ball, with its height; robots by (colour, number), with their headings."""

    def __init__(self):
        self.times_s = array("d")
        self.ball = Track()
        self.robots = {}

    def begin_frame(self, time_s):
        self.times_s.append(time_s)
        for track in (self.ball, *self.robots.values()):
            track.add_frame()

    def robot(self, key):
        return self.robots.setdefault(key, Track(len(self.times_s))) if key not in self.robots else self.robots[key]


def _varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, at
        shift += 7


def _fields(data, at, end):
    """The fields of a protobuf message as (number, where its value begins, where it ends)."""
    while at < end:
        tag, at = _varint(data, at)
        kind = tag & 7
        if kind == 0:
            after = _varint(data, at)[1]
        elif kind == 1:
            after = at + 8
        elif kind == 2:
            size, at = _varint(data, at)
            after = at + size
        elif kind == 5:
            after = at + 4
        else:
            raise LogError(f"a vision packet has a field of the unknown kind {kind}")
        yield tag >> 3, at, after
        at = after


def _unpack(layout, data, begin, end):
    if end - begin != layout.size:
        raise LogError("a detection lacks the ball's height or the robot's heading; play with sim.camera=paper")
    return layout.unpack_from(data, begin)


def _add_detections(positions, data, begin, end):
    for number, at, after in _fields(data, begin, end):
        if number == _T_CAPTURE:
            time_s = struct.unpack_from("<d", data, at)[0]
            if not positions.times_s or time_s > positions.times_s[-1]:
                positions.begin_frame(time_s)
        elif number == _BALLS:
            x, y, height = _unpack(_BALL, data, at, after)
            positions.ball.set_last(x * _M_PER_MM, y * _M_PER_MM, height * _M_PER_MM)
        elif number in _ROBOTS:
            robot, x, y, heading_rad = _unpack(_ROBOT, data, at, after)
            positions.robot((_ROBOTS[number], robot)).set_last(x * _M_PER_MM, y * _M_PER_MM, heading_rad)


def positions_in(data):
    """The positions in a log, as bytes. Of cameras that see the same robot, the last one counts."""
    if not data.startswith(_MAGIC):
        raise LogError("not an uncompressed SSL log of version 1")
    try:
        return _read(data)
    except (IndexError, struct.error) as error:
        raise LogError("the log is damaged") from error


def _read(data):
    positions = Positions()
    at = len(_MAGIC)
    while at + _RECORD.size <= len(data):
        _, kind, size = _RECORD.unpack_from(data, at)
        at += _RECORD.size
        if kind == _VISION_2014:
            for number, begin, end in _fields(data, at, at + size):
                if number == 1:  # the detections; 2 is the geometry
                    _add_detections(positions, data, begin, end)
        at += size
    return positions
