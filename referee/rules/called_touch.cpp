#include "referee/rules/called_touch.hpp"

#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Touches are confirmed well within this time, so a touch that ended earlier has already been
// judged.
constexpr double kFresh_s = 200_ms;

bool is_to_be_judged(const BallTouch& touch, const PlayState& play, double now_s) {
  return touch.robot && touch.toucher && touch.ended_s > play.in_play_since_s &&
         is_settled(touch, now_s) && !has_passed(touch.ended_s, kFresh_s, now_s);
}

// Touch times are corrected for a few frames after the first report.
constexpr double kCorrected_s = 100_ms;

}  // namespace

std::optional<Finding> find_in_touches(RefereeState& state, const RefereeInput& input,
                                       TouchCheck check) {
  const PlayState& play = state.play;
  if (!play.in_play) return std::nullopt;
  // Checks the oldest touch first, because the earliest offence decides.
  for (int back = play.touches.kept() - 1; back >= 0; --back) {
    const BallTouch& touch = play.touches.at(back);
    if (!is_to_be_judged(touch, play, input.time_s())) continue;
    if (std::optional<Finding> finding = check(state, touch, input)) return finding;
  }
  return std::nullopt;
}

bool is_called(const CalledTouch& called, const BallTouch& touch) {
  return called.robot && touch.side == called.robot->side &&
         touch.began_s <= called.ended_s + kCorrected_s;
}

CalledTouch called_at(const BallTouch& touch, double now_s) {
  return {touch.robot, touch.ended_s, now_s};
}

}  // namespace autoref::referee
