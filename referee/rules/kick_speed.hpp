// No kick is faster than 8 m/s (Laws 2014, law 12), or 6.5 m/s in space (2026). The limit is that
// of the kick: on the carpet, a fit of the ball's free way after a robot's touch, slowed evenly,
// tells the speed at the touch. It is told after seven frames, or when the next touch ends that
// way, or once it is beyond the limit by three standard deviations; at least four frames are
// needed. In the air, three successive speeds count (2016), their mean beyond the noise.
//
// Until vision can tell whether a kicked ball flies, its speed is unknown, too: a chip seems faster
// than it is. The call waits for that, or until the ball is out; then it counts as on the ground,
// as most kicks are. Nobody is blamed where nobody knows who kicked.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_kick_speed(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kKickSpeedRule{RuleId::kKickSpeed, {State::kRun}, find_kick_speed};

}  // namespace autoref::referee
