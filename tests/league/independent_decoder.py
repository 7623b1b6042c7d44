#!/usr/bin/env python3
"""Reads a log of `autoref play` without any of this project's code and compares it with the game.

usage: independent_decoder.py AUTOREF SCENARIO

The framing is decoded with struct, the messages with the descriptors written out below, using
the league's names and numbers. Needs Debian's python3-protobuf.
"""
import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

from google.protobuf import descriptor_pb2, descriptor_pool

REFEREE, VISION = 3, 4
COMMANDS = """HALT STOP NORMAL_START FORCE_START PREPARE_KICKOFF_YELLOW PREPARE_KICKOFF_BLUE
PREPARE_PENALTY_YELLOW PREPARE_PENALTY_BLUE DIRECT_FREE_YELLOW DIRECT_FREE_BLUE INDIRECT_FREE_YELLOW
INDIRECT_FREE_BLUE TIMEOUT_YELLOW TIMEOUT_BLUE GOAL_YELLOW GOAL_BLUE BALL_PLACEMENT_YELLOW
BALL_PLACEMENT_BLUE""".split()

# message -> "label type name number"; label r required, o optional, m repeated.
MESSAGES = {
    "SSL_DetectionBall": "r float confidence 1; o uint32 area 2; r float x 3; r float y 4; o float z 5;"
    "r float pixel_x 6; r float pixel_y 7",
    "SSL_DetectionRobot": "r float confidence 1; o uint32 robot_id 2; r float x 3; r float y 4;"
    "o float orientation 5; r float pixel_x 6; r float pixel_y 7; o float height 8",
    "SSL_DetectionFrame": "r uint32 frame_number 1; r double t_capture 2; r double t_sent 3;"
    "r uint32 camera_id 4; m SSL_DetectionBall balls 5;"
    "m SSL_DetectionRobot robots_yellow 6; m SSL_DetectionRobot robots_blue 7",
    "SSL_GeometryFieldSize": "r int32 field_length 1; r int32 field_width 2; r int32 goal_width 3;"
    "r int32 goal_depth 4; r int32 boundary_width 5",
    "SSL_GeometryData": "r SSL_GeometryFieldSize field 1",
    "SSL_WrapperPacket": "o SSL_DetectionFrame detection 1; o SSL_GeometryData geometry 2",
    "TeamInfo": "r string name 1; r uint32 score 2; r uint32 red_cards 3; r uint32 yellow_cards 5;"
    "r uint32 timeouts 6; r uint32 timeout_time 7; r uint32 goalkeeper 8",
    "Vector2": "r float x 1; r float y 2",
    "BallLeftField": "r int32 by_team 1; o uint32 by_bot 2; o Vector2 location 3",
    "Goal": "r int32 by_team 1; o uint32 kicking_bot 2; o Vector2 location 3; o Vector2 kick_location 4;"
    "o float max_ball_height 5; o int32 kicking_team 6; o uint32 num_robots_by_team 7;"
    "o uint64 last_touch_by_team 8; o string message 9",
    "GameEvent": "o int32 type 40; m string origin 41; o uint64 created_timestamp 49; o string id 50;"
    "o BallLeftField ball_left_field_touch_line 6; o BallLeftField ball_left_field_goal_line 7;"
    "o Goal possible_goal 39",
    "SSL_Referee": "r uint64 packet_timestamp 1; r int32 stage 2; o sint32 stage_time_left 3;"
    "r int32 command 4; r uint32 command_counter 5; r uint64 command_timestamp 6;"
    "r TeamInfo yellow 7; r TeamInfo blue 8; m GameEvent game_events 16",
}
# Numbers in GameEvent.Type and names of fields.
PARTS = {6: "ball_left_field_touch_line", 7: "ball_left_field_goal_line", 39: "possible_goal"}
TYPES = {name.upper(): number for number, name in PARTS.items()}
# Types of the paper's rules whose parts are not read here.
LEAGUE_TYPES = {"ATTACKER_TOO_CLOSE_TO_DEFENSE_AREA": 19, "NO_PROGRESS_IN_GAME": 2}


def message_classes():
    from google.protobuf import message_factory

    field_type = descriptor_pb2.FieldDescriptorProto
    labels = {"r": field_type.LABEL_REQUIRED, "o": field_type.LABEL_OPTIONAL, "m": field_type.LABEL_REPEATED}
    file = descriptor_pb2.FileDescriptorProto(name="league.proto", syntax="proto2")
    for name, fields in MESSAGES.items():
        message = file.message_type.add(name=name)
        for field in fields.split(";"):
            label, kind, field_name, number = field.split()
            added = message.field.add(name=field_name, number=int(number), label=labels[label])
            if kind in MESSAGES:
                added.type, added.type_name = field_type.TYPE_MESSAGE, kind
            else:
                added.type = getattr(field_type, "TYPE_" + kind.upper())
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    factory = message_factory.MessageFactory(pool)
    return [factory.GetPrototype(pool.FindMessageTypeByName(name)) for name in ("SSL_WrapperPacket", "SSL_Referee")]


def records(path):
    with gzip.open(path, "rb") as file:
        assert file.read(12) == b"SSL_LOG_FILE"
        assert struct.unpack(">i", file.read(4)) == (1,)
        while head := file.read(16):
            time_ns, kind, size = struct.unpack(">qii", head)
            yield time_ns, kind, file.read(size)


def read(path):
    Wrapper, Referee = message_classes()
    story = {"frames": set(), "commands": [], "robots": set(), "balls": 0, "last": None, "events": {}}
    counter = None
    for time_ns, kind, payload in records(path):
        if kind == VISION:
            packet = Wrapper.FromString(payload)
            if packet.HasField("geometry"):
                story["field"] = (packet.geometry.field.field_length, packet.geometry.field.field_width)
            if packet.HasField("detection"):
                frame = packet.detection
                assert abs(frame.t_capture * 1e9 - time_ns) < 1000
                story["frames"].add(frame.frame_number)
                story["balls"] += len(frame.balls)
                story["robots"] |= {("yellow", r.robot_id) for r in frame.robots_yellow}
                story["robots"] |= {("blue", r.robot_id) for r in frame.robots_blue}
        elif kind == REFEREE:
            packet = Referee.FromString(payload)
            assert len(payload) < 1024
            for event in packet.game_events:
                story["events"][event.id] = event
            if packet.command_counter != counter:
                counter = packet.command_counter
                story["commands"].append(COMMANDS[packet.command])
            story["last"] = packet
    return story


def event_summary(event):
    """The time, type, team and place of an event in the log."""
    part = getattr(event, PARTS[event.type]) if event.type in PARTS else None
    place = (round(part.location.x, 3), round(part.location.y, 3)) if part else None
    return (event.created_timestamp, event.type, part.by_team if part else None, place)


def summary_of(call):
    """The same of a decision; only the type's name is known of events without a part above."""
    kind = TYPES.get(call["league_event"])
    place = tuple(round(x, 3) for x in call["position_m"]) if kind else None
    team = {"yellow": 1, "blue": 2, "unknown": 0}
    if kind == 39:
        by_team = {"PREPARE_KICKOFF_YELLOW": 2, "PREPARE_KICKOFF_BLUE": 1}[call["restart"]]
    else:
        by_team = team[call["last_touch"]["colour"]] if kind else None
    return (round(call["time_s"] * 1e6), kind or LEAGUE_TYPES[call["league_event"]], by_team, place)


def main():
    autoref, scenario = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        log, events = pathlib.Path(folder) / "game.log.gz", pathlib.Path(folder) / "events.jsonl"
        text = subprocess.run(
            [
                autoref,
                "play",
                scenario,
                "--set",
                "match.half_s=60",
                "--set",
                "b.robots=4",
                "--json",
                "--log",
                log,
                "--events",
                events,
            ],
            check=True,
            capture_output=True,
            text=True,
            timeout=300,
        ).stdout
        game = json.loads(text)
        decisions = [json.loads(line) for line in events.read_text().splitlines()]
        story = read(log)
    sent = [decision["command"] for decision in decisions if decision["command"]]
    called = [decision for decision in decisions if decision["league_event"]]
    last = story["last"]
    read_events = list(story["events"].values())
    # The last frame is refereed, which ends the game; no sub-step is simulated after it.
    frames = round(game["sim_s"] * 60)
    checks = {
        "frames": (story["frames"], set(range(frames + 1))),
        "commands": (story["commands"], sent),
        "goals": ([last.yellow.score, last.blue.score], [game["goals_a"], game["goals_b"]]),
        "names": ([last.yellow.name, last.blue.name], ["basic (a)", "basic (b)"]),
        "robots": (len(story["robots"]), 10),
        "field": (story["field"], (6050, 4050)),
        "events": ([event_summary(event) for event in read_events], [summary_of(call) for call in called]),
        "balls": (story["balls"] > 0.9 * frames, True),
    }
    wrong = {name: pair for name, pair in checks.items() if pair[0] != pair[1]}
    for name, (read_value, expected) in wrong.items():
        print(f"{name}: the log has {str(read_value)[:300]}, the game {str(expected)[:300]}")
    print(f"{len(story['frames'])} frames, {len(story['commands'])} commands read")
    return 1 if wrong else 0


sys.exit(main())
