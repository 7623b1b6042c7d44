// What a page shows of one of the referee's decisions.
#pragma once

#include <optional>
#include <string>

#include "referee/decision.hpp"
#include "soccer/geometry.hpp"

namespace autoref::runner {

// Texts are words of the event log (event_log.hpp), empty where it has null.
struct RecordedDecision {
  double time_s = 0;
  std::string event;
  std::string rule;
  std::string reason;    // a sentence
  std::string offender;  // a colour
  std::string card;
  std::string card_reason;
  std::string restart;
  std::optional<Vec2> position_m;
  bool operator==(const RecordedDecision&) const = default;
};

// Whether pages show such an event. They leave out what every game goes through, such as robots
// that are ready for a restart.
bool is_shown(const std::string& event);

RecordedDecision recorded(const referee::Decision& decision);

}  // namespace autoref::runner
