#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>

#include "runner/game/game_event.hpp"
#include "runner/io/json.hpp"

namespace autoref::runner {
namespace {

std::string_view team_name(Side side) { return side == Side::kWest ? "YELLOW" : "BLUE"; }

// Messages hold single-precision numbers: 0.1 rather than 0.10000000149.
double printed(double number) {
  return std::strtod(fmt::format("{}", static_cast<float>(number)).c_str(), nullptr);
}

Json value_json(Side side) { return team_name(side); }
Json value_json(int number) { return number; }
Json value_json(bool is_true) { return is_true; }
Json value_json(double number) { return printed(number); }
Json value_json(std::uint64_t number) { return std::to_string(number); }
Json value_json(const Vec2& position_m) {
  return {{"x", printed(position_m.x())}, {"y", printed(position_m.y())}};
}

// Collects the members that are set.
struct FieldPrinter {
  Json& json;

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
  Json json;
  std::string name(name_of(event.type));
  json["type"] = name.empty() ? Json(static_cast<int>(event.type)) : Json(name);
  if (!event.origin.empty()) json["origin"] = event.origin;
  if (event.created_us) json["created_timestamp"] = value_json(*event.created_us);
  if (!event.id.empty()) json["id"] = event.id;
  if (name.empty()) return json_text(json);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Json& part = json[name] = Json::object();
  if (has_team(event.type)) part["by_team"] = "UNKNOWN";
  visit_fields(event, FieldPrinter{part});
  return json_text(json);
}

}  // namespace autoref::runner
