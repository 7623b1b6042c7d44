// Scenario files: one game, a sweep of games over values of factors, a round robin, a gauntlet, a
// knockout or a match of teams, or games to judge the referee.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runner/experiments/gauntlet.hpp"
#include "runner/experiments/judge_schedule.hpp"
#include "runner/experiments/knockout.hpp"
#include "runner/experiments/roundrobin.hpp"
#include "runner/experiments/sprt_match.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// A key that a sweep varies, by its short path ("b.handicap"), and its values. The first value is
// the baseline.
struct Factor {
  std::string path;
  std::vector<SettingValue> values;
  bool operator==(const Factor&) const = default;
};

// The factor's values as numbers; nullopt if one of them is a word.
std::optional<std::vector<double>> numbers_of(const Factor& factor);

// Every combination of the factors' values is played `pairs` times, two legs each.
struct Sweep {
  GameSettings base;  // its seed, a_plays and first_kickoff are given by the plan
  std::vector<Factor> factors;
  int pairs = 1;           // of legs, per combination; 1 to 9999
  std::uint64_t seed = 1;  // of the whole sweep
};

struct Scenario {
  std::string about;
  std::variant<GameSettings, Sweep, JudgeSchedule, RoundRobin, SprtMatch, Gauntlet, Knockout>
      content;
};

// Every kind, as `kind:` spells it.
const std::vector<std::string>& kinds();

// The kind as `kind:` spells it.
std::string_view kind_of(const Scenario& scenario);

// The verb of `autoref` that plays it.
std::string_view verb_of(const Scenario& scenario);

}  // namespace autoref::runner
