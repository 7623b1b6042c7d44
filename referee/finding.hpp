// A rule's finding: the event, the restart it leads to, and the evidence. Also declares the
// functions that create findings.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "referee/event.hpp"
#include "referee/referee_configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Details that the league's game event needs beyond the other members of the finding. Unknown
// values are not set. Positions are in the referee's coordinates.
struct EventDetails {
  // The robot at fault, if it is not the first robot that the finding names.
  std::optional<RobotId> robot;
  std::optional<Vec2> robot_m;  // position of the robot at fault
  std::optional<Vec2> ball_m;
  std::optional<Vec2> kick_m;          // for a goal: where the ball was kicked
  std::optional<Vec2> dribble_from_m;  // where the ball was when the dribbling robot gained it
  // Greatest height of the ball's top since the scoring team's last touch.
  std::optional<double> ball_top_m;
  std::optional<double> scorers_touched_s;  // time of the scoring team's last touch
  std::optional<bool> is_chipped;           // for a kick: whether it was a chip kick
  std::optional<int> robots;                // number of robots of the side concerned on the field
  std::optional<int> robots_allowed;        // number of robots that this side may have there
  // Difference between the speeds of the colliding robots.
  std::optional<double> speed_difference_mps;
  // Angle between the velocities of the colliding robots, at most pi.
  std::optional<double> crash_angle_rad;
  std::optional<double> waited_s;             // how long play has made no progress
  std::optional<double> to_target_m;          // distance from the ball to its designated position
  std::optional<double> from_target_m;        // that distance when the placement began
  std::optional<double> own_robot_to_ball_m;  // gap from ball to the placing team's nearest robot
};

// The features on which the confidence in a call depends (machine/confidence.hpp).
inline constexpr std::size_t kConfidenceFeatures = 5;
using ConfidenceFeatures = std::array<double, kConfidenceFeatures>;

using ConcernedRobots = boost::container::static_vector<RobotId, 4>;

// Rules report findings; the machine decides what to do about them, depending on its state.
struct Finding {
  Event event = Event::kBegin;
  std::string_view rule;  // the rule's source, such as "paper 4.2"
  double value = 0;       // measured value, in the threshold's unit
  double threshold = 0;
  std::string_view unit;  // unit of value and threshold; empty if nothing was measured
  ConcernedRobots robots;
  std::optional<Side> offender;  // the side at fault; nullopt if neither or both are
  bool is_foul = false;          // a foul by the offender, or by both sides if there is no offender
  // The card shown immediately to the offender, or to both sides if there is no offender.
  Card card = Card::kNone;
  std::optional<Vec2> position_m;  // where the event happened
  Command restart;                 // how play resumes; only for calls that stop play
  Vec2 ball_to_m{0, 0};            // where the ball is placed for the restart
  std::string evidence;            // one human-readable sentence
  EventDetails details;            // for the league's game event
  // The probability, from 0 to 1, that the call is right (machine/confidence.hpp). It is 1 for
  // findings that are not calls.
  double confidence = 1;
  ConfidenceFeatures confidence_features{};  // the features from which `confidence` was computed
};

// A finding with the event's fixed card and restart (event.hpp) and the rule's section, threshold
// and unit (soccer/rules/rule_book.hpp).
Finding finding_of(Event event, RuleId rule, const RuleBook& rules);

// An offence by `robot` at `where_m`. If the event has no fixed restart, the opponents get a free
// kick from there: direct if all kicks may score (`RuleBook::kicks_may_score`), otherwise indirect.
Finding offence_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                   const Vec2& where_m);

// The same for an offence by an unknown robot on the side `offender`.
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

// "yellow 3". Texts name sides by colour (soccer/side.hpp).
std::string text_of(RobotId robot);

// "367 mm"; "0 mm" if noise makes the distance between two touching bodies negative.
std::string mm_text(double distance_m);

// "83 mm from", or "302 mm inside" if the signed distance to the defence area is negative.
std::string gap_text(double signed_distance_m);

// "1st", "2nd", "3rd", "4th" ... "11th".
std::string ordinal(int number);

}  // namespace autoref::referee
