// Follows the win probability of a running game (game/play_counts/win_probability.hpp).
#pragma once

#include <cstdint>
#include <functional>

#include "game/loop/game_configuration.hpp"
#include "game/loop/observer.hpp"
#include "game/play_counts/situation_value.hpp"
#include "game/play_counts/win_probability.hpp"
#include "soccer/units.hpp"

namespace autoref::game {

// How far the game is by the referee's clock.
struct PlayingTime {
  double played_s = 0;
  double left_s = 0;  // until the end of the second half, or of extra time once it has begun
};
PlayingTime playing_time(const RefereeSignal& signal, const referee::Match& match);

// The state of the game without what the situation is worth: MatchState::scores are 0.
MatchState match_state(const StateOfPlay& play, const referee::Match& match);

class WinProbabilityObserver final : public Observer {
 public:
  static constexpr double kEvery_s = 1.0_s;
  // Called every kEvery_s, and when a team scores or the referee's stage changes, with the time
  // since the start of the game.
  using Note = std::function<void(double time_s, const WinProbability& probability)>;

  WinProbabilityObserver(const GameConfiguration& game, Note note);

  void on_play(const StateOfPlay& play) override;

 private:
  referee::Match match_;
  Field field_;
  double frame_rate_hz_;
  const ValueModel* values_;
  const WinModel* wins_;
  Note note_;
  std::int64_t frames_;  // between two calls
  std::int64_t next_frame_ = 0;
  PerSide<int> goals_;  // in the last frame
  Stage stage_ = Stage::kFirstHalfPre;
};

}  // namespace autoref::game
