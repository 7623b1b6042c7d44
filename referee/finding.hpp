// What a rule found: the event, the restart it leads to, and the evidence.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "referee/event.hpp"
#include "referee/event_details.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// What the confidence in a call depends on (machine/confidence.hpp).
inline constexpr std::size_t kConfidenceFeatures = 5;
using ConfidenceFeatures = std::array<double, kConfidenceFeatures>;

using ConcernedRobots = boost::container::static_vector<RobotId, 4>;

// Rules report findings; the machine decides what follows, depending on its state.
struct Finding {
  Event event = Event::kBegin;
  std::string_view rule;  // the rule's source, such as "paper 4.2"
  double value = 0;       // measured, in the threshold's unit
  double threshold = 0;
  std::string_view unit;  // unit of value and threshold; empty if nothing was measured
  ConcernedRobots robots;
  std::optional<Side> offender;  // the side at fault; nullopt if neither or both are
  bool is_foul = false;          // a foul of the offender, or of both sides if there is no offender
  // The card shown at once to the offender, or to both sides if there is no offender.
  Card card = Card::kNone;
  std::optional<Vec2> position_m;  // where it happened
  Command restart;                 // how play resumes; only for calls that stop play
  Vec2 ball_to_m{0, 0};            // where the ball is placed for the restart
  std::string evidence;            // one human-readable sentence
  EventDetails details;            // for the league's game event
  // The probability, from 0 to 1, that the call is right (machine/confidence.hpp). 1 for findings
  // that are not calls.
  double confidence = 1;
  ConfidenceFeatures confidence_features{};  // what it was computed from
};

}  // namespace autoref::referee
