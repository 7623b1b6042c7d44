// Splices the exit of a ball in one game into the log of another.
#pragma once

#include <filesystem>
#include <vector>

#include "referee/event.hpp"
#include "soccer/side.hpp"
#include "tests/logs/ball_exit.hpp"

namespace autoref::logs {

// A robot of a log that could have kicked the ball out of the field as in `exit`, and the call that
// must follow.
struct Splice {
  const BallExit* exit = nullptr;
  double from_s = 0;       // from here on, the log's ball is replaced; on the frames' clock
  double exit_from_s = 0;  // the time in `exit` that corresponds to `from_s`
  RobotId kicker;
  Crossing crossing;
  Vec2 direction{1, 0};

  referee::Event event = referee::Event::kThrowIn;
  Side restart = Side::kWest;  // of the team that restarts
  double call_s = 0;           // when the whole ball is over the line

  double to_s() const { return from_s + exit->duration_s() - exit_from_s; }
  // The ball; nullopt where the cameras missed it.
  std::optional<Vec2> ball_m(double time_s) const;
};

// All splices of the exit into the log: play is on and has been without a call for 2.5 s, the robot
// faces the line at the right distance and angle, and no robot is in the ball's path.
std::vector<Splice> splices_of(const BallExit& exit, const RefereedLog& log);

// Writes the log with the spliced ball, until the splice ends. Throws std::invalid_argument if the
// log has several cameras.
void write_spliced(const std::filesystem::path& log, const Splice& splice,
                   const std::filesystem::path& spliced);

}  // namespace autoref::logs
