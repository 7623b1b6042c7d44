"""The messages between a game and a team: START, VIEW, END and an OUTPUT with COMMANDs.

Units are metres, seconds and radians. Every team's own goal is at -x, with +y to its left. Angles
are counterclockwise; a heading is a unit vector towards the robot's front. docs/team-programs.md
describes all members, under the same names.
"""
from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Any, NamedTuple


class Play(str, Enum):
    """State of the game; each value equals its name as a string."""

    HALT = "HALT"
    STOP = "STOP"
    PREPARE_KICKOFF = "PREPARE_KICKOFF"
    PREPARE_PENALTY = "PREPARE_PENALTY"
    KICKOFF = "KICKOFF"
    PENALTY = "PENALTY"
    DIRECT_FREE = "DIRECT_FREE"
    INDIRECT_FREE = "INDIRECT_FREE"
    RUNNING = "RUNNING"


class Next(str, Enum):
    """Command that ends a stop; each value equals its name as a string."""

    HALT = "HALT"
    STOP = "STOP"
    NORMAL_START = "NORMAL_START"
    FORCE_START = "FORCE_START"
    PREPARE_KICKOFF = "PREPARE_KICKOFF"
    PREPARE_PENALTY = "PREPARE_PENALTY"
    DIRECT_FREE = "DIRECT_FREE"
    INDIRECT_FREE = "INDIRECT_FREE"
    TIMEOUT = "TIMEOUT"
    GOAL = "GOAL"
    BALL_PLACEMENT = "BALL_PLACEMENT"


class Field(NamedTuple):
    """Dimensions of the field, measured to the outer edges of the lines, in metres."""

    length_m: float
    width_m: float
    run_off_m: float  # from the touch lines to the wall
    line_width_m: float
    centre_circle_radius_m: float
    penalty_mark_m: float  # from the goal line of the goal under attack
    defence_area_depth_m: float  # radius of the quarter circles, or the box's size along x
    defence_area_straight_m: float  # line between the quarter circles, or the size along y
    goal_width_m: float
    goal_depth_m: float
    goal_opening_height_m: float  # to the underside of the bar
    goal_bar_radius_m: float
    goal_wall_thickness_m: float
    defence_area_is_box: bool  # otherwise two quarter circles joined by a line


class Abilities(NamedTuple):
    """What one of the team's robots can do, including its handicap."""

    speed_mps: float
    acceleration_mps2: float
    braking_mps2: float
    kick_mps: float  # fastest straight kick
    chip_mps: float  # fastest chip kick


@dataclass(frozen=True)
class Start:
    """START: sent once, before the first frame."""

    side: str  # "west" (yellow) or "east" (blue)
    random_seed: int  # of the team's random stream
    frame_rate_hz: float  # camera frames per second
    latency_s: float  # from a frame until a command sent in reply moves a robot
    field: Field
    robots: list[Abilities]  # the team's own robots, by number from 0
    rules: str  # name of the rule book
    rule_numbers: dict[str, float]
    params: dict[str, float]  # the team's parameters


class Ball(NamedTuple):
    """The ball as the team sees it."""

    x_m: float
    y_m: float
    vx_mps: float  # 0 in detections, like vy_mps and height_deviation_m
    vy_mps: float
    height_m: float | None  # of its lowest point; None if a detection does not report it
    height_deviation_m: float  # standard deviation; 0 if the height is reported
    camera_x_m: float  # the camera that sees the ball; 0 with tracked motion
    camera_y_m: float
    camera_height_m: float  # above the carpet
    is_height_known: bool  # with tracked motion: False while it is unknown whether the ball is in the air


class Robot(NamedTuple):
    """A robot as the team sees it."""

    x_m: float
    y_m: float
    heading_x: float
    heading_y: float
    vx_mps: float  # along the field's axes; 0 in detections, like the next two
    vy_mps: float
    angular_velocity_radps: float
    number: int  # 0 to 15
    is_seen: bool  # in this frame; if not, its state is extrapolated. True in detections


# Robot._make() and Ball._make(), but faster.
_new_tuple: Any = tuple.__new__
robot_from: Callable[[tuple[Any, ...]], Robot] = functools.partial(_new_tuple, Robot)
ball_from: Callable[[tuple[Any, ...]], Ball] = functools.partial(_new_tuple, Ball)

Robots = tuple[list[Robot], list[Robot]]  # own, opponents


@dataclass(slots=True)
class View:
    """VIEW, called FRAME on the wire: what the team sees in one camera frame.

    The robots are decoded when `own` or `opponents` is first read.
    """

    frame: int  # number of the camera frame
    time_s: float  # its capture time since the start of the game
    latency_s: float  # from that frame until a command sent in reply moves a robot
    stage_time_left_s: float  # of the current half
    placement_x_m: float | None  # the referee's target for the ball at the next restart
    placement_y_m: float | None
    goals_own: int
    goals_opponent: int
    play: Play
    ours: bool  # whether this team takes the current restart
    # Whether this team's robots are placing the ball now; None if neither team is placing it.
    placing_is_ours: bool | None
    next: Next | None  # the command that ends this stop; None if unknown
    next_is_ours: bool
    ball: Ball | None  # None if no camera sees it and the team requested detections
    ball_in_dribbler_zone: list[int]  # numbers of own robots that sense the ball there
    _decode: Callable[[], Robots] = field(repr=False, compare=False)
    _robots: Robots | None = field(default=None, repr=False, compare=False)

    @property
    def own(self) -> list[Robot]:
        """The team's own robots, ordered by number."""
        if self._robots is None:
            self._robots = self._decode()
        return self._robots[0]

    @property
    def opponents(self) -> list[Robot]:
        """The opponents' robots, ordered by number."""
        if self._robots is None:
            self._robots = self._decode()
        return self._robots[1]


@dataclass(frozen=True)
class End:
    """END: sent once, at the end of the game."""

    goals_own: int
    goals_opponent: int
    reason: str  # why the game ended, for example "time"


@dataclass(slots=True)
class Command:
    """COMMAND: what one robot does until the next frame, in its own axes: x forward, y left."""

    vx_mps: float = 0.0  # -100 to 100
    vy_mps: float = 0.0  # -100 to 100
    angular_velocity_radps: float = 0.0  # -1000 to 1000
    kick_mps: float = 0.0  # ball speed of a kick as soon as the ball is in the dribbler zone; 0 for no kick
    chip: bool = False  # kicks upwards at 45 degrees
    dribble: bool = False


@dataclass(slots=True)
class Output:
    """OUTPUT: the answer to a frame. Team.run() builds it from decide() and the requests."""

    frame: int
    commands: Mapping[int, Command]  # by the robot's number; a robot without one stands still
    keeper: int = 0  # robot number of the keeper; -1 if unknown
    leaves: int | None = None  # the robot to remove first after a card
    timeout: bool = False  # requests a timeout as soon as play is stopped
    text: str = ""  # for the log, at most 1000 bytes
