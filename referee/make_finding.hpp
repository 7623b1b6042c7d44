// Functions that the rules use to create their findings.
#pragma once

#include <string>

#include "referee/configuration.hpp"
#include "referee/finding.hpp"
#include "soccer/colour.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::referee {

// A finding with the event's fixed card and restart (event.hpp) and the rule's section, threshold
// and unit (soccer/rule_table.hpp).
Finding finding_of(Event event, RuleId rule, const RuleBook& rules);

// An offence by `robot` at `where_m`. If the event has no fixed restart, the opponents get a free
// kick from there: direct if all kicks may score (`RuleBook::kicks_may_score`), otherwise indirect.
Finding offence_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                   const Vec2& where_m);

// The same for an unknown robot of the side `offender`.
Finding offence_of(Event event, RuleId rule, const Configuration& configuration, Side offender,
                   const Vec2& where_m);

// An offence by `robot` at `where_m` that only counts towards a card, and only if the rule book
// counts fouls.
Finding note_of(Event event, RuleId rule, const RuleBook& rules, RobotId robot,
                const Vec2& where_m);

// A foul by `robot`, located at `robot_m`, against an opponent at `where_m`. The opponents get a
// direct free kick from there, or, under the Laws of 2014, a penalty kick if it happened inside the
// offender's own defence area.
Finding contact_foul_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                        const Vec2& robot_m, const Vec2& where_m);

// INDIRECT_FREE for `kicker` if the rule book has indirect free kicks, otherwise DIRECT_FREE.
Command indirect_free_kick(const RuleBook& rules, Side kicker);

// "yellow 3". Texts name sides by colour (soccer/colour.hpp).
std::string text_of(RobotId robot);

// "367 mm"; "0 mm" if noise makes the distance between two touching bodies negative.
std::string mm_text(double distance_m);

// "83 mm from", or "302 mm inside" if the signed distance to the area is negative.
std::string gap_text(double signed_distance_m);

}  // namespace autoref::referee
