// Dispatches on the kind of an experiment.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <type_traits>
#include <variant>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// Calls the overload of `work` for the scenario's kind of experiment. Throws std::logic_error for a
// single game.
template <typename Work>
auto with_kind(const Scenario& scenario, const Work& work) {
  using Result = decltype(work(std::declval<const Sweep&>()));
  return std::visit(
      [&](const auto& content) -> Result {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, GameSettings>) {
          throw std::logic_error(fmt::format("a {} is not an experiment", kind_of(scenario)));
        } else {
          return work(content);
        }
      },
      scenario.content);
}

}  // namespace autoref::runner
