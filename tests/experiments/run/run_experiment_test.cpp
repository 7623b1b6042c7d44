#include "experiments/run/run_experiment.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/results/shard.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

// The line that the worker made is appended as it is, and the run goes on with what it says.
TEST(Experiment, CountsTheRowsThatAreOnTheDisk) {
  const TemporaryFolder folder;
  const Scenario scenario = small_sweep(2);
  const RowFormat format = row_format(scenario.experiment());
  std::vector<std::string> lines = {io::csv_line(format.names())};
  ExperimentOptions options = fake_options(folder.path());
  options.play = slow_fake_game;
  options.ended = [&](const GameRow& row) {
    EXPECT_GE(row.circumstances.wall_s, 0.003);
    lines.push_back(format.line(row));
  };
  run_experiment(scenario, options);
  EXPECT_EQ(content_of(folder / "games/shard-0-of-1.csv"),
            fmt::format("{}\n", fmt::join(lines, "\n")));
}

TEST(Experiment, WritesAllItsFiles) {
  const TemporaryFolder folder;
  const ExperimentReport report = run_experiment(small_sweep(), fake_options(folder / "deep/er"));
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.games, 12);
  EXPECT_EQ(report.played, 12);
  EXPECT_EQ(line_count(content_of(shard_of(folder / "deep/er"))), 13);
  EXPECT_EQ(line_count(content_of(folder / "deep/er/results.csv")), 13);
  EXPECT_EQ(line_count(content_of(folder / "deep/er/summary.csv")), 3);
  EXPECT_NO_THROW(read_scenario(folder / "deep/er/effective.yaml"));
}

TEST(Experiment, SortsItsResultsByGame) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(), fake_options(folder.path()));
  const std::string results = content_of(folder / "results.csv");
  EXPECT_LT(results.find("b.robots=5-p0003-2"), results.find("b.robots=6-p0001-1"));
}

TEST(Experiment, HasTheSameResultsForAnyNumberOfWorkers) {
  const std::string expected = undisturbed_results(small_sweep());
  for (const int workers : {2, 5}) {
    const TemporaryFolder folder;
    ExperimentOptions options = fake_options(folder.path());
    options.workers = workers;
    options.play = slow_fake_game;
    run_experiment(small_sweep(), options);
    EXPECT_EQ(results_in(folder), expected);
  }
}

// The pages of running games depend on it.
TEST(Experiment, AnnouncesEachGameOnceBeforeItIsPlayed) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  std::map<std::string, int> announced;
  options.starting = [&announced](const ScheduledGame& game) { ++announced[game.id]; };
  run_experiment(small_sweep(), options);
  EXPECT_EQ(announced.size(), 12U);
  for (const auto& [id, times] : announced) EXPECT_EQ(times, 1) << id;
  EXPECT_TRUE(announced.contains("b.robots=5-p0003-2"));
}

TEST(Experiment, AnnouncesTheEndOfEachGameWithItsRow) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  std::map<std::string, int> ended;
  options.ended = [&](const GameRow& row) {
    ++ended[row.game_id];
    EXPECT_NE(content_of(shard_of(folder.path())).find(row.game_id), std::string::npos);
    EXPECT_EQ(row.record.frames, 72000);
  };
  run_experiment(small_sweep(), options);
  EXPECT_EQ(ended.size(), 12U);
  for (const auto& [id, times] : ended) EXPECT_EQ(times, 1) << id;
}

// A page that shows them must end with the final ones.
TEST(Experiment, ShowsItsResultsAndProgressAtTheEnd) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  std::size_t games = 0;
  io::GameCounts last;
  options.show = [&games](const ExperimentResults& results) {
    games = 0;
    for (const Group& group : results.groups) games += group.differences.size();
  };
  options.publish = [&last](const io::GameCounts& counts, const std::string&) { last = counts; };
  run_experiment(small_sweep(), options);
  EXPECT_EQ(games, 12U);
  EXPECT_EQ(last.done, 12);
  EXPECT_EQ(last.total, 12);
}

TEST(Experiment, PlaysNothingIfAlreadyComplete) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  run_experiment(small_sweep(), options);
  const auto time = std::filesystem::last_write_time(folder / "results.csv");
  options.play = [](const game::GameConfiguration&) -> game::GameRecord {
    throw std::runtime_error("no");
  };
  const ExperimentReport report = run_experiment(small_sweep(), options);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 0);
  EXPECT_EQ(report.results.groups.size(), 2U);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "results.csv"), time);
}

TEST(Experiment, PlaysOnlyTheNewGamesIfPairsAreAdded) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(3), fake_options(folder.path()));
  EXPECT_EQ(run_experiment(small_sweep(5), fake_options(folder.path())).played, 8);
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep(5)));
}

// The first `count` rows as if the games had been played in the order of their pairs and ids.
std::string rows_by_pair_and_id(const std::string& file, std::size_t count) {
  std::istringstream text(file);
  std::string header;
  std::getline(text, header);
  std::map<std::string, std::string> rows;
  for (std::string line; std::getline(text, line);) {
    const std::string id = line.substr(0, line.find(','));
    const std::size_t pair = id.rfind("-p");
    rows[id.substr(pair) + id.substr(0, pair)] = line;
  }
  std::string first = header + "\n";
  for (const auto& [key, line] : rows) {
    if (count-- == 0) break;
    first += line + "\n";
  }
  return first;
}

TEST(Experiment, ContinuesARoundRobinThatBeganInAnotherOrder) {
  const Scenario scenario = small_roundrobin({6, 5, 4, 3});
  const TemporaryFolder whole;
  run_experiment(scenario, fake_options(whole.path()));
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "games");
  write_content(shard_of(folder.path()),
                rows_by_pair_and_id(content_of(shard_of(whole.path())), 7));
  EXPECT_EQ(run_experiment(scenario, fake_options(folder.path())).played, 24 - 7);
  EXPECT_EQ(results_in(folder), results_in(whole));
  EXPECT_EQ(content_of(folder / "standings.csv"), content_of(whole / "standings.csv"));
}

TEST(Experiment, ReplaysTheGameOfATruncatedRow) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(), fake_options(folder.path()));
  const std::string rows = content_of(shard_of(folder.path()));
  write_content(shard_of(folder.path()), rows.substr(0, rows.size() - 20));
  EXPECT_EQ(run_experiment(small_sweep(), fake_options(folder.path())).played, 1);
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep()));
}

TEST(Experiment, ReplaysTheGameOfADamagedRow) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(), fake_options(folder.path()));
  std::string rows = content_of(shard_of(folder.path()));
  rows[rows.size() / 2] ^= 1;
  write_content(shard_of(folder.path()), rows);
  EXPECT_EQ(run_experiment(small_sweep(), fake_options(folder.path())).played, 1);
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep()));
}

TEST(Experiment, ContinuesAfterAnInterrupt) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = interrupting();
  const ExperimentReport report = run_experiment(small_sweep(), options);
  EXPECT_FALSE(report.is_complete);
  EXPECT_FALSE(std::filesystem::exists(folder / "results.csv"));
  run_experiment(small_sweep(), fake_options(folder.path()));
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep()));
}

TEST(Experiment, IsRefusedWhileAnotherRunWritesToTheFolder) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(), fake_options(folder.path()));
  const Shard other(shard_of(folder.path()), "");
  EXPECT_THROW(run_experiment(small_sweep(), fake_options(folder.path())), io::InputOutputError);
}

TEST(Experiment, IsRefusedInAFolderOfAnotherConfigurationNamingTheDifferences) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(), fake_options(folder.path()));
  Scenario changed = small_sweep();
  changed.as<Sweep>()->base.match.half_s = 60;
  try {
    run_experiment(changed, fake_options(folder.path()));
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("match.half_s is 60.0 here and 600.0 there"),
              std::string::npos)
        << error.what();
  }
}

TEST(Experiment, IsRefusedInAFolderOfAnotherBuildUnlessAllowed) {
  const TemporaryFolder folder;
  run_experiment(small_sweep(), fake_options(folder.path()));
  ExperimentOptions options = fake_options(folder.path());
  options.build = "0.1.0-other";
  EXPECT_THROW(run_experiment(small_sweep(), options), io::InputError);
  options.allow_mixed_build = true;
  EXPECT_EQ(run_experiment(small_sweep(), options).played, 12);
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep()));
}

TEST(Experiment, PlaysOnlyTheNewTeamsGamesIfATeamIsAdded) {
  const TemporaryFolder folder;
  const ExperimentReport two =
      run_experiment(small_roundrobin({6, 5}), fake_options(folder.path()));
  EXPECT_EQ(two.played, 4);
  const Scenario three = small_roundrobin({6, 5, 4});
  const ExperimentReport report = run_experiment(three, fake_options(folder.path()));
  EXPECT_EQ(report.played, 8);
  EXPECT_EQ(report.results.standings.size(), 3U);
  EXPECT_EQ(results_in(folder), undisturbed_results(three));
}

TEST(Experiment, WritesTheStandingsOfARoundRobin) {
  const TemporaryFolder folder;
  run_experiment(small_roundrobin({6, 5, 4}), fake_options(folder.path()));
  EXPECT_EQ(line_count(content_of(folder / "results.csv")), 13);
  EXPECT_EQ(line_count(content_of(folder / "summary.csv")), 4);
  EXPECT_EQ(line_count(content_of(folder / "standings.csv")), 4);
}

TEST(Experiment, ReportsWhichTeamOfARoundRobinDiffers) {
  const TemporaryFolder folder;
  run_experiment(small_roundrobin({6, 5}), fake_options(folder.path()));
  try {
    run_experiment(small_roundrobin({6, 4, 3}), fake_options(folder.path()));
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("(teams.team1.robots is 4 here and 5 there)"),
              std::string::npos)
        << error.what();
  }
}

TEST(Experiment, ThrowsIfItsFolderCannotBeCreated) {
  const TemporaryFolder folder;
  write_content(folder / "file", "");
  EXPECT_THROW(run_experiment(small_sweep(), fake_options(folder / "file/x")),
               io::InputOutputError);
}

}  // namespace
}  // namespace autoref::experiments
