"""What a robot does: drive, shoot, carry the ball. All is seen by a team whose goal is at -x."""
import cmath
import dataclasses
import math

ROBOT_M = 0.09
KICK_MPS = 5.5
SPEED_MPS, TURN_RADPS = 1.8, 8.0
CARRY_MPS, HOLDING_M = 0.5, 0.103


@dataclasses.dataclass
class Command:
    """Velocity in the field's coordinates, in m/s; positive turns are counterclockwise."""

    velocity: complex = 0j
    turn_radps: float = 0.0
    kick_mps: float = 0.0
    dribbles: bool = False


def unit(vector):
    return vector / abs(vector) if abs(vector) > 1e-9 else 1 + 0j


def limited(vector, length):
    return vector if abs(vector) <= length else unit(vector) * length


def drive(view, robot, target, towards, speed_mps=SPEED_MPS):
    """To a point, with the front towards another, around other robots."""
    position, front = robot
    velocity = limited(3 * (target - position), speed_mps)
    error_rad = cmath.phase((towards - position) * front.conjugate()) if towards != position else 0.0
    turn_radps = max(-TURN_RADPS, min(TURN_RADPS, 6 * error_rad))
    return Command(velocity + evasion(view, position, velocity), turn_radps)


def evasion(view, position, velocity):
    """A velocity that leads past the nearest robot ahead."""
    ahead = [
        other - position
        for other in view.others(position)
        if abs(other - position) < 0.4 and ((other - position) * velocity.conjugate()).real > 0
    ]
    if not ahead or abs(velocity) < 0.2:
        return 0j
    nearest = min(ahead, key=abs)
    side = 1j if (nearest * velocity.conjugate()).imag <= 0 else -1j
    return unit(nearest) * (side - 0.6) * abs(velocity) * (0.4 - abs(nearest)) / 0.25


def behind(view, robot, ball, direction, gap_m):
    """A point behind the ball, or beside it while the robot is still in front of it."""
    relative = (robot[0] - ball) * direction.conjugate()
    if relative.real > -0.08 and abs(relative.imag) < 0.25:
        return ball + direction * (-0.2 + (0.3j if relative.imag > 0 else -0.3j))
    return ball - direction * gap_m


def shoot(view, robot, aim):
    """Goes behind the ball, then through it."""
    ball = view.ball + 0.12 * limited(view.ball_velocity, 3)
    direction = unit(aim - ball)
    relative = (robot[0] - ball) * direction.conjugate()
    if relative.real > -0.06 or abs(relative.imag) > 0.045:
        return drive(view, robot, behind(view, robot, ball, direction, 0.2), aim)
    command = drive(view, robot, ball + 0.05 * direction, aim, 1.2)
    command.velocity += 0.7 * limited(view.ball_velocity, 1.5)
    if abs(cmath.phase(robot[1] * direction.conjugate())) < math.radians(8):
        command.kick_mps = KICK_MPS
    return command


def carry(view, robot, target):
    """Pulls the ball to a point, backwards, and leaves it there."""
    position, front = robot
    if abs(view.ball - target) < 0.08:
        away = unit(position - view.ball) * 0.7
        return drive(view, robot, view.ball + away, view.ball, 0.6)
    direction = unit(view.ball - target)  # that of the front
    relative = (position - view.ball) * direction.conjugate()
    if relative.real > -0.05 or abs(relative.imag) > 0.04 or relative.real < -0.3:
        return drive(view, robot, behind(view, robot, view.ball, direction, 0.2), view.ball, 1.0)
    holds = abs(position - view.ball) < HOLDING_M
    slow = CARRY_MPS if abs(view.ball - target) > 0.3 else 0.25
    goal = position - direction if holds else view.ball
    command = drive(view, robot, goal, position + direction, slow)
    command.velocity, command.dribbles = limited(goal - position, slow), True
    return command
