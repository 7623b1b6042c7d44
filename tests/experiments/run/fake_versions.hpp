// Experiments with versions of teams, with fake games of different builds of AutoRef.
#pragma once

#include <map>
#include <string>

#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/run/earlier_versions.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {

// A team scores as many goals as it has robots, a few more depending on the seed, and those that a
// build adds for its number of robots.
using AddedGoals = std::map<std::size_t, int>;

inline PlayGame game_of_build(AddedGoals added) {
  return [added = std::move(added)](const game::GameConfiguration& game) {
    const auto goals = [&added](std::size_t robots) {
      const auto more = added.find(robots);
      return static_cast<int>(robots) + (more == added.end() ? 0 : more->second);
    };
    game::GameRecord record = fake_game(game);
    record.goals_a = goals(game.a.robots.size()) + static_cast<int>(game.seed % 3);
    record.goals_b = goals(game.b.robots.size()) + static_cast<int>(game.seed / 3 % 3);
    record.goals_by_half = {{record.goals_a, 0}, {0, record.goals_b}};
    return record;
  };
}

// basic, an anchor, and two versions against zone.
inline Scenario versioned_gauntlet(int pairs = 4) {
  Gauntlet gauntlet;
  gauntlet.teams["zone"].robots = 5;
  gauntlet.challengers["basic"].robots = 6;
  gauntlet.challengers["v1"].robots = 3;
  gauntlet.challengers["v2"].robots = 4;
  gauntlet.versions.of_teams = {{"v1", {"2026-01-01", ""}}, {"v2", {"2026-03-01", ""}}};
  gauntlet.versions.anchors = {"basic"};
  gauntlet.pairs = pairs;
  gauntlet.seed = 2014;
  return {"A test.", gauntlet};
}

inline Scenario versioned_robin(int pairs = 4) {
  RoundRobin robin;
  robin.teams["basic"].robots = 6;
  robin.teams["calm"].robots = 5;
  robin.teams["v1"].robots = 3;
  robin.teams["v2"].robots = 4;
  robin.versions.of_teams = {{"v1", {"2026-01-01", ""}}, {"v2", {"2026-03-01", ""}}};
  robin.versions.anchors = {"basic", "calm"};
  robin.pairs = pairs;
  robin.seed = 2014;
  return {"A test.", robin};
}

}  // namespace autoref::experiments
