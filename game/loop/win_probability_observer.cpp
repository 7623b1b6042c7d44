#include "game/loop/win_probability_observer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/play_counts/play_statistics.hpp"

namespace autoref::game {

PlayingTime playing_time(const RefereeSignal& signal, const referee::Match& match) {
  const double half_s = match.half_s;
  const double all_s = match.halves * half_s;
  const double extra_s = match.rules.extra_half_s;
  const double stage_s = std::max(signal.stage_time_left_s, 0.0);
  const auto at = [](double played_s, double of_s) {
    const double within_s = std::clamp(played_s, 0.0, of_s);  // a controller may have other halves
    return PlayingTime{within_s, of_s - within_s};
  };
  switch (signal.stage) {
    case Stage::kFirstHalfPre:
      return at(0, all_s);
    case Stage::kFirstHalf:
      return at(half_s - stage_s, all_s);
    case Stage::kHalfTime:
    case Stage::kSecondHalfPre:
      return at(half_s, all_s);
    case Stage::kSecondHalf:
      return at(all_s - stage_s, all_s);
    case Stage::kExtraTimeBreak:
    case Stage::kExtraFirstHalfPre:
      return at(all_s, all_s + 2 * extra_s);
    case Stage::kExtraFirstHalf:
      return at(all_s + extra_s - stage_s, all_s + 2 * extra_s);
    case Stage::kExtraHalfTime:
    case Stage::kExtraSecondHalfPre:
      return at(all_s + extra_s, all_s + 2 * extra_s);
    case Stage::kExtraSecondHalf:
      return at(all_s + 2 * extra_s - stage_s, all_s + 2 * extra_s);
    case Stage::kShootoutBreak:
    case Stage::kShootout:
    case Stage::kPostGame:
      break;
  }
  return at(all_s, all_s);
}

MatchState match_state(const StateOfPlay& play, const referee::Match& match) {
  const PlayingTime time = playing_time(play.signal, match);
  MatchState result;
  result.goals = play.signal.goals;
  result.played_s = time.played_s;
  result.left_s = time.left_s;
  for (const Side side : kSides) {
    result.xg[side] = play.statistics.counts()[side].xg;
    result.robots[side] = static_cast<int>(play.now.robots[side].size());
  }
  return result;
}

WinProbabilityObserver::WinProbabilityObserver(const GameConfiguration& game, Note note)
    : match_(game.match),
      field_(game.field),
      frame_rate_hz_(game.sim.frame_rate_hz),
      values_(&value_model(game.match.rules.name)),
      wins_(&win_model(game.match.rules.name)),
      note_(std::move(note)),
      frames_(std::lround(kEvery_s * game.sim.frame_rate_hz)) {}

void WinProbabilityObserver::on_play(const StateOfPlay& play) {
  const RefereeSignal& signal = play.signal;
  const bool has_changed = signal.goals != goals_ || signal.stage != stage_;
  if (play.now.frame < next_frame_ && !has_changed) return;
  goals_ = signal.goals;
  stage_ = signal.stage;
  next_frame_ = play.now.frame + frames_;
  MatchState match = match_state(play, match_);
  if (const std::optional<BallOwner> owner = play.statistics.ball_owner()) {
    const SituationValue value =
        values_->value(value_features(*owner, play.now, field_), owner->shot_chance);
    match.scores[owner->team] = value.scores;
    match.scores[opponent_of(owner->team)] = value.concedes;
  }
  note_(static_cast<double>(play.now.frame) / frame_rate_hz_, wins_->probability(match));
}

}  // namespace autoref::game
