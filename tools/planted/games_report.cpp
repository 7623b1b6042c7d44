#include "tools/planted/games_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "experiments/kinds/compare/parts_report.hpp"
#include "experiments/statistics/ratings.hpp"
#include "io/words.hpp"

namespace autoref::tools {
namespace {

using experiments::Interval;
using experiments::mean_with_interval;
using Rows = std::vector<std::vector<std::string>>;

bool excludes(const std::optional<Interval>& interval, double value) {
  return interval && (value < interval->low || interval->high < value);
}

const MeasuredDifference& goals_of(const MeasuredChange& change) { return change.measures.front(); }

const MeasuredDifference& xg_of(const MeasuredChange& change) {
  return *std::find_if(change.measures.begin(), change.measures.end(),
                       [](const MeasuredDifference& measured) { return measured.measure == kXg; });
}

std::string factor_text(double factor) {
  return factor < kMostRelativeGames ? fmt::format("{:.2f}", factor)
                                     : fmt::format(">{:.0f}", kMostRelativeGames);
}

std::string relative_text(const RelativeGames& relative) {
  return fmt::format("{} [{}, {}]", factor_text(relative.factor),
                     factor_text(relative.interval.low), factor_text(relative.interval.high));
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

std::string games_text(const std::optional<int>& games, const std::string& otherwise) {
  return games ? std::to_string(*games) : otherwise;
}

using RowOf = std::function<std::vector<std::string>(const MeasuredDifference& measured)>;

// A row per change and measure.
experiments::Table table_of(const std::vector<MeasuredChange>& changes,
                            std::vector<std::string> head, const RowOf& row_of) {
  head.insert(head.begin(), {"change", "measure"});
  Rows rows = {std::move(head)};
  for (const MeasuredChange& change : changes) {
    for (const MeasuredDifference& measured : change.measures) {
      std::vector<std::string> row = row_of(measured);
      row.insert(row.begin(), {change.name, measured.measure});
      rows.push_back(std::move(row));
    }
  }
  return {std::move(rows), 2};
}

experiments::Table differences_table(const std::vector<MeasuredChange>& changes) {
  return table_of(changes,
                  {"changed minus usual team [95 %]", "minus that of goals [95 %]",
                   "standard deviation", "correlation with goals"},
                  [](const MeasuredDifference& measured) {
                    return std::vector<std::string>{
                        mean_with_interval(measured.mean, measured.interval),
                        mean_with_interval(measured.minus_goals, measured.minus_goals_interval),
                        fmt::format("{:.2f}", measured.sd),
                        measured.correlation ? fmt::format("{:.2f}", *measured.correlation) : "-"};
                  });
}

experiments::Table games_table(const std::vector<MeasuredChange>& changes, int pairs) {
  return table_of(changes,
                  {"games", "relative to goals [95 %]", "relative, if the means were equal",
                   "games until a decision", "right", "wrong"},
                  [most = fmt::format(">{}", 2 * pairs)](const MeasuredDifference& measured) {
                    return std::vector<std::string>{
                        games_text(measured.games, "-"),
                        relative_text(measured.relative),
                        factor_text(measured.relative_with_equal_means),
                        games_text(measured.decisions.median_games, most),
                        percent(measured.decisions.right),
                        percent(measured.decisions.wrong)};
                  });
}

// The changes in which a measure has this verdict or property.
std::vector<std::string> names_of(const std::vector<MeasuredChange>& changes,
                                  const std::function<bool(const MeasuredChange& change)>& has) {
  std::vector<std::string> names;
  for (const MeasuredChange& change : changes)
    if (has(change)) names.push_back(change.name);
  return names;
}

// "2 (5 % slower, slow keeper)"; "0".
std::string counted(const std::vector<std::string>& names) {
  return names.empty() ? "0" : fmt::format("{} ({})", names.size(), io::listed(names));
}

std::vector<std::string> names_with(GamesVerdict verdict,
                                    const std::vector<MeasuredChange>& changes) {
  return names_of(changes, [verdict](const MeasuredChange& change) {
    return verdict_of(xg_of(change), goals_of(change)) == verdict;
  });
}

std::string answer_about_games(const std::vector<MeasuredChange>& changes) {
  std::vector<double> factors;
  for (const MeasuredChange& change : changes) {
    if (verdict_of(xg_of(change), goals_of(change)) != GamesVerdict::kUnknown)
      factors.push_back(xg_of(change).relative.factor);
  }
  if (factors.empty())
    return "No difference in goals is certain, so it remains open whether xG needs fewer games.";
  return fmt::format(
      "Of the changes with a certain difference in goals, xG needs fewer games than goals for {}, "
      "more games for {}, and an uncertain number for {}; the median is {} times as many.",
      counted(names_with(GamesVerdict::kFewer, changes)),
      counted(names_with(GamesVerdict::kMore, changes)),
      counted(names_with(GamesVerdict::kUncertain, changes)),
      factor_text(experiments::quantile_of(factors, 0.5)));
}

std::string answer_about_means(const std::vector<MeasuredChange>& changes) {
  const std::vector<std::string> names = names_of(changes, [](const MeasuredChange& change) {
    return excludes(xg_of(change).minus_goals_interval, 0);
  });
  if (names.empty())
    return "The mean by xG does not certainly differ from that by goals for any change.";
  return fmt::format(
      "The mean by xG certainly differs from that by goals for {} of the {} changes: {}.",
      names.size(), changes.size(), io::listed(names));
}

std::string games_sentence(const MeasuredDifference& xg, const MeasuredDifference& goals) {
  const std::string factor = relative_text(xg.relative);
  switch (verdict_of(xg, goals)) {
    case GamesVerdict::kUnknown:
      return "The difference in goals is uncertain, and with it the number of games";
    case GamesVerdict::kFewer:
      return fmt::format("xG needs fewer games, {} times as many", factor);
    case GamesVerdict::kMore:
      return fmt::format("xG needs more games, {} times as many", factor);
    case GamesVerdict::kUncertain:
      break;
  }
  return fmt::format("Whether xG needs fewer games is uncertain: {} times as many", factor);
}

std::string means_sentence(const MeasuredDifference& xg) {
  const std::string difference = mean_with_interval(xg.minus_goals, xg.minus_goals_interval);
  return excludes(xg.minus_goals_interval, 0)
             ? fmt::format("The mean by xG certainly differs from that by goals: {}", difference)
             : fmt::format("The mean by xG does not certainly differ from that by goals: {}",
                           difference);
}

experiments::List sentences_about(const std::vector<MeasuredChange>& changes) {
  experiments::List list;
  list.items.reserve(changes.size());
  for (const MeasuredChange& change : changes) {
    list.items.push_back(fmt::format("{}: {}. {}.", change.name,
                                     games_sentence(xg_of(change), goals_of(change)),
                                     means_sentence(xg_of(change))));
  }
  return list;
}

std::string introduction(int pairs) {
  return fmt::format(
      "A changed cobalt played the usual one in {} pairs of games for each change, under the rules "
      "of 2026-b. The legs of a pair have the same seed and changed sides, as in comparisons. Each "
      "measure is a difference between the two teams, in goals per game: goals, expected goals "
      "(xG), expected goals on target (xGOT), and the mean of goals and xG. This command made the "
      "page:",
      pairs);
}

}  // namespace

GamesVerdict verdict_of(const MeasuredDifference& measured, const MeasuredDifference& goals) {
  if (!excludes(goals.interval, 0)) return GamesVerdict::kUnknown;
  if (measured.relative.interval.high < 1) return GamesVerdict::kFewer;
  if (measured.relative.interval.low > 1) return GamesVerdict::kMore;
  return GamesVerdict::kUncertain;
}

experiments::Document games_report(const std::vector<MeasuredChange>& changes, int pairs) {
  using experiments::Heading;
  using experiments::Paragraph;
  return {
      "Games needed to find a change",
      {Paragraph{introduction(pairs)},
       experiments::Verbatim{fmt::format(
           "build/release/bin/games_needed {} > results/reference/games-needed.md", pairs)},
       Heading{"Differences"},
       Paragraph{"The intervals are Student's. The standard deviation is that of a pair's "
                 "difference; the correlation is over pairs."},
       differences_table(changes), Heading{"Games"},
       Paragraph{fmt::format(
           "Games: the fixed number of games with which a two-sided t test at the level 0.05 finds "
           "the difference with a probability of {}, if mean and standard deviation are the true "
           "ones; \"-\" if the measure favours the other team than goals do. Relative to goals: "
           "this "
           "number divided by that of the goals, with a bootstrap interval over pairs; {} also "
           "stands for measures that favour the other team. If the means were equal: the same if "
           "the measure had the mean of goals and its own spread.",
           percent(kPower), factor_text(kMostRelativeGames))},
       Paragraph{"The last three columns belong to the sequential rule of comparisons, which ends "
                 "when the interval that is valid at any time excludes 0, here without their end "
                 "for small differences: the median number of games, and how often the decision "
                 "agrees with the mean of goals or contradicts it, if the pairs are played in "
                 "random orders. The other orders end undecided."},
       games_table(changes, pairs), Heading{"Answer"}, sentences_about(changes),
       Paragraph{answer_about_games(changes) + " " + answer_about_means(changes)}}};
}

}  // namespace autoref::tools
