// From the world's truth to what vision reports.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/world.hpp"
#include "soccer/frame.hpp"

namespace autoref::sim {

// How well vision sees. Defaults are the preset `paper`: true positions and the ball's height, as
// the paper's simulator reported them (section 3, "Simulator").
struct CameraParameters {
  bool reports_height = true;
};

// The preset of that name. Throws std::invalid_argument that names the known ones.
CameraParameters camera_preset(std::string_view name);
std::vector<std::string> camera_preset_names();

// Takes one picture per frame. Values are rounded to what a league vision packet holds (float
// millimetres and radians), so that a recorded game shows the same as the live one.
class Camera {
 public:
  Camera(const CameraParameters& parameters, double frame_rate_hz);

  // Fills `frame` in place: nothing is allocated.
  void look(const WorldState& world, Frame& frame) const;

 private:
  CameraParameters parameters_;
  double frame_rate_hz_;
};

}  // namespace autoref::sim
