// The assignment of roles to robots.
#pragma once

#include <array>
#include <cstdint>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

enum class Role : std::uint8_t { kNone, kKeeper, kGoalLine, kBall, kReceiver, kStands, kTaker };

// A robot's role, and its target position if the role has one.
struct Task {
  Role role = Role::kNone;
  Waypoint waypoint;
};

class RoleAssignment {
 public:
  explicit RoleAssignment(const PredictedState& predicted) : predicted_(&predicted) {}

  bool is_free(int index) const { return task(index).role == Role::kNone; }
  const Task& task(int index) const { return tasks_[static_cast<std::size_t>(index)]; }
  int free_robots() const;

  void give(int index, Role role, const Waypoint& waypoint = {});

  // The free robot nearest to the position, extrapolated by the style's moves_on_s; -1 if there is
  // none.
  int nearest_free(const Vec2& position_m) const;

  // Moves all positions to permitted ones, and apart if robots would overlap.
  void spread();

  // Sends the nearest free robot to the waypoint, if there is a free robot.
  void send_nearest(const Waypoint& waypoint);

 private:
  const PredictedState* predicted_;
  std::array<Task, kMaxRobots> tasks_;
};

}  // namespace autoref::strategies
