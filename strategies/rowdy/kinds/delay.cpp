#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_own_restart(view)) return std::nullopt;
  return ActiveFoul{};
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  hold_back(view, foul.robot, view.now.ball.position_m, 2 * view.field.length_m, output.commands);
  return is_own_restart(view);
}

}  // namespace

const FoulBehaviour kDelay = {"delay", "Does not take its restart in time.", 0.05, 15, find_chance,
                              go_on};

}  // namespace autoref::strategies::rowdy
