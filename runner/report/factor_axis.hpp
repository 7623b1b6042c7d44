// The x axis of plots over a factor of numbers.
#pragma once

#include <string>
#include <vector>

#include "runner/report/group_names.hpp"

namespace autoref::runner {

// The lines of a script that label the axis with the factor's values and lay the baseline to the
// left.
std::string factor_axis(const NumericFactor& factor, const std::vector<Group>& groups);

// How far two marks of one value stand apart from it, in the factor's unit.
double dodge_of(const NumericFactor& factor);

// Whether any group has a game that is not void.
bool has_games(const std::vector<Group>& groups);

}  // namespace autoref::runner
