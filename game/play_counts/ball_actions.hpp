// What robots do with the ball, divided into actions, and what each action was worth to its team.
//
// What a situation is worth to a team is the probability that the current spell of play ends with a
// goal by the team, minus that of a goal against it (situation_value.hpp). What an action was worth
// is the difference between the situations at its end and at its start. From the touch that takes
// a restart until play stops, each action begins where the previous one ends, so that their worths
// add up to the difference between the situation at the end and at the restart, seen from one team.
// At the end, the situation is the goal (1 or -1), the restart that a call awards, or otherwise
// what it was when play stopped.
//
// Calls while the ball is not in play, and fouls by both teams, have no action. Neither has the
// action that the end of a game during play cuts short. If nobody commands the game, calls change
// nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/play_counts/situation_value.hpp"
#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

enum class ActionKind : std::uint8_t {
  kPass,     // a kick, other than a shot, after which the team keeps the ball
  kDribble,  // from a robot's first touch to its kick, or to a team-mate's touch
  kShot,     // as in PlayCounts
  kLoss,     // every other action after which the opponents have the ball or get the restart
  kFoul,     // a robot's foul that decides how play continues; the action before it is not a loss
};
constexpr auto names_of(ActionKind /*any*/) {
  return std::to_array<Named<ActionKind>>({{ActionKind::kPass, "pass"},
                                           {ActionKind::kDribble, "dribble"},
                                           {ActionKind::kShot, "shot"},
                                           {ActionKind::kLoss, "loss"},
                                           {ActionKind::kFoul, "foul"}});
}
inline constexpr std::size_t kActionKindCount = names_of(ActionKind{}).size();

struct BallAction {
  Side team = Side::kWest;
  int robot = -1;  // number; -1 if unknown, for a foul
  ActionKind kind = ActionKind::kDribble;
  std::int64_t first_frame = 0;  // as in sim::Touch; of a foul, both are the decision's
  std::int64_t last_frame = 0;
  Vec2 first_m{0, 0};  // the ball's position in these frames
  Vec2 last_m{0, 0};
  double worth = 0;  // goals, from -2 to 2; positive if it helped the team
};

// Divides a game into actions. PlayStatistics calls these functions in the order of events.
class BallActions {
 public:
  // `model` must outlive this object.
  BallActions(const Field& field, const ValueModel& model) : field_(field), model_(&model) {}

  // Call at the start of each frame: discards the actions that ended in the previous one.
  void begin_frame() { ended_.clear(); }
  // The actions that have ended in this frame.
  std::span<const BallAction> ended() const { return ended_; }

  // Who had the ball or the restart before an event, and who has it afterwards.
  struct Owners {
    std::optional<BallOwner> before;
    std::optional<BallOwner> after;
  };

  // Simultaneous touches by robots of one team. `is_kick_away`: whether they kicked the ball away.
  void touch(std::span<const sim::Touch> touches, bool is_kick_away, const Owners& owners,
             const sim::WorldState& now);
  // The kick in progress was a shot by the team, or its robot has pushed the ball into the goal.
  void note_shot(Side team);
  // The kick in progress has ended, for example with an opponent's touch.
  void end_kick();
  // The kick in progress only pushed the ball ahead.
  void discard_kick();
  // A goal has been given.
  void give_goal(Side scorer, const sim::WorldState& now);
  // A call has stopped play, or has changed the restart. `owners.after`: who gets the restart.
  void call(const referee::Decision& decision, const Owners& owners, const sim::WorldState& now);
  // Play has stopped. `owner`: who had the ball.
  void stop(const std::optional<BallOwner>& owner, const sim::WorldState& now);

 private:
  // An action in progress.
  struct Action {
    RobotId robot;
    bool is_kick = false;
    bool is_kick_over = false;
    bool is_shot = false;
    std::int64_t frame = 0;
    Vec2 ball_m{0, 0};
    double value = 0;  // to west, at the start
  };

  double value_to_west(const std::optional<BallOwner>& owner, const sim::WorldState& now) const;
  Action action_from(std::span<const sim::Touch> touches, bool is_kick_away,
                     const std::optional<BallOwner>& before, const sim::WorldState& now) const;
  bool goes_on_with(std::span<const sim::Touch> touches) const;
  void begin(const Action& action);
  void end(std::int64_t frame, const Vec2& ball_m, double value, Side next);
  void add_foul(const referee::Decision& decision, double before, double after, const Vec2& ball_m);

  Field field_;
  const ValueModel* model_;
  std::optional<Action> action_;  // of the team with the ball
  // The action that has begun if the other team, which touched the ball last, gains it.
  std::optional<Action> next_;
  std::vector<BallAction> ended_;
};

}  // namespace autoref::game
