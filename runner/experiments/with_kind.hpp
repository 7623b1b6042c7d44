// Telling the kinds of experiments apart.
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// Calls the overload of `work` for the scenario's kind of experiment.
template <typename Work>
auto with_kind(const Scenario& scenario, const Work& work) {
  if (const auto* sweep = std::get_if<Sweep>(&scenario.content)) return work(*sweep);
  if (const auto* robin = std::get_if<RoundRobin>(&scenario.content)) return work(*robin);
  if (const auto* match = std::get_if<SprtMatch>(&scenario.content)) return work(*match);
  if (const auto* gauntlet = std::get_if<Gauntlet>(&scenario.content)) return work(*gauntlet);
  if (const auto* knockout = std::get_if<Knockout>(&scenario.content)) return work(*knockout);
  throw std::logic_error(fmt::format("a {} is no experiment", kind_of(scenario)));
}

}  // namespace autoref::runner
