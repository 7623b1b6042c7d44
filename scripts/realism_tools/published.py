"""Published figures of real games. docs/realism.md lists the sources, by the letters here.

Each is a range: the lowest and the highest figure of comparable games or teams.
"""

from dataclasses import dataclass


@dataclass
class Published:
    low: float
    high: float
    text: str


PUBLISHED = {
    "length": Published(12.0, 23.5, "12 and 18, mean of ten 23, halts left out (L)"),
    "goals": Published(1, 5, "1 to 5 in four finals (F)"),
    "passes_per_team": Published(40.8, 40.8, "41, one team (C)"),
    "passes_completed": Published(0.792, 0.792, "79 %, one team (C)"),
    "play_share": Published(0.379, 0.556, "38 to 56 % (L)"),
    "play": Published(5.1, 10.1, "5.1 and 10.1, mean of ten 8.9 (L)"),
    "stops_per_min": Published(6, 9, "6 to 9 (L)"),
    "spell": Published(7, 10, "7 to 10 (L)"),
    "kicks": Published(72, 224, "72 to 224, mean 150; by our detector 99 (L)"),
    "kicks_per_min": Published(11.1, 16.9, "17; by our detector 11 (L)"),
    "flat_kick_median": Published(3.14, 3.5, "3.1 to 3.5 (L)"),
    "flat_kick_p95": Published(4.73, 6.73, "4.7 to 6.7, by team (L)"),
    "chips": Published(0.03, 0.28, "3 to 28 %, by game (L)"),
    "robot_p95": Published(1.25, 2.25, "1.3 to 2.3, by team (L)"),
    "robot_p99": Published(1.51, 2.91, "1.5 to 2.9, by team (L)"),
    "robot_max": Published(1.72, 3.93, "1.7 to 3.9, by team (L)"),
    "speed_up_p95": Published(2.12, 4.47, "2.1 to 4.5, by team (L)"),
    "speed_up_p99": Published(2.98, 6.05, "3.0 to 6.1, by team (L)"),
    "brake_p95": Published(2.93, 6.06, "2.9 to 6.1, by team (L)"),
    "brake_p99": Published(4.44, 8.32, "4.4 to 8.3, by team (L)"),
}
NOT_FOUND = "none found"
