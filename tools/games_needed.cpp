// Compares measures of a team's success by how many games they need to find a change of the team:
// goals, expected goals (xG), and others. Cobalt plays against slightly changed cobalts.
//
//   games_needed [PAIRS]     PAIRS of games per change, at least 10; default: 200
//
// Prints a Markdown page, and on the error stream which change is being played. The exit code is 2
// if PAIRS is invalid, and 1 after any other failure.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/team_games.hpp"
#include "experiments/report/document.hpp"
#include "experiments/schedule/schedule.hpp"
#include "io/words.hpp"
#include "tools/planted/games_report.hpp"
#include "tools/planted/measured_difference.hpp"
#include "tools/planted/planted_change.hpp"

namespace autoref::tools {
namespace {

using experiments::TeamGame;

constexpr int kFewestPairs = 10;  // decisions need as many
constexpr int kDefaultPairs = 200;

std::vector<PlantedChange> all_changes() {
  return {{"5 % slower", {}, {{"handicap", "0.95"}}},
          {"10 % slower", {}, {{"handicap", "0.9"}}},
          {"shoots only if the chance is 0.3", {}, {{"params.shot_threshold", "0.3"}}},
          never_passes(),
          {"kicks three times as inaccurately", {}, {{"kicker.direction_noise_deg", "8.7"}}},
          slow_keeper()};
}

struct Measure {
  std::string name;
  experiments::TeamNumber number;
};

// Goals first.
std::vector<Measure> all_measures() {
  const auto goals = [](const TeamGame& game) { return static_cast<double>(game.goals); };
  return {
      {"goals", goals},
      {kXg, [](const TeamGame& game) { return game.own->xg; }},
      {"xGOT", [](const TeamGame& game) { return game.own->xgot; }},
      {"(goals + xG) / 2", [](const TeamGame& game) { return (game.goals + game.own->xg) / 2; }}};
}

MeasuredChange measured_change(const PlantedChange& change, int pairs) {
  const experiments::Comparison comparison = comparison_of(change, pairs);
  const experiments::RowsById rows = play_all(comparison, change.change);
  std::vector<MeasuredPairs> measures;
  for (const Measure& measure : all_measures()) {
    MeasuredPairs& measured = measures.emplace_back();
    measured.measure = measure.name;
    measured.differences.reserve(static_cast<std::size_t>(pairs));
    for (int pair = 1; pair <= pairs; ++pair) {
      const experiments::TeamNumbers numbers =
          mean_over_legs(measure.number, matchup_of(comparison), pair, rows);
      measured.differences.push_back(numbers.of_a - numbers.of_b);
    }
  }
  return {change.name, measured_differences(measures)};
}

void print_page(int pairs) {
  const std::vector<PlantedChange> changes = all_changes();
  std::vector<MeasuredChange> measured;
  measured.reserve(changes.size());
  for (const PlantedChange& change : changes) {
    fmt::print(stderr, "{} of {}: {}\n", measured.size() + 1, changes.size(), change.name);
    measured.push_back(measured_change(change, pairs));
  }
  fmt::print("{}", experiments::markdown_of(games_report(measured, pairs)));
}

// nullopt if it is invalid.
std::optional<int> pairs_in(const std::string& text) {
  const std::optional<int> pairs = io::whole_number_in(text);
  if (!pairs || *pairs < kFewestPairs || *pairs > experiments::kMostPairs) return std::nullopt;
  return pairs;
}

int main_of(const std::vector<std::string>& arguments) {
  const std::optional<int> pairs =
      arguments.empty() ? std::optional(kDefaultPairs) : pairs_in(arguments.front());
  if (!pairs || arguments.size() > 1) {
    fmt::print(stderr, "usage: games_needed [PAIRS], a whole number from {} to {}\n", kFewestPairs,
               experiments::kMostPairs);
    return 2;
  }
  print_page(*pairs);
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  return autoref::tools::main_of(std::vector<std::string>(argv + 1, argv + argc));
} catch (const std::exception& error) {
  std::fprintf(stderr, "games_needed: %s\n", error.what());
  return 1;
}
