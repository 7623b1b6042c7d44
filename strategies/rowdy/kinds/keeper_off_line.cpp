#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kBeforeLine_m = 350_mm;

bool is_their_penalty(const RowdyView& view) {
  return !view.now.ours &&
         (view.now.play == Play::kPreparePenalty || view.now.play == Play::kPenalty);
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_their_penalty(view)) return std::nullopt;
  return foul_by(find(view.now.own, view.keeper), view.now.ball.position_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const Vec2 position_m = view.field.goal_centre_m(Side::kWest) + Vec2(kBeforeLine_m, 0);
  output.command(foul.robot) = go_to(view, *find(view.now.own, foul.robot), position_m);
  return is_their_penalty(view);
}

}  // namespace

const FoulBehaviour kKeeperOffLine = {"keeper_off_line",
                                      "The keeper leaves its line before a penalty kick is taken.",
                                      0.4,
                                      25,
                                      find_chance,
                                      go_on};

}  // namespace autoref::strategies::rowdy
