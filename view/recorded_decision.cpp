#include "view/recorded_decision.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "io/errors.hpp"
#include "referee/event.hpp"

namespace autoref::view {
namespace {

using referee::Event;

struct ShownText {
  const char* name;  // on the page
  const char* key;   // in the event log
  std::string RecordedDecision::*text;
};

// What a page shows besides time, event and position.
constexpr ShownText kShownTexts[] = {
    {"rule", "rule", &RecordedDecision::rule},
    {"reason", "evidence", &RecordedDecision::reason},
    {"offender", "offender", &RecordedDecision::offender},
    {"card", "card", &RecordedDecision::card},
    {"card_reason", "card_reason", &RecordedDecision::card_reason},
    {"restart", "restart", &RecordedDecision::restart},
};

// Returns the text under this key, or an empty string if there is none.
std::string text_at(const io::Json& line, const char* key) {
  const auto found = line.find(key);
  return found != line.end() && found->is_string() ? found->get<std::string>() : "";
}

// Throws Json::exception if a coordinate is not a number.
std::optional<Vec2> position_in(const io::Json& line) {
  const auto found = line.find("position_m");
  if (found == line.end() || !found->is_array() || found->size() != 2) return std::nullopt;
  return Vec2((*found)[0].get<double>(), (*found)[1].get<double>());
}

}  // namespace

bool is_shown(const std::string& event) {
  constexpr std::array kInEveryGame = {
      Event::kBegin,        Event::kRobotsMoved, Event::kStartTimeout, Event::kReady,
      Event::kReadyTimeout, Event::kSignalled,   Event::kCommandGiven};
  return std::none_of(kInEveryGame.begin(), kInEveryGame.end(),
                      [&](Event one) { return name_of(one) == event; });
}

RecordedDecision recorded(const io::Json& line) {
  RecordedDecision decision;
  decision.time_s = line.at("time_s").get<double>();
  decision.event = line.at("event").get<std::string>();
  for (const ShownText& shown : kShownTexts) decision.*shown.text = text_at(line, shown.key);
  decision.position_m = position_in(line);
  return decision;
}

std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file) {
  std::vector<RecordedDecision> decisions;
  for (int number = 1; !lines.empty(); ++number) {
    const std::string line(lines.substr(0, lines.find('\n')));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    if (line.empty()) continue;
    try {
      decisions.push_back(recorded(io::Json::parse(line)));
    } catch (const io::Json::exception&) {
      throw io::InputError(
          {file, number, 1}, "",
          "this is not a referee's decision as written by `autoref play --events`");
    }
  }
  return decisions;
}

io::Json page_json(const RecordedDecision& decision) {
  io::Json json = {{"time_s", decision.time_s}, {"event", decision.event}};
  for (const ShownText& shown : kShownTexts) {
    const std::string& text = decision.*shown.text;
    json[shown.name] = text.empty() ? io::Json() : io::Json(text);
  }
  const std::optional<Vec2>& at_m = decision.position_m;
  json["position_m"] = at_m ? io::Json::array({at_m->x(), at_m->y()}) : io::Json();
  return json;
}

}  // namespace autoref::view
