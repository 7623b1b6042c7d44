#include "game/settings/measured_presets.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "game/settings/named_files.hpp"
#include "game/settings/robot_types.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "io/words.hpp"
#include "sim/presets.hpp"

namespace autoref::game {
namespace {

void copy_ball(const sim::Configuration& from, sim::BallParameters& ball,
               sim::ContactParameters& contacts) {
  ball = from.ball;
  contacts = from.contacts;
}

void copy_camera(const sim::Configuration& from, sim::Configuration& to) {
  to.vision = from.vision;
  to.radio.command_loss = from.radio.command_loss;
  to.latency_s = from.latency_s;
  to.frame_rate_hz = from.frame_rate_hz;
}

std::vector<Setting> settings_of(sim::Configuration& sim) {
  std::vector<Setting> settings = ball_settings(sim, "");
  for (Setting& setting : camera_settings(sim, "")) settings.push_back(std::move(setting));
  return settings;
}

std::vector<std::string> read_sections(const YamlFile& file, sim::Configuration& sim) {
  return read_settings_file(file, "measured", settings_of(sim));
}

// Throws std::invalid_argument if the file has none of the sections that the settings belong to.
void check_sections(const NamedFile& file, const std::vector<std::string>& given,
                    const std::vector<Setting>& settings, std::string_view what) {
  const std::vector<std::string> wanted = names_below(settings, "");
  if (std::find_first_of(given.begin(), given.end(), wanted.begin(), wanted.end()) != given.end())
    return;
  throw std::invalid_argument(fmt::format("{} has no values for the {}; expected one of {}",
                                          file.path, what, io::listed(wanted)));
}

MeasuredPresets* presets_of(const Setting& setting) {
  if (const auto* ball = std::get_if<BallPreset>(&setting.target)) return ball->measured;
  if (const auto* camera = std::get_if<CameraPreset>(&setting.target)) return camera->measured;
  return nullptr;
}

std::string take_preset(const Setting& setting, const std::string& text,
                        const std::filesystem::path& folder) {
  const NamedFile file = read_named_file(text, folder, kPreset);
  const std::vector<std::string>& known = setting.allowed_words;
  if (std::find(known.begin(), known.end(), file.name) != known.end()) refuse_name(file);
  sim::Configuration measured;
  const std::vector<std::string> given = read_sections({file.text, file.path}, measured);
  MeasuredPreset preset;
  if (std::holds_alternative<BallPreset>(setting.target)) {
    check_sections(file, given, ball_settings(measured, ""), "ball");
    copy_ball(measured, preset.sim.ball, preset.sim.contacts);
  } else {
    check_sections(file, given, camera_settings(measured, ""), "camera");
    copy_camera(measured, preset.sim);
  }
  add_named(file, preset, *presets_of(setting));
  return file.name;
}

}  // namespace

MeasuredPreset read_measured_text(const std::string& text, const std::string& file_name) {
  MeasuredPreset preset;
  read_sections({text, file_name}, preset.sim);
  return preset;
}

bool operator==(const MeasuredPreset& one, const MeasuredPreset& other) {
  MeasuredPreset first = one;
  MeasuredPreset second = other;
  const std::vector<Setting> its = settings_of(first.sim);
  const std::vector<Setting> others = settings_of(second.sim);
  return std::equal(its.begin(), its.end(), others.begin(), others.end(),
                    [](const Setting& a, const Setting& b) { return value_of(a) == value_of(b); });
}

bool accepts_file(const Setting& setting) {
  return std::holds_alternative<TypeName>(setting.target) || presets_of(setting) != nullptr;
}

std::string take_name(const Setting& setting, const std::string& text,
                      const std::filesystem::path& folder, RobotTypes& types) {
  if (!accepts_file(setting) || !is_settings_file(text)) return text;
  return std::holds_alternative<TypeName>(setting.target) ? take_type(text, folder, types)
                                                          : take_preset(setting, text, folder);
}

void apply_preset(const std::string& name, const BallPreset& preset) {
  if (preset.measured != nullptr) {
    const auto found = preset.measured->find(name);
    const bool is_measured = found != preset.measured->end();
    // Known presets leave some values unchanged. Reset these, since a file may have set them.
    copy_ball(is_measured ? found->second.sim : sim::Configuration{}, *preset.ball,
              *preset.contacts);
    if (is_measured) return;
  }
  sim::apply_ball_preset(name, *preset.ball);
}

void apply_preset(const std::string& name, const CameraPreset& preset) {
  if (preset.measured != nullptr) {
    const auto found = preset.measured->find(name);
    if (found != preset.measured->end()) return copy_camera(found->second.sim, *preset.sim);
  }
  sim::apply_camera_preset(name, *preset.sim);
}

}  // namespace autoref::game
