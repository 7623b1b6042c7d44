// Two opponents run into each other: substantial contact (Laws 12), crashing (2026).
//
// What counts is the difference of their velocities just before, along the line of their centres.
// The faster robot is at fault. Where the speeds differ by less than 0.3 m/s, nobody is by the Laws
// of 2014 (play goes on without a call), and both are by the rules of 2026.
//
// Robots meet when their cylinders of 180 mm do. Where both fronts are flat, hulls are up to 30 mm
// apart then, but robots that close at 1.5 m/s need four times that to brake.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_crash(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kCrashRule{RuleId::kCrash, {State::kRun}, find_crash};

}  // namespace autoref::referee
