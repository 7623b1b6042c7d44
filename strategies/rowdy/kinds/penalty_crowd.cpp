#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kBeside_m = 500_mm;  // distance to the side of the penalty mark

bool is_penalty(const RowdyView& view) {
  return view.now.play == Play::kPreparePenalty || view.now.play == Play::kPenalty;
}

Vec2 mark_m(const RowdyView& view) {
  return view.now.placement_m.value_or(view.now.ball.position_m);
}

// The fouling robot is any robot other than the kicker.
std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_penalty(view)) return std::nullopt;
  const TrackedRobot* kicker =
      view.now.ours ? nearest_mate(view, mark_m(view), view.field.length_m) : nullptr;
  for (const TrackedRobot& mate : view.now.own) {
    if (mate.number != view.keeper && &mate != kicker) return foul_by(&mate, mark_m(view));
  }
  return std::nullopt;
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  output.command(foul.robot) =
      go_to(view, *find(view.now.own, foul.robot), foul.from_m + Vec2(0, kBeside_m));
  return is_penalty(view);
}

}  // namespace

const FoulBehaviour kPenaltyCrowd = {"penalty_crowd",
                                     "Puts a robot next to the mark when a penalty kick is taken.",
                                     0.4,
                                     25,
                                     find_chance,
                                     go_on};

}  // namespace autoref::strategies::rowdy
