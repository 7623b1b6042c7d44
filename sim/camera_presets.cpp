#include "sim/camera_presets.hpp"

#include <array>

#include "sim/presets.hpp"

namespace autoref::sim {
namespace {

struct CameraPreset {
  std::string_view name;
  VisionParameters vision;
  double command_loss;
  double latency_s;
};

// The paper's simulator reported ground truth (section 3). The others match the realism levels of
// ER-Force's simulator, where robots occlude the ball at every level except the ideal one.
// Latencies include camera, vision, the team's decision and radio.
constexpr std::array kCameraPresets = {
    CameraPreset{"paper", {0, 0, 0, 0, 0, true, false}, 0, 35_ms + 5_ms},
    CameraPreset{"none", {0, 0, 0, 0, 0, false, false}, 0, 35_ms + 5_ms},
    CameraPreset{"friendly", {0.0004, 0.0003, 0.003, 0.05, 0.02, false, true}, 0.01, 35_ms + 10_ms},
    CameraPreset{"rc2021", {0.001, 0.0013, 0.01, 0.05, 0, false, true}, 0.03, 35_ms + 10_ms},
    CameraPreset{
        "realistic", {0.0014, 0.0013, 0.01, 0.05, 0.02, false, true}, 0.03, 35_ms + 10_ms + 3_ms},
};

}  // namespace

void apply_camera_preset(std::string_view name, Configuration& configuration) {
  const CameraPreset& preset = preset_called(name, kCameraPresets, "camera");
  configuration.vision = preset.vision;
  configuration.radio.command_loss = preset.command_loss;
  configuration.latency_s = preset.latency_s;
}

std::optional<std::string> camera_preset_of(const Configuration& configuration) {
  return name_of_preset(kCameraPresets, [&](const CameraPreset& preset) {
    return configuration.vision == preset.vision &&
           configuration.radio.command_loss == preset.command_loss &&
           configuration.latency_s == preset.latency_s;
  });
}

std::vector<std::string> camera_preset_names() { return names_of(kCameraPresets); }

}  // namespace autoref::sim
