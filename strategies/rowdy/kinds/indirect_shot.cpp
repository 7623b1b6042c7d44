#include "strategies/rowdy/foul_behaviours.hpp"

#include "strategies/skills/openings.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kShot_mps = 6.0;

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!view.now.ours || view.now.play != Play::kIndirectFree) return std::nullopt;
  return foul_by(nearest_mate(view, view.now.ball.position_m, view.field.length_m),
                 view.now.ball.position_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2& ball_m = view.now.ball.position_m;
  const Vec2 target_m = best_shot(view.field, ball_m, view.now.opponents).target_m;
  clear_lane(view, foul.robot, ball_m, target_m, output.commands);
  output.command(foul.robot) = kick_at(view, *find(view.now.own, foul.robot), target_m, kShot_mps);
  return view.now.play == Play::kIndirectFree;
}

}  // namespace

const FoulBehaviour kIndirectShot = {"indirect_shot",
                                     "Shoots straight at the goal from an indirect free kick.",
                                     0.3,
                                     10,
                                     find_chance,
                                     go_on};

}  // namespace autoref::strategies::rowdy
