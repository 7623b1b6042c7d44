// Drives a yellow robot of the simulated world straight ahead at 1 m/s for two seconds, and looks
// up a team that could have done so.
#include <cstdio>
#include <string>

#include "sim/world.hpp"
#include "strategies/registry.hpp"

int main() {
  using autoref::Side;
  using autoref::Vec2;
  autoref::PerSide<autoref::sim::TeamSpec> teams;
  teams[Side::kWest].robots.resize(1);
  autoref::sim::World world(autoref::Field{}, autoref::sim::Configuration{}, teams, 1);
  const Vec2 before_m = world.state().robots[Side::kWest].front().position_m;

  autoref::PerSide<autoref::TeamCommands> commands;
  commands[Side::kWest][0].velocity_mps = Vec2(1, 0);
  for (int frame = 0; frame < 120; ++frame) world.step(commands, std::nullopt);
  const Vec2 after_m = world.state().robots[Side::kWest].front().position_m;
  std::printf("driven: %.1f m\n", (after_m - before_m).norm());

  const autoref::strategies::Entry* team = autoref::strategies::find_strategy("basic");
  std::printf("team: %s\n", team == nullptr ? "none" : std::string(team->name).c_str());
}
