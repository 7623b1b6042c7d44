// The headers of CSV files of small experiments.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "experiments/export/export_folder.hpp"
#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/kinds/swiss/swiss.hpp"
#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/kinds/weakness/weakness_report.hpp"
#include "experiments/report/plots.hpp"
#include "game/lab/lab.hpp"
#include "game/loop/chain_log.hpp"
#include "game/play_counts/play_counts.hpp"
#include "io/csv.hpp"
#include "judge/judge_report.hpp"
#include "logs/log_tables.hpp"
#include "tests/experiments/kinds/rules/small_rules.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/experiments/run/fake_games.hpp"
#include "tests/experiments/run/fake_tuning.hpp"
#include "tests/experiments/run/fake_versions.hpp"
#include "tests/support/written_names.hpp"

namespace autoref {
namespace {

WrittenNames head_of(const std::string& csv) {
  const std::vector<std::string_view> lines = io::complete_lines(csv);
  return lines.empty() ? WrittenNames{} : io::csv_cells(lines.front()).value_or(WrittenNames{});
}

// The header of a file in an experiment's folder; the path of a sweep's factor becomes FACTOR.
WrittenNames head_in_folder(const experiments::Scenario& scenario, const std::string& file) {
  const TemporaryFolder folder;
  EXPECT_TRUE(
      experiments::run_experiment(scenario, experiments::fake_options(folder.path())).is_complete);
  EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  WrittenNames names = head_of(content_of(folder / file));
  for (const std::string& factor : scenario.experiment().value_columns()) {
    std::replace(names.begin(), names.end(), factor, std::string("FACTOR"));
  }
  return names;
}

// The header of a file of a kind that has a column of its own, such as "situation".
WrittenNames head_with_own_column(const experiments::Scenario& scenario, const std::string& file) {
  WrittenNames names = head_in_folder(scenario, file);
  std::replace(names.begin(), names.end(), std::string("FACTOR"),
               scenario.experiment().value_columns().at(0));
  return names;
}

experiments::Scenario small_gauntlet() {
  experiments::Gauntlet gauntlet;
  gauntlet.challengers["bold"].robots = 6;
  gauntlet.teams["zone"].robots = 5;
  return {"A test.", gauntlet};
}

experiments::Scenario small_knockout() {
  experiments::Knockout knockout;
  knockout.order = {"zone", "bold"};
  knockout.teams["zone"].robots = 6;
  knockout.teams["bold"].robots = 5;
  return {"A test.", knockout};
}

// One round of two teams, whom its games link.
experiments::Scenario small_swiss() {
  experiments::Swiss swiss;
  swiss.teams["zone"].robots = 6;
  swiss.teams["bold"].robots = 5;
  return {"A test.", swiss};
}

experiments::Scenario factorial() {
  experiments::Scenario scenario = experiments::small_sweep();
  scenario.as<experiments::Sweep>()->factors.push_back({"a.robots", {6, 4}});
  return scenario;
}

// With PARAMETER for the name of the only parameter.
WrittenNames tuning_columns() {
  experiments::Scenario scenario = experiments::small_tuning("spsa");
  scenario.as<experiments::Tuning>()->parameters.resize(1);
  WrittenNames names = head_in_folder(scenario, "tune.csv");
  for (std::string& name : names) {
    if (name == "pass_risk") name = "PARAMETER";
    if (name == "best.pass_risk") name = "best.PARAMETER";
  }
  return names;
}

bool is_calls_column(const std::string& name) { return name.starts_with("calls_"); }

WrittenNames results_columns() {
  WrittenNames names =
      with_general_names(head_in_folder(experiments::small_sweep(), "results.csv"));
  const auto first = std::find_if(names.begin(), names.end(), is_calls_column);
  if (first != names.end()) names.insert(first, "calls_EVENT");
  std::erase_if(names, [](const std::string& name) {
    return is_calls_column(name) && name != "calls_EVENT";
  });
  return names;
}

// The columns of games/*.csv after those of results.csv.
WrittenNames circumstances_columns() {
  const WrittenNames results = head_in_folder(experiments::small_sweep(), "results.csv");
  WrittenNames names = head_in_folder(experiments::small_sweep(), "games/shard-0-of-1.csv");
  const auto shared = std::mismatch(results.begin(), results.end(), names.begin(), names.end());
  EXPECT_EQ(shared.first, results.end());
  names.erase(names.begin(), shared.second);
  return names;
}

// The columns of situations that results.csv of other kinds does not have.
WrittenNames scene_columns() {
  const WrittenNames others = head_in_folder(experiments::small_sweep(), "results.csv");
  WrittenNames names = head_with_own_column(experiments::small_situations(), "results.csv");
  std::erase_if(names, [&others](const std::string& name) {
    return std::find(others.begin(), others.end(), name) != others.end();
  });
  return names;
}

WrittenNames lab_columns() {
  const game::LabScene scene = game::read_lab_scene_text(
      "schema: 1\nkind: lab\nduration_s: 0.02\nrobots: [{ side: west }]\n", "x.yaml");
  WrittenNames names = head_of(game::csv_of(scene, game::play_lab_scene(scene)));
  const std::string robot = "west0";
  for (std::string& name : names) {
    if (name.starts_with(robot)) name.replace(0, robot.size(), "ROBOT");
  }
  return names;
}

WrittenNames plot_columns(const experiments::Scenario& scenario, const std::string& name) {
  const TemporaryFolder folder;
  const auto results =
      experiments::run_experiment(scenario, experiments::fake_options(folder.path())).results;
  for (const experiments::Plot& plot : experiments::plots_of(scenario, results)) {
    if (plot.name == name) return head_of(plot.csv);
  }
  return {};
}

experiments::Scenario robin() { return experiments::small_roundrobin({6, 5, 4}); }

}  // namespace

WrittenNames with_general_names(const WrittenNames& names) {
  WrittenNames shorter;
  for (const std::string& name : names) {
    const std::string general = with_general_name(name, "_", "_");
    if (std::find(shorter.begin(), shorter.end(), general) == shorter.end())
      shorter.push_back(general);
  }
  return shorter;
}

std::string with_general_name(std::string name, std::string_view before, std::string_view after) {
  const bool is_of_actions = name.starts_with("actions_") || name.starts_with("worth_");
  const auto replace = [&](std::string_view special, const char* general) {
    const std::size_t at = name.find(fmt::format("{}{}{}", before, special, after));
    if (at != std::string::npos) name.replace(at + before.size(), special.size(), general);
  };
  if (is_of_actions) {
    for (const auto& kind : names_of(game::ActionKind{})) replace(kind.name, "KIND");
  } else {
    for (const game::ChainGroup& group : game::chain_groups()) replace(group.name, "GROUP");
  }
  return name;
}

WrittenNames calls_columns() {
  WrittenNames names = head_in_folder(experiments::small_sweep(), "results.csv");
  std::erase_if(names, [](const std::string& name) { return !is_calls_column(name); });
  return names;
}

std::vector<Artefact> written_csv() {
  return {
      {"results.csv", results_columns},
      {"games/*.csv", circumstances_columns},
      {"play --chains", [] { return io::heads_of(game::chain_columns({}, 60)); }},
      {"play --actions", [] { return io::heads_of(game::action_columns({}, 60)); }},
      {"log info of several logs", [] { return io::heads_of(logs::summary_columns()); }},
      {"log export: tracks.csv", [] { return io::heads_of(logs::track_columns()); }},
      {"log export: chains.csv", [] { return io::heads_of(logs::logged_chain_columns()); }},
      {"log export: actions.csv", [] { return io::heads_of(logs::logged_action_columns()); }},
      {"log export: shots.csv", [] { return io::heads_of(logs::logged_shot_columns()); }},
      {"games/*.csv of autoref judge",
       [] { return experiments::row_format(experiments::JudgeSchedule{}).names(); }},
      {"summary.csv of a sweep",
       [] { return head_in_folder(experiments::small_sweep(), "summary.csv"); }},
      {"summary.csv of a round robin or gauntlet",
       [] {
         WrittenNames names = head_in_folder(robin(), "summary.csv");
         EXPECT_EQ(names, head_in_folder(small_gauntlet(), "summary.csv"));
         EXPECT_EQ(names, head_in_folder(small_swiss(), "summary.csv"));
         return names;
       }},
      {"summary.csv of an SPRT match",
       [] { return head_in_folder(experiments::small_sprt_match(), "summary.csv"); }},
      {"summary.csv of a knockout", [] { return head_in_folder(small_knockout(), "summary.csv"); }},
      {"results.csv of situations", scene_columns},
      {"summary.csv of situations",
       [] { return head_with_own_column(experiments::small_situations(), "summary.csv"); }},
      {"differences.csv of a round robin or gauntlet",
       [] { return head_in_folder(robin(), "differences.csv"); }},
      {"versions.csv",
       [] {
         WrittenNames names = head_in_folder(experiments::versioned_robin(), "versions.csv");
         EXPECT_EQ(names, head_in_folder(experiments::versioned_gauntlet(), "versions.csv"));
         return names;
       }},
      {"version_pairs.csv",
       [] { return head_in_folder(experiments::versioned_gauntlet(), "version_pairs.csv"); }},
      {"comparison.csv",
       [] { return head_in_folder(experiments::small_comparison(), "comparison.csv"); }},
      {"parts.csv", [] { return head_in_folder(experiments::small_comparison(), "parts.csv"); }},
      {"play.csv", [] { return head_in_folder(experiments::small_comparison(), "play.csv"); }},
      {"differences.csv of situations",
       [] { return head_with_own_column(experiments::small_situations(), "differences.csv"); }},
      {"summary.csv of an experiment on rules",
       [] { return head_with_own_column(experiments::small_rules(), "summary.csv"); }},
      {"summary.csv of a tuning",
       [] { return head_in_folder(experiments::small_tuning("spsa"), "summary.csv"); }},
      {"tune.csv", tuning_columns},
      {"weaknesses.csv",
       [] { return head_of(experiments::weaknesses_csv(experiments::WeaknessState{})); }},
      {"search.csv", [] { return head_of(experiments::search_csv(experiments::WeaknessState{})); }},
      {"rounds.csv of a Swiss tournament",
       [] { return head_in_folder(small_swiss(), "rounds.csv"); }},
      {"standings.csv of a round robin",
       [] {
         WrittenNames names = head_in_folder(robin(), "standings.csv");
         EXPECT_EQ(names, head_in_folder(small_swiss(), "standings.csv"));
         return names;
       }},
      {"standings.csv of a gauntlet",
       [] { return head_in_folder(small_gauntlet(), "standings.csv"); }},
      {"effects.csv of a sweep", [] { return head_in_folder(factorial(), "effects.csv"); }},
      {"judge.csv", [] { return head_of(judge::csv_of(judge::JudgeReport{})); }},
      {"faults.csv",
       [] {
         return head_of(
             judge::report_of(experiments::JudgeSchedule{}, experiments::RowsById{}).faults_csv);
       }},
      {"experiment lab --csv", lab_columns},
      {"Table settings", experiments::settings_columns},
      {"Table events", [] { return experiments::game_table_columns("events"); }},
      {"Table chains", [] { return experiments::game_table_columns("chains"); }},
      {"Table actions", [] { return experiments::game_table_columns("actions"); }},
      {"Table shots", [] { return experiments::game_table_columns("shots"); }},
  };
}

std::vector<Artefact> written_plots() {
  return {
      {"plots/scores.csv", [] { return plot_columns(experiments::small_sweep(), "scores"); }},
      {"plots/difference.csv over a factor of numbers",
       [] { return plot_columns(experiments::small_sweep(), "difference"); }},
      {"plots/difference.csv of other experiments",
       [] { return plot_columns(robin(), "difference"); }},
      {"plots/effects.csv", [] { return plot_columns(factorial(), "effects"); }},
      {"plots/crosstable.csv", [] { return plot_columns(robin(), "crosstable"); }},
      {"plots/ratings.csv", [] { return plot_columns(robin(), "ratings"); }},
      {"plots/versions.csv",
       [] { return plot_columns(experiments::versioned_robin(), "versions"); }},
      {"plots/histogram.csv", [] { return plot_columns(robin(), "histogram"); }},
      {"plots/tuning_path.csv",
       [] { return plot_columns(experiments::small_tuning("spsa"), "tuning_path"); }},
      {"plots/running_mean.csv", [] { return plot_columns(robin(), "running_mean"); }},
  };
}

}  // namespace autoref
