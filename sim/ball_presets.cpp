#include "sim/ball_presets.hpp"

#include <array>

#include "sim/presets.hpp"

namespace autoref::sim {
namespace {

struct BallPreset {
  std::string_view name;
  double slide_mps2;
  double roll_mps2;
  double switch_ratio;
  double hop_first_xy;
  double hop_later_xy;
  double hop_z;
};

constexpr BallParameters kOwn{};

// The values of `erforce` and `grsim` were measured in those simulators; those of `tigers` come
// from Sumatra (TIGERs Mannheim), which fitted them to balls on RoboCup fields.
constexpr std::array kBallPresets = {
    BallPreset{"default", kOwn.slide_mps2, kOwn.roll_mps2, kOwn.switch_ratio, kOwn.hop_first_xy,
               kOwn.hop_later_xy, kOwn.hop_z},
    BallPreset{"erforce", 3.92, 0.35, 0.69, 0.715, 1.0, 0.566},
    BallPreset{"tigers", 3.0, 0.26, 0.667, 0.8, 0.85, 0.47},
    BallPreset{"grsim", 10.3, 0.70, 0.70, 0.59, 0.95, 0.49},
};

bool has_numbers_of(const BallPreset& preset, const BallParameters& ball) {
  return ball.slide_mps2 == preset.slide_mps2 && ball.roll_mps2 == preset.roll_mps2 &&
         ball.switch_ratio == preset.switch_ratio && ball.hop_first_xy == preset.hop_first_xy &&
         ball.hop_later_xy == preset.hop_later_xy && ball.hop_z == preset.hop_z;
}

}  // namespace

void apply_ball_preset(std::string_view name, BallParameters& ball) {
  const BallPreset& preset = preset_called(name, kBallPresets, "ball");
  ball.slide_mps2 = preset.slide_mps2;
  ball.roll_mps2 = preset.roll_mps2;
  ball.switch_ratio = preset.switch_ratio;
  ball.hop_first_xy = preset.hop_first_xy;
  ball.hop_later_xy = preset.hop_later_xy;
  ball.hop_z = preset.hop_z;
}

std::optional<std::string> ball_preset_of(const BallParameters& ball) {
  return name_of_preset(kBallPresets, [&](const BallPreset& p) { return has_numbers_of(p, ball); });
}

std::vector<std::string> ball_preset_names() { return names_of(kBallPresets); }

}  // namespace autoref::sim
