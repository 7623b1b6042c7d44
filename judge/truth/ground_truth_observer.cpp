#include "judge/truth/ground_truth_observer.hpp"

#include <algorithm>
#include <array>

#include "judge/truth/ground_truth_rules.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kLongAgo_s = -1e9;

// The non-stopping fouls of the 2026 rules that invalidate a later goal of the same team.
constexpr std::array<std::string_view, 4> kFouls = {"attacker_touched_ball_in_defense_area",
                                                    "bot_kicked_ball_too_fast", "bot_crash_unique",
                                                    "bot_crash_drawn"};

}  // namespace

GroundTruthObserver::GroundTruthObserver(const Field& field, const RuleBook& rules,
                                         double frame_rate_hz)
    : field_(field),
      rules_(rules),
      frame_s_(1.0 / frame_rate_hz),
      play_(rules),
      ball_(field, rules),
      rules_of_truth_(ground_truth_rules_of(rules)),
      fouled_s_{{kLongAgo_s, kLongAgo_s}} {}

void GroundTruthObserver::see(const sim::World& world, const RefereeSignal& signal) {
  see(world.state(), world.touches(), world.collisions(), signal);
}

void GroundTruthObserver::see(const sim::WorldState& now, std::span<const sim::Touch> touches,
                              std::span<const sim::RobotCollision> collisions,
                              const RefereeSignal& signal) {
  const double time_s = static_cast<double>(now.frame) * frame_s_;
  if (has_begun_) {
    ball_.update(now, touches, time_s);
    write_message({field_, rules_, time_s, frame_s_, before_, now, touches, collisions,
                   play_.update(now, time_s, signal), ball_, signal_, keepers_, fouled_s_});
  }
  has_begun_ = true;
  const int count = play_.play().count;
  play_.obey(now, time_s, signal);
  if (play_.play().count != count && play_.play().is_on) ball_.begin();
  before_ = now;
  signal_ = signal;
}

void GroundTruthObserver::write_message(const TrueFrame& frame) {
  for (const auto& ground_truth : rules_of_truth_) {
    const std::size_t from = true_events_.size();
    ground_truth->watch(frame, true_events_);
    note_fouls(from);  // immediately, since a goal in this frame depends on them
  }
}

void GroundTruthObserver::note_fouls(std::size_t from) {
  for (std::size_t i = from; i < true_events_.size(); ++i) {
    const TrueEvent& event = true_events_[i];
    const bool is_foul = event.standing == Standing::kTrue &&
                         std::find(kFouls.begin(), kFouls.end(), event.name) != kFouls.end();
    if (!is_foul) continue;
    for (const Side side : kSides) {
      if (event.offender.value_or(side) == side) fouled_s_[side] = event.time_s;
    }
  }
}

}  // namespace autoref::judge::ground_truth
