"""The types of the league's game events, and what each one does to the game."""
import math

from protocol import BLUE, YELLOW

TYPES = {
    "PREPARED": 1,
    "NO_PROGRESS_IN_GAME": 2,
    "PLACEMENT_FAILED": 3,
    "PLACEMENT_SUCCEEDED": 5,
    "BALL_LEFT_FIELD_TOUCH_LINE": 6,
    "BALL_LEFT_FIELD_GOAL_LINE": 7,
    "GOAL": 8,
    "AIMLESS_KICK": 11,
    "KEEPER_HELD_BALL": 13,
    "ATTACKER_DOUBLE_TOUCHED_BALL": 14,
    "ATTACKER_TOUCHED_BALL_IN_DEFENSE_AREA": 15,
    "BOT_DRIBBLED_BALL_TOO_FAR": 17,
    "BOT_KICKED_BALL_TOO_FAST": 18,
    "ATTACKER_TOO_CLOSE_TO_DEFENSE_AREA": 19,
    "BOT_INTERFERED_PLACEMENT": 20,
    "BOT_CRASH_DRAWN": 21,
    "BOT_CRASH_UNIQUE": 22,
    "BOT_PUSHED_BOT": 24,
    "BOT_HELD_BALL_DELIBERATELY": 26,
    "BOT_TIPPED_OVER": 27,
    "BOT_TOO_FAST_IN_STOP": 28,
    "DEFENDER_TOO_CLOSE_TO_KICK_POINT": 29,
    "DEFENDER_IN_DEFENSE_AREA": 31,
    "MULTIPLE_CARDS": 32,
    "MULTIPLE_FOULS": 34,
    "BOT_SUBSTITUTION": 37,
    "TOO_MANY_ROBOTS": 38,
    "POSSIBLE_GOAL": 39,
    "BOUNDARY_CROSSING": 41,
    "INVALID_GOAL": 42,
    "PENALTY_KICK_FAILED": 43,
    "BOT_DROPPED_PARTS": 47,
    "EXCESSIVE_BOT_SUBSTITUTION": 48,
}
NAMES = {number: name for name, number in TYPES.items()}

# Reported while play is stopped as well.
OUTSIDE_PLAY = {
    "PLACEMENT_SUCCEEDED",
    "PLACEMENT_FAILED",
    "BOT_INTERFERED_PLACEMENT",
    "BOT_TOO_FAST_IN_STOP",
    "DEFENDER_TOO_CLOSE_TO_KICK_POINT",
    "BOUNDARY_CROSSING",
    "BOT_CRASH_UNIQUE",
    "BOT_CRASH_DRAWN",
    "BOT_PUSHED_BOT",
    "ATTACKER_TOO_CLOSE_TO_DEFENSE_AREA",
}
# Counted for their team; play goes on.
FOULS_IN_PLAY = {
    "ATTACKER_TOUCHED_BALL_IN_DEFENSE_AREA",
    "BOT_KICKED_BALL_TOO_FAST",
    "BOT_CRASH_UNIQUE",
    "BOT_PUSHED_BOT",
    "BOT_INTERFERED_PLACEMENT",
    "BOT_TOO_FAST_IN_STOP",
    "DEFENDER_TOO_CLOSE_TO_KICK_POINT",
}
# A free kick for the other team.
STOPPING = {
    "BALL_LEFT_FIELD_TOUCH_LINE",
    "BALL_LEFT_FIELD_GOAL_LINE",
    "AIMLESS_KICK",
    "KEEPER_HELD_BALL",
    "ATTACKER_DOUBLE_TOUCHED_BALL",
    "BOT_DRIBBLED_BALL_TOO_FAR",
    "ATTACKER_TOO_CLOSE_TO_DEFENSE_AREA",
    "BOT_HELD_BALL_DELIBERATELY",
    "BOT_TIPPED_OVER",
    "BOUNDARY_CROSSING",
    "INVALID_GOAL",
}
# These count at once they are proposed and old enough; all others need a majority.
ACCEPTED = {"POSSIBLE_GOAL", "BALL_LEFT_FIELD_TOUCH_LINE", "BALL_LEFT_FIELD_GOAL_LINE"}


def body_of(event):
    field = event.WhichOneof("event")
    return getattr(event, field) if field else None


def team_of(event):
    return getattr(body_of(event), "by_team", 0)


def location_of(event):
    """Where it happened, in metres, or None."""
    body = body_of(event)
    for field in ("kick_location", "location", "start"):
        if body is not None and field in body.DESCRIPTOR.fields_by_name and body.HasField(field):
            point = getattr(body, field)
            if math.isfinite(point.x) and math.isfinite(point.y):
                return point.x, point.y
    return None


class Field:
    """Half lengths and the defence area, in metres; the origin is the centre."""

    def __init__(self):
        self.half_length, self.half_width = 4.5, 3.0
        self.area_depth, self.area_half_width = 1.0, 1.0

    def take(self, size):
        self.half_length, self.half_width = size.field_length / 2000, size.field_width / 2000
        if size.HasField("penalty_area_depth"):
            self.area_depth = size.penalty_area_depth / 1000
            self.area_half_width = size.penalty_area_width / 2000

    def free_kick_position(self, x, y):
        """Inside the lines by 0.2 m and away from the defence areas by a metre."""
        near_goal = self.half_length - self.area_depth - 1
        if abs(x) > near_goal and abs(y) < self.area_half_width + 0.3:
            x = math.copysign(near_goal, x)

        def clamp(value, limit):
            return max(-limit, min(limit, value))

        return clamp(x, self.half_length - 0.2), clamp(y, self.half_width - 0.2)


def placement_of(event, field, blue_on_positive_half):
    """Where the free kick after this event is taken."""
    x, y = location_of(event) or (0.0, 0.0)
    if NAMES.get(event.type) != "BALL_LEFT_FIELD_GOAL_LINE":
        return field.free_kick_position(x, y)
    defender = BLUE if (x > 0) == blue_on_positive_half else YELLOW
    is_corner = team_of(event) == defender
    side = math.copysign(field.half_width - 0.2, y)
    return math.copysign(field.half_length - (0.2 if is_corner else 1.0), x), side
