#include "experiments/report/sections.hpp"

#include <fmt/format.h>

#include <utility>

#include "experiments/export/play_drawings.hpp"
#include "experiments/report/group_names.hpp"
#include "experiments/report/standings_plots.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kShootoutsInDifferences =
    "The winner of a shoot-out wins the game. Shoot-out goals do not count as goals of the game: "
    "goal differences, ratings in goals and sequential tests treat the game as drawn.";

std::string kind_text(const Scenario& scenario) {
  const std::vector<std::string> factors = scenario.experiment().value_columns();
  return factors.empty() ? std::string(kind_of(scenario))
                         : fmt::format("{} of {}", kind_of(scenario), io::listed(factors));
}

std::size_t pairs_of(const std::vector<Group>& groups) {
  std::size_t pairs = 0;
  for (const Group& group : groups) pairs += group.pair_differences.size();
  return pairs;
}

// Adds a table row for each kind of rows that do not count, if there are any.
void add_rows_that_do_not_count(Table& table, const ResultFolder& folder) {
  if (!folder.damaged.empty()) {
    table.rows.push_back({"damaged rows (not counted)", std::to_string(folder.damaged.size())});
  }
  if (folder.completed_games.other_games > 0) {
    table.rows.push_back({"rows that do not belong to any game of the experiment",
                          std::to_string(folder.completed_games.other_games)});
  }
  for (const auto& [build, count] : folder.completed_games.other_builds) {
    table.rows.push_back({"rows of build " + build + " (not counted here)", std::to_string(count)});
  }
}

List meaning_of_results(const ExperimentResults& results) {
  List list{{"All intervals are 95 % confidence intervals.",
             "Goals are mean ± standard deviation per game.",
             "a minus b is the mean goal difference per game. Its interval is Student's over pairs "
             "of legs with changed sides; a pair with a void game is left out."}};
  if (results.are_compared_with_first) {
    list.items.emplace_back(
        "From the first: the difference from the first value, over pairs with the same number; "
        "p is that of the paired t test, with Holm's correction over the table.");
  }
  if (!results.effects.empty()) {
    list.items.emplace_back(
        "Effect of a value: how much a minus b changes from the factor's first value to this one, "
        "averaged over the values of the other factors. Effect of two values: how much the second "
        "changes the effect of the first; it is 0 if the factors add up. Both over pairs with the "
        "same number; p has Holm's correction over all effects.");
  }
  if (!results.standings.empty()) {
    list.items.emplace_back("A win gives three points, a draw one.");
  }
  if (!results.groups.empty()) {
    list.items.emplace_back(kShootoutsInDifferences);
  }
  if (are_rated(results.standings)) {
    list.items.emplace_back(
        "Intervals of ratings in goals come from resampled pairs of legs, those of Bradley-Terry "
        "strengths from the profile of the penalised likelihood. If a team won all its games, its "
        "interval has only a lower end; if it lost all of them, only an upper end.");
  }
  return list;
}

constexpr const char* kNewMinusOld =
    "new minus old is the mean goal difference per game: of the games between the two teams, or of "
    "the new team's minus the old team's against the same opponent with the same seeds. A pair "
    "with "
    "a void game is left out.";
constexpr const char* kEndOfComparison =
    "The comparison ends as soon as its interval excludes 0 or lies within the smallest difference "
    "that matters. The interval remains valid even though the games decide when to stop (Lai "
    "1976); "
    "it is wider than Student's. p is that of the same test.";

List meaning_of_comparison() {
  return List{
      {"All intervals in the table are 95 % confidence intervals.", kNewMinusOld, kEndOfComparison,
       "Intervals in the plots and in summary.csv are Student's, which do not allow for that.",
       kShootoutsInDifferences}};
}

List meaning_of_tuning() {
  return List{
      {"The column \"now\" is the best value known so far: the mean of the search over the last "
       "half of its iterations.",
       "The test plays new games, with seeds that no iteration used, and ends as soon as they "
       "decide: two simultaneous sequential tests (Sobel and Wald 1949), as in kind sprt.",
       "The interval of the gain remains valid even though the games decide when to stop (Lai "
       "1976); it is wider than Student's."}};
}

std::vector<std::string> share_texts(const ResultCounts& counts) {
  const int games = counts[0] + counts[1] + counts[2];
  std::vector<std::string> texts = {std::to_string(games)};
  for (const int count : counts) texts.push_back(share_text(count, games));
  return texts;
}

Table groups_shares(const Scenario& scenario, const std::vector<Group>& groups) {
  Table table{{value_heads(scenario, groups)}, value_heads(scenario, groups).size()};
  io::append(table.rows.front(), {"games", "a won [95 %]", "drawn [95 %]", "b won [95 %]"});
  for (const Group& group : groups) {
    table.rows.push_back(group.values);
    io::append(table.rows.back(), share_texts(group.results()));
  }
  return table;
}

Table teams_shares(const std::vector<Standing>& standings) {
  Table table{{{"team", "games", "won [95 %]", "drawn [95 %]", "lost [95 %]"}}, 1};
  for (const Standing& standing : standings) {
    table.rows.push_back({standing.team});
    io::append(table.rows.back(), share_texts(standing.results()));
  }
  return table;
}

std::string cross_text(const std::optional<CrossCell>& cell) {
  if (!cell || !cell->mean_difference) return "";
  return fmt::format("{} ({:+.2f})", cell->points(), *cell->mean_difference);
}

}  // namespace

std::string games_text(const ResultFolder& folder) {
  return fmt::format("{} of {}", folder.completed_games.done.size(), folder.needed);
}

Section played_section(const ResultFolder& folder, const ExperimentResults& results) {
  Table table{{{"experiment", ""},
               {"kind", kind_text(folder.scenario)},
               {kGamesRow, games_text(folder)},
               {"void games", std::to_string(folder.void_games())},
               {kBuildRow, folder.build.empty() ? "none" : folder.build},
               {"master seed", seed_text(folder.scenario.experiment())},
               {kChecksumRow, rows_checksum(folder)}},
              2};
  if (!results.groups.empty()) {
    table.rows.push_back(
        {"pairs of legs without a void game", std::to_string(pairs_of(results.groups))});
  }
  add_rows_that_do_not_count(table, folder);
  Section section = {Heading{"What was played"}, table};
  if (List notes{rule_notes(folder.completed_games.done)}; !notes.items.empty())
    section.emplace_back(std::move(notes));
  if (!folder.is_complete()) {
    section.emplace_back(Paragraph{
        fmt::format("{} games are missing.{}", folder.needed - folder.completed_games.done.size(),
                    results.comparison ? "" : fmt::format(" {}", kInterimWarning))});
  }
  return section;
}

Section results_section(const ExperimentResults& results) {
  Section section = {Heading{"Results"}, Verbatim{io::text_of(results.table)}};
  for (Block& list : meaning_of(results)) section.push_back(std::move(list));
  return section;
}

Section meaning_of(const ExperimentResults& results) {
  Section lists;
  if (results.comparison) {
    lists.emplace_back(meaning_of_comparison());
  } else if (!results.groups.empty()) {
    lists.emplace_back(meaning_of_results(results));
  }
  if (results.search) lists.emplace_back(meaning_of_tuning());
  return lists;
}

Section bracket_section(const ExperimentResults& results) {
  if (results.ties.empty()) return {};
  return {Heading{"Bracket"}, CupBracket{results.ties}};
}

Section drawings_section(const ResultFolder& folder, const ExperimentResults& results,
                         const std::filesystem::path& into) {
  std::vector<ResultDrawing> drawings = results.drawings;
  for (ResultDrawing& drawing : stored_play_drawings(folder, into))
    drawings.push_back(std::move(drawing));
  if (drawings.empty()) return {};
  Section section = {Heading{"Drawings"}};
  for (const ResultDrawing& drawing : drawings) section.emplace_back(drawing);
  return section;
}

Section shares_section(const ResultFolder& folder, const ExperimentResults& results) {
  if (results.groups.empty()) return {};
  Section section = {Heading{"Won, drawn, lost"},
                     Paragraph{"Proportions of games with 95 % intervals: Wilson's, or Clopper and "
                               "Pearson's for a proportion of 0 or 1. Games are assumed to be "
                               "independent."}};
  if (!results.standings.empty()) section.emplace_back(teams_shares(results.standings));
  section.emplace_back(groups_shares(folder.scenario, results.groups));
  return section;
}

Section crosstable_section(const ExperimentResults& results) {
  const std::optional<Crosstable> crosstable = crosstable_of(results);
  if (!crosstable) return {};
  Table table{{{"team"}}, 1};
  io::append(table.rows.front(), crosstable->teams);
  for (std::size_t row = 0; row < crosstable->teams.size(); ++row) {
    table.rows.push_back({crosstable->teams[row]});
    for (const auto& cell : crosstable->cells[row]) table.rows.back().push_back(cross_text(cell));
  }
  return {Heading{"Crosstable"},
          Paragraph{"Points of the row's team against the column's, 3 for a win and 1 for a "
                    "draw, and its mean goal difference."},
          table};
}

}  // namespace autoref::experiments
