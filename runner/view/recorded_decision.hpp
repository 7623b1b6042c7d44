// A decision of the referee, as shown on a page.
#pragma once

#include <optional>
#include <string>

#include "referee/decision.hpp"
#include "soccer/geometry.hpp"

namespace autoref::runner {

// Texts are those of the event log (event_log.hpp); a null there becomes an empty text.
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

RecordedDecision recorded(const referee::Decision& decision);

}  // namespace autoref::runner
