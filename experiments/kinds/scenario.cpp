#include "experiments/kinds/scenario.hpp"

#include <stdexcept>

namespace autoref::experiments {

Experiment& Scenario::experiment() {
  if (auto* its = std::get_if<AnyExperiment>(&content)) return **its;
  throw std::logic_error("a single game is not an experiment");
}

const Experiment& Scenario::experiment() const {
  if (const auto* its = std::get_if<AnyExperiment>(&content)) return **its;
  throw std::logic_error("a single game is not an experiment");
}

std::string_view kind_of(const Scenario& scenario) {
  return scenario.is_game() ? kGameKind : scenario.experiment().kind().name;
}

std::string_view verb_of(const Scenario& scenario) {
  return scenario.is_game() ? "play" : scenario.experiment().kind().verb;
}

}  // namespace autoref::experiments
