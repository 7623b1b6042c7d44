#include "runner/judge/truth/witness.hpp"

#include <algorithm>
#include <array>

#include "runner/judge/truth/truths.hpp"

namespace autoref::runner::truth {
namespace {

constexpr double kLongAgo_s = -1e9;

// What counts as a foul for a goal's validity where fouls let play go on.
constexpr std::array<std::string_view, 4> kFouls = {"crash", "crash_drawn", "pushing",
                                                    "restart_distance"};

}  // namespace

Witness::Witness(const Field& field, const RuleBook& rules, double frame_rate_hz)
    : field_(field),
      rules_(rules),
      frame_s_(1.0 / frame_rate_hz),
      play_(rules),
      ball_(rules),
      truths_(truths_of(rules)),
      fouled_s_{{kLongAgo_s, kLongAgo_s}} {}

void Witness::see(const sim::World& world, const RefereeSignal& signal) {
  see(world.state(), world.touches(), world.meetings(), signal);
}

void Witness::see(const sim::WorldState& now, std::span<const sim::Touch> touches,
                  std::span<const sim::Meeting> meetings, const RefereeSignal& signal) {
  const double time_s = static_cast<double>(now.frame) * frame_s_;
  if (has_begun_) {
    ball_.update(now, touches, time_s);
    tell({field_, rules_, time_s, frame_s_, before_, now, touches, meetings,
          play_.update(now, time_s, signal), ball_, signal_, keepers_, fouled_s_});
  }
  has_begun_ = true;
  const int count = play_.play().count;
  play_.obey(now, time_s, signal);
  if (play_.play().count != count && play_.play().is_on) ball_.begin();
  before_ = now;
  signal_ = signal;
}

void Witness::tell(const Scene& scene) {
  const std::size_t from = happenings_.size();
  for (const auto& truth : truths_) truth->watch(scene, happenings_);
  note_fouls(from);
}

void Witness::note_fouls(std::size_t from) {
  for (std::size_t i = from; i < happenings_.size(); ++i) {
    const Happening& happening = happenings_[i];
    const bool is_foul = happening.standing == Standing::kTrue &&
                         std::find(kFouls.begin(), kFouls.end(), happening.name) != kFouls.end();
    if (!is_foul) continue;
    for (const Side side : kSides) {
      if (happening.offender.value_or(side) == side) fouled_s_[side] = happening.time_s;
    }
  }
}

}  // namespace autoref::runner::truth
