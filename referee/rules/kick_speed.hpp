// No kick is faster than 8 m/s (Laws 2014, law 12), or 6.5 m/s in space (2026): called once the
// ball has been faster in three successive pictures after a robot's touch (2016), beyond the noise.
// What the carpet takes until then is added: the limit is that of the kick.
//
// Until vision can tell whether a kicked ball flies, its speed is unknown, too: a chip seems faster
// than it is. The call waits for that, or until the ball is out; then it counts as on the ground,
// as most kicks are. Nobody is blamed where nobody knows who kicked.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_kick_speed(Memory& memory, const Moment& moment);

inline constexpr Rule kKickSpeedRule{RuleId::kKickSpeed, {State::kRun}, find_kick_speed};

}  // namespace autoref::referee
