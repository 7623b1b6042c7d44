"""Kicks, possessions and robot speeds, measured in the positions of a log."""

from bisect import bisect_left
from math import ceil, cos, dist, floor, hypot, sin

# A kick, as in the published analysis of the league's logs (docs/realism.md): within 3 frames the ball gains 1 m/s
# while it is 0.03 to 0.24 m in front of a robot and at most 0.09 m off its axis.
KICK_GAIN_MPS = 1.0
KICK_FRAMES = 3
IN_FRONT_M = (0.03, 0.24)
BESIDE_M = 0.09
SAME_KICK_S = 0.1  # a kicker needs this long before its next kick
CHIP_HEIGHT_M = 0.03  # the ball's lowest point
CHIP_WITHIN_S = 0.1  # how soon after a chip kick it is that high

TOUCH_M = 0.115  # between the centres: radii 0.09 and 0.0215 m, and 3.5 mm
TOUCH_HEIGHT_M = 0.15  # a robot's height
IN_PLAY_M = 0.05  # the ball is in play once it has moved this far

# Robots, as in that analysis, which smooths noise over the same time and counts the same samples.
WINDOW_S = 0.05  # before and after
EVERY_S = 0.05
JUMP_MPS, JUMP_MPS2 = 5.0, 25.0  # anything above is not motion: the robot was moved
TANGENT_MPS = 0.3  # accelerations count for robots faster than this


def percentile(values, share):
    """The value below which this share of the values lies, interpolated linearly; None without values."""
    if not values:
        return None
    ordered = sorted(values)
    at = share * (len(ordered) - 1)
    low, high = ordered[floor(at)], ordered[ceil(at)]
    return low + (high - low) * (at - floor(at))


def frames_of(times_s, period):
    """The range of the frames from begin_s to end_s, the last one included."""
    begin_s, end_s = period
    return range(bisect_left(times_s, begin_s - 1e-6), bisect_left(times_s, end_s + 1e-6))


def _ball_speed(positions, frame):
    """Speed along the carpet until the next frame."""
    ball, times_s = positions.ball, positions.times_s
    away_m = hypot(ball.x_m[frame + 1] - ball.x_m[frame], ball.y_m[frame + 1] - ball.y_m[frame])
    return away_m / (times_s[frame + 1] - times_s[frame])


def _is_at_kicker(positions, frame):
    ball = positions.ball
    for robot in positions.robots.values():
        x_m, y_m = ball.x_m[frame] - robot.x_m[frame], ball.y_m[frame] - robot.y_m[frame]
        if not abs(x_m) + abs(y_m) < 2 * IN_FRONT_M[1]:  # also if the robot was not seen
            continue
        ahead_x, ahead_y = cos(robot.third[frame]), sin(robot.third[frame])
        is_in_front = IN_FRONT_M[0] <= x_m * ahead_x + y_m * ahead_y <= IN_FRONT_M[1]
        if is_in_front and abs(y_m * ahead_x - x_m * ahead_y) <= BESIDE_M:
            return True
    return False


def _kick_at(positions, frame, end):
    """(speed_mps, is_chip) of a kick that begins in this frame; None if none does. `end`: the end of play."""
    after = frame + KICK_FRAMES
    if not _ball_speed(positions, after) - _ball_speed(positions, frame) > KICK_GAIN_MPS:
        return None
    if not _is_at_kicker(positions, frame):
        return None
    speed_mps = max(_ball_speed(positions, later) for later in range(frame, after + 1))
    until_s = positions.times_s[frame] + CHIP_WITHIN_S
    heights = []
    while after < end and positions.times_s[after] <= until_s:
        heights.append(positions.ball.third[after])
        after += 1
    return speed_mps, any(height_m >= CHIP_HEIGHT_M for height_m in heights)


def kicks(positions, spells):
    """Kicks during play as (speed_mps, is_chip); a chip's speed is that along the carpet."""
    found = []
    for spell in spells:
        frames = frames_of(positions.times_s, spell)
        again_s = 0.0
        for frame in range(frames.start, frames.stop - KICK_FRAMES - 1):  # a speed also needs the next frame
            if positions.times_s[frame] < again_s:
                continue
            kick = _kick_at(positions, frame, frames.stop)
            if kick:
                found.append(kick)
                again_s = positions.times_s[frame] + SAME_KICK_S
    return found


def _distance_to_path(robot_x_m, robot_y_m, begin, end):
    """Distance of a point from the straight path between two points."""
    along_x, along_y = end[0] - begin[0], end[1] - begin[1]
    length2 = along_x * along_x + along_y * along_y
    share = 0.0
    if length2 > 0:
        share = ((robot_x_m - begin[0]) * along_x + (robot_y_m - begin[1]) * along_y) / length2
        share = min(1.0, max(0.0, share))
    return dist((robot_x_m, robot_y_m), (begin[0] + share * along_x, begin[1] + share * along_y))


def _touching_side(positions, frame):
    """The side that touches the ball between the last frame and this one; None if none or both do."""
    ball = positions.ball
    if frame == 0 or not ball.third[frame] <= TOUCH_HEIGHT_M:
        return None
    begin, end = (ball.x_m[frame - 1], ball.y_m[frame - 1]), (ball.x_m[frame], ball.y_m[frame])
    sides = set()
    for (side, _), robot in positions.robots.items():
        x_m, y_m = robot.x_m[frame], robot.y_m[frame]
        if abs(x_m - end[0]) < 0.4 and abs(y_m - end[1]) < 0.4:
            if _distance_to_path(x_m, y_m, begin, end) <= TOUCH_M:
                sides.add(side)
    return sides.pop() if len(sides) == 1 else None


def _in_play_from(positions, frames):
    """The first frame in which the ball is in play."""
    ball = positions.ball
    place = (ball.x_m[frames.start], ball.y_m[frames.start])
    for frame in frames:
        if dist(place, (ball.x_m[frame], ball.y_m[frame])) > IN_PLAY_M:
            return frame
    return frames.stop


def possessions_s(positions, spells):
    """How long each possession was in play: from a side's touch to the next touch by the other, or the end of play."""
    lengths = []
    for spell in spells:
        frames = frames_of(positions.times_s, spell)
        if not frames:
            continue
        holder, since_s = None, None
        in_play = _in_play_from(positions, frames)
        for frame in frames:
            side = _touching_side(positions, frame)
            if side is None or side == holder:
                continue
            now_s = max(positions.times_s[frame], positions.times_s[min(in_play, frames.stop - 1)])
            if holder and frame >= in_play:
                lengths.append(now_s - since_s)
            holder, since_s = side, now_s
        if holder and in_play < frames.stop:
            lengths.append(positions.times_s[frames.stop - 1] - since_s)
    return lengths


class RobotMotion:
    """Samples of all robots: speeds_mps, and while faster than TANGENT_MPS accelerations along the motion, by sign."""

    def __init__(self):
        self.speeds_mps, self.speed_ups_mps2, self.brakes_mps2 = [], [], []

    def add(self, robot, frame, reach, over_s):
        """A sample from three positions: in this frame, and `reach` frames before and after it, `over_s` apart."""
        before, after = frame - reach, frame + reach
        vx_mps = (robot.x_m[after] - robot.x_m[before]) / over_s
        vy_mps = (robot.y_m[after] - robot.y_m[before]) / over_s
        speed_mps = hypot(vx_mps, vy_mps)
        if not speed_mps <= JUMP_MPS:  # also if the robot was not seen
            return
        per_s2 = 4 / over_s**2
        ax_mps2 = (robot.x_m[after] - 2 * robot.x_m[frame] + robot.x_m[before]) * per_s2
        ay_mps2 = (robot.y_m[after] - 2 * robot.y_m[frame] + robot.y_m[before]) * per_s2
        if not hypot(ax_mps2, ay_mps2) <= JUMP_MPS2:
            return
        self.speeds_mps.append(speed_mps)
        if speed_mps > TANGENT_MPS:
            along_mps2 = (ax_mps2 * vx_mps + ay_mps2 * vy_mps) / speed_mps
            (self.speed_ups_mps2 if along_mps2 > 0 else self.brakes_mps2).append(abs(along_mps2))


def robot_motion(positions, periods):
    """The motion of all robots on the field in these periods, 20 times a second."""
    times_s, motion = positions.times_s, RobotMotion()
    if len(times_s) < 2:
        return motion
    frame_s = (times_s[-1] - times_s[0]) / (len(times_s) - 1)
    reach, step = max(1, round(WINDOW_S / frame_s)), max(1, round(EVERY_S / frame_s))
    for period in periods:
        frames = frames_of(times_s, period)
        for frame in range(frames.start + reach, frames.stop - reach, step):
            over_s = times_s[frame + reach] - times_s[frame - reach]
            for robot in positions.robots.values():
                motion.add(robot, frame, reach, over_s)
    return motion
