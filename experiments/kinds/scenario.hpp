// Scenarios: a single game, or an experiment of one of the kinds.
#pragma once

#include <concepts>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "experiments/kinds/experiment.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// An experiment of any kind, as a value: copies are independent. After it has been moved from, it
// can only be destroyed or assigned to.
class AnyExperiment {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): an experiment is an AnyExperiment
  AnyExperiment(std::unique_ptr<Experiment> its) : its_(std::move(its)) {}
  template <std::derived_from<Experiment> Its>
  // NOLINTNEXTLINE(google-explicit-constructor)
  AnyExperiment(Its its) : its_(std::make_unique<Its>(std::move(its))) {}
  AnyExperiment(const AnyExperiment& other) : its_(other.its_->copy()) {}
  AnyExperiment(AnyExperiment&&) = default;
  AnyExperiment& operator=(AnyExperiment other) noexcept {
    its_ = std::move(other.its_);
    return *this;
  }
  ~AnyExperiment() = default;

  Experiment& operator*() { return *its_; }
  const Experiment& operator*() const { return *its_; }

 private:
  std::unique_ptr<Experiment> its_;
};

struct Scenario {
  std::string about;
  std::variant<game::GameSettings, AnyExperiment> content;

  bool is_game() const { return std::holds_alternative<game::GameSettings>(content); }

  // These functions throw std::logic_error if the scenario is a single game.
  Experiment& experiment();
  const Experiment& experiment() const;

  // The experiment as one of the kind `Its`. Throws std::logic_error if it is of another kind.
  template <std::derived_from<Experiment> Its>
  const Its& get() const {
    if (const Its* its = as<Its>()) return *its;
    throw std::logic_error("the scenario is of another kind than " + std::string(Its::kKind.name));
  }

  // The experiment if it is of the kind `Its`, otherwise null.
  template <std::derived_from<Experiment> Its>
  Its* as() {
    return is_game() ? nullptr : dynamic_cast<Its*>(&experiment());
  }
  template <std::derived_from<Experiment> Its>
  const Its* as() const {
    return is_game() ? nullptr : dynamic_cast<const Its*>(&experiment());
  }
};

inline constexpr std::string_view kGameKind = "game";

// The scenario's value of `kind:`.
std::string_view kind_of(const Scenario& scenario);

// The verb of `autoref` that plays the scenario.
std::string_view verb_of(const Scenario& scenario);

}  // namespace autoref::experiments
