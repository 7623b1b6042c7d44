"""What the referee's command means for a team at the moment."""
from world import BLUE, YELLOW

IN_PLAY_M = 0.05
# Command -> situation, team.
COMMANDS = {
    0: ("halt", 0),
    1: ("stop", 0),
    3: ("run", 0),
    4: ("before kick-off", YELLOW),
    5: ("before kick-off", BLUE),
    6: ("before penalty", YELLOW),
    7: ("before penalty", BLUE),
    8: ("free kick", YELLOW),
    9: ("free kick", BLUE),
    10: ("free kick", YELLOW),
    11: ("free kick", BLUE),
    12: ("halt", 0),
    13: ("halt", 0),
    14: ("stop", 0),
    15: ("stop", 0),
    16: ("placement", YELLOW),
    17: ("placement", BLUE),
}
NORMAL_START = 2
AFTER_NORMAL_START = {"before kick-off": "kick-off", "before penalty": "penalty"}
POST_GAME = 13


class Situation:
    """The referee's packets, one after the other."""

    def __init__(self):
        self.kind, self.team, self.counter = "halt", 0, None
        self.ball_at_start, self.target, self.is_over = None, None, False
        self.blue_is_east, self.keepers, self.score = True, {}, {}

    def read(self, referee, ball):
        self.is_over = referee.stage == POST_GAME
        self.blue_is_east = referee.blue_team_on_positive_half
        self.keepers = {YELLOW: referee.yellow.goalkeeper, BLUE: referee.blue.goalkeeper}
        self.score = {"yellow": referee.yellow.score, "blue": referee.blue.score}
        if referee.HasField("designated_position"):
            point = referee.designated_position
            self.target = complex(point.x, point.y) / 1000
        if referee.command_counter != self.counter:
            self.counter, self.ball_at_start = referee.command_counter, ball
            self.change(referee.command)

    def change(self, command):
        if command == NORMAL_START:
            self.kind = AFTER_NORMAL_START.get(self.kind, "run")
        else:
            self.kind, self.team = COMMANDS[command]

    def see_ball(self, ball):
        """After a kick-off or free kick, play runs once the ball has moved."""
        if self.kind in ("kick-off", "free kick") and self.ball_at_start is not None:
            if abs(ball - self.ball_at_start) > IN_PLAY_M:
                self.kind = "run"

    def turn(self, team):
        """1 if a team's goal is at -x, otherwise -1."""
        return 1 if (team == BLUE) != self.blue_is_east else -1
