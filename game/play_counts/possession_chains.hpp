// Possession chains: what a team does from the moment it gains the ball until it loses it.
//
// Every moment of play belongs to the chain of one team, from the first touch after a restart on.
// A single touch does not gain the ball: it may be a deflection or a parry. A team gains the ball
// with a touch that is a kick (kAway_mps in play_counts.hpp), or if it touches the ball again
// kSameKick_s or more after that touch, before the other team does. The chain then begins at the
// first of these touches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/play_counts/chance.hpp"
#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// How a team gained the ball.
enum class ChainStart : std::uint8_t {
  kKickOff,
  kPenalty,
  kFreeKick,      // after a foul, or after any call that is not listed below
  kCornerKick,    // free kick after the opponents sent the ball over their own goal line
  kGoalKick,      // free kick after the opponents sent the ball over the team's goal line
  kThrowIn,       // throw-in or free kick after the ball left the field over a touch line
  kKeeper,        // touch in the team's own defence area
  kInterception,  // touch of a ball that the opponents kicked, kAway_m or more from the kick
  kDuel,          // touch next to an opponent: within kDuelOver_m
  kLooseBall,     // every other touch, such as the first one after a force start
};
constexpr auto names_of(ChainStart /*any*/) {
  return std::to_array<Named<ChainStart>>({{ChainStart::kKickOff, "kick_off"},
                                           {ChainStart::kPenalty, "penalty"},
                                           {ChainStart::kFreeKick, "free_kick"},
                                           {ChainStart::kCornerKick, "corner_kick"},
                                           {ChainStart::kGoalKick, "goal_kick"},
                                           {ChainStart::kThrowIn, "throw_in"},
                                           {ChainStart::kKeeper, "keeper"},
                                           {ChainStart::kInterception, "interception"},
                                           {ChainStart::kDuel, "duel"},
                                           {ChainStart::kLooseBall, "loose_ball"}});
}
inline constexpr std::size_t kChainStartCount = names_of(ChainStart{}).size();

enum class ChainEnd : std::uint8_t {
  kGoal,
  kOwnGoal,  // the team's ball in its own goal
  kShot,     // the team's last action was a shot that did not score
  kLost,     // the opponents gained the ball
  kOut,      // the ball left the field
  kFoul,     // by the team
  kFouled,   // by the opponents, or by both teams
  kWhistle,  // play stopped for another reason, such as the end of a half
};

constexpr auto names_of(ChainEnd /*any*/) {
  return std::to_array<Named<ChainEnd>>({{ChainEnd::kGoal, "goal"},
                                         {ChainEnd::kOwnGoal, "own_goal"},
                                         {ChainEnd::kShot, "shot"},
                                         {ChainEnd::kLost, "lost"},
                                         {ChainEnd::kOut, "out"},
                                         {ChainEnd::kFoul, "foul"},
                                         {ChainEnd::kFouled, "fouled"},
                                         {ChainEnd::kWhistle, "whistle"}});
}

using autoref::name_of;

struct PossessionChain {
  Side team = Side::kWest;
  ChainStart start = ChainStart::kLooseBall;
  ChainEnd end = ChainEnd::kWhistle;
  std::int64_t first_frame = 0;  // of its first touch, as in sim::Touch
  std::int64_t last_frame = 0;   // of the opponents' first touch, or when play stopped
  Vec2 first_m{0, 0};            // the ball's position in these frames
  Vec2 last_m{0, 0};
  int passes = 0;  // completed passes and shots, as in PlayCounts
  int shots = 0;
  double xg = 0;  // sum of the shots' chances
  bool operator==(const PossessionChain&) const = default;
};

struct Shot {
  Side team = Side::kWest;
  std::int64_t frame = 0;  // of the kick, as in sim::Touch
  Vec2 from_m{0, 0};       // the ball's position at the kick
  // nullopt if there was no kick at the goal: a robot pushed the ball into it, or the path of a
  // kick that went in was not that of a shot. If there was no kick at all, frame and from_m are
  // those of the goal.
  std::optional<ShotSituation> situation{};
  // The probabilities that it scores: xG and xGOT (chance.hpp). Both are 1 without a situation,
  // since such a chance is known only after the goal.
  double chance = 1;
  double chance_on_target = 1;
  // Whether the team's chain ended with a goal after this shot, with no other touch by the team.
  bool has_scored = false;
};

// The team that a goal is given to; nullopt if the decision is another one. The kick-off after a
// goal is the other team's. (The command names the scorer only if AutoRef commands the game.)
// Includes goals that are awarded because of a foul at a penalty kick.
std::optional<Side> scorer_in(const referee::Decision& decision);

// The restart that a team is to take.
struct NextRestart {
  ChainStart start = ChainStart::kLooseBall;
  std::optional<Side> side;  // nullopt after a force start, and if none is known
};

// Divides a game into possession chains. PlayStatistics calls these functions in the order of
// events.
class PossessionChains {
 public:
  explicit PossessionChains(std::int64_t same_kick_frames) : same_kick_frames_(same_kick_frames) {}

  // Call at the start of each frame: discards the chains that ended in the previous one.
  void begin_frame() {
    ended_.clear();
    ended_shots_.clear();
  }
  // The chains that have ended in this frame, and the shots of these chains.
  std::span<const PossessionChain> ended() const { return ended_; }
  std::span<const Shot> ended_shots() const { return ended_shots_; }

  // The team with the ball; nullopt until the first touch after a restart.
  std::optional<Side> team() const { return chain_ ? std::optional(chain_->team) : std::nullopt; }

  // The restart that comes next, from the call that awards it until it is taken.
  const NextRestart& next_restart() const { return next_restart_; }

  // A touch by a single team. `is_kick_away`: whether it kicked the ball away. `gained`: how the
  // team gains the ball with this touch, if it does so and takes no restart.
  void touch(const sim::Touch& touch, bool is_kick_away, ChainStart gained);
  // The team has completed a pass.
  void complete_pass(Side team);
  // A shot has ended. If it is a single touch that became a goal, the team gains the ball with it.
  void end_shot(const Shot& shot);
  // `ball_m`: the ball's position in the decision's frame.
  void decide(const referee::Decision& decision, const Vec2& ball_m);
  // A command was given. decide() does this for the commands of decisions.
  void prepare_restart(const Command& command);
  // Ends the chain when play has stopped. Call it after the decisions of this frame.
  void stop(std::int64_t frame, const Vec2& ball_m);

 private:
  ChainStart first_start(Side side, ChainStart gained);
  void gain_ball();
  void end(ChainEnd how, std::int64_t frame, const Vec2& ball_m);
  ChainEnd end_by(const referee::Finding& finding) const;

  std::int64_t same_kick_frames_;
  std::vector<PossessionChain> ended_;
  std::vector<Shot> ended_shots_;
  std::vector<Shot> shots_;               // of the chain in progress
  std::optional<PossessionChain> chain_;  // nullopt until the first touch after a restart
  // The chain that begins if the other team, which touched the ball last, gains it.
  std::optional<PossessionChain> next_;
  bool is_shot_last_ = false;  // whether the team's last action was a shot
  ChainEnd stopped_by_ = ChainEnd::kWhistle;
  std::optional<NextRestart> restart_;  // until it is taken
  NextRestart awarded_;                 // by the last call that stopped play
  NextRestart next_restart_;            // awarded or prepared, whichever is newer
};

}  // namespace autoref::game
