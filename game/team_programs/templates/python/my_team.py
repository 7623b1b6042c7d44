#!/usr/bin/env python3
"""A team of one page. Robot 0 stays in the goal, the robot nearest to the ball gets behind it and
kicks it to the opponents' goal, and the others stand in a row. Our goal is at -x.

It reads one JSON object per line and answers each frame with one line. Anything else, such as
debugging output, belongs on sys.stderr. Every number is in metres and seconds.
"""
import json
import math
import sys

SPEED_MPS = 2.0  # of all robots
STOP_MPS = 0.9  # while play is stopped: the Laws of 2014 allow 1 m/s
TURN_RADPS = 8.0
KICK_MPS = 5.0
# Distance to the ball or its path while we may not play it: the rules require 0.5 m to the hull.
TOO_NEAR_M = 0.6
KEEP_OFF_M = 0.65  # the distance to which robots retreat
PLAYABLE = ("KICKOFF", "PENALTY", "DIRECT_FREE", "INDIRECT_FREE")  # by the team that takes the restart


def main():
    print("autoref-team 1 json", flush=True)
    field = None
    for line in sys.stdin:
        message = json.loads(line)
        if "start" in message:
            field = message["start"]["field"]
        elif "frame" in message:
            print(json.dumps(decide(message["frame"], field)), flush=True)
        else:  # the game has ended
            break


def decide(frame, field):
    robots = frame["own"]
    if frame["play"] == "HALT" or not robots:
        return {"frame": frame["frame"]}
    latency = frame["latency_s"]  # our commands take effect this much later
    ball_x = frame["ball"]["x_m"] + frame["ball"]["vx_mps"] * latency
    ball_y = frame["ball"]["y_m"] + frame["ball"]["vy_mps"] * latency
    is_ours = frame["play"] == "RUNNING" or (frame["ours"] and frame["play"] in PLAYABLE)
    speed = STOP_MPS if frame["play"] == "STOP" else SPEED_MPS
    keeper = robots[0]
    chaser = keeper  # if the ball is in our area, otherwise another robot
    if not is_in_area(field, -ball_x, ball_y, 0.0):
        chaser = nearest(robots[1:], ball_x, ball_y)
    commands = []
    for index, robot in enumerate(robots):
        if is_ours and robot is chaser:
            x, y, to_x, to_y = attack(robot, ball_x, ball_y, field)
        elif robot is keeper:
            x, y, to_x, to_y = guard(ball_x, ball_y, field)
        else:
            x, y, to_x, to_y = line_up(index, len(robots), ball_x, ball_y, field)
        if robot is not keeper:
            x = out_of_areas(field, x, y)
        if not is_ours:
            x, y = keep_off(robot, x, y, *nearest_on_way(robot, ball_x, ball_y, frame))
        commands.append(drive(robot, x, y, to_x, to_y, speed, latency))
    return {"frame": frame["frame"], "keeper": keeper["number"], "commands": commands}


def nearest(robots, x, y):
    best, least = None, math.inf
    for robot in robots:
        dx, dy = robot["x_m"] - x, robot["y_m"] - y
        if dx * dx + dy * dy < least:
            best, least = robot, dx * dx + dy * dy
    return best


def attack(robot, ball_x, ball_y, field):
    """Drives through the ball towards the goal, or first to a place behind the ball, or around it."""
    to_x, to_y = unit(field["length_m"] / 2 - ball_x, -ball_y)
    dx, dy = robot["x_m"] - ball_x, robot["y_m"] - ball_y
    ahead, aside = dx * to_x + dy * to_y, dy * to_x - dx * to_y
    if ahead < -0.05 and -0.04 < aside < 0.04:
        back, off = -0.05, 0.0
    elif ahead < -0.12:
        back, off = 0.15, 0.0
    else:
        back, off = 0.2, 0.25 if aside > 0 else -0.25
    return ball_x - back * to_x - off * to_y, ball_y - back * to_y + off * to_x, to_x, to_y


def guard(ball_x, ball_y, field):
    """Stands on the line from the ball to the middle of our goal."""
    goal_x = -field["length_m"] / 2
    to_x, to_y = unit(ball_x - goal_x, ball_y)
    return goal_x + 0.1 + 0.2 * to_x, 0.3 * to_y, to_x, to_y


def line_up(index, count, ball_x, ball_y, field):
    """Stands in a row across our half, facing the ball."""
    x, y = -field["length_m"] / 5, (index - count / 2) * field["width_m"] / (count + 1)
    to_x, to_y = unit(ball_x - x, ball_y - y)
    return x, y, to_x, to_y


def is_in_area(field, x, y, margin):
    """Whether a point is in the opponents' defence area, approximated by a box; for ours, pass -x."""
    half = field["defence_area_straight_m"] / 2
    if not field["defence_area_is_box"]:
        half = half + field["defence_area_depth_m"]
    depth = field["defence_area_depth_m"] + margin
    return x > field["length_m"] / 2 - depth and -half - margin < y < half + margin


def out_of_areas(field, x, y):
    """The nearest x at which a robot is in neither defence area."""
    limit = field["length_m"] / 2 - field["defence_area_depth_m"] - 0.3
    if is_in_area(field, x, y, 0.3):
        return limit
    if is_in_area(field, -x, y, 0.3):
        return -limit
    return x


def nearest_on_way(robot, ball_x, ball_y, frame):
    """The point nearest to the robot on the ball's path to the referee's target."""
    if frame["placement_x_m"] is None:
        return ball_x, ball_y
    end_x, end_y = frame["placement_x_m"], frame["placement_y_m"]
    way_x, way_y = end_x - ball_x, end_y - ball_y
    whole = way_x * way_x + way_y * way_y
    along = (robot["x_m"] - ball_x) * way_x + (robot["y_m"] - ball_y) * way_y
    if along <= 0:
        return ball_x, ball_y
    if along >= whole:
        return end_x, end_y
    return ball_x + along / whole * way_x, ball_y + along / whole * way_y


def keep_off(robot, x, y, near_x, near_y):
    """Moves away from a point if the robot is near it; otherwise goes to (x, y), but around the point."""
    dx, dy = robot["x_m"] - near_x, robot["y_m"] - near_y
    if dx * dx + dy * dy < TOO_NEAR_M * TOO_NEAR_M:
        x, y = robot["x_m"], robot["y_m"]
    from_x, from_y = unit(dx, dy)
    lack = KEEP_OFF_M - (x - near_x) * from_x - (y - near_y) * from_y
    return (x + lack * from_x, y + lack * from_y) if lack > 0 else (x, y)


def drive(robot, x, y, to_x, to_y, most, latency):
    """A command that brings the robot to (x, y), facing the direction (to_x, to_y)."""
    vx = 3 * (x - robot["x_m"] - robot["vx_mps"] * latency)
    vy = 3 * (y - robot["y_m"] - robot["vy_mps"] * latency)
    speed = math.sqrt(vx * vx + vy * vy)
    if speed > most:
        vx, vy = vx / speed * most, vy / speed * most
    front_x, front_y = robot["heading_x"], robot["heading_y"]
    turn = front_x * to_y - front_y * to_x  # the sine of the angle to turn by
    if front_x * to_x + front_y * to_y < 0:
        turn = 1.0 if turn > 0 else -1.0
    return {
        "robot": robot["number"],
        "vx_mps": vx * front_x + vy * front_y,  # forward
        "vy_mps": vy * front_x - vx * front_y,  # to its left
        "angular_velocity_radps": TURN_RADPS * turn,
        "kick_mps": KICK_MPS,  # takes effect as soon as the ball is at the kicker
    }


def unit(x, y):
    length = math.sqrt(x * x + y * y)
    return (x / length, y / length) if length > 0 else (1.0, 0.0)


if __name__ == "__main__":
    main()
