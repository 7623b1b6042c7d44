// Counts a game's figures (play_counts.hpp) while it is played.
//
// It owns what a kick under way, a duel and possession need to be remembered for. The game loop
// feeds it once per frame; it changes nothing and allocates nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "referee/decision.hpp"
#include "runner/game/play_counts/duels.hpp"
#include "runner/game/play_counts/kick_away.hpp"
#include "runner/game/play_counts/play_counts.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::runner {

class PlayStatistics {
 public:
  // One frame, after the referee has judged it.
  struct FrameSummary {
    const sim::WorldState& now;
    std::span<const sim::Touch> touches;             // of the step that led here
    std::span<const referee::Decision> decisions{};  // of this frame
    bool is_play_on = false;  // from now on: signalled and not ended (referee::State::kRun)
    bool is_ball_in_play = false;
  };

  PlayStatistics(const Field& field, const sim::BallParameters& ball, double frame_rate_hz);

  void update(const FrameSummary& summary);

  // Of the frames so far; a kick under way is not yet among them.
  PerSide<PlayCounts> counts() const;

 private:
  // What touched the ball at the same time: all kicks of a sub-step, or all hulls met in it.
  struct TouchGroup;
  enum class Next : std::uint8_t { kMate, kOpponent, kGoal, kStop };

  void touch(const FrameSummary& summary);
  void touch(const TouchGroup& group, const sim::WorldState& now);
  void meet(const TouchGroup& group);
  void settle(Next next);
  void note(const referee::Decision& decision);
  void give_goal(Side scorer);
  void end_play();

  Field field_;
  sim::BallParameters ball_;
  double frame_rate_hz_;
  std::int64_t same_kick_frames_;
  Duels duels_;
  bool is_on_ = false;              // play, until this frame
  std::optional<KickAway> kick_;    // under way
  std::optional<Side> last_touch_;  // since play began
  PerSide<PlayCounts> counts_;
  PerSide<std::int64_t> possession_frames_;
};

}  // namespace autoref::runner
