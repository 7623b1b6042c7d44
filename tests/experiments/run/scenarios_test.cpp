// Every scenario file can be read, its games can be played in a shortened form, and what it then
// writes is described in docs/schemas.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sprt/sprt_match.hpp"
#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/kinds/weakness/weakness.hpp"
#include "experiments/run/run_experiment.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/game_settings.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/csv.hpp"
#include "judge/evaluate_calls.hpp"
#include "tests/checkout.hpp"
#include "tests/support/schema_tables.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written_names.hpp"

namespace autoref::experiments {
namespace {

std::vector<std::string> scenario_files() {
  std::vector<std::string> files;
  const std::filesystem::path folder = in_checkout("scenarios");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

constexpr double kShortHalf_s = 5;

void shorten(game::GameSettings& game) {
  game.match.half_s = game.match.rules.extra_half_s = kShortHalf_s;
  // Rule books of variants keep the halves short.
  game.given.insert({"match.half_s", "match.extra_half_s"});
}

// The smallest numbers of games that those kinds allow which have other numbers than pairs.
void make_few(SprtMatch& match) { match.sprt.min_pairs = match.sprt.max_pairs = 2; }
void make_few(Tuning& tuning) {
  tuning.iterations = 1;
  tuning.test.min_pairs = tuning.test.max_pairs = 2;
}
void make_few(Weakness& weakness) {
  weakness.searches = weakness.iterations = 1;
  weakness.test_pairs = weakness.reduction_pairs = 2;
}
// The two best and the two worst teams: their games are seldom drawn, and need few shoot-outs and
// replays.
void make_few(Knockout& knockout) {
  std::vector<std::string>& order = knockout.order;
  if (order.size() > 4) order.erase(order.begin() + 2, order.end() - 2);
  std::erase_if(knockout.teams, [&](const auto& team) {
    return std::find(order.begin(), order.end(), team.first) == order.end();
  });
}
void make_few(JudgeSchedule& schedule) {
  schedule.games_each = 2;
  schedule.seeds.resize(1);
}

template <typename... Kinds>
void make_few_of(Scenario& scenario) {
  const auto make = [](auto* experiment) {
    if (experiment != nullptr) make_few(*experiment);
  };
  (make(scenario.as<Kinds>()), ...);
}

void shorten(Scenario& scenario) {
  if (auto* game = std::get_if<game::GameSettings>(&scenario.content)) return shorten(*game);
  for (const Key& key : scenario.experiment().keys()) {
    if (key.base != nullptr) shorten(*key.base);
    if (key.pairs != nullptr) *key.pairs = 1;
  }
  make_few_of<SprtMatch, Tuning, Weakness, Knockout, JudgeSchedule>(scenario);
}

// Plays a game as from the checkout, where programs are found.
game::GameRecord play_from_checkout(game::GameConfiguration game) {
  for (game::TeamConfiguration* team : {&game.a, &game.b}) {
    if (team->program) team->program->directory = in_checkout("");
  }
  return game::play(game, nullptr, game::make_program_or_registered_team);
}

// Columns that are described for all scenarios together: calls, a factor's or parameter's values.
bool has_a_general_name(const std::string& column, const Scenario& scenario) {
  const std::vector<std::string> factors = scenario.experiment().value_columns();
  const auto* tuning = scenario.as<Tuning>();
  return column.starts_with("calls_") ||
         std::find(factors.begin(), factors.end(), column) != factors.end() ||
         (tuning != nullptr && std::any_of(tuning->parameters.begin(), tuning->parameters.end(),
                                           [&](const TunedParameter& parameter) {
                                             return column == parameter.name ||
                                                    column == "best." + parameter.name;
                                           }));
}

// docs/schemas.md has a section for the file, whose title begins with the file's name, with all of
// its columns; those of results.csv may be in several sections. The exact columns and their order
// are compared in schemas_test.cpp, for the files listed there (also those of judged games).
void expect_described(const std::filesystem::path& file, const Scenario& scenario) {
  const std::string text = content_of(file);
  WrittenNames columns = with_general_names(io::csv_cells(io::complete_lines(text).at(0)).value());
  std::erase_if(columns,
                [&](const std::string& column) { return has_a_general_name(column, scenario); });
  WrittenNames closest = columns;
  for (const SchemaSection& section : schema_sections()) {
    if (!section.title.starts_with(file.filename().string())) continue;
    WrittenNames missing = file.filename() == "results.csv" ? closest : columns;
    const WrittenNames described = section.names();
    std::erase_if(missing, [&](const std::string& column) {
      return std::find(described.begin(), described.end(), column) != described.end();
    });
    if (missing.size() < closest.size()) closest = missing;
  }
  EXPECT_TRUE(closest.empty()) << "docs/schemas.md does not describe these columns of "
                               << file.filename() << ": " << testing::PrintToString(closest);
}

bool has_python() { return std::system("command -v python3 >/dev/null") == 0; }

class EveryScenario : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenario, ReadsBackEqualFromItsEffectiveText) {
  const std::string text = effective_text(read_scenario(GetParam()));
  EXPECT_EQ(effective_text(read_scenario_text(text, "effective.yaml")), text);
}

TEST_P(EveryScenario, PlaysShortenedGames) {
  if (GetParam().find("python") != std::string::npos && !has_python()) {
    std::puts("skipped: missing Debian packages: python3");
    GTEST_SKIP();
  }
  Scenario scenario = read_scenario(GetParam());
  shorten(scenario);
  if (auto* game = std::get_if<game::GameSettings>(&scenario.content)) {
    EXPECT_EQ(game::play(game::resolved(*game)).status, game::Status::kOk);
    return;
  }
  if (auto* schedule = scenario.as<JudgeSchedule>()) {
    for (const ScheduledJudgeGame& game : games_of(*schedule))
      EXPECT_EQ(judge::evaluate_calls(game::resolved(game.settings.combined())).record.void_reason,
                "")
          << game.id;
    return;
  }
  const TemporaryFolder folder;
  ExperimentOptions options;
  options.folder = folder.path();
  options.build = "test";
  options.workers = 2;
  options.play = play_from_checkout;
  const ExperimentReport report = run_experiment(scenario, options);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.void_games, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().extension() == ".csv") expect_described(entry.path(), scenario);
}

INSTANTIATE_TEST_SUITE_P(Files, EveryScenario, testing::ValuesIn(scenario_files()),
                         [](const auto& test) {
                           std::string name = std::filesystem::path(test.param).stem();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace autoref::experiments
