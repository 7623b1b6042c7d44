#include "strategies/rowdy/foul_behaviours.hpp"

namespace autoref::strategies::rowdy {
namespace {

constexpr double kTurnsBefore_m = 300_mm;
constexpr double kShare = 0.6;  // fraction of half the field's width that the robot crosses

std::optional<ActiveFoul> find_chance(const RowdyView& view) {
  if (view.now.play != Play::kStop) return std::nullopt;
  const TrackedRobot* mate =
      nearest_mate(view, Vec2(-view.field.half_length_m() / 2, 0), view.field.length_m);
  return foul_by(mate, mate != nullptr ? mate->position_m : Vec2(0, 0));
}

// The robot drives back and forth.
bool go_on(const RowdyView& view, ActiveFoul& foul, TeamOutput& output) {
  const TrackedRobot& robot = *find(view.now.own, foul.robot);
  const double wing_m = kShare * view.field.half_width_m();
  const Vec2 target_m(foul.from_m.x(), foul.is_halfway ? -wing_m : wing_m);
  if ((target_m - robot.position_m).norm() < kTurnsBefore_m) foul.is_halfway = !foul.is_halfway;
  output.command(foul.robot) = go_to(view, robot, target_m);
  return view.now.play == Play::kStop;
}

}  // namespace

const FoulBehaviour kStopSprint = {
    "stop_sprint", "Drives fast across the field while play is stopped.", 0.1, 5, find_chance,
    go_on};

}  // namespace autoref::strategies::rowdy
