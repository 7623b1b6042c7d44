// Findings as rules make them.
#pragma once

#include <string>

#include "referee/configuration.hpp"
#include "referee/finding.hpp"
#include "soccer/colour.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::referee {

// The event, with what is the same whenever it occurs: its card and restart (event.hpp), and the
// rule's section, threshold and unit (soccer/rule_table.hpp).
Finding finding_of(Event event, RuleId rule, const RuleBook& rules);

// An offence of `robot` at `where_m`, with a free kick from there for its opponents: an indirect
// one, or where all kicks may score (`RuleBook::kicks_may_score`) a direct one; or with the restart
// that always follows the event.
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

// "yellow 3": texts name sides by their colours (soccer/colour.hpp).
std::string text_of(RobotId robot);

// "367 mm"; 0 where noise makes the distance of two bodies that touch negative.
std::string mm_text(double distance_m);

// "83 mm from" or, where the signed distance from an area is negative, "302 mm inside".
std::string gap_text(double signed_distance_m);

}  // namespace autoref::referee
