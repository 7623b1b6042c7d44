// Presets for ball, vision, radio, dribblers and kickers, and lookup in preset tables. A preset
// table is any range of structs with a `name`.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/sim_configuration.hpp"

namespace autoref::sim {

template <typename Presets>
std::vector<std::string> names_of(const Presets& presets) {
  std::vector<std::string> names;
  names.reserve(presets.size());
  for (const auto& preset : presets) names.emplace_back(preset.name);
  return names;
}

// Finds a preset by name. Throws a std::invalid_argument that lists the known presets; `kind` says
// what the presets are for.
template <typename Presets>
const auto& preset_called(std::string_view name, const Presets& presets, const std::string& kind) {
  std::string known;
  for (const auto& preset : presets) {
    if (preset.name == name) return preset;
    known += (known.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw std::invalid_argument("unknown " + kind + " preset '" + std::string(name) +
                              "'; known: " + known);
}

// The name of the first preset for which `is_it` returns true.
template <typename Presets, typename Is>
std::optional<std::string> name_of_preset(const Presets& presets, Is is_it) {
  for (const auto& preset : presets) {
    if (is_it(preset)) return std::string(preset.name);
  }
  return std::nullopt;
}

// The ball models of the league's simulators, for comparing results with those simulators.

// Sets the parameters of the two-phase model and of the bounces to the preset's values; leaves the
// other parameters (rest_mps, rolls_below_hop_m, net_mps2) unchanged. Throws a
// std::invalid_argument that lists the known presets if the name is unknown.
void apply_ball_preset(std::string_view name, BallParameters& ball);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> ball_preset_of(const BallParameters& ball);

std::vector<std::string> ball_preset_names();

// Vision and radio presets, for comparing results with other simulators.

// Sets vision, frame rate, radio packet loss and latency to the preset's values; leaves the other
// parameters unchanged. Throws a std::invalid_argument that lists the known presets if the name is
// unknown.
void apply_camera_preset(std::string_view name, Configuration& configuration);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> camera_preset_of(const Configuration& configuration);

std::vector<std::string> camera_preset_names();

// Presets of dribblers and kickers.

// Each function sets all parameters to the preset's values. If the name is unknown, it throws a
// std::invalid_argument that lists the known presets. For dribblers, `default` loses the ball in
// hard motion, and `perfect` keeps it in any motion of its robot. For both dribblers and kickers,
// `rc2026` has the values measured in games of 2026.
void apply_dribbler_preset(std::string_view name, DribblerParameters& dribbler);
void apply_kicker_preset(std::string_view name, KickerParameters& kicker);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> dribbler_preset_of(const DribblerParameters& dribbler);
std::optional<std::string> kicker_preset_of(const KickerParameters& kicker);

std::vector<std::string> dribbler_preset_names();
std::vector<std::string> kicker_preset_names();

}  // namespace autoref::sim
