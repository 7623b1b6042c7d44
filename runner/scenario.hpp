// Scenario files: one game, a sweep of games over values of factors, a round robin, a gauntlet, a
// knockout or a match of teams, or games to judge the referee.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runner/configuration.hpp"
#include "runner/gauntlet.hpp"
#include "runner/judge_plan.hpp"
#include "runner/knockout.hpp"
#include "runner/match.hpp"
#include "runner/roundrobin.hpp"

namespace autoref::runner {

// A key that a sweep varies, by its short path ("b.handicap"), and its values as assign() reads
// them. The first value is the baseline.
struct Factor {
  std::string path;
  std::vector<std::string> values;
  bool operator==(const Factor&) const = default;
};

// Every combination of the factors' values is played `pairs` times, two legs each.
struct Sweep {
  GameConfiguration base;  // its seed, a_plays and first_kickoff are given by the plan
  std::vector<Factor> factors;
  int pairs = 1;           // of legs, per combination; 1 to 9999
  std::uint64_t seed = 1;  // of the whole sweep
};

struct Scenario {
  std::string about;
  std::variant<GameConfiguration, Sweep, JudgePlan, RoundRobin, Match, Gauntlet, Knockout> content;
};

// The kind as `kind:` spells it.
std::string_view kind_of(const Scenario& scenario);

// The verb of `autoref` that plays it.
std::string_view verb_of(const Scenario& scenario);

// Reads a scenario strictly: every key must be known and given once, every value in its range.
// What is not given has its default. Throws InputError with file, line and key.
Scenario read_scenario(const std::filesystem::path& file);
Scenario read_scenario_text(const std::string& text, const std::string& file_name);

// The scenario with every setting spelt out, each with its meaning as a comment. Reading it gives
// the same scenario again.
std::string effective_text(const Scenario& scenario);

}  // namespace autoref::runner
