#!/usr/bin/env python3
"""A stand-in for a team that speaks the league's messages; uses none of this project's code.

usage: league_team.py pipe
       league_team.py udp COLOUR VISION REFEREE CONTROL    addresses: HOST:PORT

The robot nearest to the ball gets behind it and kicks at the goal. Robots with even numbers are sent
global velocities, the others local ones. Messages are read from the wire by the league's numbers. By
UDP, the program answers the first packet of each frame.
"""
import io
import math
import select
import socket
import struct
import sys

HALT, NORMAL_START, FORCE_START, DIRECT_FREE = 0, 2, 3, 8
FORGET_AFTER_FRAMES = 30


def read_varint(stream):
    value = shift = 0
    while True:
        byte = stream.read(1)
        if not byte:
            raise EOFError
        value |= (byte[0] & 127) << shift
        shift += 7
        if byte[0] < 128:
            return value


def parsed(content):
    """The values of a message's fields by their number: varints as integers, the rest as bytes."""
    stream, fields = io.BytesIO(content), {}
    while stream.tell() < len(content):
        key = read_varint(stream)
        wire = key & 7
        value = (
            read_varint(stream) if wire == 0 else stream.read({1: 8, 5: 4}[wire] if wire != 2 else read_varint(stream))
        )
        fields.setdefault(key >> 3, []).append(value)
    return fields


def number(fields, field):
    """A float."""
    return struct.unpack("<f", fields[field][0])[0]


def written_varint(value):
    return bytes([value]) if value < 128 else bytes([value & 127 | 128]) + written_varint(value >> 7)


def nested(field, content):
    return bytes([field << 3 | 2]) + written_varint(len(content)) + content


def floats(*values):
    """Fields 1, 2 and so on."""
    return b"".join(bytes([i << 3 | 5]) + struct.pack("<f", value) for i, value in enumerate(values, 1))


class Team:
    def __init__(self, is_yellow):
        self.is_yellow = is_yellow
        self.robots = {}
        self.seen = {}  # the frame in which a robot was last detected
        self.ball = None
        self.goal_mm = 0
        self.command = HALT
        self.is_forwards = is_yellow
        self.frame = -1

    def see(self, packet):
        """Takes an SSL_WrapperPacket; returns whether it begins a frame."""
        wrapper = parsed(packet)
        if 2 in wrapper:
            field = parsed(parsed(wrapper[2][0])[1][0])
            self.goal_mm = field[1][0] / 2
        if 1 not in wrapper:
            return False
        detection = parsed(wrapper[1][0])
        begins, self.frame = detection[1][0] != self.frame, detection[1][0]
        for robot in map(parsed, detection.get(6 if self.is_yellow else 7, [])):
            self.robots[robot[2][0]] = (number(robot, 3), number(robot, 4), number(robot, 5))
            self.seen[robot[2][0]] = self.frame
        for ball in map(parsed, detection.get(5, [])):
            self.ball = (number(ball, 3), number(ball, 4))
        return begins

    def hear(self, packet):
        """Takes a Referee."""
        referee = parsed(packet)
        self.command = referee[4][0]
        self.is_forwards = self.is_yellow == bool(referee[10][0])

    def may_play(self):
        if self.command in (NORMAL_START, FORCE_START):
            return True
        return DIRECT_FREE <= self.command < DIRECT_FREE + 4 and self.command % 2 == (not self.is_yellow)

    def control(self):
        """A RobotControl."""
        present = [robot for robot in sorted(self.robots) if self.seen[robot] > self.frame - FORGET_AFTER_FRAMES]
        if not present or not self.ball or not self.may_play():
            return b""
        distances = {robot: math.dist(self.robots[robot][:2], self.ball) for robot in present}
        nearest = min(distances, key=lambda robot: (distances[robot], robot))
        commands = b""
        for robot in present:
            content = bytes([1 << 3, robot])
            if robot == nearest:
                content += self.attack(robot)
            commands += nested(1, content)
        return commands

    def attack(self, robot):
        x, y, heading = self.robots[robot]
        goal = (self.goal_mm if self.is_forwards else -self.goal_mm, 0)
        aim = math.atan2(goal[1] - self.ball[1], goal[0] - self.ball[0])
        behind = (x - self.ball[0]) * math.cos(aim) + (y - self.ball[1]) * math.sin(aim)
        beside = (y - self.ball[1]) * math.cos(aim) - (x - self.ball[0]) * math.sin(aim)
        is_behind = behind < -50 and abs(beside) < 40
        away = 60 if is_behind else 250
        to = (self.ball[0] - away * math.cos(aim) - x, self.ball[1] - away * math.sin(aim) - y)
        if behind > -100 and not is_behind:  # around the ball, not through it
            side = 250 if beside >= 0 else -250
            to = (to[0] - side * math.sin(aim), to[1] + side * math.cos(aim))
        speed = min(1.5, 0.003 * math.hypot(*to) + 0.1)
        direction = math.atan2(to[1], to[0])
        turn = 4 * math.remainder(aim - heading, 2 * math.pi)
        if robot % 2 == 0:
            move = nested(3, floats(speed * math.cos(direction), speed * math.sin(direction), turn))
        else:
            local = direction - heading
            move = nested(2, floats(speed * math.cos(local), speed * math.sin(local), turn))
        kick = bytes([3 << 3 | 5]) + struct.pack("<f", 6.0)
        return nested(2, move) + (kick if is_behind else b"")


def play_by_pipe():
    """The fields of LeagueInput: 1 vision, 2 referee, 4 is_yellow, 5 frame, 6 end."""
    print("autoref-team 1 league", flush=True)
    pipe, team = sys.stdin.buffer, None
    while True:
        message = parsed(pipe.read(read_varint(pipe)))
        if 6 in message:
            return
        team = team or Team(bool(message[4][0]))
        team.hear(message[2][0])
        for packet in message[1]:
            team.see(packet)
        if 5 in message:
            control = team.control()
            sys.stdout.buffer.write(written_varint(len(control)) + control)
            sys.stdout.buffer.flush()


def listener(host, port):
    udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    udp.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    udp.bind((host, port))
    if host.startswith("224."):
        udp.setsockopt(
            socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(host) + socket.inet_aton("127.0.0.1")
        )
    return udp


def play_by_udp(colour, *addresses):
    ends = [(host, int(port)) for host, port in (text.split(":") for text in addresses)]
    team, vision, referee = Team(colour == "yellow"), listener(*ends[0]), listener(*ends[1])
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    referee.setblocking(False)
    while True:
        packet = vision.recv(65536)
        while select.select([referee], [], [], 0)[0]:
            team.hear(referee.recv(65536))
        if team.see(packet):
            sender.sendto(team.control(), ends[2])


if sys.argv[1] == "pipe":
    play_by_pipe()
else:
    play_by_udp(*sys.argv[2:])
