// What truly happened on the field: one event by the rules, told from the exact world.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::runner::ground_truth {

// How surely it happened.
enum class Standing : std::uint8_t {
  kTrue,
  kPrevented,  // was about to happen when the referee ended play: nobody can tell any more
  kNearMiss,   // did not happen, but within the margin that the rule's truth names
};

struct TrueEvent {
  std::string_view name;  // as in referee/decision.hpp
  double time_s = 0;
  std::optional<Side> offender{};  // at fault; none where nobody or both are
  std::optional<RobotId> robot{};
  std::optional<Vec2> position_m{};
  Standing standing = Standing::kTrue;
  bool is_borderline = false;  // true, but within the same margin
  bool is_in_air = false;      // the ball flew: who sees no height must guess
};

using TrueEvents = std::vector<TrueEvent>;

// Adds `event` by how far it is beyond its threshold (`excess`, in the threshold's unit): true
// above 0, a near miss down to `-margin`, nothing below.
inline void add_measured(TrueEvents& all, TrueEvent event, double excess, double margin) {
  if (!(excess > -margin)) return;
  event.standing = excess > 0 ? Standing::kTrue : Standing::kNearMiss;
  event.is_borderline = excess > 0 && excess <= margin;
  all.push_back(event);
}

}  // namespace autoref::runner::ground_truth
