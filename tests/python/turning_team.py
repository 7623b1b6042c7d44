"""A team of the tests. Its commands depend on everything that it sees and on its random numbers.

    turning_team.py ENCODING [MOTION]
"""
import sys

import autoref


class TurningTeam(autoref.Team):
    """Drives about, and prints, which must not disturb the messages."""

    def prepare(self) -> None:
        """Prints the parameters."""
        print("parameters:", self.params)
        self.keeper = 2

    def decide(self, view: autoref.View) -> dict[int, autoref.Command]:
        """Drives towards the ball, with random turns; asks for a timeout once."""
        print("frame", view.frame)
        self.timeout = view.frame == 60
        self.text = f"frame {view.frame}" if view.frame % 100 == 0 else ""
        if view.ball is None or view.play == "HALT":
            return {}
        crowd_m = sum(robot.x_m + robot.vx_mps for robot in view.opponents)
        return {
            robot.number: autoref.Command(
                robot.heading_x * (view.ball.x_m - robot.x_m),
                view.ball.y_m - robot.y_m,
                self.random.random() - 0.5 + 0.01 * crowd_m,
                4.0,
                robot.number == 3,
                True,
            )
            for robot in view.own
        }

    def finish(self, end: autoref.End) -> None:
        """Prints the end."""
        print("end", end.reason)


if __name__ == "__main__":
    TurningTeam.run(*sys.argv[1:])
