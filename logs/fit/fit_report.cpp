#include "logs/fit/fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/json.hpp"
#include "io/words.hpp"

namespace autoref::logs {
namespace {

std::string short_text(double value) { return fmt::format("{:.4g}", value); }

// The settings of a game with default values, to look up ranges and defaults.
class DefaultSettings {
 public:
  DefaultSettings() : settings_(game::settings_of(game_)) {}

  const game::Setting* find(const FittedNumber& number) const {
    return game::find_setting(settings_, "sim." + number.name());
  }

  std::string value_of(const FittedNumber& number) const {
    const game::Setting* setting = find(number);
    return setting == nullptr ? "" : game::value_of(*setting);
  }

  double allowed(const FittedNumber& number, double value) const {
    const game::Setting* setting = find(number);
    if (setting == nullptr || setting->range.contains(value)) return value;
    const Range& range = setting->range;
    constexpr double kJustAbove = 1e-6;
    return std::clamp(value, range.above_low ? range.low + kJustAbove : range.low, range.high);
  }

 private:
  game::GameSettings game_;
  std::vector<game::Setting> settings_;
};

std::string interval_text(const Estimated& number) {
  return fmt::format("{} to {}", short_text(number.low), short_text(number.high));
}

void add_rows(const std::vector<FittedNumber>& numbers, const DefaultSettings& settings,
              io::TextTable& table) {
  for (const FittedNumber& number : numbers) {
    const auto& estimated = number.estimate.number;
    table.rows.push_back({number.name(), estimated ? short_text(estimated->value) : "not enough",
                          estimated ? interval_text(*estimated) : "",
                          std::to_string(number.estimate.episodes), settings.value_of(number)});
  }
}

io::TextTable table_of(const std::vector<std::vector<FittedNumber>>& groups) {
  io::TextTable table{{{"setting below sim", "estimate", "95 % interval", "seen", "default"}},
                      {io::Align::kLeft}};
  table.columns.resize(table.rows.front().size(), io::Align::kRight);
  const DefaultSettings settings;
  for (const auto& numbers : groups) add_rows(numbers, settings, table);
  return table;
}

io::TextTable team_table(const std::vector<FittedTeam>& teams) {
  std::vector<std::vector<FittedNumber>> groups;
  groups.reserve(teams.size());
  for (const FittedTeam& team : teams) groups.push_back(team.robots);
  io::TextTable table = table_of(groups);
  table.rows.front().insert(table.rows.front().begin(), "team");
  table.columns.insert(table.columns.begin(), io::Align::kLeft);
  table.keys = 2;
  std::size_t row = 1;
  for (const FittedTeam& team : teams) {
    for (std::size_t i = 0; i < team.robots.size(); ++i, ++row)
      table.rows[row].insert(table.rows[row].begin(), team.name);
  }
  return table;
}

std::string cameras_text(const LogFit& fit) {
  std::string text;
  for (const auto& [number, camera] : fit.cameras) {
    text +=
        fmt::format("Camera {}: {} captures, {:.2f} Hz", number, camera.captures, camera.rate_hz);
    if (number != fit.cameras.begin()->first) {
      text += fmt::format(", {:.2f} ms after the first camera (standard deviation {:.2f} ms)",
                          1e3 * camera.phase_s.value, 1e3 * camera.phase_s.deviation);
    }
    text += ".\n";
  }
  return text;
}

std::string seen_text(const LogFit& fit) {
  std::string shares;
  for (const SeenShare& share : fit.ball_seen) {
    if (share.frames == 0) continue;
    shares +=
        fmt::format("{}{:.2f} m {:.0f} %", shares.empty() ? "" : ", ", share.distance_m,
                    100.0 * static_cast<double>(share.seen) / static_cast<double>(share.frames));
  }
  if (shares.empty()) return "The ball was never near a robot.";
  return "Ball seen, by its distance to the nearest robot's centre: " + shares + ".";
}

std::string prediction_text(const LogFit& fit) {
  if (!fit.roll_prediction) return "Too few rolling balls to check predictions of their paths.";
  const RollPrediction& roll = *fit.roll_prediction;
  return fmt::format(
      "Where a rolling ball will be {:.1f} m on, predicted from the first third of its path: off "
      "by "
      "{:.0f} mm with what the other paths show, and by {:.0f} mm with the default ball (root mean "
      "square, {} paths).",
      roll.travelled_m, 1e3 * roll.fitted_m, 1e3 * roll.compared_m, roll.paths);
}

std::string drifts_text(const LogFit& fit) {
  std::string text = "Slowly drifting part of the noise, which a simulation does not have:";
  for (const FittedNumber& number : fit.drifts) {
    const auto& estimated = number.estimate.number;
    text +=
        fmt::format(" {} {}{}", number.key, estimated ? short_text(estimated->value) : "unknown",
                    &number == &fit.drifts.back() ? "." : ",");
  }
  return text;
}

io::Json json_of(const FittedNumber& number) {
  io::Json json{{"setting", "sim." + number.name()},
                {"estimate", nullptr},
                {"low", nullptr},
                {"high", nullptr},
                {"seen", number.estimate.episodes}};
  if (const auto& estimated = number.estimate.number) {
    json["estimate"] = estimated->value;
    json["low"] = estimated->low;
    json["high"] = estimated->high;
  }
  return json;
}

io::Json json_of(const std::vector<FittedNumber>& numbers) {
  io::Json json = io::Json::array();
  for (const FittedNumber& number : numbers) json.push_back(json_of(number));
  return json;
}

// Lines "key: value  # interval", indented below a section.
std::string yaml_lines(const std::vector<FittedNumber>& numbers, const std::string& section) {
  const DefaultSettings settings;
  const std::string indent = section.empty() ? "" : "  ";
  std::string lines;
  for (const FittedNumber& number : numbers) {
    if (number.section != section) continue;
    if (const auto& estimated = number.estimate.number) {
      lines += fmt::format("{}{}: {}   # {}; {} seen\n", indent, number.key,
                           short_text(settings.allowed(number, estimated->value)),
                           interval_text(*estimated), number.estimate.episodes);
    } else {
      lines += fmt::format("{}# {}: not enough; {} seen\n", indent, number.key,
                           number.estimate.episodes);
    }
  }
  return lines;
}

bool has_value(const std::vector<FittedNumber>& numbers, const std::string& section) {
  return std::any_of(numbers.begin(), numbers.end(), [&](const FittedNumber& number) {
    return number.section == section && number.estimate.number;
  });
}

// A section, or a comment in its place if it has no number.
std::string yaml_section(const std::vector<FittedNumber>& numbers, const std::string& section) {
  const std::string head = has_value(numbers, section) ? section : "# " + section;
  return head + ":\n" + yaml_lines(numbers, section);
}

// The numbers without those of turning that are below the defaults: teams rarely turn as fast as
// their robots can, so these would be too slow.
std::vector<FittedNumber> limiting(const std::vector<FittedNumber>& numbers) {
  const DefaultSettings settings;
  std::vector<FittedNumber> limits;
  std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(limits),
               [&](const FittedNumber& number) {
                 const auto& estimated = number.estimate.number;
                 return !number.key.starts_with("angular_") || !estimated ||
                        estimated->value > io::number_in(settings.value_of(number)).value_or(0);
               });
  return limits;
}

// The limit of the wheels, if the default would keep robots from what they reached.
std::string yaml_wheels(const std::vector<FittedNumber>& numbers) {
  const FittedNumber wheels{"robot", "wheel_acceleration_mps2", {}};
  const double limit_mps2 = io::number_in(DefaultSettings().value_of(wheels)).value_or(0);
  double reached_mps2 = 0;
  for (const FittedNumber& number : numbers) {
    if (number.key.ends_with("_mps2") && number.estimate.number)
      reached_mps2 = std::max(reached_mps2, number.estimate.number->value);
  }
  if (reached_mps2 <= limit_mps2) return "";
  return fmt::format("  {}: {}   # so that the wheels allow this\n", wheels.key,
                     short_text(reached_mps2));
}

std::string yaml_head(const std::string& kind, const std::string& about) {
  return fmt::format(
      "# Estimated by `autoref log fit`. Each number comes with its 95 % interval and the number\n"
      "# of observations behind it.\n"
      "schema: 1\nkind: {}\nabout: {}\n",
      kind, io::Json(about).dump());
}

std::string yaml_vision(const LogFit& fit) {
  std::string text = "vision:\n" + yaml_lines(fit.vision, "vision");
  text += fmt::format("  reports_height: {0}\n  robots_hide_ball: {1}\n  cameras_run_freely: {2}\n",
                      fit.reports_height, !fit.reports_height, fit.cameras_run_freely);
  const std::size_t cameras = fit.cameras.size();
  const bool is_known = cameras == 1 || cameras == 2 || cameras == 4;
  text += fmt::format("  {}cameras: {}\n", is_known ? "" : "# not simulated: ", cameras);
  if (fit.camera_height_m) {
    const FittedNumber height{"vision", "camera_height_m", {}};
    text += fmt::format("  camera_height_m: {}\n",
                        short_text(DefaultSettings().allowed(height, *fit.camera_height_m)));
  }
  return text;
}

}  // namespace

io::TextBlocks fit_text(const LogFit& fit) {
  return {
      fmt::format("{:.1f} min of vision, {:.1f} min of running play.\n", fit.length_s / 60,
                  fit.running_s / 60),
      table_of({fit.ball, fit.kicker, fit.vision}),
      "\nReached by each team's robots, so at least what they can do:\n", team_table(fit.teams),
      "\n" + cameras_text(fit) + seen_text(fit) + "\n" + prediction_text(fit) + "\n" +
          drifts_text(fit) +
          "\nA log has no commands, so it does not show the spread of kick speeds, nor delays."};
}

std::string fit_json(const LogFit& fit) {
  io::Json json{{"length_s", fit.length_s}, {"running_s", fit.running_s}};
  json["numbers"] = json_of(fit.ball);
  for (const auto* numbers : {&fit.kicker, &fit.vision, &fit.drifts}) {
    for (io::Json& number : json_of(*numbers)) json["numbers"].push_back(std::move(number));
  }
  json["teams"] = io::Json::array();
  for (const FittedTeam& team : fit.teams)
    json["teams"].push_back({{"team", team.name}, {"numbers", json_of(team.robots)}});
  json["cameras"] = io::Json::array();
  for (const auto& [number, camera] : fit.cameras) {
    json["cameras"].push_back({{"camera", number},
                               {"captures", camera.captures},
                               {"rate_hz", camera.rate_hz},
                               {"phase_s", camera.phase_s.value},
                               {"phase_deviation_s", camera.phase_s.deviation}});
  }
  json["ball_seen"] = io::Json::array();
  for (const SeenShare& share : fit.ball_seen) {
    json["ball_seen"].push_back(
        {{"distance_m", share.distance_m}, {"frames", share.frames}, {"seen", share.seen}});
  }
  json["roll_prediction"] = nullptr;
  if (const auto& roll = fit.roll_prediction) {
    json["roll_prediction"] = {{"paths", roll->paths},
                               {"travelled_m", roll->travelled_m},
                               {"fitted_m", roll->fitted_m},
                               {"default_m", roll->compared_m}};
  }
  return io::json_text(json);
}

std::string measured_yaml(const LogFit& fit, const std::string& about) {
  return yaml_head("measured", about) + yaml_section(fit.ball, "ball") +
         yaml_section(fit.ball, "contacts") + yaml_lines(fit.vision, "") + yaml_vision(fit);
}

std::string robots_yaml(const LogFit& fit, const FittedTeam& team, const std::string& about) {
  return yaml_head("robot", about) + "# What the robots reached: they may be able to do more.\n" +
         yaml_section(limiting(team.robots), "robot") + yaml_wheels(team.robots) +
         "# Of all teams in the logs.\n" + yaml_section(fit.kicker, "kicker");
}

std::string file_word(const std::string& team) {
  constexpr std::size_t kLongest = 40;
  std::string word;
  for (const char c : team) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte < 0x80 && std::isalnum(byte) != 0;
    if (is_plain) {
      word += static_cast<char>(std::tolower(byte));
    } else if (!word.empty() && word.back() != '-') {
      word += '-';
    }
  }
  word.resize(std::min(word.size(), kLongest));
  while (!word.empty() && word.back() == '-') word.pop_back();
  return word.empty() ? "team" : word;
}

}  // namespace autoref::logs
