#include "game/loop/substitution.hpp"

#include <algorithm>
#include <optional>

#include "soccer/robot_shape.hpp"

namespace autoref::game {
namespace {

constexpr double kNotice_s = 1.0;              // time for the team to choose the robot that leaves
constexpr double kFromHalfwayLine_m = 200_mm;  // distance to the first return position
constexpr double kNextPosition_m = 200_mm;     // distance between return positions
constexpr double kFromWall_m = 20_mm;          // distance from hull to wall

bool is_stopped(CommandKind command) {
  switch (command) {
    case CommandKind::kNormalStart:
    case CommandKind::kForceStart:
    case CommandKind::kDirectFree:
    case CommandKind::kIndirectFree:
      return false;
    default:
      return true;
  }
}

int count_on(const sim::World& world, Side side) {
  return static_cast<int>(world.state().robots[side].size());
}

// The number of the robot that leaves. The side must have a robot on the field.
int leaver(const sim::World& world, Side side, const TeamRequests& requests) {
  const auto& robots = world.state().robots[side];
  const auto is_named = [&](const sim::RobotState& r) { return r.number == requests.leaves; };
  if (std::any_of(robots.begin(), robots.end(), is_named)) return *requests.leaves;
  const int highest = robots.back().number;
  return highest == requests.keeper && robots.size() > 1 ? robots[robots.size() - 2].number
                                                         : highest;
}

bool is_off_ball(const Vec2& position_m, const RefereeSignal& signal, const sim::World& world,
                 double from_ball_m) {
  const auto keeps_from = [&](const Vec2& ball_m) {
    return (position_m - ball_m).norm() > from_ball_m + kRobotRadius_m;
  };
  return keeps_from(world.state().ball.position_m) &&
         (!signal.placement || keeps_from(signal.placement->target_m));
}

}  // namespace

std::optional<Vec2> return_position(const Field& field, Side side, const RefereeSignal& signal,
                                    const sim::World& world, double from_ball_m) {
  const double turn = -goal_sign(side);  // 1 in the west, -1 in the east
  // In the middle of the run-off, or nearer to the field if the wall is too close.
  const double off_line_m =
      std::min(field.run_off_m / 2, field.run_off_m - kRobotRadius_m - kFromWall_m);
  const double beside_m = field.half_width_m() + off_line_m;
  const int positions = static_cast<int>(field.half_length_m() / kNextPosition_m);
  for (const double y_m : {-beside_m, beside_m}) {
    for (int i = 0; i < positions; ++i) {
      // With a rotation by 180 degrees, both sides have the same positions as seen from their own
      // goals.
      const Vec2 position_m = turn * Vec2(-kFromHalfwayLine_m - kNextPosition_m * i, y_m);
      if (world.is_free(position_m) && is_off_ball(position_m, signal, world, from_ball_m))
        return position_m;
    }
  }
  return std::nullopt;
}

void SubstitutionController::act(const RefereeSignal& signal, const PerSide<TeamRequests>& requests,
                                 double time_s, sim::World& world) {
  for (const Side side : kSides) {
    const int allowed = signal.robots_allowed[side];
    note_allowance(side, allowed, time_s);
    if (!is_stopped(signal.command.kind)) continue;
    const int on = count_on(world, side);
    const int available = robots_[side] - static_cast<int>(kept_off_[side].count());
    if (on > std::max(0, allowed)) {
      if (time_s - fell_s_[side] < kNotice_s) continue;
      world.take_off({side, leaver(world, side, requests[side])});
    } else if (on < std::min(allowed, available)) {
      call_back(side, signal, world);
    }
  }
}

void SubstitutionController::note_allowance(Side side, int allowed, double time_s) {
  if (allowed < allowed_[side]) fell_s_[side] = time_s;
  allowed_[side] = allowed;
}

void SubstitutionController::call_back(Side side, const RefereeSignal& signal,
                                       sim::World& world) const {
  const std::optional<Vec2> position_m = return_position(field_, side, signal, world, from_ball_m_);
  if (!position_m) return;
  int number = 0;
  const auto is_kept_off = [&](int robot) {
    return kept_off_[side].test(static_cast<std::size_t>(robot));
  };
  while (world.is_on({side, number}) || is_kept_off(number)) ++number;
  world.put_on({side, number}, *position_m, Vec2(0, position_m->y() > 0 ? -1.0 : 1.0));
}

}  // namespace autoref::game
