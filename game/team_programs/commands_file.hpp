// A file with the commands of a game's programs, from which the game can be replayed without them.
//
// A gzip file with a header line, `autoref-commands 1`, and then entries in the order in which they
// took effect. An entry begins with a byte:
//   bits 0-1  0 a change of the world before the teams' next entries, 1 an entry of team a, 2 an
//             entry of team b, 3 the end: 8 bytes with the game's final state follow
//   bit 2     requests follow: keeper and robot that leaves (int8, -1: none), timeout (uint8); of
//             the end: the game was interrupted here
//   bit 3     a fault follows: its length (uint16) and text; the team's last entry
// Unless there is a fault, a uint16 follows: bit n is set if robot n's command differs from its
// previous one, which is initially all zero. Each of these robots then has a byte:
//   bits 0-3  forward, left, angular velocity, kick follow as floats; the others are as before
//   bit 4     chip
//   bit 5     dribble
// In a change of the world, bits 2-3 are 0 for the ball, 1 for a robot that is placed, 2 for one
// that is taken off the field. For a robot, its side (uint8, 0 west) and number (uint8) follow.
// Unless a robot is taken off, these doubles come next: position and velocity, then, for the ball,
// height, vertical speed and 1 if it rolls or 0, or, for a robot, heading (x, y) and angular
// velocity. The first entries may have bits 2-3 equal to 3: they contain the side and number of a
// robot and its limits as doubles, in the order of ChangedRobot. All numbers are little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "game/team_programs/world_change.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::game {

// The file's information about a team in one step.
struct TeamEntry {
  TeamCommands commands{};  // commands as transmitted() returns them
  TeamRequests requests;
  std::string fault;  // empty unless the team failed; at most 4000 bytes are kept
};

// Whether both are equal in the file; entries, regardless of faults.
bool is_same(const RobotCommand& a, const RobotCommand& b);
bool is_same(const TeamRequests& a, const TeamRequests& b);
bool is_same(const TeamEntry& a, const TeamEntry& b);

// The numbers of the format above, for its writer and its reader.
struct CommandsFormat {
  static constexpr std::string_view kHeader = "autoref-commands 1\n";
  static constexpr std::size_t kLongestFault = 4000;

  static constexpr unsigned kTeamBits = 3;
  static constexpr unsigned kChange = 0;  // bits 0-1; the kinds in bits 2-3
  static constexpr unsigned kEnd = 3;
  static constexpr unsigned kChangeShift = 2;
  static constexpr unsigned kBall = 0;
  static constexpr unsigned kPlaced = 1;
  static constexpr unsigned kRemoved = 2;
  static constexpr unsigned kChangedRobot = kChange | 3U << kChangeShift;  // the first byte
  static constexpr unsigned kHasRequests = 4;
  static constexpr unsigned kIsInterrupted = 4;  // of the end
  static constexpr unsigned kHasFault = 8;
  static constexpr unsigned kHasChip = 16;
  static constexpr unsigned kHasDribble = 32;

  // The index of an entry of team 'a' or 'b'; its bits 0-1 are one more.
  static constexpr std::size_t index_of(char team) { return team == 'a' ? 0 : 1; }
  // A command's numbers and a robot's limits in the file's order.
  static std::array<float, 4> numbers_of(const RobotCommand& command);
  static std::array<double*, 9> limits_of(ChangedRobot& robot);
};

}  // namespace autoref::game
