#include "referee/machine/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "soccer/exponential.hpp"
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

// Calls without a row have not been seen often enough to be fitted.
constexpr ConfidenceCoefficients kOfOtherCalls = {2.2, 0, 0, 0, 0};

double margin_of(const Finding& finding) {
  const double scale = std::abs(finding.value) + std::abs(finding.threshold);
  if (finding.unit.empty() || !(scale > 0)) return 0;
  return std::min(1.0, std::abs(finding.value - finding.threshold) / scale);
}

// The time of the newest touch by that side.
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

}  // namespace autoref::referee
