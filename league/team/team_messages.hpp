// The messages between the simulator and a team that runs as a program of its own. The program
// receives one TeamStart, then one TeamFrame per camera frame, which it answers with one
// TeamOutput, and finally a TeamEnd. docs/team-programs.md describes the encodings.
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

// The information that a team gets before the game. All coordinates of these messages are the
// team's own: its goal is at -x, whichever side it plays on.
struct TeamStart {
  Side side = Side::kWest;  // the colour: west is yellow
  Field field;
  RuleBook rules;  // the rules in force in the match; numbers as in TeamContext::rules
  RuleSet obeyed;  // the rules in force and those of the team's laws
  double frame_rate_hz = 60;
  double latency_s = 0;           // from a frame until a command sent in reply moves a robot
  std::uint64_t random_seed = 0;  // RandomStream(random_seed) is the team's stream
  std::map<std::string, double> params;
  boost::container::static_vector<Abilities, kMaxRobots> robots;  // the team's own, by number
};

// A team's view of one camera frame. If there are detections, they replace the robots and the ball
// of `view`; the team's own robots are then west's.
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
  std::int64_t frame = 0;  // the number of the frame that it answers
  TeamCommands commands;
  TeamRequests requests;
  std::string text;  // for the log; any bytes, at most kLongestOutputText
};

// Calls `visit` with the name and value of every number of the rule book, in a fixed order, for
// programs that do not know this project's rules. Names are RuleBook's members; a bool is 1 or 0.
// After these follow "edition" (0 for the paper, 1 for the Laws of 2014, 2 for the rules of 2026)
// and, for each rule, "in_force." followed by its name, which is 1 or 0.
void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit);

// The numbers in a START: first those of the rule book, then those for which its field record has
// no room: "field.goal_line_run_off_m", from the goal lines to the wall, and
// "field.goal_sides_reach_wall", 1 or 0. Last, for each rule, "obeyed." followed by its name, which
// is 1 or 0.
void visit_start_numbers(const TeamStart& start,
                         const std::function<void(std::string_view name, double value)>& visit);

}  // namespace autoref::league
