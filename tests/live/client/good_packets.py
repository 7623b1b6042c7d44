"""A short game's packets without a fault, to be broken by tests."""
import math

from vision_checks import LINES, SIZES, expected

START_S = 1_795_000_000.0
FRAME_S = 1 / 60
ROBOTS = {number: (500.0 * number - 2000, 300.0) for number in range(6)}


def fill_geometry(geometry):
    for name, size in SIZES.items():
        setattr(geometry.field, name, size)
    for name, (kind, start, end) in LINES.items():
        line = geometry.field.field_lines.add(name=name, thickness=10, type=kind)
        line.p1.x, line.p1.y = expected(geometry.field, start)
        line.p2.x, line.p2.y = expected(geometry.field, end)
    arc = geometry.field.field_arcs.add(name="CenterCircle", radius=500, a1=0, a2=2 * math.pi, thickness=10, type=1)
    arc.center.x = arc.center.y = 0
    geometry.calib.add(
        camera_id=0,
        focal_length=1000,
        principal_point_x=800,
        principal_point_y=600,
        distortion=0,
        q0=1,
        q1=0,
        q2=0,
        q3=0,
        tx=0,
        ty=0,
        tz=6000,
        derived_camera_world_tx=0,
        derived_camera_world_ty=0,
        derived_camera_world_tz=6000,
        pixel_image_width=1600,
        pixel_image_height=1200,
    )
    straight, chip = geometry.models.straight_two_phase, geometry.models.chip_fixed_loss
    straight.acc_slide, straight.acc_roll, straight.k_switch = -3.3, -0.3, 0.66
    chip.damping_xy_first_hop, chip.damping_xy_other_hops, chip.damping_z = 0.7, 0.87, 0.46


def vision(messages, number):
    packet = messages.SSL_WrapperPacket(source=1)
    time = START_S + number * FRAME_S
    frame = packet.detection
    frame.frame_number, frame.t_capture, frame.t_sent, frame.camera_id = number, time, time + 0.03, 0
    frame.t_capture_camera = time
    frame.balls.add(confidence=1, x=100, y=200, pixel_x=5, pixel_y=6)
    for robots in (frame.robots_yellow, frame.robots_blue):
        for robot, (x, y) in ROBOTS.items():
            robots.add(confidence=1, robot_id=robot, x=x, y=y, orientation=1, pixel_x=5, pixel_y=6, height=145)
    if number % 4 == 0:
        fill_geometry(packet.geometry)
    return packet


def tracker(messages, number):
    packet = messages.TrackerWrapperPacket(uuid="one", source_name="tracker")
    frame = packet.tracked_frame
    frame.frame_number, frame.timestamp = number, START_S + number * FRAME_S
    frame.capabilities.extend([1, 3])
    ball = frame.balls.add(visibility=1)
    ball.pos.x, ball.pos.y, ball.pos.z, ball.vel.x, ball.vel.y, ball.vel.z = 0.1, 0.2, 0, 1, 1, 0
    for team in (1, 2):
        for number, (x, y) in ROBOTS.items():
            robot = frame.robots.add(orientation=1, vel_angular=0, visibility=1)
            robot.robot_id.id, robot.robot_id.team = number, team
            robot.pos.x, robot.pos.y, robot.vel.x, robot.vel.y = x / 1000, y / 1000, 1, 1
    kick = frame.kicked_ball
    kick.pos.x, kick.pos.y, kick.vel.x, kick.vel.y, kick.vel.z = 0.1, 0.2, 1, 1, 0
    kick.start_timestamp, kick.stop_timestamp = frame.timestamp - 1, frame.timestamp
    kick.robot_id.id, kick.robot_id.team = 3, 1
    return packet


# Stage and command of the referee's packets, one after the other, and what is announced.
COURSE = ((0, 1, 4), (0, 4, 2), (1, 2, None), (1, 1, 9), (1, 17, 9), (1, 9, None), (4, 1, None), (13, 0, None))
PACKETS = 2 * len(COURSE)  # two of each command


def referee(messages, number):
    stage, command, announced = COURSE[number // 2]
    time_us = int(START_S * 1e6) + number * 25_000
    packet = messages.Referee(
        packet_timestamp=time_us,
        stage=stage,
        stage_time_left=1_000_000 - number,
        command=command,
        command_counter=number // 2,
        command_timestamp=time_us - number % 2 * 25_000,
        blue_team_on_positive_half=stage < 4,
        current_action_time_remaining=5_000_000,
    )
    if announced is not None:
        packet.next_command = announced
    packet.designated_position.x, packet.designated_position.y = 300, 400
    for team, name in ((packet.yellow, "one"), (packet.blue, "two")):
        team.name, team.score, team.red_cards, team.yellow_cards = name, 1, 0, 1
        team.timeouts, team.timeout_time, team.goalkeeper, team.max_allowed_bots = 4, 300_000_000, 0, 5
        team.yellow_card_times.append(100_000_000)
    event = packet.game_events.add(type=41)
    event.boundary_crossing.by_team = 1
    return packet
