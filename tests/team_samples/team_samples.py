#!/usr/bin/env python3
"""Decodes and encodes the messages of teams' programs without any of this project's code.

usage: team_samples.py TEAM_SAMPLES

TEAM_SAMPLES writes the same messages as JSON and as flat records; decoded with json and struct,
they must agree in every bit. It then reads outputs that are written here in both encodings. Layouts
and names are those of docs/team-programs.md.
"""
import json
import random
import struct
import subprocess
import sys

PLAYS = [
    "HALT",
    "STOP",
    "PREPARE_KICKOFF",
    "PREPARE_PENALTY",
    "KICKOFF",
    "PENALTY",
    "DIRECT_FREE",
    "INDIRECT_FREE",
    "RUNNING",
]
COMMANDS = [
    "HALT",
    "STOP",
    "NORMAL_START",
    "FORCE_START",
    "PREPARE_KICKOFF",
    "PREPARE_PENALTY",
    "DIRECT_FREE",
    "INDIRECT_FREE",
    "TIMEOUT",
    "GOAL",
    "BALL_PLACEMENT",
]
FIELD = """length_m width_m run_off_m line_width_m centre_circle_radius_m penalty_mark_m
defence_area_depth_m defence_area_straight_m goal_width_m goal_depth_m goal_opening_height_m
goal_bar_radius_m goal_wall_thickness_m""".split()
ABILITIES = "speed_mps acceleration_mps2 braking_mps2 kick_mps chip_mps".split()
POSE = "x_m y_m heading_x heading_y".split()
MOTION = "vx_mps vy_mps angular_velocity_radps".split()


def text(raw):
    return raw[: raw.index(b"\0")].decode()


def flat_start(record):
    head = struct.unpack_from("<IHHQ15d4I56s", record)
    start = {
        "side": ["west", "east"][head[2]],
        "random_seed": str(head[3]),
        "frame_rate_hz": head[4],
        "latency_s": head[5],
    }
    start["field"] = dict(zip(FIELD, head[6:19]), defence_area_is_box=bool(head[19]))
    robots, rules, params = head[20:23]
    at = 208
    start["robots"] = [dict(zip(ABILITIES, struct.unpack_from("<5d", record, at + 40 * i))) for i in range(robots)]
    at += 40 * robots
    numbers = [struct.unpack_from("<56sd", record, at + 64 * i) for i in range(rules + params)]
    assert at + 64 * (rules + params) == len(record)
    start["rules"] = text(head[23])
    start["rule_numbers"] = {text(name): value for name, value in numbers[:rules]}
    start["params"] = {text(name): value for name, value in numbers[rules:]}
    return start


def flat_robot(record, at, is_detection):
    values = struct.unpack_from("<7diI", record, at)
    robot = dict(zip(POSE, values), number=values[7])
    if not is_detection:
        robot.update(zip(MOTION, values[4:7]), is_seen=bool(values[8]))
    return robot


def flat_ball(head, is_detection):
    if not head[-6]:
        return None
    names = "x_m y_m vx_mps vy_mps height_m height_deviation_m camera_x_m camera_y_m camera_height_m"
    ball = dict(zip(names.split(), head[9:18]), is_height_known=bool(head[-5]))
    if is_detection:
        if not ball["is_height_known"]:
            ball["height_m"] = None
        unused = "vx_mps vy_mps height_deviation_m is_height_known"
    else:
        unused = "camera_x_m camera_y_m camera_height_m"
    for name in unused.split():
        del ball[name]
    return ball


def flat_frame(record):
    head = struct.unpack_from("<IHHq14d2i10BHI", record)
    is_detection = bool(head[2])
    play, ours, has_placement, placing, following, next_is_ours = head[20:26]
    own, opponents, in_zone = head[-4:-1]
    frame = {
        "frame": head[3],
        "time_s": head[4],
        "latency_s": head[5],
        "stage_time_left_s": head[6],
        "placement_x_m": head[7] if has_placement else None,
        "placement_y_m": head[8] if has_placement else None,
        "goals_own": head[18],
        "goals_opponent": head[19],
        "play": PLAYS[play],
        "ours": bool(ours),
        "placing_is_ours": [None, False, True][placing],
        "next": None if following == 255 else COMMANDS[following],
        "next_is_ours": bool(next_is_ours),
        "ball": flat_ball(head, is_detection),
        "ball_in_dribbler_zone": [i for i in range(16) if in_zone >> i & 1],
    }
    robots = [flat_robot(record, 152 + 64 * i, is_detection) for i in range(own + opponents)]
    assert len(record) == 152 + 64 * len(robots)
    frame["own"], frame["opponents"] = robots[:own], robots[own:]
    return frame


def flat_end(record):
    head = struct.unpack("<IHHii56s", record)
    return {"goals_own": head[3], "goals_opponent": head[4], "reason": text(head[5])}


def flat_messages(data):
    readers = {1: ("start", flat_start), 2: ("frame", flat_frame), 3: ("end", flat_end)}
    at = 0
    while at < len(data):
        length, kind = struct.unpack_from("<IH", data, at)
        name, read = readers[kind]
        yield {name: read(data[at : at + length])}
        at += length


def exact(value):
    """The value with its doubles in hexadecimal, which shows every bit."""
    if isinstance(value, dict):
        return {name: exact(member) for name, member in value.items()}
    if isinstance(value, list):
        return [exact(element) for element in value]
    return value.hex() if isinstance(value, float) else value


def compare_inputs(program):
    written = {
        encoding: subprocess.run([program, "write", encoding], check=True, stdout=subprocess.PIPE).stdout
        for encoding in ("json", "flat")
    }
    from_json = [json.loads(line) for line in written["json"].decode().splitlines()]
    from_flat = list(flat_messages(written["flat"]))
    assert len(from_json) == len(from_flat) == 202, (len(from_json), len(from_flat))
    for one, other in zip(from_json, from_flat):
        assert exact(one) == exact(other), f"\n{exact(one)}\n{exact(other)}"


def random_output(draw, frame):
    commands = [
        {
            "robot": robot,
            "vx_mps": draw.uniform(-3, 3),
            "vy_mps": -0.0,
            "angular_velocity_radps": draw.gauss(0, 10),
            "kick_mps": draw.uniform(0, 8),
            "chip": draw.random() < 0.5,
            "dribble": draw.random() < 0.5,
        }
        for robot in draw.sample(range(16), draw.randrange(17))
    ]
    return {
        "frame": frame,
        "commands": commands,
        "keeper": draw.randrange(-1, 16),
        "leaves": draw.randrange(-1, 16),
        "timeout": draw.random() < 0.5,
        "text": f"number-{frame}",
    }


def as_json(output):
    members = dict(output)
    if members["leaves"] == -1:
        members["leaves"] = None
    return json.dumps(members).encode() + b"\n"


def as_flat(output):
    words = output["text"].encode()
    commands = output["commands"]
    return (
        struct.pack(
            "<IHHqiiHHI",
            32 + 40 * len(commands) + len(words),
            4,
            output["timeout"],
            output["frame"],
            output["keeper"],
            output["leaves"],
            len(commands),
            len(words),
            0,
        )
        + b"".join(
            struct.pack(
                "<4diBBH",
                c["vx_mps"],
                c["vy_mps"],
                c["angular_velocity_radps"],
                c["kick_mps"],
                c["robot"],
                c["chip"],
                c["dribble"],
                0,
            )
            for c in commands
        )
        + words
    )


def described(output):
    cells = [
        str(output["frame"]),
        str(output["keeper"]),
        str(output["leaves"]),
        str(int(output["timeout"])),
        output["text"],
    ]
    commands = {command["robot"]: command for command in output["commands"]}
    for robot in range(16):
        command = commands.get(robot, {})
        cells += [
            float(command.get(name, 0)).hex() for name in ("vx_mps", "vy_mps", "angular_velocity_radps", "kick_mps")
        ]
        cells += [str(int(command.get(name, False))) for name in ("chip", "dribble")]
    return cells


def normalised(line):
    """Doubles as Python writes them in hexadecimal."""
    return [float.fromhex(cell).hex() if "0x" in cell else cell for cell in line.split(" ")]


def compare_outputs(program):
    draw = random.Random(5)
    outputs = [random_output(draw, frame) for frame in range(100)]
    for encoding, encode in (("json", as_json), ("flat", as_flat)):
        read = subprocess.run(
            [program, "read", encoding], check=True, stdout=subprocess.PIPE, input=b"".join(map(encode, outputs))
        ).stdout.decode()
        lines = read.splitlines()
        assert len(lines) == len(outputs), (encoding, len(lines))
        for line, output in zip(lines, outputs):
            assert normalised(line) == described(output), f"{encoding}\n{line}\n{output}"


compare_inputs(sys.argv[1])
compare_outputs(sys.argv[1])
