#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kBeyond_m = 700_mm;  // distance beyond the halfway line
constexpr double kBesideShare = 0.5;  // fraction of half the field's width

bool is_kickoff(const RowdyView& view) {
  return view.now.play == Play::kPrepareKickoff || view.now.play == Play::kKickoff;
}

Vec2 position_m(const RowdyView& view) {
  return {kBeyond_m, kBesideShare * view.field.half_width_m()};
}

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (!is_kickoff(view)) return std::nullopt;
  return foul_by(nearest_mate(view, position_m(view), view.field.length_m),
                 view.now.ball.position_m);
}

bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  output.command(foul.robot) = go_to(view, *find(view.now.own, foul.robot), position_m(view));
  return is_kickoff(view);
}

}  // namespace

const FoulBehaviour kKickoffIntruder = {"kickoff_intruder",
                                        "Puts a robot in the opponents' half at a kick-off.",
                                        0.3,
                                        25,
                                        find_chance,
                                        go_on};

}  // namespace autoref::strategies::rowdy
