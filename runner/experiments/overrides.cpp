#include "runner/experiments/overrides.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "runner/experiments/knockout_schedule.hpp"
#include "runner/experiments/matchup_schedule.hpp"
#include "runner/experiments/situations_schedule.hpp"
#include "runner/experiments/sprt_settings.hpp"
#include "runner/experiments/tuning_schedule.hpp"
#include "runner/experiments/with_kind.hpp"

namespace autoref::runner {
namespace {

int* pairs_in(Sweep& sweep) { return &sweep.pairs; }
int* pairs_in(RoundRobin& robin) { return &robin.pairs; }
int* pairs_in(Gauntlet& gauntlet) { return &gauntlet.pairs; }
int* pairs_in(Situations& situations) { return &situations.pairs; }
int* pairs_in(SprtMatch& match) { return &match.sprt.max_pairs; }
int* pairs_in(Tuning& tuning) { return &tuning.pairs; }
int* pairs_in(Knockout& /*knockout*/) { return nullptr; }
int* pairs_in(JudgeSchedule& /*schedule*/) { return nullptr; }  // it has a number of games instead

template <typename Experiment>
std::optional<std::uint64_t> master_seed_in(const Experiment& experiment) {
  return experiment.seed;
}

std::optional<std::uint64_t> master_seed_in(const JudgeSchedule& schedule) {
  const NamedSeed& seed = schedule.seeds.front();
  return seed.name.empty() ? std::optional(seed.value) : std::nullopt;
}

template <typename Experiment>
void set_seed(std::uint64_t seed, Experiment& experiment) {
  experiment.seed = seed;
}

void set_seed(std::uint64_t seed, JudgeSchedule& schedule) {
  schedule.seeds = {{"", std::to_string(seed), seed}};
}

// Throws if the number of pairs contradicts other settings.
template <typename Experiment>
void check_pairs(const Experiment& experiment) {
  if constexpr (std::is_same_v<Experiment, SprtMatch>) check_test(experiment.sprt);
  if constexpr (!std::is_same_v<Experiment, JudgeSchedule>) scheduled_games(experiment);
}

}  // namespace

std::optional<int> pairs_of(const Scenario& experiment) {
  return with_kind(experiment, [](auto its) -> std::optional<int> {
    const int* const pairs = pairs_in(its);
    return pairs == nullptr ? std::nullopt : std::optional(*pairs);
  });
}

std::optional<std::uint64_t> master_seed_of(const Scenario& experiment) {
  return with_kind(experiment, [](const auto& its) { return master_seed_in(its); });
}

void set_pairs(Scenario& experiment, int pairs) {
  if (pairs < 1 || pairs > kMostPairs) {
    throw std::invalid_argument(
        fmt::format("expected a whole number from 1 to {}, found {}", kMostPairs, pairs));
  }
  experiment.content = with_kind(experiment, [pairs](auto its) -> decltype(Scenario::content) {
    int* const place = pairs_in(its);
    if (place == nullptr) {
      throw std::invalid_argument(
          "a knockout has no pairs: each tie is one game, replayed if it is drawn");
    }
    *place = pairs;
    check_pairs(its);
    return its;
  });
}

void set_master_seed(Scenario& experiment, std::uint64_t seed) {
  experiment.content = with_kind(experiment, [seed](auto its) -> decltype(Scenario::content) {
    set_seed(seed, its);
    return its;
  });
}

}  // namespace autoref::runner
