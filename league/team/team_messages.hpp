// The messages between the simulator and a team that runs as a program of its own. The program
// receives one TeamStart, then one TeamFrame per camera frame, and finally a TeamEnd. It answers
// each TeamFrame with one TeamOutput. docs/team-programs.md describes the encodings.
#pragma once

#include <bitset>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"
#include "soccer/team_view.hpp"

namespace autoref::league {

inline constexpr std::size_t kLongestOutput = 65536;     // bytes of an encoded TeamOutput
inline constexpr std::size_t kLongestOutputText = 1000;  // bytes
inline constexpr std::size_t kLongestName = 55;          // bytes of a parameter's name

// The information that a team gets before the game. All coordinates in these messages are the
// team's own: its goal is at -x, whichever side it plays on.
struct TeamStart {
  Side side = Side::kWest;  // the colour: west is yellow
  Field field;
  RuleBook rules;  // the rules in force in the match; values as in TeamContext::rules
  RuleSet obeyed;  // the rules in force and those of the team's laws
  double frame_rate_hz = 60;
  double latency_s = 0;           // delay from a frame until a command sent in reply moves a robot
  std::uint64_t random_seed = 0;  // RandomStream(random_seed) is the team's stream
  std::map<std::string, double> params;
  boost::container::static_vector<Abilities, kMaxRobots> robots;  // the team's own, by number
};

// A team's view of one camera frame. If there are detections, they replace the robots and the ball
// in `view`, and list the team's own robots as west's.
struct TeamFrame {
  TeamView view;
  std::optional<Frame> detections;
  std::bitset<kMaxRobots> ball_in_dribbler_zone;  // the team's own robots' sensors, by number
};

struct TeamEnd {
  std::string reason;  // for example "time"; at most kLongestName bytes are sent
  int goals_own = 0;
  int goals_opponent = 0;
};

// A team's answer to a frame. A robot without a command stands still.
struct TeamOutput {
  std::int64_t frame = 0;  // number of the frame that this output answers
  TeamCommands commands;
  TeamRequests requests;
  std::string text;  // for the log; any bytes, at most kLongestOutputText
};

// Calls `visit` with the name and value of every value in the rule book, in a fixed order, for
// programs that do not know this project's rules. Names are RuleBook's members; a bool is 1 or 0.
// Then come "edition" (0 for the paper, 1 for the Laws of 2014, 2 for the rules of 2026) and, for
// each rule, "in_force." followed by the rule's name, which is 1 or 0.
void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit);

// Visits the values in a START. First come those of the rule book. Then come those that its field
// record cannot hold: "field.goal_line_run_off_m", the distance from the goal lines to the wall,
// and "field.goal_sides_reach_wall", which is 1 or 0. The last, for each rule, is "obeyed."
// followed by the rule's name, which is 1 or 0.
void visit_start_numbers(const TeamStart& start,
                         const std::function<void(std::string_view name, double value)>& visit);

}  // namespace autoref::league
