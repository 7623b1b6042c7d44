// What a rule found: the event, the restart it leads to, and the evidence.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "referee/event.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

using ConcernedRobots = boost::container::static_vector<RobotId, 4>;

// Rules find, the machine decides: what follows depends on its state.
struct Finding {
  Event event = Event::kBegin;
  std::string_view rule;  // what it rests on, such as "paper 4.2"
  double value = 0;       // measured, in the threshold's unit
  double threshold = 0;
  std::string_view unit;  // of value and threshold; empty where nothing was measured
  ConcernedRobots robots;
  std::optional<Side> offender;    // the side at fault; none where nobody or both are
  bool is_foul = false;            // counts towards a card of the offender; of both where none is
  Card card = Card::kNone;         // shown to the offender at once, or to both
  std::optional<Vec2> position_m;  // where it happened
  Command restart;                 // what play goes on with; of stops only
  Vec2 ball_to_m{0, 0};            // and from where
  std::string evidence;            // one sentence for people
};

}  // namespace autoref::referee
