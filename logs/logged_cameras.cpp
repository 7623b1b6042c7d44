#include "logs/logged_cameras.hpp"

#include "sim/camera.hpp"

namespace autoref::logs {
namespace {

constexpr double kDivisionA_m = 12.0;
constexpr double kDivisionB_m = 9.0;
constexpr double kHeightIn2026_m = 6.25;  // cameras hang at 6.0 to 6.5 m

}  // namespace

std::vector<CameraPosition> logged_cameras(const game::GameConfiguration& game) {
  const sim::VisionParameters& vision = game.sim.vision;
  int cameras = vision.cameras;
  double height_m = vision.camera_height_m;
  if (vision.reports_height && cameras == 4 && game.field.length_m >= kDivisionB_m) {
    cameras = game.field.length_m >= kDivisionA_m ? 2 : 1;
    height_m = kHeightIn2026_m;
  }
  const sim::CameraPositions positions = sim::camera_positions(game.field, cameras, height_m);
  return {positions.begin(), positions.end()};
}

}  // namespace autoref::logs
