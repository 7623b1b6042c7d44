#include "game/team_programs/world_change.hpp"

namespace autoref::game {
namespace {

struct Apply {
  Game& game;
  void operator()(const sim::BallState& ball) const { game.put_ball(ball); }
  void operator()(const RemovedRobot& removed) const { game.take_off(removed.robot); }
  void operator()(const PlacedRobot& placed) const {
    if (!game.world().is_on(placed.robot)) {
      if (!game.world().is_free(placed.state.position_m)) return;
      game.put_on(placed.robot, placed.state.position_m, placed.state.heading);
    }
    game.put_robot(placed.robot, placed.state);
  }
};

}  // namespace

void apply(const WorldChange& change, Game& game) { std::visit(Apply{game}, change); }

}  // namespace autoref::game
