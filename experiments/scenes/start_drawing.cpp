#include "experiments/scenes/start_drawing.hpp"

#include "view/drawing.hpp"

namespace autoref::experiments {
namespace {

Frame frame_of(const game::StartState& start) {
  Frame frame;
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : start.robots[side])
      frame.robots[side].push_back({robot.number, robot.position_m, robot.heading});
  }
  frame.ball = BallObservation{start.ball.position_m, start.ball.height_m};
  return frame;
}

RefereeSignal signal_of(const referee::MidwayStart& midway_start) {
  RefereeSignal signal;
  signal.stage = Stage::kFirstHalf;
  signal.command = midway_start.restart.value_or(Command{CommandKind::kForceStart, Side::kWest});
  return signal;
}

}  // namespace

std::string drawing_of(const game::StartState& start, const Field& field,
                       const PerSide<std::string>& names) {
  return view::drawing_of({field, names, signal_of(start.referee), {frame_of(start)}});
}

}  // namespace autoref::experiments
