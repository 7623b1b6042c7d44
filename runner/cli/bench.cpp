#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "runner/cli/command_line.hpp"
#include "runner/game/fixed_games.hpp"
#include "runner/game/game.hpp"
#include "runner/game/state_hash.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {

namespace {

// Plays the fixed games and prints how fast they were, and a hash over them.
int bench_verb(bool json) {
  std::vector<double> x_real_time;
  StateHash signature;
  for (int i = 0; i < kFixedGames; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const GameRecord record = play(fixed_game(i));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    x_real_time.push_back(record.sim_s / wall.count());
    signature.add(record.state_hash);
  }
  const double speed = median(x_real_time);
  if (json) {
    fmt::print("{}\n", json_text({{"x_real_time", rounded(speed, 1)},
                                  {"signature", fmt::format("{:016x}", signature.value())}}));
  } else {
    fmt::print("Games run {:.0f} times faster than real time on one core of this machine.\n",
               speed);
    fmt::print("signature {:016x}\n", signature.value());
  }
  return kDone;
}

}  // namespace

void add_bench_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("bench", "Measure how fast games run on this machine.");
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "Print one JSON object.");
  verb->footer(
      "The signature is a hash over the games: builds that print the same one play the same "
      "games.\n\nExample:\n  autoref bench --json");
  verb->callback([json, &chosen] { chosen = [json] { return bench_verb(*json); }; });
}

}  // namespace autoref::runner
