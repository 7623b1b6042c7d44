// Plays a case: brings a referee to its starting point, feeds it the frames, and records its calls.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "referee/referee.hpp"
#include "soccer/random.hpp"
#include "tests/referee/rules/case.hpp"
#include "tests/referee/rules/staged_bodies.hpp"

namespace autoref::referee {

// A decision and its consequences. Times count from the start of the case.
struct Call {
  Decision decision;
  double at_s = 0;
  std::optional<Command> next;
  std::optional<Vec2> ball_m;
};

// A turned game is rotated by 180 degrees with the sides swapped before the referee sees it, and
// the calls are rotated back, so that a case expects the same calls either way.
class StagedGame {
 public:
  StagedGame(const Case& it, bool turned);

  // Plays the whole case. Throws std::runtime_error if the starting point cannot be reached or a
  // cue cannot be followed.
  void play();

  // All calls since the start of the case, without the machine's own procedure.
  const std::vector<Call>& calls() const { return calls_; }
  PerSide<int> goals() const;

 private:
  void obey(const Cue& cue);
  void step();
  void look(Frame& frame);
  void place_ball();
  void hear();
  Frame turned_frame(const Frame& frame) const;
  Command turned(Command command) const { return turned_ ? mirrored(command) : command; }

  void run(double seconds);
  void run_until(State state, double limit_s);
  void curtain(double seconds);

  void open();
  void line_up_assignment();
  void show_robots();
  void play_on_from_force_start();
  void score_goals();
  void score_goal(Side scorer);
  void kick_out(const Vec2& from_m, RobotId kicker, const Vec2& direction);
  void foul_for_penalty();
  void play_to_the_stop();
  void check_beginning() const;

  const Case& case_;
  const bool turned_;
  Field field_;
  AutoRef referee_;
  PerSide<TeamRequests> requests_;
  StagedBodies bodies_;
  RandomStream random_;
  RefereeSignal signal_;
  std::int64_t frame_number_ = 0;
  double began_s_ = 0;
  PerSide<int> goals_before_;
  std::vector<Call> all_;
  std::vector<Call> calls_;
};

}  // namespace autoref::referee
