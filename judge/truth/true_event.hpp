// An event that truly happened according to the rules, derived from the exact state of the world.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::judge::ground_truth {

// How certain it is that the event happened.
enum class Standing : std::uint8_t {
  kTrue,
  kPrevented,  // about to happen when the referee stopped play; cannot be verified
  kNearMiss,   // did not happen, but was within the margin given in the rule's source file
};

struct TrueEvent {
  std::string_view name;  // name of the event, as in referee/decision.hpp
  double time_s = 0;
  std::optional<Side> offender{};  // the side at fault; nullopt if nobody or both sides are
  std::optional<RobotId> robot{};
  std::optional<Vec2> position_m{};
  Standing standing = Standing::kTrue;
  bool is_borderline = false;  // happened, but by less than the margin of kNearMiss
  bool is_in_air = false;      // the ball was in the air: a referee without heights must guess
  std::string_view or_name{};  // an equally valid name for the event
  bool is_counted = true;      // counts towards a card, if fouls of this kind do
};

using TrueEvents = std::vector<TrueEvent>;

// Adds `event` according to how far it exceeds its threshold (`excess`, in the threshold's unit).
// The event is added as true if `excess` is above 0, as a near miss if it is above `-margin`, and
// otherwise not at all.
inline void add_measured(TrueEvents& all, TrueEvent event, double excess, double margin) {
  if (!(excess > -margin)) return;
  event.standing = excess > 0 ? Standing::kTrue : Standing::kNearMiss;
  event.is_borderline = excess > 0 && excess <= margin;
  all.push_back(event);
}

}  // namespace autoref::judge::ground_truth
