#include "runner/batch/experiment_kinds.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string_view>

#include "runner/analysis/knockout_report.hpp"
#include "runner/analysis/situations_report.hpp"
#include "runner/analysis/sprt_match_report.hpp"
#include "runner/analysis/sprt_match_state.hpp"
#include "runner/analysis/standings_report.hpp"
#include "runner/analysis/summary.hpp"
#include "runner/analysis/tuning_report.hpp"
#include "runner/analysis/tuning_state.hpp"
#include "runner/batch/results_json.hpp"
#include "runner/experiments/knockout_schedule.hpp"
#include "runner/experiments/matchup_schedule.hpp"
#include "runner/experiments/situations_schedule.hpp"
#include "runner/experiments/with_kind.hpp"

namespace autoref::runner {
namespace {

std::vector<std::string> value_columns(const Sweep& sweep) {
  std::vector<std::string> paths;
  paths.reserve(sweep.factors.size());
  for (const Factor& factor : sweep.factors) paths.push_back(factor.path);
  return paths;
}

std::vector<std::string> value_columns(const NamedTeams& /*named*/) { return {}; }
std::vector<std::string> value_columns(const Tuning& tuning) { return paths_of(tuning); }
std::vector<std::string> value_columns(const JudgeSchedule& /*schedule*/) {
  return {"seeds", "rules", "camera"};
}

std::vector<std::string> value_columns(const Situations& /*situations*/) { return {"situation"}; }

// Experiments of all other kinds need all their games.
template <typename Experiment>
bool is_decided(const Experiment& /*experiment*/, const RowsById& /*rows*/) {
  return false;
}

bool is_decided(const SprtMatch& match, const RowsById& rows) {
  return state_of(match, rows).is_decided;
}

bool is_decided(const Tuning& tuning, const RowsById& rows) {
  return is_test_decided(tuning, rows);
}

template <typename Experiment>
Schedule schedule_of(const Experiment& experiment, const RowsById& /*rows*/) {
  std::vector<ScheduledGame> games = scheduled_games(experiment);
  const std::size_t needed = games.size();
  return {std::move(games), needed};
}

Schedule schedule_of(const SprtMatch& match, const RowsById& rows) {
  const SprtMatchState state = state_of(match, rows);
  std::vector<ScheduledGame> games = scheduled_games(match);
  const std::size_t needed =
      state.is_decided ? 2 * static_cast<std::size_t>(state.last_pair) : games.size();
  return {std::move(games), needed};
}

// Each tie without known teams counts as one needed game, so the experiment cannot be complete
// before the bracket is.
Schedule schedule_of(const Knockout& knockout, const RowsById& rows) {
  const std::vector<Tie> ties = bracket_of(knockout, rows);
  std::vector<ScheduledGame> games = games_of(knockout, ties);
  const auto unknown =
      std::count_if(ties.begin(), ties.end(), [](const Tie& tie) { return !tie.is_known(); });
  const std::size_t needed = games.size() + static_cast<std::size_t>(unknown);
  return {std::move(games), needed};
}

// The games of iterations that are not known yet count as needed.
Schedule schedule_of(const Tuning& tuning, const RowsById& rows) {
  const TuningState state = state_of(tuning, rows);
  const int pairs = state.test.is_decided ? state.test.last_pair : tuning.test.max_pairs;
  const int needed = games_of_search(tuning) + pairs * games_of_test_pair(tuning);
  return {known_games(tuning, state), static_cast<std::size_t>(needed)};
}

ExperimentResults results_of(const JudgeSchedule& /*schedule*/, const RowsById& /*rows*/) {
  throw std::logic_error("results of judged games are computed in runner/judge");
}

// Columns of a table of groups to drop on a narrow screen: goals, since their difference is shown,
// and void games, since the progress bar counts them.
const Cells kColumnsToSpare = {kGoalsBHead, kGoalsAHead, kVoidHead};

// The number of games can be dropped too: it is the sum of the wins, draws and losses on the right.
ProgressTable matchups_shown(const std::vector<Group>& matchups) {
  Cells to_spare = kColumnsToSpare;
  append(to_spare, {kGamesHead, kDifferenceHead});
  const std::vector<Cells> rows = matchups_rows(matchups);
  return {rows, kMatchupsColumns, "matchups", columns_named(rows.front(), to_spare)};
}

// Puts standings first, since a small screen shows only the first part.
void show_standings(ExperimentResults& results, const std::string& noun) {
  results.table = {matchups_table(results.groups), "\n", standings_table(results.standings)};
  const Cells to_spare = are_rated(results.standings)
                             ? Cells{kStrengthHead, kGoalRatingHead, kGamesHead}
                             : Cells{kGoalDifferenceHead, kGamesHead};
  const std::vector<Cells> rows = standings_rows(results.standings);
  results.shown = {{rows, kStandingsColumns, noun, columns_named(rows.front(), to_spare)},
                   matchups_shown(results.groups)};
  results.json = std::make_shared<Json>(
      Json{{"standings", json_of(results.standings)}, {"groups", json_of(results.groups)}});
}

// Drops the rows of the ties before the first undecided one.
std::vector<Cells> rows_from_first_open_tie(const std::vector<Tie>& ties, std::vector<Cells> rows) {
  const auto open =
      std::find_if(ties.begin(), ties.end(), [](const Tie& tie) { return !tie.is_decided(); });
  if (open != ties.end()) rows.erase(rows.begin() + 1, rows.begin() + 1 + (open - ties.begin()));
  return rows;
}

ExperimentResults results_of(const Sweep& sweep, const RowsById& rows) {
  ExperimentResults results;
  results.groups = grouped(sweep.factors, rows);
  results.files = {{"summary.csv", "a row per value", summary_csv(sweep.factors, results.groups)}};
  results.table = summary_table(sweep.factors, results.groups);
  results.effects = effects_of(sweep.factors, results.groups);
  if (!results.effects.empty()) {
    results.files.push_back(
        {"effects.csv", "a row per effect of the factors", effects_csv(results.effects)});
    results.table.emplace_back("\n");
    for (auto& block : effects_table(results.effects)) results.table.push_back(std::move(block));
  }
  const std::vector<Cells> shown = summary_rows(sweep.factors, results.groups);
  results.shown = {{shown,
                    {},
                    "values",
                    columns_named(shown.front(), kColumnsToSpare),
                    slope_text(sweep.factors, results.groups)}};
  results.json = std::make_shared<Json>(Json{{"groups", json_of(results.groups)}});
  return results;
}

ExperimentResults results_of(const RoundRobin& robin, const RowsById& rows) {
  ExperimentResults results;
  results.groups = grouped(matchups_of(robin), rows);
  results.standings = standings_of(results.groups);
  results.files = {{"summary.csv", "a row per matchup", matchups_csv(results.groups)},
                   {"standings.csv", "a row per team", standings_csv(results.standings)}};
  show_standings(results, "teams");
  return results;
}

ExperimentResults results_of(const Gauntlet& gauntlet, const RowsById& rows) {
  ExperimentResults results;
  results.groups = grouped(matchups_of(gauntlet), rows);
  results.standings = standings_of_challengers(results.groups);
  results.files = {{"summary.csv", "a row per matchup", matchups_csv(results.groups)},
                   {"standings.csv", "a row per challenger", standings_csv(results.standings)}};
  show_standings(results, "challengers");
  return results;
}

ExperimentResults results_of(const SprtMatch& match, const RowsById& rows) {
  const SprtMatchState state = state_of(match, rows);
  ExperimentResults results;
  results.groups = grouped({matchup_of(match)}, rows);
  const Group& matchup = results.groups.front();
  results.files = {
      {"summary.csv", "the SPRT match and its verdict", sprt_match_csv(match, matchup, state)}};
  results.table = sprt_match_table(match, matchup, state);
  results.shown = {matchups_shown(results.groups)};
  results.shown.front().text = verdict_text(match, state);
  results.json =
      std::make_shared<Json>(Json{{"groups", json_of(results.groups)}, {"sprt", json_of(state)}});
  return results;
}

ExperimentResults results_of(const Knockout& knockout, const RowsById& rows) {
  const std::vector<Tie> ties = bracket_of(knockout, rows);
  ExperimentResults results;
  results.files = {{"summary.csv", "a row per tie", ties_csv(ties, rows)}};
  results.ties = tie_results(ties, rows);
  results.table = bracket_table(ties, rows);
  results.shown = {
      {rows_from_first_open_tie(ties, bracket_rows(ties, rows)), kBracketColumns, "ties"}};
  results.json = std::make_shared<Json>(Json{{"ties", json_of(ties)}});
  return results;
}

ExperimentResults results_of(const Situations& situations, const RowsById& rows) {
  const std::vector<SceneGroup> groups = scene_groups(situations, rows);
  const std::vector<SceneDifference> differences = scene_differences(groups);
  ExperimentResults results;
  results.files = {
      {"summary.csv", "a row per situation and teams", scenes_csv(groups)},
      {"differences.csv", "a row per two attacking teams", scene_differences_csv(differences)}};
  results.table = scenes_table(groups, differences);
  results.shown = {{scenes_rows(groups), kScenesColumns, "situations"}};
  results.json = std::make_shared<Json>(Json{{"situations", json_of(groups)}});
  return results;
}

ExperimentResults results_of(const Tuning& tuning, const RowsById& rows) {
  const auto state = std::make_shared<TuningState>(state_of(tuning, rows));
  ExperimentResults results;
  results.tuning = state;
  results.files = {{"tune.csv", "a row per iteration", tuning_csv(tuning, *state)},
                   {"summary.csv", "the test of the result", tuning_test_csv(tuning, *state)},
                   {"result.yaml", "the tuned team", result_yaml(tuning, *state)}};
  results.table = tuning_table(tuning, *state);
  results.shown = {{parameter_rows(tuning, *state), kParameterColumns, "parameters"}};
  results.shown.front().text = comparison_text(tuning, *state);
  results.json = std::make_shared<Json>(Json{{"tuning", json_of(tuning, *state)}});
  return results;
}

}  // namespace

RowsById counted(const Schedule& schedule, RowsById rows) {
  std::set<std::string_view> needed;
  for (std::size_t i = 0; i < std::min(schedule.needed, schedule.games.size()); ++i) {
    needed.insert(schedule.games[i].id);
  }
  std::erase_if(rows, [&needed](const auto& entry) { return !needed.contains(entry.first); });
  return rows;
}

bool is_experiment(const Scenario& scenario) {
  return verb_of(scenario) == "run" || is_tuning(scenario);
}

bool is_tuning(const Scenario& scenario) {
  return std::holds_alternative<Tuning>(scenario.content);
}

bool keeps_rows(const Scenario& scenario) {
  return !std::holds_alternative<GameSettings>(scenario.content);
}

RowFormat row_format(const Scenario& scenario) {
  if (std::holds_alternative<JudgeSchedule>(scenario.content))
    return RowFormat(value_columns(scenario), RowKind::kJudged);
  const bool is_scenes = std::holds_alternative<Situations>(scenario.content);
  return RowFormat(value_columns(scenario), is_scenes ? RowKind::kScene : RowKind::kPlayed);
}

std::vector<ScheduledGame> scheduled_games(const Scenario& scenario) {
  return with_kind(scenario, [](const auto& experiment) { return scheduled_games(experiment); });
}

std::string caveat_of_schedule(const Scenario& scenario) {
  if (std::holds_alternative<SprtMatch>(scenario.content))
    return "at most, since the match ends once it is decided";
  if (is_tuning(scenario)) return "at most, since the test of the result ends once it is decided";
  if (!std::holds_alternative<Knockout>(scenario.content)) return "";
  return "assuming that the better seed wins every tie; drawn ties are replayed";
}

bool follows_its_rows(const Scenario& scenario) {
  return std::holds_alternative<SprtMatch>(scenario.content) ||
         std::holds_alternative<Knockout>(scenario.content) || is_tuning(scenario);
}

Schedule schedule_of(const Scenario& scenario, const RowsById& rows) {
  return with_kind(scenario, [&](const auto& experiment) { return schedule_of(experiment, rows); });
}

bool is_decided(const Scenario& scenario, const RowsById& rows) {
  return with_kind(scenario, [&](const auto& experiment) { return is_decided(experiment, rows); });
}

std::vector<std::string> value_columns(const Scenario& scenario) {
  return with_kind(scenario, [](const auto& experiment) { return value_columns(experiment); });
}

ExperimentResults results_of(const Scenario& scenario, const RowsById& rows) {
  return with_kind(scenario, [&](const auto& experiment) { return results_of(experiment, rows); });
}

}  // namespace autoref::runner
