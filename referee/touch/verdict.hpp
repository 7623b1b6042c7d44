// Which of several candidates touched the ball, or that nobody can know.
#pragma once

#include <optional>

#include "referee/touch/touch_candidates.hpp"
#include "referee/touch_parameters.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

struct Verdict {
  bool is_touch = false;             // whether a robot touched the ball at all
  std::optional<Side> side;          // none: unknown
  std::optional<RobotId> robot;      // none: unknown, or one of several of that side
  std::optional<RobotId> runner_up;  // the best of the other side, or else of the same
  double gap_m = 0;
  double share = 0;
};

// Candidates that explain the change of velocity go before those that do not, unless these have the
// ball pinned against them. Among equals the side
// that is nearer by a clear lead touched the ball; without a lead nobody knows. A goal that is as
// near as the best robot makes the touch unknown, unless that robot's side had it before, and one
// that is clearly nearer makes it no touch.
Verdict attribute_touch(const Candidates& candidates, double gap_to_goals_m,
                        std::optional<Side> had_it, const TouchParameters& parameters);

}  // namespace autoref::referee
