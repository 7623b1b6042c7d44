// Checks what `autoref log fit` estimates against the truth: plays games whose ball, robots, kicks
// and cameras are drawn at random, fits the log of each game, and compares the estimates with what
// was drawn.
//
//   fit_truth FOLDER [LOGS] [SEED]     default: 40 logs, seed 1; each log lasts ten minutes
//
// Writes the logs to FOLDER, where they replace older ones, and prints the Markdown tables of
// results/reference/fit-truth.md. The exit code is 1 if less than 90 % of all intervals contain the
// true number, or if one of the settings or robots' limits is far off (problem_of()).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/words.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/log_fit.hpp"
#include "logs/recorded_facts.hpp"
#include "tools/fit_truth/drawn_games.hpp"

namespace autoref::tools {
namespace {

constexpr double kLeastCoverage = 0.9;

// A number of one log: what was drawn, and what the log shows.
struct Compared {
  double truth = 0;
  logs::Estimated estimated;

  double error() const { return estimated.value / truth - 1; }
  bool is_covered() const { return estimated.low <= truth && truth <= estimated.high; }
};

// Of one setting, in all logs.
struct Comparison {
  Drawn drawn;
  int logs = 0;  // including those that show too little
  std::vector<Compared> fitted;

  template <typename Predicate>
  std::size_t count(const Predicate& predicate) const {
    return static_cast<std::size_t>(std::count_if(fitted.begin(), fitted.end(), predicate));
  }
  std::vector<double> sizes() const {  // of the errors
    std::vector<double> sizes = errors();
    for (double& size : sizes) size = std::abs(size);
    return sizes;
  }
  std::vector<double> errors() const {
    std::vector<double> errors;
    errors.reserve(fitted.size());
    for (const Compared& compared : fitted) errors.push_back(compared.error());
    return errors;
  }
};

// In the order in which settings are first added.
class Comparisons {
 public:
  // `drawn` may be null: then the number is not compared.
  void add(const logs::FittedNumber& number, const Drawn* drawn, const std::string& prefix,
           const game::GameSettings& game) {
    if (drawn == nullptr) return;
    const std::string path = prefix + std::string(drawn->path);
    const double truth = io::number_in(game::value_at(game, path)).value();
    const auto [found, is_new] = by_name_.try_emplace(number.name());
    if (is_new) names_.push_back(number.name());
    Comparison& comparison = found->second;
    comparison.drawn = *drawn;
    ++comparison.logs;
    if (number.estimate.number) comparison.fitted.push_back({truth, *number.estimate.number});
  }

  template <typename Use>
  void for_each(const Use& use) const {
    for (const std::string& name : names_) use(name, by_name_.at(name));
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, Comparison> by_name_;
};

struct Tables {
  Comparisons numbers;
  Comparisons robots;  // lower bounds
};

void add_log(const std::string& log, const game::GameSettings& game, Tables& tables) {
  const logs::LogFit fit = logs::fit_of({{log, logs::facts_of(log).names}});
  for (const auto* numbers : {&fit.ball, &fit.kicker, &fit.vision}) {
    for (const logs::FittedNumber& number : *numbers)
      tables.numbers.add(number, drawn_of_game("sim." + number.name(), game), "", game);
  }
  const PerSide<std::string> names = game::shown_names(game::resolved(game));
  for (const logs::FittedTeam& team : fit.teams) {
    const std::string prefix = team.name == names[game.match.a_plays] ? "a." : "b.";
    for (const logs::FittedNumber& number : team.robots)
      tables.robots.add(number, drawn_of_robots(number.name()), prefix, game);
  }
}

// What is wrong with the estimates of a setting: a median error of over three times the target,
// more than half of the intervals beside the truth, or too few logs that show enough. Empty if
// nothing is.
std::string problem_of(const Comparison& all) {
  constexpr double kFarOff = 3;
  constexpr std::size_t kEnough = 4;  // estimates, to say anything
  const std::size_t fitted = all.fitted.size();
  if (all.drawn.shown == Shown::kAlways && static_cast<int>(2 * fitted) < all.logs)
    return "estimated in less than half of the logs";
  if (fitted < kEnough) return "";
  if (2 * all.count([](const Compared& one) { return one.is_covered(); }) < fitted)
    return "more than half of the intervals do not contain the truth";
  const bool is_far_off =
      all.drawn.target > 0 && logs::median(all.sizes()) > kFarOff * all.drawn.target;
  return is_far_off ? "far off" : "";
}

// The same for what robots reached, which must not be much more than their limits.
std::string problem_of_robots(const Comparison& all) {
  constexpr double kMost = 0.1;  // more
  if (static_cast<int>(2 * all.fitted.size()) < all.logs)
    return "estimated for less than half of the teams";
  const std::vector<double> errors = all.errors();
  return *std::max_element(errors.begin(), errors.end()) > kMost ? "above the limit" : "";
}

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string target_text(const Drawn& drawn) {
  return drawn.target > 0 ? fmt::format("{:.0f} %", 100 * drawn.target) : "";
}

// The first cells of a row.
std::string row_head(const std::string& name, const Comparison& all) {
  return fmt::format("| `{}` | {:g} to {:g} | {} of {} |", name, all.drawn.low, all.drawn.high,
                     all.fitted.size(), all.logs);
}

// Prints a row for each setting. Returns the share of all intervals that contain the true number.
double print_numbers(const Comparisons& comparisons) {
  fmt::print(
      "| setting below sim | drawn from | estimated in | median error | target | largest error | "
      "median of signed errors | intervals that contain the truth "
      "|\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
  std::size_t intervals = 0;
  std::size_t covered = 0;
  comparisons.for_each([&](const std::string& name, const Comparison& all) {
    const std::size_t fitted = all.fitted.size();
    fmt::print("{}", row_head(name, all));
    if (fitted == 0) {
      fmt::print(" | {} | | | |\n", target_text(all.drawn));
      return;
    }
    const std::vector<double> errors = all.errors();
    const std::vector<double> sizes = all.sizes();
    const std::size_t contain = all.count([](const Compared& one) { return one.is_covered(); });
    fmt::print(" {} | {} | {} | {:+.1f} % | {} of {} |\n", percent(logs::median(sizes)),
               target_text(all.drawn), percent(*std::max_element(sizes.begin(), sizes.end())),
               100 * logs::median(errors), contain, fitted);
    intervals += fitted;
    covered += contain;
  });
  const double share =
      intervals == 0 ? 0 : static_cast<double>(covered) / static_cast<double>(intervals);
  fmt::print("\n{} of {} intervals contain the true number: {}.\n", covered, intervals,
             percent(share));
  return share;
}

void print_robots(const Comparisons& comparisons) {
  fmt::print(
      "| setting of a robot | drawn from | estimated in | median of estimate / limit | least | "
      "most | intervals that begin below the limit |\n|---|--:|--:|--:|--:|--:|--:|\n");
  comparisons.for_each([](const std::string& name, const Comparison& all) {
    if (all.fitted.empty()) return;
    const std::vector<double> errors = all.errors();
    const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
    fmt::print("{} {} | {} | {} | {} of {} |\n", row_head(name, all),
               percent(1 + logs::median(errors)), percent(1 + *least), percent(1 + *most),
               all.count([](const Compared& one) { return one.estimated.low <= one.truth; }),
               all.fitted.size());
  });
}

// Prints the page of results/reference. Returns the share of the intervals that contain the truth.
double print_page(const Tables& tables, int count, int seed) {
  fmt::print(
      "# Numbers estimated from logs, against the truth\n\n"
      "Written by `build/release/bin/fit_truth FOLDER {} {}`. It plays {} games whose numbers are "
      "drawn\nat random, writes the first ten minutes of each as a log, and estimates the numbers "
      "from each log\nalone, like `autoref log fit`. `cobalt` plays against four teams in turn, "
      "under the rules of\n2014, 2026-b and 2026-a with four, one and two cameras; in half of the "
      "games, the teams place\nthe ball. \"Estimated in\" counts the logs with enough "
      "observations; about the others, the program\nsays \"not enough\".\n\n"
      "## Ball, contacts, kicks and cameras\n\n",
      count, seed, count);
  const double share = print_numbers(tables.numbers);
  fmt::print(
      "\n## Robots\n\nEach team of each log has robots of its own. The estimate is what they "
      "reached: a lower\nbound of their limits. Short manoeuvres do not show these fully.\n\n");
  print_robots(tables.robots);
  return share;
}

// Returns whether there is none.
bool report_problems(const Tables& tables, double share) {
  bool is_good = share >= kLeastCoverage;
  const auto report = [&](const std::string& name, const std::string& problem) {
    if (problem.empty()) return;
    fmt::print(stderr, "{}: {}\n", name, problem);
    is_good = false;
  };
  tables.numbers.for_each(
      [&](const std::string& name, const Comparison& all) { report(name, problem_of(all)); });
  tables.robots.for_each([&](const std::string& name, const Comparison& all) {
    report(name, problem_of_robots(all));
  });
  return is_good;
}

int main_of(const std::string& folder, int count, int seed) {
  std::filesystem::create_directories(folder);
  Tables tables;
  for (int number = 0; number < count; ++number) {
    const game::GameSettings game =
        drawn_game(static_cast<std::size_t>(number), static_cast<std::uint64_t>(seed));
    const std::string log = fmt::format("{}/{}.log.gz", folder, number);
    write_log(game, log);
    add_log(log, game, tables);
    fmt::print(stderr, "{} of {}\n", number + 1, count);
  }
  return report_problems(tables, print_page(tables, count, seed)) ? 0 : 1;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  constexpr int kDefaultLogs = 40;
  const auto count = argc > 2 ? autoref::io::whole_number_in(argv[2]) : kDefaultLogs;
  const auto seed = argc > 3 ? autoref::io::whole_number_in(argv[3]) : 1;
  if (argc < 2 || argc > 4 || !count || *count < 1 || !seed || *seed < 0) {
    std::fprintf(stderr, "usage: fit_truth FOLDER [LOGS] [SEED]\n");
    return 2;
  }
  return autoref::tools::main_of(argv[1], *count, *seed);
} catch (const std::exception& error) {
  std::fprintf(stderr, "fit_truth: %s\n", error.what());
  return 1;
}
