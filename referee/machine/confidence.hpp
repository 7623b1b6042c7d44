// How sure the referee is of a call, estimated by a logistic model from what vision shows.
// scripts/fit-confidence fitted the coefficients (confidence.def) to calls in simulated games, each
// call judged by ground truth. results/reference/judge shows how well they hold in other games.
//
// Also turns a step of the machine and its call into a row of the event log.
#pragma once

#include <array>

#include "referee/decision.hpp"
#include "referee/event.hpp"
#include "referee/finding.hpp"
#include "referee/machine/machine.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

using ConfidenceCoefficients = std::array<double, kConfidenceFeatures>;

// The features, in this order, each from 0 to 1:
// - always 1;
// - vision noise: the combined standard deviation of ball and robots, scaled to reach 1 at 20 mm
//   and above;
// - margin: |value - threshold| / (|value| + |threshold|) of the measured quantity; 0 if nothing
//   was measured;
// - contest: exp(-t / 0.1 s), where t is the time between the last touches of the two sides; 0 if
//   only one has touched the ball;
// - rival: 1 if the next best candidate for the last touch is of the other side.
ConfidenceFeatures confidence_features(const Finding& finding, const RefereeState& state,
                                       const RefereeInput& input);

// The probability, from 0 to 1, that a call with these features is right.
double confidence_by(const ConfidenceCoefficients& coefficients,
                     const ConfidenceFeatures& features);

// Sets the finding's confidence and the features from which it was computed. If the last touch
// decides the call, the confidence is multiplied by the probability that no later touch of the
// other side is hidden in a gap in vision. Findings that are not calls keep a confidence of 1.
void add_confidence(Finding& finding, const RefereeState& state, const RefereeInput& input);

// The decision that `finding` led to in the state `before`, including the state of the game and the
// card shown.
Decision decision_of(const RefereeState& before, const RefereeInput& input, const Finding& finding,
                     const Step& taken);

}  // namespace autoref::referee
