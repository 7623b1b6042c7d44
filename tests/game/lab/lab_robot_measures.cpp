// Measurements of robots that drive, turn, push and collide.
#include <algorithm>

#include "tests/game/lab/lab_measures.hpp"
#include "tests/game/lab/lab_record.hpp"

namespace autoref::game::lab_measures {
namespace {

constexpr std::size_t kStopCommand = 75;  // frame of the command to stop, at 1.25 s

double path_m(const LabRecord& record, std::size_t robot) {
  return (west(record.states.back(), robot).position_m - west(record.states[0], robot).position_m)
      .norm();
}

}  // namespace

// The time from the first motion until the robot reaches 3 m/s, extrapolated from the frame before.
double to_three_s(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState&, const WorldState& now) {
    return west(now).velocity_mps.norm() > 2.999;
  });
  const double missing_mps = 3.0 - west(record.states[f - 1]).velocity_mps.norm();
  return static_cast<double>(f - 1) * kFrame_s + missing_mps / 3.0;
}

double top_mps(const LabRecord& record) {
  double top = 0.0;
  for (const WorldState& state : record.states) {
    top = std::max(top, west(state).velocity_mps.norm());
  }
  return top;
}

double stop_s(const LabRecord& record) {
  std::size_t f = kStopCommand;
  while (west(record.states[f + 1]).velocity_mps.norm() > 1e-3) ++f;
  return static_cast<double>(f - kStopCommand) * kFrame_s +
         west(record.states[f]).velocity_mps.norm() / 5.0;
}

double stop_m(const LabRecord& record) {
  return (west(record.states.back()).position_m - west(record.states[kStopCommand]).position_m)
      .norm();
}

double turning_radps2(const LabRecord& record) {
  return west(record.states[12]).angular_velocity_radps / (12 * kFrame_s);
}

double turning_radps(const LabRecord& record) {
  return west(record.states[60]).angular_velocity_radps;
}

// The delay until a uniformly accelerating robot starts to move, found by extrapolating its speed
// back to zero.
double delay_ms(const LabRecord& record) {
  const std::size_t last = record.states.size() - 1;
  const double first_mps = west(record.states[last - 6]).velocity_mps.x();
  const double mps = west(record.states[last]).velocity_mps.x();
  const double mps2 = (mps - first_mps) / (6 * kFrame_s);
  return 1000 * (static_cast<double>(last) * kFrame_s - mps / mps2 - 0.1);
}

// Deceleration of two robots in contact, from their mean speed at 0.95 s and 1.15 s.
double pair_mps2(const LabRecord& record) {
  const auto mean_mps = [&](std::size_t f) {
    const WorldState& state = record.states[f];
    return (west(state).velocity_mps.x() + east(state).velocity_mps.x()) / 2;
  };
  return (mean_mps(57) - mean_mps(69)) / (12 * kFrame_s);
}

// The restitution of a collision of two robots, relative to their approach speeds. Corrects for
// their braking with 5 m/s^2 immediately after the collision.
double robots_rebound(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState& former, const WorldState& now) {
    return west(former).velocity_mps.x() > 0.0 && west(now).velocity_mps.x() < 0.0;
  });
  const RobotState& last = west(record.states[f - 1]);
  const RobotState& first = west(record.states[f]);
  const double to_mps = last.velocity_mps.x();
  const double from_mps = first.velocity_mps.x();
  const double after_s =
      (first.position_m.x() - last.position_m.x() - from_mps * kFrame_s) / (to_mps - from_mps);
  return (-from_mps + 5.0 * (kFrame_s - after_s)) / to_mps;
}

double middle_mm(const LabRecord& record) {
  const WorldState& end = record.states.back();
  return 500 * (west(end).position_m.x() + east(end).position_m.x());
}

double fast_path_m(const LabRecord& record) { return path_m(record, 0); }
double slow_path_m(const LabRecord& record) { return path_m(record, 1); }

}  // namespace autoref::game::lab_measures
