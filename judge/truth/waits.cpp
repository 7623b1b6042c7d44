// Timeouts: restarts not taken, and balls without progress.
#include <algorithm>
#include <deque>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// If play ends less than this time before the limit, the call was early.
constexpr double kWaitLead_s = 0.2;

// Adds the event if its time limit has passed, or if it was about to pass when play ended.
bool add_timed(const TrueFrame& frame, TrueEvent event, double excess_s, TrueEvents& all) {
  const double half_frame_s = frame.frame_s / 2;
  if (excess_s < -half_frame_s && !(frame.play.ends_now && excess_s > -kWaitLead_s)) return false;
  if (excess_s < -half_frame_s) event.standing = Standing::kPrevented;
  all.push_back(event);
  return true;
}

class UntakenRestart final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const TruePlay& play = frame.play;
    if (!play.is_on || play.in_play || !play.taker || reported_ == play.count) return;
    if (play.is_penalty() && frame.may_penalty_fail()) return;
    const double limit_s = play.is_kickoff() || play.is_penalty() ? frame.rules.restart_timeout_s
                                                                  : frame.rules.free_kick_timeout_s;
    const TrueEvent untaken{"restart_not_taken", frame.time_s, play.taker, std::nullopt,
                            play.ball_from_m};
    const double waited_s = frame.time_s - waits_since_s(play, all);
    if (add_timed(frame, untaken, waited_s - limit_s, all)) reported_ = play.count;
  }

 private:
  // 2026 rules: an opponent that is too close to the ball for too long resets the time limit for
  // the kicker.
  static double waits_since_s(const TruePlay& play, const TrueEvents& all) {
    for (auto it = all.rbegin(); it != all.rend() && it->time_s > play.began_s; ++it) {
      if (it->name == "defender_too_close_to_kick_point" && it->standing == Standing::kTrue)
        return it->time_s;
    }
    return play.began_s;
  }

  int reported_ = -1;
};

// The ball is stuck if it stays for `stuck_time_s` within `stuck_distance_m` of its initial
// position.
class StuckBall final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!frame.play.is_on || !frame.play.in_play || frame.play.entered_now || is_held(frame)) {
      positions_m_.clear();
      is_reported_ = false;
      return;
    }
    positions_m_.push_back(frame.now.ball.position_m);
    const double limit_s = frame.rules.stuck_time_s;
    const auto frames = static_cast<std::size_t>(limit_s / frame.frame_s + 1.5);
    // A sliding window as long as the limit: the ball is stuck if all positions in the window are
    // near its first one.
    if (positions_m_.size() > frames) positions_m_.pop_front();
    const double excess_s = static_cast<double>(positions_m_.size() - 1) * frame.frame_s - limit_s;
    if (excess_s < -kWaitLead_s || !has_stayed(frame.rules.stuck_distance_m)) {
      is_reported_ = false;
      return;
    }
    const bool is_2026 = frame.rules.has(RuleId::kNoProgressInGame);
    TrueEvent stuck{is_2026 ? "no_progress_in_game" : "stuck_ball", frame.time_s, std::nullopt,
                    std::nullopt, frame.now.ball.position_m};
    if (!is_reported_) {
      is_reported_ = add_timed(frame, stuck, excess_s, all);
    } else if (frame.play.ends_now) {  // still stuck: a call now is merely late
      stuck.standing = Standing::kNearMiss;
      all.push_back(stuck);
    }
  }

 private:
  // Where keeper_held_ball is in force, it alone applies to a keeper's ball.
  static bool is_held(const TrueFrame& frame) {
    return frame.rules.has(RuleId::kKeeperHeldBall) &&
           std::any_of(kSides.begin(), kSides.end(),
                       [&frame](Side side) { return is_keepers_ball(frame, side); });
  }

  bool has_stayed(double within_m) const {
    return std::all_of(positions_m_.begin(), positions_m_.end(), [&](const Vec2& position_m) {
      return (position_m - positions_m_.front()).norm() < within_m;
    });
  }

  std::deque<Vec2> positions_m_;
  bool is_reported_ = false;
};

}  // namespace

std::unique_ptr<GroundTruthRule> untaken_restart() { return std::make_unique<UntakenRestart>(); }
std::unique_ptr<GroundTruthRule> stuck_ball() { return std::make_unique<StuckBall>(); }

}  // namespace autoref::judge::ground_truth
