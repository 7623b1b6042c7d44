"""What the packets say about field, robots and ball. Positions are complex numbers, in metres."""
import cmath

UNSEEN_S = 0.3
YELLOW, BLUE = 1, 2


class Field:
    """Lengths of the field, and points on it as seen by a team whose goal is at -x."""

    def __init__(self, size):
        self.end_x, self.side_y = size.field_length / 2000, size.field_width / 2000
        self.goal_y = size.goal_width / 2000
        self.area_x = self.end_x - size.penalty_area_depth / 1000
        self.area_y = size.penalty_area_width / 2000
        self.own_goal, self.goal = complex(-self.end_x), complex(self.end_x)

    def in_area(self, point, margin=0.0):
        """Whether a point is in a defence area or closer than `margin`: -1 own, 1 theirs, 0 neither."""
        inside = abs(point.real) > self.area_x - margin and abs(point.imag) < self.area_y + margin
        return (-1 if point.real < 0 else 1) if inside else 0

    def out_of_areas(self, point, own_margin, their_margin):
        """The nearest point that is outside both areas."""
        margin = own_margin if point.real < 0 else their_margin
        if not self.in_area(point, margin):
            return point
        x, y = self.area_x - margin, self.area_y + margin
        if abs(point.real) - x < y - abs(point.imag) or abs(point.real) > self.end_x:
            return complex(x if point.real > 0 else -x, point.imag)
        return complex(point.real, y if point.imag > 0 else -y)

    def inside(self, point, margin=0.0):
        x, y = self.end_x - margin, self.side_y - margin
        return complex(min(max(point.real, -x), x), min(max(point.imag, -y), y))


class World:
    """Field, robots and ball as last seen."""

    def __init__(self):
        self.field, self.cameras = None, 1
        self.robots = {YELLOW: {}, BLUE: {}}  # number -> time, position, direction of the front
        self.ball, self.ball_velocity, self.ball_time = None, 0j, None
        self.time, self.frame = 0.0, None

    def read_geometry(self, geometry):
        self.field, self.cameras = Field(geometry.field), max(1, len(geometry.calib))

    def read_detection(self, detection):
        self.time, self.frame = detection.t_capture, detection.frame_number
        for team, robots in ((YELLOW, detection.robots_yellow), (BLUE, detection.robots_blue)):
            for robot in robots:
                position = complex(robot.x, robot.y) / 1000
                self.robots[team][robot.robot_id] = self.time, position, cmath.rect(1, robot.orientation)
        if detection.balls:
            self.see_ball(max(detection.balls, key=lambda ball: ball.confidence))

    def see_ball(self, ball):
        position, previous = complex(ball.x, ball.y) / 1000, self.ball
        passed_s = self.time - self.ball_time if previous is not None else 0
        if passed_s > 0:
            velocity = (position - previous) / passed_s
            is_moved = abs(velocity) > 15  # by the referee
            self.ball_velocity = 0j if is_moved else 0.6 * self.ball_velocity + 0.4 * velocity
        self.ball, self.ball_time = position, self.time

    def seen_robots(self, team):
        return {
            number: robot[1:] for number, robot in sorted(self.robots[team].items()) if self.time - robot[0] < UNSEEN_S
        }
