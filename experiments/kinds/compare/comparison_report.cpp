#include "experiments/kinds/compare/comparison_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/analysis/difference_parts.hpp"
#include "experiments/analysis/play_differences.hpp"
#include "experiments/analysis/saturation.hpp"
#include "experiments/analysis/standings.hpp"
#include "experiments/kinds/compare/parts_report.hpp"
#include "experiments/kinds/compare/play_report.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

// The number of games considered by the test, against one opponent and in all.
int games_of(const ComparedTeams& compared, const ComparedOpponent& opponent) {
  return (opponent.of_old ? 4 : 2) * compared.test.pairs;
}
int games_of(const ComparedTeams& compared) {
  int games = 0;
  for (const ComparedOpponent& opponent : compared.opponents) games += games_of(compared, opponent);
  return games;
}

std::optional<Interval> interval_of(const Comparison& comparison,
                                    const ComparedOpponent& opponent) {
  return anytime_interval(values_of(opponent.differences), least_deviation(comparison.test));
}

// "1.20 : 0.50": mean goals of a group's team a and of its opponents.
std::string goals_text(const Group& group) {
  if (group.games() == 0) return "-";
  return fmt::format("{:.2f} : {:.2f}", mean(group.goals_a), mean(group.goals_b));
}

std::string more_games_text(const Comparison& comparison, const ComparedTeams& compared) {
  if (!compared.test.interval) return "; too few games for an interval";
  const std::optional<int> pairs = pairs_to_decide(comparison.test, compared.test);
  if (!pairs || *pairs > kMostPairs) return "; more games than one comparison can have are needed";
  return fmt::format("; about {} games would decide it",
                     2 * *pairs * static_cast<int>(matchups_of(comparison).size()));
}

std::string verdict_name(ThreeWayVerdict verdict) { return name_of(verdict, "no difference"); }

std::vector<io::Cells> comparison_rows(const Comparison& comparison,
                                       const ComparedTeams& compared) {
  std::vector<io::Cells> rows = {
      {"against", "games", "goals of new", "goals of old", "new minus old [95 %]"}};
  for (const ComparedOpponent& opponent : compared.opponents) {
    const std::vector<double> differences = values_of(opponent.differences);
    rows.push_back({opponent.of_old ? opponent.name : "each other",
                    std::to_string(games_of(compared, opponent)), goals_text(opponent.of_new),
                    opponent.of_old ? goals_text(*opponent.of_old) : "",
                    differences.empty() ? "-"
                                        : mean_with_interval(mean(differences),
                                                             interval_of(comparison, opponent))});
  }
  if (compared.opponents.size() > 1) {
    rows.push_back({kAllOpponents, std::to_string(games_of(compared)), "", "",
                    mean_with_interval(compared.test.mean, compared.test.interval)});
  }
  return rows;
}

const std::vector<io::Align> kComparisonColumns = {io::Align::kLeft};

std::string explanation(const ComparedTeams& compared) {
  std::string text =
      "Goals are per game, for and against. The interval may be read at any time, since it allows "
      "for stopping as soon as the games decide.";
  if (compared.opponents.size() > 1)
    text += " \"all\" is the mean of the rows above it; against itself, old would play 0.";
  if (compared.void_pairs > 0)
    text += fmt::format(" Pairs left out because of a void game: {}.", compared.void_pairs);
  return text + "\n";
}

// Each note is a block of its own.
io::TextBlocks notes_on_opponents(const Comparison& comparison, const ComparedTeams& compared) {
  io::TextBlocks notes;
  for (const ComparedOpponent& opponent : compared.opponents) {
    if (!opponent.of_old) continue;
    const std::string note =
        saturation_text(opponent.name, comparison.against.at(opponent.name),
                        {&opponent.of_new, &*opponent.of_old}, "or leave it out");
    if (!note.empty()) notes.emplace_back("\n" + note + "\n");
    if (opponent.equal_games > 0) {
      notes.emplace_back(fmt::format(
          "\nOf new's {} games against {}, {} are the same as old's in every frame: what changed "
          "had "
          "no effect in them.\n",
          opponent.of_new.games(), opponent.name, opponent.equal_games));
    }
  }
  return notes;
}

// One row of comparison.csv.
struct ComparedRow {
  std::string opponent;
  int games = 0;
  int pairs = 0;
  std::optional<double> goals_of_new;
  std::optional<double> goals_against_new;
  std::optional<double> goals_of_old;
  std::optional<double> goals_against_old;
  std::optional<double> difference;
  std::optional<Interval> interval;
  std::string verdict;
  std::string p;
};

ComparedRow row_against(const Comparison& comparison, const ComparedTeams& compared,
                        const ComparedOpponent& opponent) {
  const Group& of_new = opponent.of_new;
  ComparedRow row{opponent.name,
                  games_of(compared, opponent),
                  compared.test.pairs,
                  mean_of(of_new.goals_a),
                  mean_of(of_new.goals_b),
                  {},
                  {},
                  mean_of(values_of(opponent.differences)),
                  interval_of(comparison, opponent),
                  "",
                  ""};
  if (!opponent.of_old) return row;
  row.goals_of_old = mean_of(opponent.of_old->goals_a);
  row.goals_against_old = mean_of(opponent.of_old->goals_b);
  return row;
}

std::vector<ComparedRow> compared_rows(const Comparison& comparison,
                                       const ComparedTeams& compared) {
  std::vector<ComparedRow> rows;
  for (const ComparedOpponent& opponent : compared.opponents)
    rows.push_back(row_against(comparison, compared, opponent));
  ComparedRow all;
  all.opponent = kAllOpponents;
  all.games = games_of(compared);
  all.pairs = compared.test.pairs;
  if (all.pairs > 0) all.difference = compared.test.mean;
  all.interval = compared.test.interval;
  all.verdict = verdict_name(compared.test.verdict);
  all.p = p_cell(compared.test.p);
  rows.push_back(std::move(all));
  return rows;
}

io::TableColumns<ComparedRow> comparison_columns() {
  return io::joined(
      io::TableColumns<ComparedRow>{
          {"opponent", &ComparedRow::opponent, io::kInJson},
          {"games", &ComparedRow::games, io::kInJson},
          {"pairs", &ComparedRow::pairs, io::kInJson},
          {"goals_of_new", &ComparedRow::goals_of_new, io::kInJson},
          {"goals_against_new", &ComparedRow::goals_against_new, io::kInJson},
          {"goals_of_old", &ComparedRow::goals_of_old, io::kInJson},
          {"goals_against_old", &ComparedRow::goals_against_old, io::kInJson},
          {"mean_diff", &ComparedRow::difference, io::kInJson}},
      interval_columns<ComparedRow>("diff_", &ComparedRow::interval, io::kInJson),
      io::TableColumns<ComparedRow>{{"verdict", &ComparedRow::verdict}, {"p", &ComparedRow::p}});
}

// Why one team is better.
struct Reasons {
  DifferenceParts parts;
  std::vector<PlayDifference> play;
};

std::vector<PairedOpponent> paired_opponents_of(const ComparedTeams& compared) {
  std::vector<PairedOpponent> opponents;
  for (const ComparedOpponent& opponent : compared.opponents) {
    if (opponent.of_old)
      opponents.push_back(
          {matchup_name({kNewTeam, opponent.name}), matchup_name({kOldTeam, opponent.name})});
    else
      opponents.push_back({matchup_name({kNewTeam, kOldTeam}), std::nullopt});
  }
  return opponents;
}

// nullopt before the first complete pair.
std::optional<Reasons> reasons_of(const ComparedTeams& compared, const RowsById& rows) {
  if (compared.pairs.empty()) return std::nullopt;
  const std::vector<PairedOpponent> opponents = paired_opponents_of(compared);
  Reasons reasons = {difference_parts(opponents, compared.pairs, rows),
                     play_differences(opponents, compared.pairs, rows)};
  // The interval of the answer, which assumes some spread even if few goals were scored.
  DifferencePart& goals = reasons.parts.goals;
  goals.interval = compared.test.interval;
  goals.p = goals.p_holm = compared.test.p;
  return reasons;
}

io::Json comparison_json(const std::vector<ComparedRow>& rows, const Comparison& comparison,
                         const ComparedTeams& compared, const std::optional<Reasons>& reasons) {
  const auto [low, high] = bounds_of(compared.test.interval);
  io::Json opponents = io::Json::array();
  for (const ComparedRow& row : rows) {
    opponents.push_back(io::Json::object());
    io::add_members(opponents.back(), comparison_columns(), row);
  }
  opponents.erase(opponents.size() - 1);  // the row of all opponents
  return {{"answer", answer(comparison, compared)},
          {"verdict", verdict_name(compared.test.verdict)},
          {"least", comparison.test.least},
          {"games", games_of(compared)},
          {"pairs", compared.test.pairs},
          {"void_pairs", compared.void_pairs},
          {"mean_diff", io::json_number(rows.back().difference)},
          {"diff_low95", io::json_number(low)},
          {"diff_high95", io::json_number(high)},
          {"p", compared.test.p},
          {"opponents", std::move(opponents)},
          {"parts", reasons ? parts_json(reasons->parts) : io::Json::array()},
          {"play", reasons ? play_json(reasons->play) : io::Json::array()}};
}

ComparisonAnswer answer_with_tables(const Comparison& comparison, const ComparedTeams& compared,
                                    const std::optional<Reasons>& reasons) {
  ComparisonAnswer answered{compared.test.verdict, answer(comparison, compared), "", {}, {}, {}};
  answered.opponents = {io::TextTable{comparison_rows(comparison, compared), kComparisonColumns, 1},
                        "\n" + explanation(compared)};
  for (auto& note : notes_on_opponents(comparison, compared))
    answered.opponents.push_back(std::move(note));
  if (!reasons) return answered;
  answered.reason = most_certain_text(reasons->parts) + "\n" + most_certain_text(reasons->play);
  answered.parts = parts_table(reasons->parts, compared.opponents.size() > 1);
  answered.play = play_table(reasons->play);
  return answered;
}

// The table for the terminal.
io::TextBlocks table_of(const ComparisonAnswer& answered) {
  const std::string reason = answered.reason.empty() ? "" : answered.reason + "\n";
  io::TextBlocks table = {answered.sentence + "\n" + reason + "\n"};
  table.insert(table.end(), answered.opponents.begin(), answered.opponents.end());
  for (const io::TextBlocks* blocks : {&answered.parts, &answered.play}) {
    if (!blocks->empty()) table.emplace_back("\n");
    table.insert(table.end(), blocks->begin(), blocks->end());
  }
  return table;
}

}  // namespace

std::string answer(const Comparison& comparison, const ComparedTeams& compared) {
  const ComparisonState& test = compared.test;
  const std::string difference = goals_with_interval(test.mean, test.interval);
  const int games = games_of(compared);
  switch (test.verdict) {
    case ThreeWayVerdict::kBetter:
    case ThreeWayVerdict::kWorse:
      return fmt::format("{} is {} than {}: {}, decided after {} games; p {}", kNewTeam,
                         verdict_name(test.verdict), kOldTeam, difference, games,
                         test.p < 0.001 ? "< 0.001" : fmt::format("= {:.3g}", test.p));
    case ThreeWayVerdict::kNotShown:
      return fmt::format(
          "{} and {} differ by less than {} goals per game: {}, decided after {} "
          "games",
          kNewTeam, kOldTeam, comparison.test.least, difference, games);
    case ThreeWayVerdict::kUndecided:
      if (test.pairs == 0) {
        return fmt::format("undecided: ended after {} pairs, each with a void game",
                           compared.void_pairs);
      }
      return fmt::format("undecided after {} games whether {} is better than {}: {}{}", games,
                         kNewTeam, kOldTeam, difference, more_games_text(comparison, compared));
    case ThreeWayVerdict::kGoOn:
      break;
  }
  if (test.pairs == 0) return "not decided yet";
  return fmt::format("not decided yet after {} games: {} minus {} is {}", games, kNewTeam, kOldTeam,
                     difference);
}

ExperimentResults comparison_results(const Comparison& comparison, const RowsById& all_rows) {
  ComparedTeams compared = compared_teams(comparison, all_rows);
  compared.opponents = considered_opponents(comparison, compared, all_rows);
  const std::vector<ComparedRow> rows = compared_rows(comparison, compared);
  const std::optional<Reasons> reasons = reasons_of(compared, all_rows);
  ExperimentResults results;
  results.files = {{"comparison.csv", "a row per opponent, and one of all",
                    io::csv_text(io::table_rows(comparison_columns(), rows))}};
  if (reasons) {
    results.files.push_back(
        {"parts.csv", "the parts of the difference", parts_csv(reasons->parts)});
    results.files.push_back({"play.csv", "what new does differently", play_csv(reasons->play)});
  }
  results.comparison = answer_with_tables(comparison, compared, reasons);
  const ComparisonAnswer& answered = *results.comparison;
  results.table = table_of(answered);
  results.shown = {{std::get<io::TextTable>(answered.opponents.front()).rows,
                    kComparisonColumns,
                    "opponents",
                    {}}};
  results.shown.front().text = answered.sentence + "\n";
  results.json = std::make_shared<io::Json>(
      io::Json{{"comparison", comparison_json(rows, comparison, compared, reasons)}});
  results.groups = grouped(matchups_of(comparison), all_rows);
  results.files.push_back({"summary.csv",
                           "a row per matchup, with intervals for a fixed number of games",
                           matchups_csv(results.groups)});
  return results;
}

}  // namespace autoref::experiments
