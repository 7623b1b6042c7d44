#include "runner/view/recorded_decision.hpp"

#include <algorithm>
#include <array>

#include "soccer/colour.hpp"
#include "soccer/published.hpp"

namespace autoref::runner {

using referee::Event;

bool is_shown(const std::string& event) {
  constexpr std::array kInEveryGame = {
      Event::kBegin,        Event::kRobotsMoved, Event::kStartTimeout, Event::kReady,
      Event::kReadyTimeout, Event::kSignalled,   Event::kCommandGiven};
  return std::none_of(kInEveryGame.begin(), kInEveryGame.end(),
                      [&](Event one) { return name_of(one) == event; });
}

RecordedDecision recorded(const referee::Decision& decision) {
  const referee::Finding& finding = decision.finding;
  RecordedDecision record;
  record.time_s = decision.time_s;
  record.event = name_of(finding.event);
  record.rule = finding.rule;
  record.reason = finding.evidence;
  if (finding.offender) record.offender = colour_of(*finding.offender);
  if (finding.card != referee::Card::kNone) record.card = name_of(finding.card);
  record.card_reason = decision.card_reason;
  if (const auto restart = decision.restart()) record.restart = name_of(*restart);
  if (finding.position_m)
    record.position_m = published(*finding.position_m, decision.blue_on_positive_half);
  return record;
}

}  // namespace autoref::runner
