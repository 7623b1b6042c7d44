// Offside, an experimental rule (referee/README.md has its definition): a robot gets the ball from
// a team-mate, and was in an offside position when the ball left that team-mate.
#include <algorithm>
#include <optional>
#include <vector>

#include "judge/truth/ground_truth_rules.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// How far a fast robot moves in a frame, since the time of a touch is known only to within a frame.
constexpr double kOffsideMargin_m = 50_mm;

class Offside final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (frame.play.count != count_) {
      count_ = frame.play.count;
      pass_ = {};
    }
    if (!frame.play.is_on) return;
    for (const sim::Touch& touch : frame.touches) {
      if (pass_.touches > 0 && touch.robot != pass_.robot) receive(frame, touch, all);
      note(frame, touch);
    }
  }

 private:
  struct Beyond {
    RobotId robot;
    double excess_m = 0;  // how far the robot is beyond the offside line
  };
  // A robot's touches in a row; the last one is the pass.
  struct Pass {
    RobotId robot;
    int touches = 0;  // how often a robot has taken over the ball in this play, this time included
    std::vector<Beyond> mates;
  };

  void note(const TrueFrame& frame, const sim::Touch& touch) {
    if (pass_.touches == 0 || touch.robot != pass_.robot) {
      pass_.robot = touch.robot;
      ++pass_.touches;
    }
    pass_.mates.clear();
    const std::optional<double> line_m = offside_line_m(frame, touch);
    if (!line_m) return;
    const double end = goal_sign(opponent_of(touch.robot.side));
    for_each_robot(frame.now, touch.robot.side, [&](RobotId id, const sim::RobotState& robot) {
      pass_.mates.push_back({id, end * robot.position_m.x() - *line_m});
    });
  }

  // Distance from the halfway line towards the opponents' goal beyond which a robot is offside: the
  // halfway line, the ball or the second-last opponent, whichever is farthest. nullopt if there are
  // fewer than two opponents.
  static std::optional<double> offside_line_m(const TrueFrame& frame, const sim::Touch& touch) {
    const Side opponents = opponent_of(touch.robot.side);
    const double end = goal_sign(opponents);
    std::vector<double> depths_m;
    for_each_robot(frame.now, opponents, [&](RobotId, const sim::RobotState& robot) {
      depths_m.push_back(end * robot.position_m.x());
    });
    if (depths_m.size() < 2) return std::nullopt;
    std::sort(depths_m.rbegin(), depths_m.rend());
    return std::max({0.0, end * touch.ball_m.x(), depths_m[1]});
  }

  // Nobody is offside straight from a restart, that is, at the play's first touch.
  void receive(const TrueFrame& frame, const sim::Touch& touch, TrueEvents& all) const {
    if (pass_.touches < 2 || touch.robot.side != pass_.robot.side) return;
    for (const Beyond& mate : pass_.mates) {
      if (mate.robot != touch.robot) continue;
      add_measured(all, {"offside", frame.time_s, touch.robot.side, touch.robot, touch.ball_m},
                   mate.excess_m, kOffsideMargin_m);
    }
  }

  int count_ = -1;
  Pass pass_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> offside() { return std::make_unique<Offside>(); }

}  // namespace autoref::judge::ground_truth
