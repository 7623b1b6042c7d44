// Experiments with fake games, which keep the tests fast.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/sprt/sprt_match.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/run/run_experiment.hpp"
#include "game/settings/game_settings.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::experiments {

// A result that depends on the whole configuration, as a real game's does.
inline game::GameRecord fake_game(const game::GameConfiguration& game) {
  game::GameRecord record;
  record.goals_a = static_cast<int>(game.seed % 7);
  const std::size_t robots = game.b.robots.size();
  record.goals_b = static_cast<int>(game.seed / 7 % 5 + robots);
  record.goals_by_half = {{record.goals_a, 0}, {0, record.goals_b}};
  record.frames = 72000;
  record.sim_s = 1200;
  record.state_hash = game.seed * 31 + robots;
  return record;
}

using PlayGame = std::function<game::GameRecord(const game::GameConfiguration&)>;

// Interrupts the run in each game, as Ctrl-C would, and then plays that game to its end.
inline PlayGame interrupting(PlayGame play = fake_game) {
  return [runner = getpid(), play = std::move(play)](const game::GameConfiguration& game) {
    kill(runner, SIGINT);
    return play(game);
  };
}

inline game::GameRecord slow_fake_game(const game::GameConfiguration& game) {
  std::this_thread::sleep_for(std::chrono::milliseconds(3));
  return fake_game(game);
}

// A sweep with the values 6 and 5 of b.robots and `pairs` pairs per value.
inline Scenario small_sweep(int pairs = 3) {
  Sweep sweep;
  sweep.factors = {{"b.robots", {6, 5}}};
  sweep.pairs = pairs;
  sweep.seed = 2014;
  return {"A test.", sweep};
}

// A round robin of team0, team1, ... with these numbers of robots and `pairs` pairs per matchup.
inline Scenario small_roundrobin(const std::vector<int>& robots, int pairs = 2) {
  RoundRobin robin;
  for (const int count : robots) {
    robin.teams["team" + std::to_string(robin.teams.size())].robots = count;
  }
  robin.pairs = pairs;
  robin.seed = 2014;
  return {"A test.", robin};
}

// An SPRT match that is decided after min_pairs pairs: b has five robots, and the goal difference
// of fake games is -4 on average.
inline Scenario small_sprt_match(int max_pairs = 40) {
  SprtMatch match;
  match.teams["team0"].robots = 6;
  match.teams["team1"].robots = 5;
  match.sprt = {.d0 = 0, .d1 = -4, .min_pairs = std::min(10, max_pairs), .max_pairs = max_pairs};
  match.seed = 2014;
  return {"A test.", match};
}

// A comparison without opponents, of teams with six and five robots.
inline Scenario small_comparison(int max_pairs = 40) {
  Comparison comparison;
  comparison.teams[kOldTeam].robots = 6;
  comparison.teams[kNewTeam].robots = 5;
  comparison.test.max_pairs = max_pairs;
  comparison.seed = 2014;
  return {"A test.", comparison};
}

inline ExperimentOptions fake_options(const std::filesystem::path& folder) {
  ExperimentOptions options;
  options.folder = folder;
  options.build = "0.1.0-test";
  options.play = fake_game;
  options.patience_s = 0.05;
  return options;
}

inline std::filesystem::path shard_of(const std::filesystem::path& folder) {
  return folder / "games" / "shard-0-of-1.csv";
}

inline int line_count(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

// results.csv and summary.csv of an uninterrupted run.
inline std::string undisturbed_results(const Scenario& scenario) {
  const TemporaryFolder folder;
  run_experiment(scenario, fake_options(folder.path()));
  return content_of(folder / "results.csv") + content_of(folder / "summary.csv");
}

inline std::string results_in(const TemporaryFolder& folder) {
  return content_of(folder / "results.csv") + content_of(folder / "summary.csv");
}

}  // namespace autoref::experiments
