#include "referee/machine/confidence.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>

#include "referee/machine/cards.hpp"
#include "referee/machine/guards.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kMostNoise_m = 20_mm;
constexpr double kContest_s = 0.1_s;

struct EventCoefficients {
  Event event;
  ConfidenceCoefficients values;
};

#define AUTOREF_CONFIDENCE(event, ...) EventCoefficients{Event::event, {__VA_ARGS__}},
constexpr std::array kFitted = {
#include "referee/machine/confidence.def"
};
#undef AUTOREF_CONFIDENCE

// Calls without a row have not been seen often enough for a fit.
constexpr ConfidenceCoefficients kOfOtherCalls = {2.2, 0, 0, 0, 0};

double margin_of(const Finding& finding) {
  const double scale = std::abs(finding.value) + std::abs(finding.threshold);
  if (finding.unit.empty() || !(scale > 0)) return 0;
  return std::min(1.0, std::abs(finding.value - finding.threshold) / scale);
}

// The time of the newest touch by this side.
std::optional<double> last_touch_s(const TouchHistory& touches, Side side) {
  for (int back = 0; touches.has(back); ++back) {
    if (touches.at(back).side == side) return touches.at(back).ended_s;
  }
  return std::nullopt;
}

double contest_of(const TouchHistory& touches) {
  const std::optional<double> west_s = last_touch_s(touches, Side::kWest);
  const std::optional<double> east_s = last_touch_s(touches, Side::kEast);
  return west_s && east_s ? exponential(-std::abs(*west_s - *east_s) / kContest_s) : 0;
}

// The card actually shown, which may differ from the one in the finding.
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

// Adds the positions of the ball and of the robot at fault.
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

ConfidenceFeatures confidence_features(const Finding& finding, const RefereeState& state,
                                       const RefereeInput& input) {
  const tracking::VisionNoise& noise = input.configuration.noise;
  const LastTouch& touch = input.last_touch;
  const bool has_rival = touch.runner_up && touch.side && touch.runner_up->side != *touch.side;
  return {1, std::min(1.0, std::hypot(noise.ball_m, noise.robot_m) / kMostNoise_m),
          margin_of(finding), contest_of(state.play.touches), has_rival ? 1.0 : 0.0};
}

double confidence_by(const ConfidenceCoefficients& coefficients,
                     const ConfidenceFeatures& features) {
  double logit = 0;
  for (std::size_t i = 0; i < features.size(); ++i) logit += coefficients[i] * features[i];
  return 1 / (1 + exponential(-logit));
}

void add_confidence(Finding& finding, const RefereeState& state, const RefereeInput& input) {
  if (!is_call(finding.event)) return;
  const auto* row = std::find_if(
      kFitted.begin(), kFitted.end(),
      [&finding](const EventCoefficients& fitted) { return fitted.event == finding.event; });
  const ConfidenceCoefficients& coefficients = row == kFitted.end() ? kOfOtherCalls : row->values;
  finding.confidence_features = confidence_features(finding, state, input);
  finding.confidence = confidence_by(coefficients, finding.confidence_features);
  const bool is_by_last_touch =
      entry_of(finding.event).is_exit || finding.event == Event::kAimlessKick;
  if (is_by_last_touch) finding.confidence *= input.last_touch.kept;
}

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
