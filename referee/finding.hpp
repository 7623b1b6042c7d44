// What a rule found: the event, the restart it leads to, and the evidence.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "referee/configuration.hpp"
#include "referee/decision.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::referee {

// Rules find, the machine decides: what follows depends on its state.
struct Finding {
  Event event = Event::kBegin;
  std::string_view rule;  // what it rests on, such as "paper 4.2"
  double value = 0;       // measured, in the threshold's unit
  double threshold = 0;
  std::string_view unit;
  ConcernedRobots robots;
  std::optional<Side> offender;    // the side at fault; none where nobody or both are
  bool is_foul = false;            // counts towards a card of the offender; of both where none is
  Card card = Card::kNone;         // shown to the offender at once, or to both
  std::optional<Vec2> position_m;  // where it happened
  Command restart;                 // what play goes on with; of stops only
  Vec2 ball_to_m{0, 0};            // and from where
  std::string evidence;            // one sentence for people
};

// The event, with what the rule table says of the rule: section, threshold and unit.
Finding finding_of(Event event, RuleId rule, const RuleBook& rules);

// An offence of `robot` at `where_m`, with a free kick from there for its opponents: an indirect
// one, or where all kicks may score (`RuleBook::kicks_may_score`) a direct one.
Finding offence_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                   const Vec2& where_m);

// The same where it is not known which robot of the `offender` it was.
Finding offence_of(Event event, RuleId rule, const Configuration& configuration, Side offender,
                   const Vec2& where_m);

// An offence of `robot` at `where_m` that is noted only; where the book counts fouls, it counts.
Finding note_of(Event event, RuleId rule, const RuleBook& rules, RobotId robot,
                const Vec2& where_m);

// A foul of `robot`, which is at `robot_m`, against an opponent at `where_m`, with a direct free
// kick from there; by the Laws of 2014, inside the offender's own defence area, with a penalty
// kick.
Finding contact_foul_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                        const Vec2& robot_m, const Vec2& where_m);

// DIRECT_FREE or, where the book has them, INDIRECT_FREE for `kicker`.
Command indirect_free_kick(const RuleBook& rules, Side kicker);

// "west 3".
std::string text_of(RobotId robot);

}  // namespace autoref::referee
