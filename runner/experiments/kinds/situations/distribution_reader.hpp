// Reads numbers that may be distributions.
#pragma once

#include <string>
#include <string_view>

#include "runner/experiments/kinds/situations/distribution.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// Reads a number, [low, high] or { mean, sd }. Throws InputError if anything but the tails of a
// normal distribution is outside `range`.
Distribution read_distribution(const YamlFile& file, const YamlEntry& entry,
                               const std::string& path, const Range& range, std::string_view unit);

}  // namespace autoref::runner
