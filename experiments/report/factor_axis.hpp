// The x axis of plots over a numeric factor.
#pragma once

#include <string>
#include <vector>

#include "experiments/report/group_names.hpp"

namespace autoref::experiments {

// Script lines that label the axis with the factor's values, with the baseline on the left.
std::string factor_axis(const NumericFactor& factor, const std::vector<Group>& groups);

// Sideways shift that separates two marks at the same value, in the factor's unit.
double dodge_of(const NumericFactor& factor);

// Returns whether any group has a game that is not void.
bool has_games(const std::vector<Group>& groups);

}  // namespace autoref::experiments
