// A decision of the referee, as shown on a page.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "soccer/geometry.hpp"

namespace autoref::view {

// Texts are those of the event log; a null there becomes an empty text.
struct RecordedDecision {
  double time_s = 0;
  std::string event;
  std::string rule;
  std::string reason;    // a sentence
  std::string offender;  // a colour
  std::string card;
  std::string card_reason;
  std::string restart;
  std::optional<Vec2> position_m;  // published (soccer/published.hpp)
  bool operator==(const RecordedDecision&) const = default;
};

// Whether pages show such an event. They omit routine events, such as robots being ready for a
// restart.
bool is_shown(const std::string& event);

// What a page shows of a line of an event log. Throws Json::exception if it is not a decision.
RecordedDecision recorded(const io::Json& line);

// The decisions of an event log, as written by `autoref play --events`: `lines`, one JSON object
// per line. Throws InputError with `file` and the line's number if a line is not a decision.
std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file);

// The decision as the page's script reads it (view/page/highlights.js).
io::Json page_json(const RecordedDecision& decision);

}  // namespace autoref::view
