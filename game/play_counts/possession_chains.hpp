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
inline constexpr std::size_t kChainStartCount = 10;

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

enum class ChainEnd : std::uint8_t {
  kGoal,
  kOwnGoal,  // the team's ball in its own goal
  kShot,     // a shot without a goal was the last that the team did
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
  bool operator==(const PossessionChain&) const = default;
};

// Divides a game into possession chains. PlayStatistics calls these functions in the order of
// events.
class PossessionChains {
 public:
  explicit PossessionChains(std::int64_t same_kick_frames) : same_kick_frames_(same_kick_frames) {}

  // Call at the start of each frame: discards the chains that ended in the previous one.
  void begin_frame() { ended_.clear(); }
  // The chains that have ended in this frame.
  std::span<const PossessionChain> ended() const { return ended_; }

  // A touch by a single team. `is_kick_away`: whether it kicked the ball away. `gained`: how the
  // team gains the ball with this touch, unless it takes a restart.
  void touch(const sim::Touch& touch, bool is_kick_away, ChainStart gained);
  // The team has completed a pass.
  void pass(Side team);
  // The team's shot has ended. With a touch that became a goal, the team has gained the ball.
  void shoot(Side team);
  // `ball_m`: the ball's position in the decision's frame.
  void decide(const referee::Decision& decision, const Vec2& ball_m);
  // Ends the chain when play has stopped. Call it after the decisions of this frame.
  void stop(std::int64_t frame, const Vec2& ball_m);

 private:
  struct Restart {
    ChainStart start = ChainStart::kLooseBall;
    std::optional<Side> side;  // nullopt after a force start
  };

  ChainStart first_start(Side side, ChainStart gained);
  void gain_ball();
  void end(ChainEnd how, std::int64_t frame, const Vec2& ball_m);
  void prepare_restart(const Command& command);
  ChainEnd end_by(const referee::Finding& finding) const;

  std::int64_t same_kick_frames_;
  std::vector<PossessionChain> ended_;
  std::optional<PossessionChain> chain_;  // nullopt until the first touch after a restart
  // The chain that begins if the other team, which touched the ball last, gains it.
  std::optional<PossessionChain> next_;
  bool is_shot_last_ = false;  // whether a shot was the last that the team did
  ChainEnd stopped_by_ = ChainEnd::kWhistle;
  std::optional<Restart> restart_;  // until it is taken
  Restart awarded_;                 // by the last call that stopped play
};

}  // namespace autoref::game
