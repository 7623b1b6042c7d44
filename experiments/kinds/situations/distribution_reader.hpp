// Reads numbers that may be distributions.
#pragma once

#include <string>
#include <string_view>

#include "experiments/kinds/situations/distribution.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::experiments {

// Reads a number, [low, high] or { mean, sd }. Throws InputError if anything but the tails of a
// normal distribution is outside `range`.
Distribution read_distribution(const game::YamlFile& file, const game::YamlEntry& entry,
                               const std::string& path, const Range& range, std::string_view unit);

}  // namespace autoref::experiments
