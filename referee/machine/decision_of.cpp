#include "referee/machine/decision_of.hpp"

#include <cctype>
#include <string>

#include "referee/machine/cards.hpp"
#include "referee/machine/timekeeping.hpp"
#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

// The card actually shown, which may differ from the finding's.
Card card_shown(const RefereeSignal& before, const RefereeSignal& after) {
  for (const Side side : kSides) {
    if (after.red_cards[side] > before.red_cards[side]) return Card::kRed;
    if (after.yellow_cards[side] > before.yellow_cards[side]) return Card::kYellow;
  }
  return Card::kNone;
}

std::optional<ShootoutKick> kick_between(const ShootoutBook& before, const ShootoutBook& after) {
  for (const Side side : kSides) {
    if (after.kicks[side] <= before.kicks[side]) continue;
    return ShootoutKick{side, after.kicks[side], after.goals[side] > before.goals[side]};
  }
  return std::nullopt;
}

// Capitalises the first letter; the text may begin with a colour such as "yellow".
std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

// The ball's position, and that of the robot at fault.
void add_positions(EventDetails& details, const Finding& finding, const RefereeInput& input) {
  if (!details.ball_m && input.ball) details.ball_m = input.ball->position_m;
  if (details.robot_m || (!details.robot && finding.robots.empty())) return;
  const RobotId id = details.robot ? *details.robot : finding.robots.front();
  const RobotObservation* robot = find_robot(input.frame.robots[id.side], id.number);
  if (robot != nullptr) details.robot_m = robot->position_m;
}

void add_standing(Decision& decision, const RefereeState& before, const RefereeInput& input,
                  const RefereeState& after) {
  decision.stage = before.signal.stage;
  decision.clock = half_clock(before, input.configuration, input.time_s());
  decision.goals = after.signal.goals;
  decision.shootout_goals = after.signal.shootout_goals;
  decision.blue_on_positive_half = after.signal.blue_on_positive_half;
  decision.shootout_kick = kick_between(before.shootout, after.shootout);
}

}  // namespace

Decision decision_of(const RefereeState& before, const RefereeInput& input, const Finding& finding,
                     const Step& taken) {
  Decision decision;
  decision.frame = input.frame.number;
  decision.time_s = input.time_s();
  decision.transition = taken.label;
  decision.from = before.machine_state;
  decision.to = taken.state.machine_state;
  decision.command = taken.sent;
  decision.finding = finding;
  decision.finding.evidence = sentence(finding.evidence);
  add_positions(decision.finding.details, finding, input);
  decision.last_touch = input.last_touch;
  add_standing(decision, before, input, taken.state);
  const Card card = card_shown(before.signal, taken.state.signal);
  decision.finding.card = card;
  if (card != Card::kNone) {
    decision.card_reason = card_reason(before.cards, finding, card, input.configuration.rules);
  }
  return decision;
}

}  // namespace autoref::referee
