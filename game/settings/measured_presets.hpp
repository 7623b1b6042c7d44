// Presets of ball and camera from files of kind measured, such as those that `autoref log fit`
// writes:
//
//   schema: 1
//   kind: measured
//   about: One sentence.
//   ball: { roll_mps2: 0.31 }       # keys as below `sim.`
//   contacts: { ... }
//   frame_rate_hz: 73.2
//   latency_s: 0.05
//   vision: { ... }
//   radio: { command_loss: 0.03 }
//
// A preset of the ball consists of `ball` and `contacts`, a preset of the camera of the rest. Like
// a preset that has a name, it replaces all these values: those that the file does not give are the
// defaults, which are the presets `default` and `paper`.
#pragma once

#include <filesystem>
#include <string>

#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::game {

// Reads a file as strictly as a scenario. Throws InputError with file, line and key.
MeasuredPreset read_measured_text(const std::string& text, const std::string& file_name);

bool operator==(const MeasuredPreset& one, const MeasuredPreset& other);

// Returns whether a user can give a file as the value of the setting: a robot type, or a preset of
// the game's ball or camera.
bool accepts_file(const Setting& setting);

// Resolves a value that a user gave as `text` and returns it as value_in() reads it. If the setting
// accepts files and `text` is the path of one, relative to `folder`, reads that file into `types`
// or into the game's presets, and returns its name: "presets/mine.yaml" becomes "mine". Throws
// std::invalid_argument if the file cannot be read, gives no values for this setting, or has the
// name of another type or preset. Throws InputError for errors inside the file.
std::string take_name(const Setting& setting, const std::string& text,
                      const std::filesystem::path& folder, RobotTypes& types);

// Applies the preset of that name, which is known or from a file.
void apply_preset(const std::string& name, const BallPreset& preset);
void apply_preset(const std::string& name, const CameraPreset& preset);

}  // namespace autoref::game
