"""Commands, stages and times of the league's game."""
from protocol import BLUE

HALT, STOP, NORMAL_START, FORCE_START = 0, 1, 2, 3
PREPARE_KICKOFF, PREPARE_PENALTY, DIRECT_FREE, TIMEOUT, GOAL, PLACEMENT = 4, 6, 8, 12, 14, 16
COMMANDS = ["HALT", "STOP", "NORMAL_START", "FORCE_START"] + [
    f"{kind}_{team}"
    for kind in (
        "PREPARE_KICKOFF",
        "PREPARE_PENALTY",
        "DIRECT_FREE",
        "INDIRECT_FREE",
        "TIMEOUT",
        "GOAL",
        "BALL_PLACEMENT",
    )
    for team in ("YELLOW", "BLUE")
]
STAGES = [
    "NORMAL_FIRST_HALF_PRE",
    "NORMAL_FIRST_HALF",
    "NORMAL_HALF_TIME",
    "NORMAL_SECOND_HALF_PRE",
    "NORMAL_SECOND_HALF",
    "EXTRA_TIME_BREAK",
    "EXTRA_FIRST_HALF_PRE",
    "EXTRA_FIRST_HALF",
    "EXTRA_HALF_TIME",
    "EXTRA_SECOND_HALF_PRE",
    "EXTRA_SECOND_HALF",
    "PENALTY_SHOOTOUT_BREAK",
    "PENALTY_SHOOTOUT",
    "POST_GAME",
]
HALVES = {1, 4, 7, 10}
BEFORE_HALVES = {0, 3, 6, 9}
PAUSED = {2, 5, 8, 11}
POST_GAME = 13
RUNNING = {NORMAL_START, FORCE_START, DIRECT_FREE, DIRECT_FREE + 1}  # the clock runs

PROPOSAL_S = 1.0  # after which a proposal counts
PLACEMENT_S = 30.0
BREAK_S = 300.0  # of half-time
FREE_KICK_S = 10.0  # after which play is on
NO_PROGRESS_S = 10.0
NO_PROGRESS_M = 0.5
IN_PLAY_M = 0.05
PLACED_M = 0.15
STOP_S = 2.0  # at least, before play resumes
AFTER_HALT_S = 10.0  # the same after a HALT


def for_team(command, team):
    return command + (team == BLUE)
