// What a rule found: the event, the restart it leads to, and the evidence.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "referee/decision.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::referee {

// Rules find, the machine decides: what follows depends on its state.
struct Finding {
  Event event = Event::kBegin;
  std::string_view rule;  // what it rests on, such as "paper 4.2"
  double value = 0;       // measured, in the threshold's unit
  double threshold = 0;
  std::string_view unit;
  ConcernedRobots robots;
  std::optional<Vec2> position_m;  // where it happened
  Command restart;                 // what play goes on with; of stops only
  Vec2 ball_to_m{0, 0};            // and from where
  std::string evidence;            // one sentence for people
};

}  // namespace autoref::referee
