#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>

#include "game/loop/game_event.hpp"
#include "io/json.hpp"

namespace autoref::game {
namespace {

std::string_view team_name(Side side) { return side == Side::kWest ? "YELLOW" : "BLUE"; }

// Messages hold single-precision numbers: 0.1 rather than 0.10000000149.
double printed(double number) {
  return std::strtod(fmt::format("{}", static_cast<float>(number)).c_str(), nullptr);
}

io::Json value_json(Side side) { return team_name(side); }
io::Json value_json(int number) { return number; }
io::Json value_json(bool is_true) { return is_true; }
io::Json value_json(double number) { return printed(number); }
io::Json value_json(std::uint64_t number) { return std::to_string(number); }
io::Json value_json(const Vec2& position_m) {
  return {{"x", printed(position_m.x())}, {"y", printed(position_m.y())}};
}

// Collects the members that are set.
struct FieldPrinter {
  io::Json& json;

  template <typename T>
  void operator()(const char* name, const std::optional<T>& value) const {
    if (value) json[name] = value_json(*value);
  }
  void operator()(const char* name, const std::string& text) const {
    if (!text.empty()) json[name] = text;
  }
};

bool has_team(GameEventType type) {
  return type != GameEventType::kNoProgressInGame && type != GameEventType::kBotCrashDrawn &&
         type != GameEventType::kPrepared;
}

}  // namespace

std::string game_event_json(const GameEvent& event) {
  io::Json json;
  std::string name(name_of(event.type));
  json["type"] = name.empty() ? io::Json(static_cast<int>(event.type)) : io::Json(name);
  if (!event.origin.empty()) json["origin"] = event.origin;
  if (event.created_us) json["created_timestamp"] = value_json(*event.created_us);
  if (!event.id.empty()) json["id"] = event.id;
  if (name.empty()) return io::json_text(json);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  io::Json& part = json[name] = io::Json::object();
  if (has_team(event.type)) part["by_team"] = "UNKNOWN";
  visit_fields(event, FieldPrinter{part});
  return io::json_text(json);
}

}  // namespace autoref::game
