// The start of a game that does not begin with both teams lined up for the first kick-off, and
// scenes: games with a few seconds of play, which are scored for team a, the attackers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/loop/ghost.hpp"
#include "referee/decision.hpp"
#include "referee/state.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// The positions and the restart with which a game starts. Uses the program's coordinates: west
// defends the goal at -x.
struct StartState {
  // Robots on the field, by number; a team's other robots stay off it, except that one may return
  // for each yellow card with which the game starts, once that card is over.
  PerSide<sim::RobotStates> robots;
  sim::BallState ball;
  referee::MidwayStart referee;
  // What vision showed before the start, with times before 0. Tracks begin with these frames, and
  // teams see them first if vision is delayed. May be empty.
  std::vector<Frame> seen_before;
  std::optional<Ghost> ghost;  // nullopt if both sides are played by teams
};

// The start state as seen from the other end: rotated by 180 degrees, with the sides swapped.
StartState mirrored(const StartState& state);

// What ended a scene. kStop stands for the end of the half and for any other call that stops play.
enum class SceneEnd : std::uint8_t { kTime, kGoal, kBallOut, kFoul, kStop };

constexpr auto names_of(SceneEnd /*any*/) {
  return std::to_array<Named<SceneEnd>>({{SceneEnd::kTime, "time"},
                                         {SceneEnd::kGoal, "goal"},
                                         {SceneEnd::kBallOut, "ball_out"},
                                         {SceneEnd::kFoul, "foul"},
                                         {SceneEnd::kStop, "stop"}});
}

using autoref::name_of;

// How a scene ends with this event, if it stops play.
SceneEnd scene_end_by(referee::Event event);

inline constexpr std::size_t kSceneEndCount = names_of(SceneEnd{}).size();

// The weights of a scene's measures; its score is the weighted sum.
struct SceneWeights {
  double goal = 1;
  double conceded = 0;
  double ball_kept = 0;
  double gained_m = 0;
  double xg = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    constexpr Range kWeights = {-1000, 1000};
    visitor(self.goal, {"goal", kWeights, "the attackers scored, 0 or 1"});
    visitor(self.conceded, {"conceded", kWeights, "the defenders scored, 0 or 1"});
    visitor(self.ball_kept,
            {"ball_kept", kWeights, "the attackers have the ball at the end, 0 or 1"});
    visitor(self.gained_m,
            {"gained_m", kWeights, "how far the ball has come towards the defenders' goal"});
    visitor(self.xg, {"xg", kWeights, "the attackers' expected goals"});
  }
  bool operator==(const SceneWeights&) const = default;

  // Whether every score with these weights is 0 or 1.
  bool is_proportion() const {
    return *this == SceneWeights{1, 0, 0, 0, 0} || *this == SceneWeights{0, 1, 0, 0, 0} ||
           *this == SceneWeights{0, 0, 1, 0, 0};
  }
};

struct Scene {
  double lasts_s = 10;  // duration of the scene, counted from the start of play
  // The events that end the scene, indexed by SceneEnd; kTime is always true.
  std::array<bool, kSceneEndCount> ends = {true, true, true, true, true};
  SceneWeights weights;

  bool is_ended_by(SceneEnd end) const { return ends[static_cast<std::size_t>(end)]; }
};

struct SceneRecord {
  SceneEnd ended_by = SceneEnd::kTime;
  // Whether the attackers touched the ball last or take the next restart. Also true if nobody has
  // touched the ball.
  bool ball_kept = true;
  double gained_m = 0;
  double score = 0;
};

// Follows a scene frame by frame.
class SceneFollower {
 public:
  SceneFollower(const Scene& scene, Side attackers) : scene_(scene), attackers_(attackers) {}

  // The ground truth of a frame and the referee's output for it.
  struct Input {
    double time_s;
    const sim::WorldState& world;
    std::span<const sim::Touch> touches;
    std::span<const referee::Decision> decisions;
    referee::State state;
    const RefereeSignal& signal;
  };
  void update(const Input& input);

  bool is_over() const { return ended_by_.has_value(); }
  // Whether play has not begun although the referee's timeouts are over.
  bool is_late(double time_s) const { return !began_s_ && time_s > kLongestWait_s; }
  // The measures so far, given the numbers of goals scored by attackers and defenders, and the
  // attackers' expected goals.
  SceneRecord record(int goals, int goals_against, double xg) const;

 private:
  static constexpr double kLongestWait_s = 120;

  bool keeps_ball(const RefereeSignal& signal) const;

  Scene scene_;
  Side attackers_;
  std::optional<double> began_s_;  // when play began
  double from_m_ = 0;              // the ball's x at that time, towards the defenders' goal
  double to_m_ = 0;                // the ball's x now
  std::optional<Side> touched_;    // the side that touched the ball last
  bool is_kept_ = true;
  std::optional<SceneEnd> ended_by_;
};

}  // namespace autoref::game
