"""Checks of vision: units are millimetres, radians and Unix seconds."""
import math

LARGEST_BYTES = 1472
SOURCE_OTHER = 1
LATENCY_S = 1.0
GEOMETRY_S = 1.1
HIGHEST_ID = 15
REMEMBERED_FRAMES = 1000
# Name -> number of the type, and two ends in units of half the length and half the width of the
# field (G) or of the edge of a defence area (A).
LINES = {
    "TopTouchLine": (2, "-G +G", "+G +G"),
    "BottomTouchLine": (3, "-G -G", "+G -G"),
    "LeftGoalLine": (4, "-G -G", "-G +G"),
    "RightGoalLine": (5, "+G -G", "+G +G"),
    "HalfwayLine": (6, "0 -G", "0 +G"),
    "CenterLine": (7, "-G 0", "+G 0"),
    "LeftPenaltyStretch": (8, "-A -A", "-A +A"),
    "RightPenaltyStretch": (9, "+A -A", "+A +A"),
    "LeftFieldLeftPenaltyStretch": (10, "-G +A", "-A +A"),
    "LeftFieldRightPenaltyStretch": (11, "-G -A", "-A -A"),
    "RightFieldLeftPenaltyStretch": (12, "+G +A", "+A +A"),
    "RightFieldRightPenaltyStretch": (13, "+G -A", "+A -A"),
}
# The field of Division B in 2026.
SIZES = {
    "field_length": 9000,
    "field_width": 6000,
    "goal_width": 1000,
    "goal_depth": 180,
    "boundary_width": 300,
    "penalty_area_depth": 1000,
    "penalty_area_width": 2000,
    "center_circle_radius": 500,
    "line_thickness": 10,
    "goal_center_to_penalty_mark": 6000,
    "goal_height": 155,
    "ball_radius": 21.5,
    "max_robot_radius": 90,
}


class VisionChecks:
    """The packets of one game, one after the other."""

    def __init__(self, findings):
        self.findings = findings
        self.expect, self.expect_within = findings.expect, findings.expect_within
        self.field, self.cameras = None, []
        self.last = {}  # camera -> number and time of its last frame
        self.time, self.geometry_time, self.farthest_mm = None, None, 0.0
        self.frames = {}  # time in ms -> {(team, number): position in mm}, of the last frames

    def check(self, wrapper, size):
        self.expect("vision: fits into a datagram", size < LARGEST_BYTES, size)
        self.findings.expect_known("vision: no unknown fields", wrapper)
        self.expect("vision: says something", wrapper.HasField("detection") or wrapper.HasField("geometry"))
        self.expect("vision: source is OTHER", wrapper.source == SOURCE_OTHER, wrapper.source)
        if wrapper.HasField("geometry"):
            self.check_geometry(wrapper.geometry)
        if wrapper.HasField("detection"):
            self.check_detection(wrapper.detection)

    def check_detection(self, frame):
        self.check_order(frame)
        self.time = frame.t_capture
        robots = self.frames.setdefault(round(1000 * self.time), {})
        if len(self.frames) > REMEMBERED_FRAMES:
            self.frames.pop(next(iter(self.frames)))
        self.expect_within("vision: sent after it was taken", frame.t_sent - frame.t_capture, 0, LATENCY_S)
        if frame.HasField("t_capture_camera"):
            delay_s = abs(frame.t_capture_camera - frame.t_capture)
            self.expect_within("vision: the camera's clock agrees", delay_s, 0, LATENCY_S)
        if self.geometry_time is not None:
            silent_s = frame.t_capture - self.geometry_time
            self.expect_within("vision: geometry once a second", silent_s, -GEOMETRY_S, GEOMETRY_S)
        for ball in frame.balls:
            self.check_ball(ball)
        for team, seen in ((1, frame.robots_yellow), (2, frame.robots_blue)):
            numbers = [robot.robot_id for robot in seen]
            self.expect("vision: a robot is seen once", len(numbers) == len(set(numbers)), numbers)
            for robot in seen:
                self.check_robot(robot)
                robots[team, robot.robot_id] = robot.x, robot.y

    def check_order(self, frame):
        if self.cameras:
            self.expect("vision: camera is in the geometry", frame.camera_id in self.cameras, frame.camera_id)
        if frame.camera_id in self.last:
            number, time = self.last[frame.camera_id]
            self.expect(
                "vision: frame numbers have no gap",
                frame.frame_number == number + 1,
                f"{frame.frame_number} after {number}",
            )
            self.expect("vision: time advances", frame.t_capture > time, f"{frame.t_capture} after {time}")
        self.last[frame.camera_id] = frame.frame_number, frame.t_capture

    def check_position(self, thing):
        self.farthest_mm = max(self.farthest_mm, abs(thing.x), abs(thing.y))
        if self.field is None:
            return
        margin = self.field.boundary_width + 50
        self.expect_within("vision: x is within the walls", abs(thing.x), 0, self.field.field_length / 2 + margin)
        self.expect_within("vision: y is within the walls", abs(thing.y), 0, self.field.field_width / 2 + margin)
        self.expect("vision: pixels are finite", math.isfinite(thing.pixel_x) and math.isfinite(thing.pixel_y))

    def check_ball(self, ball):
        self.expect_within("vision: ball's confidence", ball.confidence, 0, 1)
        self.expect_within("vision: ball's height", ball.z, 0, 5000)
        self.check_position(ball)

    def check_robot(self, robot):
        self.expect("vision: robot has a number", robot.HasField("robot_id"))
        self.expect_within("vision: robot's number", robot.robot_id, 0, HIGHEST_ID)
        self.expect_within("vision: robot's confidence", robot.confidence, 0, 1)
        self.expect("vision: robot has an orientation", robot.HasField("orientation"))
        self.expect_within("vision: robot's orientation", robot.orientation, -math.pi - 1e-6, math.pi + 1e-6)
        if robot.HasField("height"):
            self.expect_within("vision: robot's height", robot.height, 50, 150)
        self.check_position(robot)

    def check_geometry(self, geometry):
        self.field, self.geometry_time = geometry.field, self.time
        self.cameras = [camera.camera_id for camera in geometry.calib]
        for name, size_mm in SIZES.items():
            found = getattr(geometry.field, name)
            self.expect(f"vision: {name}", abs(found - size_mm) < 1e-3, f"{found}, not {size_mm}")
        self.check_lines(geometry.field)
        self.expect("vision: cameras are calibrated", len(self.cameras) > 0)
        self.expect("vision: each camera once", len(self.cameras) == len(set(self.cameras)), self.cameras)
        for camera in geometry.calib:
            self.check_camera(camera)
        self.check_models(geometry.models)

    def check_lines(self, field):
        lines = {line.name: line for line in field.field_lines}
        missing = sorted(set(LINES) - set(lines))
        self.expect("vision: all lines have their names", not missing, missing)
        self.expect("vision: each line once", len(lines) == len(field.field_lines))
        for name in set(LINES) & set(lines):
            self.check_line(field, lines[name], *LINES[name])
        circles = [arc for arc in field.field_arcs if arc.name == "CenterCircle" and arc.type == 1]
        self.expect("vision: there is a centre circle", len(circles) == 1, len(circles))
        for arc in circles:
            self.expect_within("vision: the circle's radius", arc.radius, 490, 510)
            self.expect_within("vision: the circle is closed", arc.a2 - arc.a1, 2 * math.pi - 1e-3, 2 * math.pi + 1e-3)

    def check_line(self, field, line, kind, start, end):
        self.expect("vision: a line's type is that of its name", line.type == kind, f"{line.name} {line.type}")
        self.expect_within("vision: a line's thickness", line.thickness, 10, 10)
        for point, where in ((line.p1, start), (line.p2, end)):
            x, y = expected(field, where)
            self.expect(
                "vision: lines lie where their names say",
                math.hypot(point.x - x, point.y - y) < 15,
                f"{line.name}: {point.x}, {point.y}, not {x}, {y}",
            )

    def check_camera(self, camera):
        self.expect_within("vision: focal length in pixels", camera.focal_length, 100, 10000)
        norm = math.hypot(camera.q0, camera.q1, camera.q2, camera.q3)
        self.expect_within("vision: the camera's rotation is a unit quaternion", norm, 0.999, 1.001)
        self.expect_within("vision: the camera hangs above the field", camera.derived_camera_world_tz, 2000, 12000)
        derived = camera.derived_camera_world_tx, camera.derived_camera_world_ty, camera.derived_camera_world_tz
        self.expect(
            "vision: the derived position is that of the translation",
            math.dist(derived, camera_position(camera)) < 1,
            f"{derived}, not {camera_position(camera)}",
        )
        if camera.HasField("pixel_image_width"):
            self.expect_within(
                "vision: principal point is in the image", camera.principal_point_x, 1, camera.pixel_image_width
            )
            self.expect_within(
                "vision: principal point is in the image", camera.principal_point_y, 1, camera.pixel_image_height
            )

    def check_models(self, models):
        straight, chip = models.straight_two_phase, models.chip_fixed_loss
        self.expect(
            "vision: geometry has both models of the ball",
            models.HasField("straight_two_phase") and models.HasField("chip_fixed_loss"),
        )
        if models.HasField("straight_two_phase"):
            self.expect_within("vision: deceleration of a sliding ball", straight.acc_slide, -10, -1)
            self.expect_within("vision: deceleration of a rolling ball", straight.acc_roll, -1, -0.05)
            self.expect_within("vision: share of speed when the ball begins to roll", straight.k_switch, 0.4, 0.9)
        if models.HasField("chip_fixed_loss"):
            self.expect_within("vision: damping of a chip", chip.damping_xy_first_hop, 0.1, 1)
            self.expect_within("vision: damping of a chip", chip.damping_xy_other_hops, 0.1, 1)
            self.expect_within("vision: damping of a chip", chip.damping_z, 0.1, 1)

    def check_end(self):
        """Metres would never come to this distance."""
        self.expect_within("vision: positions are in millimetres", self.farthest_mm, 500, 10000)


def expected(field, where):
    """Where a point of LINES lies, in mm."""
    reach = {
        "G": (field.field_length / 2, field.field_width / 2),
        "A": (field.field_length / 2 - field.penalty_area_depth, field.penalty_area_width / 2),
    }
    return [
        0.0 if part == "0" else float(part[0] + "1") * reach[part[1]][axis] for axis, part in enumerate(where.split())
    ]


def camera_position(camera):
    """Where the camera hangs: its translation, turned back by its rotation (x, y, z, w)."""
    x, y, z, w = camera.q0, camera.q1, camera.q2, camera.q3
    a, b, c = camera.tx, camera.ty, camera.tz
    return (
        -(a * (1 - 2 * (y * y + z * z)) + b * 2 * (x * y + z * w) + c * 2 * (x * z - y * w)),
        -(a * 2 * (x * y - z * w) + b * (1 - 2 * (x * x + z * z)) + c * 2 * (y * z + x * w)),
        -(a * 2 * (x * z + y * w) + b * 2 * (y * z - x * w) + c * (1 - 2 * (x * x + y * y))),
    )
