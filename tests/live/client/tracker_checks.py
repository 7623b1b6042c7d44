"""Checks of the tracks: units are metres, radians and Unix seconds."""
import collections
import math

from vision_checks import REMEMBERED_FRAMES

LARGEST_BYTES = 1472
HIGHEST_ID = 15
FLYING, MULTIPLE, KICKED = 1, 2, 3
FARTHEST_M = 7.0
FASTEST_BALL_MPS, FASTEST_ROBOT_MPS, FASTEST_TURN_RADPS = 15.0, 8.0, 100.0
FROM_VISION_MM = 150.0


class TrackerChecks:
    """The packets of one game, one after the other; `vision` has checked those of the cameras."""

    def __init__(self, findings, vision):
        self.findings, self.vision = findings, vision
        self.expect, self.expect_within = findings.expect, findings.expect_within
        self.previous, self.uuid = None, None
        self.previous_in_vision = False
        self.pending = collections.deque(maxlen=REMEMBERED_FRAMES)  # not yet compared with vision

    def check(self, wrapper, size):
        self.expect("tracker: fits into a datagram", size < LARGEST_BYTES, size)
        self.findings.expect_known("tracker: no unknown fields", wrapper)
        self.expect("tracker: has an identity", wrapper.uuid != "")
        self.uuid = self.uuid or wrapper.uuid
        self.expect("tracker: keeps its identity", wrapper.uuid == self.uuid, wrapper.uuid)
        self.expect("tracker: has a name", wrapper.source_name != "")
        self.expect("tracker: has a frame", wrapper.HasField("tracked_frame"))
        self.check_frame(wrapper.tracked_frame)

    def check_frame(self, frame):
        if self.previous is not None:
            self.expect(
                "tracker: frame numbers have no gap",
                frame.frame_number == self.previous.frame_number + 1,
                f"{frame.frame_number} after {self.previous.frame_number}",
            )
            self.expect("tracker: time advances", frame.timestamp > self.previous.timestamp, frame.timestamp)
        self.check_capabilities(frame)
        for ball in frame.balls:
            self.check_ball(ball)
        identities = [(robot.robot_id.team, robot.robot_id.id) for robot in frame.robots]
        self.expect("tracker: a robot is tracked once", len(identities) == len(set(identities)), identities)
        for robot in frame.robots:
            self.check_robot(robot)
        if frame.HasField("kicked_ball"):
            self.check_kick(frame, frame.kicked_ball)
        self.previous = frame
        self.pending.append(frame)

    def compare_with_vision(self):
        """Vision of a frame may arrive after its tracks."""
        while self.pending and self.vision.time is not None and self.vision.time > self.pending[0].timestamp - 1e-4:
            frame = self.pending.popleft()
            robots = self.vision.frames.get(round(1000 * frame.timestamp))
            if self.previous_in_vision:
                self.expect("tracker: its times are those of vision", robots is not None, frame.timestamp)
            self.previous_in_vision = self.previous_in_vision or robots is not None
            for robot in frame.robots if robots else ():
                self.check_against_vision(robot, robots)

    def check_against_vision(self, robot, robots):
        seen = robots.get((robot.robot_id.team, robot.robot_id.id))
        if seen:
            distance_mm = math.dist(seen, (1000 * robot.pos.x, 1000 * robot.pos.y))
            self.expect_within("tracker: robots are where vision saw them", distance_mm, 0, FROM_VISION_MM)

    def check_capabilities(self, frame):
        capabilities = list(frame.capabilities)
        self.expect("tracker: says what it can do", len(capabilities) > 0)
        self.expect(
            "tracker: capabilities are known, each once",
            len(capabilities) == len(set(capabilities)) and 0 not in capabilities,
            capabilities,
        )
        self.expect(
            "tracker: one ball, unless it says otherwise",
            len(frame.balls) <= 1 or MULTIPLE in capabilities,
            len(frame.balls),
        )
        self.expect("tracker: no kick, unless it says so", not frame.HasField("kicked_ball") or KICKED in capabilities)

    def check_position(self, position):
        self.expect_within(
            "tracker: positions are within the walls, in metres", math.hypot(position.x, position.y), 0, FARTHEST_M
        )

    def check_ball(self, ball):
        self.check_position(ball.pos)
        self.expect_within("tracker: the ball's height", ball.pos.z, 0, 5)
        if ball.HasField("vel"):
            self.expect_within(
                "tracker: the ball's speed", math.hypot(ball.vel.x, ball.vel.y, ball.vel.z), 0, FASTEST_BALL_MPS
            )
        self.check_visibility(ball)

    def check_visibility(self, thing):
        if thing.HasField("visibility"):
            self.expect_within("tracker: visibility", thing.visibility, 0, 1)

    def check_robot(self, robot):
        self.expect_within("tracker: a robot's number", robot.robot_id.id, 0, HIGHEST_ID)
        self.expect("tracker: a robot has a team", robot.robot_id.team in (1, 2), robot.robot_id.team)
        self.check_position(robot.pos)
        self.expect_within("tracker: orientation", robot.orientation, -math.pi - 1e-6, math.pi + 1e-6)
        if robot.HasField("vel"):
            self.expect_within("tracker: a robot's speed", math.hypot(robot.vel.x, robot.vel.y), 0, FASTEST_ROBOT_MPS)
        if robot.HasField("vel_angular"):
            self.expect_within("tracker: a robot's turn", abs(robot.vel_angular), 0, FASTEST_TURN_RADPS)
        self.check_visibility(robot)

    def check_kick(self, frame, kick):
        self.check_position(kick.pos)
        self.expect("tracker: a kick is of the past", kick.start_timestamp <= frame.timestamp, kick.start_timestamp)
        self.expect_within(
            "tracker: the speed of a kick", math.hypot(kick.vel.x, kick.vel.y, kick.vel.z), 0, FASTEST_BALL_MPS
        )
        if kick.HasField("stop_timestamp"):
            self.expect("tracker: a kicked ball stops after the kick", kick.stop_timestamp >= kick.start_timestamp)
        if kick.HasField("robot_id"):
            self.expect("tracker: a robot of a team kicks", kick.robot_id.team in (1, 2), kick.robot_id.team)

    def check_end(self):
        self.expect("tracker: frames of vision are tracked", self.previous_in_vision)
