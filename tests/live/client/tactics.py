"""A team that obeys the referee, chases the ball and shoots."""
import dataclasses

from skills import Command, ROBOT_M, SPEED_MPS, carry, drive, limited, shoot, unit

STOP_M, STOP_MPS = 0.65, 1.0
AREA_M = ROBOT_M + 0.05
THEIR_AREA_M = ROBOT_M + 0.3
TOUCH_M = 0.14
RESTARTS = "kick-off", "free kick", "penalty"


@dataclasses.dataclass
class View:
    """A game as one team sees it; its goal is at -x."""

    field: object
    own: dict  # number -> position, direction of the front
    opponents: list  # positions
    ball: complex
    ball_velocity: complex
    kind: str
    is_ours: bool
    target: complex
    keeper: int

    def others(self, position):
        """Positions of all robots except the one that stands here."""
        for other, _ in self.own.values():
            if other != position:
                yield other
        yield from self.opponents


class Team:
    """The roles of one team from frame to frame."""

    def __init__(self):
        self.chaser = self.barred = None
        self.kind, self.was_ours = "halt", False

    def decide(self, view):
        """A command for each robot that is seen."""
        if view.kind == "halt":
            return {number: Command() for number in view.own}
        self.bar_kicker(view)
        self.chaser = self.nearest(view)
        commands, players = {}, [number for number in view.own if number not in (view.keeper, self.chaser)]
        for spot, number in enumerate(players):
            commands[number] = self.support(view, view.own[number], spot)
        if view.keeper in view.own:
            commands[view.keeper] = self.keep(view, view.own[view.keeper])
        if self.chaser is not None:
            commands[self.chaser] = self.chase(view, view.own[self.chaser])
        return commands

    def bar_kicker(self, view):
        """Who took a restart may not touch the ball again before another robot does."""
        if view.kind == "run" and self.kind in ("kick-off", "free kick") and self.was_ours:
            self.barred = self.chaser
        elif view.kind != "run":
            self.barred = None
        if self.barred is not None and self.barred in view.own:
            kicker = view.own[self.barred][0]
            if any(abs(other - view.ball) < TOUCH_M for other in view.others(kicker)):
                self.barred = None
        self.kind, self.was_ours = view.kind, view.is_ours

    def nearest(self, view):
        """The number of the robot that should go for the ball."""

        def distance_m(number):
            return abs(view.own[number][0] - view.ball) - (0.2 if number == self.chaser else 0)

        players = [number for number in view.own if number not in (view.keeper, self.barred)]
        return min(players, key=distance_m, default=None)

    def chase(self, view, robot):
        area = view.field.in_area(view.ball)
        if view.kind == "placement" and view.is_ours:
            return carry(view, robot, view.target)
        if view.kind == "run" and area == 0 or view.kind in RESTARTS and view.is_ours:
            return shoot(view, robot, self.aim(view))
        if view.kind.startswith("before") and view.is_ours:
            return drive(view, robot, view.ball + unit(view.ball - view.field.goal) * 0.3, view.ball, STOP_MPS)
        return self.move(view, robot, view.ball + unit(view.field.own_goal - view.ball) * 0.75)

    def aim(self, view):
        """The point in the opponents' goal with the most space."""

        def space_m(point):
            direction = unit(point - view.ball)
            ahead = [(other - view.ball) * direction.conjugate() for other in view.opponents]
            return min((abs(other.imag) for other in ahead if other.real > 0), default=9.0)

        points = [complex(view.field.end_x, y * view.field.goal_y) for y in (0, -0.75, 0.75)]
        return max(points, key=space_m)

    def support(self, view, robot, spot):
        """Two defend, the others wait for the ball."""
        ball, goal = view.ball, view.field.own_goal
        if spot < 2:
            target = goal + unit(ball - goal) * 1.9 + (0.15j if spot else -0.15j)
        else:
            target = complex(ball.real + (1.2, 0.8, -1.5)[spot % 3], (1.6, -1.6, 0.6)[spot % 3])
        return self.move(view, robot, target)

    def move(self, view, robot, target):
        """To a position that the referee allows."""
        return drive(view, robot, allowed(view, target), view.ball, SPEED_MPS if view.kind == "run" else STOP_MPS)

    def keep(self, view, robot):
        """In the goal, on the line to the ball; a slow ball in the area is kicked away."""
        goal, ball = view.field.own_goal, view.ball
        if view.kind == "run" and view.field.in_area(ball) == -1 and abs(view.ball_velocity) < 1:
            return shoot(view, robot, self.aim(view))
        if not view.is_ours and "penalty" in view.kind:
            return drive(view, robot, goal, ball)
        return drive(view, robot, allowed(view, goal + limited(0.4 * (ball - goal), 0.5), True), ball)


def allowed(view, target, is_keeper=False):
    """The position nearest to `target` (about) that breaks no rule."""
    field, kind = view.field, view.kind
    target = field.inside(target, 0.1)
    if "kick-off" in kind:
        target = complex(min(target.real, -0.2), target.imag)
    if "penalty" in kind and not is_keeper:
        line_x = view.ball.real + (-1.2 if view.is_ours else 1.2)
        target = complex(min(target.real, line_x) if view.is_ours else max(target.real, line_x), target.imag)
    if not is_keeper:
        target = field.out_of_areas(target, AREA_M, THEIR_AREA_M)
    if kind == "placement":
        return away_from_segment(target, view.ball, view.target)
    if kind != "run":
        return away(target, view.ball, STOP_M)
    return target


def away(point, centre, distance_m):
    return point if abs(point - centre) > distance_m else centre + unit(point - centre) * distance_m


def away_from_segment(point, start, end):
    """The nearest point that interferes with nobody who carries the ball from `start` to `end`."""
    along = end - start
    share = ((point - start) * along.conjugate()).real / max(abs(along) ** 2, 1e-6)
    return away(point, start + along * min(max(share, 0), 1), STOP_M)
