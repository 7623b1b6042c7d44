// Decides which of several candidates touched the ball, if that can be decided.
#pragma once

#include <optional>

#include "referee/touch/touch_candidates.hpp"
#include "referee/touch_parameters.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

struct Verdict {
  bool is_touch = false;         // whether a robot touched the ball at all
  std::optional<Side> side;      // nullopt if unknown
  std::optional<RobotId> robot;  // nullopt if unknown, or one of several of that side
  // The best candidate of the other side, or of the same side if the other has none.
  std::optional<RobotId> runner_up;
  double gap_m = 0;
  double share = 0;
};

// Candidates that explain the velocity change come before those that do not, unless the ball is
// pinned against one of the latter. Among equals, the side that is nearer by `lead_m` touched the
// ball; otherwise the side is unknown. If a goal is about as near as the best robot, the touch is
// unknown, unless that robot's side touched the ball before (`had_it`); if a goal is clearly
// nearer, there was no touch.
Verdict attribute_touch(const Candidates& candidates, double gap_to_goals_m,
                        std::optional<Side> had_it, const TouchParameters& parameters);

}  // namespace autoref::referee
