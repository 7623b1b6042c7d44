// Who does what: the parts that a play gives to the robots.
#pragma once

#include <array>
#include <cstdint>

#include "strategies/tactics/outlook.hpp"

namespace autoref::strategies {

enum class Part : std::uint8_t { kNone, kKeeper, kBall, kReceiver, kStands, kTaker };

// A robot's part, and where it is to be for it, if that is a place.
struct Task {
  Part part = Part::kNone;
  Waypoint place;
};

class Cast {
 public:
  explicit Cast(const Outlook& outlook) : outlook_(&outlook) {}

  bool is_free(int index) const { return task(index).part == Part::kNone; }
  const Task& task(int index) const { return tasks_[static_cast<std::size_t>(index)]; }
  int free_robots() const;

  void give(int index, Part part, const Waypoint& place = {});

  // The free robot that is soonest at the place; -1 without free robots.
  int nearest_free(const Vec2& place_m) const;

  // Makes the places permitted, and moves those apart where two robots could not stand both.
  void spread();

  // Sends the nearest free robot to stand there, if there is one.
  void send_nearest(const Waypoint& place);

 private:
  const Outlook* outlook_;
  std::array<Task, kMaxRobots> tasks_;
};

}  // namespace autoref::strategies
