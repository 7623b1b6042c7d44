#!/usr/bin/env python3
"""A team in cells: the keeper guards the goal, the robot nearest to the ball shoots it.

    python3 -m autoref play python/examples/team.py basic
"""
# %% Helpers. They use only + - * / and square roots, which give the same game on every machine.
from math import sqrt

import autoref
from autoref import Ball, Command, Robot, View

KEEPER = 0
GAIN_PER_S = 3.0  # velocity per distance: slows the robot down near its destination
TURN_GAIN_PER_S = 6.0


def limited(value: float, limit: float) -> float:
    return max(-limit, min(limit, value))


def drive(robot: Robot, x_m: float, y_m: float, face_x_m: float, face_y_m: float, speed_mps: float) -> Command:
    """Drives to a position and turns towards another. Commands are in the robot's own frame."""
    dx, dy = GAIN_PER_S * (x_m - robot.x_m), GAIN_PER_S * (y_m - robot.y_m)
    factor = min(1.0, speed_mps / max(1e-9, sqrt(dx * dx + dy * dy)))
    hx, hy = robot.heading_x, robot.heading_y
    fx, fy = face_x_m - robot.x_m, face_y_m - robot.y_m
    distance_m = max(1e-9, sqrt(fx * fx + fy * fy))
    sine, cosine = (hx * fy - hy * fx) / distance_m, (hx * fx + hy * fy) / distance_m
    turn = sine if cosine > 0 else (1.0 if sine >= 0 else -1.0)
    return Command(
        vx_mps=factor * (dx * hx + dy * hy),
        vy_mps=factor * (dy * hx - dx * hy),
        angular_velocity_radps=TURN_GAIN_PER_S * turn,
    )


# %% The team.
class Shooter(autoref.Team):
    """A team with one keeper and one attacker; the other robots stay where they are."""

    keeper = KEEPER

    def prepare(self) -> None:
        """Reads the field's size and a parameter: --set a.params.speed_mps=1.0 sets it."""
        self.goal_x_m = self.start.field.length_m / 2
        self.goal_half_m = self.start.field.goal_width_m / 2
        self.speed_mps = self.params.get("speed_mps", 1.5)

    def decide(self, view: View) -> dict[int, Command]:
        """Called for each frame."""
        if view.ball is None or view.play in ("HALT", "STOP"):
            return {}
        ball = view.ball
        commands = {robot.number: self.guard(robot, ball) for robot in view.own if robot.number == KEEPER}
        attackers = [robot for robot in view.own if robot.number != KEEPER]
        if attackers and (view.ours or view.play == "RUNNING"):
            nearest = min(attackers, key=lambda robot: (robot.x_m - ball.x_m) ** 2 + (robot.y_m - ball.y_m) ** 2)
            commands[nearest.number] = self.attack(nearest, ball)
        return commands

    def guard(self, robot: Robot, ball: Ball) -> Command:
        """Stands between the posts, level with the ball."""
        y_m = limited(ball.y_m, self.goal_half_m)
        return drive(robot, 0.15 - self.goal_x_m, y_m, ball.x_m, ball.y_m, self.speed_mps)

    def attack(self, robot: Robot, ball: Ball) -> Command:
        """Gets behind the ball as seen from the opponents' goal, then drives into it and kicks."""
        to_goal_x_m, to_goal_y_m = self.goal_x_m - ball.x_m, -ball.y_m
        distance_m = max(1e-9, sqrt(to_goal_x_m**2 + to_goal_y_m**2))
        ux, uy = to_goal_x_m / distance_m, to_goal_y_m / distance_m
        behind_m = (ball.x_m - robot.x_m) * ux + (ball.y_m - robot.y_m) * uy
        beside_m = abs((ball.x_m - robot.x_m) * uy - (ball.y_m - robot.y_m) * ux)
        is_behind = behind_m > 0 and beside_m < 0.03
        gap_m = 0.05 if is_behind else 0.25
        command = drive(robot, ball.x_m - gap_m * ux, ball.y_m - gap_m * uy, self.goal_x_m, 0.0, self.speed_mps)
        command.kick_mps = 6.0 if is_behind else 0.0
        return command


# %% To play a game against a built-in strategy from a notebook:
#     import autoref
#     game = autoref.play("python/examples/team.py", "basic", settings={"match.half_s": 60})
#     game.goals_a, game.goals_b

# %% The game starts the file as a program.
if __name__ == "__main__":
    Shooter.run()
