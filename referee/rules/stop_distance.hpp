// While play is stopped, every robot keeps 500 mm away from the ball (Laws 9). Judged once the ball
// has been at its place for 2 s: until then it comes to robots that cannot know where it goes. Each
// robot is told once in a stop.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_stop_distance(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kStopDistanceRule{
    RuleId::kStopDistance, {State::kWaitStop}, find_stop_distance};

}  // namespace autoref::referee
