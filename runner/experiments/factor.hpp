// A setting varied by a sweep.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/settings/setting_value.hpp"

namespace autoref::runner {

// A setting varied by a sweep, by its short path ("b.handicap"), and its values. The first value is
// the baseline.
struct Factor {
  std::string path;
  std::vector<SettingValue> values;
  bool operator==(const Factor&) const = default;
};

// The factor's values as numbers; nullopt if one of them is a word.
std::optional<std::vector<double>> numbers_of(const Factor& factor);

}  // namespace autoref::runner
