#include "runner/view/decision_lines.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"

namespace autoref::runner {
namespace {

// Returns the text under this key, or an empty string if there is none.
std::string text_at(const Json& decision, const char* key) {
  const auto found = decision.find(key);
  return found != decision.end() && found->is_string() ? found->get<std::string>() : "";
}

// Returns the position under this key, or nullopt if there is none. Throws Json::exception if a
// coordinate is not a number.
std::optional<Vec2> position_at(const Json& decision, const char* key) {
  const auto found = decision.find(key);
  if (found == decision.end() || !found->is_array() || found->size() != 2) return std::nullopt;
  return Vec2((*found)[0].get<double>(), (*found)[1].get<double>());
}

// Throws Json::exception if the line is not a decision.
RecordedDecision decision_in(const std::string& line) {
  const Json json = Json::parse(line);
  return {json.at("time_s").get<double>(), json.at("event").get<std::string>(),
          text_at(json, "rule"),           text_at(json, "evidence"),
          text_at(json, "offender"),       text_at(json, "card"),
          text_at(json, "card_reason"),    text_at(json, "restart"),
          position_at(json, "position_m")};
}

}  // namespace

std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file) {
  std::vector<RecordedDecision> decisions;
  for (int number = 1; !lines.empty(); ++number) {
    const std::string line(lines.substr(0, lines.find('\n')));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    if (line.empty()) continue;
    try {
      decisions.push_back(decision_in(line));
    } catch (const Json::exception&) {
      throw InputError({file, number, 1}, "",
                       "this is not a referee's decision as written by `autoref play --events`");
    }
  }
  return decisions;
}

}  // namespace autoref::runner
