#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/statistics/sample.hpp"
#include "game/loop/game.hpp"
#include "game/loop/state_hash.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"

namespace autoref::app {
namespace {

// Plays the fixed games and prints their speed and a hash over them.
int speed_verb(bool json) {
  std::vector<double> x_real_time;
  game::StateHash signature;
  for (int i = 0; i < game::kFixedGames; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const game::GameRecord record = game::play(game::fixed_game(i));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    x_real_time.push_back(record.sim_s / wall.count());
    signature.add(record.state_hash);
  }
  const double speed = experiments::median(x_real_time);
  if (json) {
    fmt::print("{}\n", io::json_text({{"x_real_time", io::rounded(speed, 1)},
                                      {"signature", fmt::format("{:016x}", signature.value())}}));
  } else {
    fmt::print("Games run {:.0f} times faster than real time on one core of this machine.\n",
               speed);
    fmt::print("signature {:016x}\n", signature.value());
  }
  return io::kDone;
}

}  // namespace

void add_speed_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("speed", "Measure how fast games run on this machine.");
  auto json = std::make_shared<bool>(false);
  add_json_flag(*verb, *json);
  verb->footer(
      "The signature is a hash over the games: builds that print the same one play the same "
      "games.\n\nExample:\n  autoref show speed --json");
  verb->callback([json, &chosen] { chosen = [json] { return speed_verb(*json); }; });
}

}  // namespace autoref::app
