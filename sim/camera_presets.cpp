#include "sim/camera_presets.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace autoref::sim {
namespace {

struct Preset {
  std::string_view name;
  VisionParameters vision;
  double command_loss;
  double latency_s;
};

// The paper's simulator reported the truth (section 3). The others are the kinds of realism of
// ER-Force's simulator, whose robots hide the ball in all but the ideal one. Latencies are from
// camera to team, plus those of deciding and of the radio.
constexpr std::array kPresets = {
    Preset{"paper", {0, 0, 0, 0, 0, true, false}, 0, 35_ms + 5_ms},
    Preset{"none", {0, 0, 0, 0, 0, false, false}, 0, 35_ms + 5_ms},
    Preset{"friendly", {0.0004, 0.0003, 0.003, 0.05, 0.02, false, true}, 0.01, 35_ms + 10_ms},
    Preset{"rc2021", {0.001, 0.0013, 0.01, 0.05, 0, false, true}, 0.03, 35_ms + 10_ms},
    Preset{
        "realistic", {0.0014, 0.0013, 0.01, 0.05, 0.02, false, true}, 0.03, 35_ms + 10_ms + 3_ms},
};

bool is_same(const VisionParameters& a, const VisionParameters& b) {
  return a.ball_noise_m == b.ball_noise_m && a.robot_noise_m == b.robot_noise_m &&
         a.robot_noise_rad == b.robot_noise_rad && a.ball_misses == b.ball_misses &&
         a.robot_misses == b.robot_misses && a.reports_height == b.reports_height &&
         a.robots_hide_ball == b.robots_hide_ball;
}

}  // namespace

void apply_camera_preset(std::string_view name, Configuration& configuration) {
  const auto preset = std::find_if(kPresets.begin(), kPresets.end(),
                                   [name](const Preset& p) { return p.name == name; });
  if (preset == kPresets.end()) {
    std::string known;
    for (const Preset& p : kPresets) known += (known.empty() ? "" : ", ") + std::string(p.name);
    throw std::invalid_argument("unknown camera preset '" + std::string(name) +
                                "'; known: " + known);
  }
  configuration.vision = preset->vision;
  configuration.radio.command_loss = preset->command_loss;
  configuration.latency_s = preset->latency_s;
}

std::optional<std::string> camera_preset_of(const Configuration& configuration) {
  for (const Preset& preset : kPresets) {
    if (is_same(configuration.vision, preset.vision) &&
        configuration.radio.command_loss == preset.command_loss &&
        configuration.latency_s == preset.latency_s) {
      return std::string(preset.name);
    }
  }
  return std::nullopt;
}

std::vector<std::string> camera_preset_names() {
  std::vector<std::string> names;
  names.reserve(std::size(kPresets));
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

}  // namespace autoref::sim
