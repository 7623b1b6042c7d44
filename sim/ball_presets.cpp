#include "sim/ball_presets.hpp"

#include <array>

#include "sim/presets.hpp"

namespace autoref::sim {
namespace {

// The parameters that a preset sets.
struct Numbers {
  double slide_mps2;
  double roll_mps2;
  double roll_per_s;
  double switch_ratio;
  double hop_first_xy;
  double hop_later_xy;
  double hop_first_z;
  double hop_later_z;
  bool operator==(const Numbers&) const = default;
};

struct BallPreset {
  std::string_view name;
  Numbers numbers;
};

constexpr Numbers numbers_of(const BallParameters& ball) {
  return {ball.slide_mps2,   ball.roll_mps2,    ball.roll_per_s,  ball.switch_ratio,
          ball.hop_first_xy, ball.hop_later_xy, ball.hop_first_z, ball.hop_later_z};
}

// The values of `erforce` and `grsim` were measured in those simulators; those of `tigers` come
// from Sumatra (TIGERs Mannheim), which fitted them to balls on RoboCup fields; those of `rc2026`
// were fitted by the team Immortals to ten recorded games of 2026.
constexpr std::array kBallPresets = {
    BallPreset{"default", numbers_of({})},
    BallPreset{"erforce", {3.92, 0.35, 0, 0.69, 0.715, 1.0, 0.566, 0.566}},
    BallPreset{"tigers", {3.0, 0.26, 0, 0.667, 0.8, 0.85, 0.47, 0.47}},
    BallPreset{"grsim", {10.3, 0.70, 0, 0.70, 0.59, 0.95, 0.49, 0.49}},
    BallPreset{"rc2026", {3.3, 0.22, 0.045, 0.66, 0.70, 0.87, 0.46, 0.40}},
};

}  // namespace

void apply_ball_preset(std::string_view name, BallParameters& ball) {
  const Numbers& numbers = preset_called(name, kBallPresets, "ball").numbers;
  ball.slide_mps2 = numbers.slide_mps2;
  ball.roll_mps2 = numbers.roll_mps2;
  ball.roll_per_s = numbers.roll_per_s;
  ball.switch_ratio = numbers.switch_ratio;
  ball.hop_first_xy = numbers.hop_first_xy;
  ball.hop_later_xy = numbers.hop_later_xy;
  ball.hop_first_z = numbers.hop_first_z;
  ball.hop_later_z = numbers.hop_later_z;
}

std::optional<std::string> ball_preset_of(const BallParameters& ball) {
  return name_of_preset(kBallPresets,
                        [&](const BallPreset& it) { return it.numbers == numbers_of(ball); });
}

std::vector<std::string> ball_preset_names() { return names_of(kBallPresets); }

}  // namespace autoref::sim
