"""Faults, each with the check that must notice it: check, kind, numbers of the packets, change."""
import good_packets

FIRST, ALL = range(1), range(good_packets.PACKETS)
PLACEMENT = 8, 9
NAN = float("nan")
LOST = b"lost"


def part(message, path):
    """A message and the name of its field."""
    *parents, name = path.split(".")
    for parent in parents:
        message = message[int(parent)] if parent.isdigit() else getattr(message, parent)
    return message, name


def assign(path, value):
    def change(message):
        target, name = part(message, path)
        if name.isdigit():
            target[int(name)] = value
        else:
            setattr(target, name, value)

    return change


def clear(path):
    def change(message):
        target, name = part(message, path)
        target.ClearField(name)

    return change


def extend(path, *values):
    def change(message):
        target, name = part(message, path)
        getattr(target, name).extend(values)

    return change


def repeat(path):
    """The first of a list twice."""

    def change(message):
        target, name = part(message, path)
        getattr(target, name).add().CopyFrom(getattr(target, name)[0])

    return change


def both(first, second):
    def change(message):
        first(message)
        second(message)

    return change


def unknown(message):
    return message.SerializeToString() + b"\xa0\x3f\x01"  # field 1012


def lost(_):
    return LOST


def nowhere(message):
    """A robot's position in metres instead of millimetres."""
    message.ClearField("geometry")
    for thing in (*message.detection.balls, *message.detection.robots_yellow, *message.detection.robots_blue):
        thing.x, thing.y = thing.x / 1000, thing.y / 1000


def later(seconds):
    def change(message):
        message.tracked_frame.timestamp += seconds

    return change


GEOMETRY, FIELD, CAMERA = "geometry", "geometry.field", "geometry.calib.0"
BALL, ROBOT = "detection.balls.0", "detection.robots_blue.2"
TRACK, TRACKED = "tracked_frame.robots.3", "tracked_frame.balls.0"
KICK = "tracked_frame.kicked_ball"
VISION = [
    ("is a message with all required fields", FIRST, clear(BALL + ".confidence")),
    ("fits into a datagram", FIRST, assign(FIELD + ".field_lines.0.name", "x" * 1472)),
    ("no unknown fields", FIRST, unknown),
    ("says something", FIRST, both(clear("detection"), clear("geometry"))),
    ("source is OTHER", FIRST, assign("source", 4)),
    ("packets arrive", ALL, lost),
    ("camera is in the geometry", FIRST, assign("detection.camera_id", 1)),
    ("frame numbers have no gap", [3], lost),
    ("frame numbers have no gap", [3], assign("detection.frame_number", 2)),
    ("time advances", [3], assign("detection.t_capture", good_packets.START_S)),
    ("sent after it was taken", FIRST, assign("detection.t_sent", good_packets.START_S - 1)),
    ("sent after it was taken", FIRST, assign("detection.t_sent", good_packets.START_S + 10)),
    ("the camera's clock agrees", FIRST, assign("detection.t_capture_camera", 17.0)),
    ("geometry once a second", [12], assign("detection.t_capture", good_packets.START_S + 5)),
    ("a robot is seen once", FIRST, assign(ROBOT + ".robot_id", 3)),
    ("x is within the walls", FIRST, assign(BALL + ".x", 6000)),
    ("y is within the walls", FIRST, assign(ROBOT + ".y", NAN)),
    ("pixels are finite", FIRST, assign(BALL + ".pixel_x", NAN)),
    ("ball's confidence", FIRST, assign(BALL + ".confidence", 1.5)),
    ("ball's height", FIRST, assign(BALL + ".z", -1)),
    ("robot has a number", FIRST, clear(ROBOT + ".robot_id")),
    ("robot's number", FIRST, assign(ROBOT + ".robot_id", 16)),
    ("robot's confidence", FIRST, assign(ROBOT + ".confidence", -0.5)),
    ("robot has an orientation", FIRST, clear(ROBOT + ".orientation")),
    ("robot's orientation", FIRST, assign(ROBOT + ".orientation", 180)),
    ("robot's height", FIRST, assign(ROBOT + ".height", 0.145)),
    ("positions are in millimetres", ALL, nowhere),
    *((name, FIRST, assign(f"{FIELD}.{name}", 1)) for name in good_packets.SIZES),
    ("all lines have their names", FIRST, assign(FIELD + ".field_lines.6.name", "PenaltyArea")),
    ("each line once", FIRST, repeat(FIELD + ".field_lines")),
    ("a line's type is that of its name", FIRST, assign(FIELD + ".field_lines.6.type", 9)),
    ("a line's thickness", FIRST, assign(FIELD + ".field_lines.6.thickness", 0.01)),
    ("lines lie where their names say", FIRST, assign(FIELD + ".field_lines.6.p1.x", 3500)),
    ("there is a centre circle", FIRST, clear(FIELD + ".field_arcs")),
    ("the circle's radius", FIRST, assign(FIELD + ".field_arcs.0.radius", 1000)),
    ("the circle is closed", FIRST, assign(FIELD + ".field_arcs.0.a2", 360)),
    ("cameras are calibrated", FIRST, clear("geometry.calib")),
    ("each camera once", FIRST, repeat("geometry.calib")),
    ("focal length in pixels", FIRST, assign(CAMERA + ".focal_length", 0)),
    ("the camera's rotation is a unit quaternion", FIRST, assign(CAMERA + ".q3", 1)),
    ("the camera hangs above the field", FIRST, assign(CAMERA + ".derived_camera_world_tz", 6)),
    ("the derived position is that of the translation", FIRST, assign(CAMERA + ".tx", 100)),
    ("principal point is in the image", FIRST, assign(CAMERA + ".principal_point_y", 2000)),
    ("geometry has both models of the ball", FIRST, clear("geometry.models.chip_fixed_loss")),
    ("deceleration of a sliding ball", FIRST, assign("geometry.models.straight_two_phase.acc_slide", 3.3)),
    ("deceleration of a rolling ball", FIRST, assign("geometry.models.straight_two_phase.acc_roll", -300)),
    ("share of speed when the ball begins to roll", FIRST, assign("geometry.models.straight_two_phase.k_switch", 1.66)),
    ("damping of a chip", FIRST, assign("geometry.models.chip_fixed_loss.damping_z", 0)),
]
START_US = int(good_packets.START_S * 1e6)
REFEREE = [
    ("is a message with all required fields", FIRST, clear("command")),
    ("fits into 1024 bytes", FIRST, assign("status_message", "x" * 1024)),
    ("no unknown fields", FIRST, unknown),
    ("packets arrive", ALL, lost),
    ("times are in microseconds", FIRST, assign("packet_timestamp", START_US // 1000)),
    ("no command is of the future", FIRST, assign("command_timestamp", START_US + 1_000_000)),
    ("time left of the stage", FIRST, assign("stage_time_left", 10**12)),
    ("time left of the action", FIRST, assign("current_action_time_remaining", 10**9)),
    ("no indirect free kicks", [10, 11], assign("command", 11)),
    ("a preparation announces NORMAL_START", [2], clear("next_command")),
    ("play announces nothing", [4], assign("next_command", 1)),
    ("a placement has a position", [8], clear("designated_position")),
    ("the ball is placed on the field", FIRST, assign("designated_position.x", 5000)),
    (
        "the position is in millimetres",
        ALL,
        both(assign("designated_position.x", 0.3), assign("designated_position.y", 0.4)),
    ),
    ("teams have names", FIRST, assign("yellow.name", "")),
    ("keeper's number", FIRST, assign("blue.goalkeeper", 16)),
    ("active cards are among all cards", FIRST, assign("blue.yellow_cards", 0)),
    ("a card lasts two minutes", FIRST, assign("blue.yellow_card_times.0", 121_000_000)),
    ("a robot fewer for each card", FIRST, assign("blue.max_allowed_bots", 6)),
    ("an event has a type", FIRST, clear("game_events.0.type")),
    ("an event's type is that of its field", FIRST, assign("game_events.0.type", 43)),
    ("time does not go back", [5], assign("packet_timestamp", START_US)),
    ("every 25 ms", [4, 5], lost),
    ("stages follow one another", [7], assign("stage", 0)),
    ("a game goes through its stages", range(12, 14), assign("stage", 1)),
    ("ends change between halves", [5], assign("blue_team_on_positive_half", False)),
    ("a stage's time runs down", [5], assign("stage_time_left", 2_000_000)),
    ("one goal at a time", [5], assign("yellow.score", 3)),
    ("cards stay", [5], assign("yellow.yellow_cards", 0)),
    ("names stay", [5], assign("yellow.name", "three")),
    ("the counter grows by one", [5], assign("command_counter", 9)),
    ("a command counts", [5], assign("command", 3)),
    ("a command keeps its time", [5], assign("command_timestamp", START_US)),
    ("a command is of the time of its packet", [4], assign("command_timestamp", START_US)),
    ("the announced command comes", PLACEMENT, assign("next_command", 8)),
]
TRACKER = [
    ("is a message with all required fields", FIRST, clear("uuid")),
    ("fits into a datagram", FIRST, assign("source_name", "x" * 1472)),
    ("no unknown fields", FIRST, unknown),
    ("packets arrive", ALL, lost),
    ("has an identity", FIRST, assign("uuid", "")),
    ("keeps its identity", [1], assign("uuid", "two")),
    ("has a name", FIRST, clear("source_name")),
    ("has a frame", FIRST, clear("tracked_frame")),
    ("frame numbers have no gap", [1], lost),
    ("time advances", [1], later(-1)),
    ("its times are those of vision", [1], later(-0.005)),
    ("frames of vision are tracked", ALL, later(-0.005)),
    ("says what it can do", FIRST, clear("tracked_frame.capabilities")),
    ("capabilities are known, each once", FIRST, extend("tracked_frame.capabilities", 3)),
    ("one ball, unless it says otherwise", FIRST, repeat("tracked_frame.balls")),
    ("no kick, unless it says so", FIRST, assign("tracked_frame.capabilities.1", 2)),
    ("positions are within the walls, in metres", FIRST, assign(TRACKED + ".pos.x", 100)),
    ("the ball's height", FIRST, assign(TRACKED + ".pos.z", 150)),
    ("the ball's speed", FIRST, assign(TRACKED + ".vel.x", 1000)),
    ("visibility", FIRST, assign(TRACKED + ".visibility", 2)),
    ("a robot is tracked once", FIRST, repeat("tracked_frame.robots")),
    ("a robot's number", FIRST, assign(TRACK + ".robot_id.id", 16)),
    ("a robot has a team", FIRST, clear(TRACK + ".robot_id.team")),
    ("orientation", FIRST, assign(TRACK + ".orientation", 90)),
    ("a robot's speed", FIRST, assign(TRACK + ".vel.y", 1000)),
    ("a robot's turn", FIRST, assign(TRACK + ".vel_angular", NAN)),
    ("robots are where vision saw them", FIRST, assign(TRACK + ".pos.x", 2)),
    ("a kick is of the past", FIRST, assign(KICK + ".start_timestamp", good_packets.START_S + 9)),
    ("the speed of a kick", FIRST, assign(KICK + ".vel.z", 1000)),
    ("a kicked ball stops after the kick", FIRST, assign(KICK + ".stop_timestamp", 1)),
    ("a robot of a team kicks", FIRST, clear(KICK + ".robot_id.team")),
]
BROKEN = [
    (f"{kind}: {check}", kind, numbers, change)
    for kind, faults in (("vision", VISION), ("referee", REFEREE), ("tracker", TRACKER))
    for check, numbers, change in faults
]
