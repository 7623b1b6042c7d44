// The settings of a sequential test, for the kinds of experiments that use one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/statistics/sequential_test.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {

// The meaning of the two error rates in an experiment.
struct ErrorRates {
  std::string_view alpha;
  std::string_view beta;
};

// The error rates and the numbers of pairs, below `branch` ("sprt" or "test").
std::vector<game::Setting> settings_of(SequentialTest& test, const std::string& branch,
                                       const ErrorRates& about);

// Throws SettingError if individually valid settings contradict each other.
void check_test(const SequentialTest& test, const std::string& branch);

}  // namespace autoref::experiments
