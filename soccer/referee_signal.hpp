// The referee's broadcasts: the league's referee commands and stages, in the program's coordinates
// and as published.
//
// The enumerators have the numbers used in the league's SSL_Referee message (2013), so logs need no
// translation table.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/side.hpp"

namespace autoref {

enum class CommandKind : std::uint8_t {
  kHalt,
  kStop,
  kNormalStart,
  kForceStart,
  kPrepareKickoff,
  kPreparePenalty,
  kDirectFree,
  kIndirectFree,
  kTimeout,
  kGoal,
  kBallPlacement,
};

// The league's names, without the side.
constexpr auto names_of(CommandKind /*any*/) {
  return std::to_array<Named<CommandKind>>({{CommandKind::kHalt, "HALT"},
                                            {CommandKind::kStop, "STOP"},
                                            {CommandKind::kNormalStart, "NORMAL_START"},
                                            {CommandKind::kForceStart, "FORCE_START"},
                                            {CommandKind::kPrepareKickoff, "PREPARE_KICKOFF"},
                                            {CommandKind::kPreparePenalty, "PREPARE_PENALTY"},
                                            {CommandKind::kDirectFree, "DIRECT_FREE"},
                                            {CommandKind::kIndirectFree, "INDIRECT_FREE"},
                                            {CommandKind::kTimeout, "TIMEOUT"},
                                            {CommandKind::kGoal, "GOAL"},
                                            {CommandKind::kBallPlacement, "BALL_PLACEMENT"}});
}

// A command; `side` is not used by the first four kinds, for which it is set to west.
struct Command {
  CommandKind kind = CommandKind::kHalt;
  Side side = Side::kWest;
  bool operator==(const Command&) const = default;
};

// Whether commands of this kind name a side.
constexpr bool is_for_one_side(CommandKind kind) { return kind >= CommandKind::kPrepareKickoff; }

// The command seen from the other end of the field.
constexpr Command mirrored(Command command) {
  return {command.kind, is_for_one_side(command.kind) ? opponent_of(command.side) : command.side};
}

// The league's number, from HALT = 0 to BALL_PLACEMENT_BLUE = 17; west is yellow.
int league_number(Command command);

// The league's name, for example "PREPARE_KICKOFF_YELLOW".
std::string name_of(Command command);

enum class Stage : std::uint8_t {
  kFirstHalfPre = 0,
  kFirstHalf = 1,
  kHalfTime = 2,
  kSecondHalfPre = 3,
  kSecondHalf = 4,
  kExtraTimeBreak = 5,
  kExtraFirstHalfPre = 6,
  kExtraFirstHalf = 7,
  kExtraHalfTime = 8,
  kExtraSecondHalfPre = 9,
  kExtraSecondHalf = 10,
  kShootoutBreak = 11,
  kShootout = 12,
  kPostGame = 13,
};

// The league's names.
constexpr auto names_of(Stage /*any*/) {
  return std::to_array<Named<Stage>>({{Stage::kFirstHalfPre, "FIRST_HALF_PRE"},
                                      {Stage::kFirstHalf, "FIRST_HALF"},
                                      {Stage::kHalfTime, "HALF_TIME"},
                                      {Stage::kSecondHalfPre, "SECOND_HALF_PRE"},
                                      {Stage::kSecondHalf, "SECOND_HALF"},
                                      {Stage::kExtraTimeBreak, "EXTRA_TIME_BREAK"},
                                      {Stage::kExtraFirstHalfPre, "EXTRA_FIRST_HALF_PRE"},
                                      {Stage::kExtraFirstHalf, "EXTRA_FIRST_HALF"},
                                      {Stage::kExtraHalfTime, "EXTRA_HALF_TIME"},
                                      {Stage::kExtraSecondHalfPre, "EXTRA_SECOND_HALF_PRE"},
                                      {Stage::kExtraSecondHalf, "EXTRA_SECOND_HALF"},
                                      {Stage::kShootoutBreak, "SHOOTOUT_BREAK"},
                                      {Stage::kShootout, "SHOOTOUT"},
                                      {Stage::kPostGame, "POST_GAME"}});
}

// Where the ball is to be placed while play is stopped. `at_once` means that there is no time to
// bring it there smoothly. Unless `by_hand`, the ball is left to the teams: their robots place it,
// or it is already at its position.
struct Placement {
  Vec2 target_m{0, 0};
  bool at_once = false;
  bool by_hand = true;
};

struct RefereeSignal {
  Command command;
  std::uint32_t command_counter = 0;  // grows by one with each command sent
  double command_time_s = 0;          // when `command` was sent
  Stage stage = Stage::kFirstHalfPre;
  double stage_time_left_s = 0;  // time left in the running half; 0 in other stages
  PerSide<int> goals;
  PerSide<int> shootout_goals;  // goals in a shoot-out, which are not included in `goals`
  // Number of robots allowed on the field; reduced by cards.
  PerSide<int> robots_allowed{{kMaxRobots, kMaxRobots}};
  PerSide<int> yellow_cards;  // yellow cards shown so far
  PerSide<int> red_cards;
  // The time of play left of each active yellow card, in increasing order.
  PerSide<boost::container::static_vector<double, kMaxRobots>> yellow_left_s;
  PerSide<int> fouls;                          // fouls that count towards a card
  PerSide<int> timeouts_left;                  // number of timeouts that the team may still take
  PerSide<double> timeout_left_s;              // total time left for them
  PerSide<std::optional<int>> keepers;         // the keepers' robot numbers; nullopt if not named
  PerSide<bool> can_place_ball{{true, true}};  // false if the team is no longer allowed to place
                                               // the ball itself
  std::optional<Placement> placement;          // nullopt unless play is stopped
  std::optional<Command> next_command;         // the command that will resume play
  // Whether blue defends the positive half of the field. Sides and positions in this signal do not
  // depend on it.
  bool blue_on_positive_half = true;
};

// Converts positions from the program's coordinates to those of the field.
//
// In the program, nothing moves when teams change ends: for the world, the referee and the teams,
// west wears yellow and defends the goal at -x in every half, which the field's symmetry permits.
// Everything that is published (logs, event logs, pages) uses the field's coordinates, with each
// team at its current end. These are either the program's coordinates or the same rotated by 180
// degrees.

inline Vec2 published(const Vec2& position_m, bool blue_on_positive_half) {
  return blue_on_positive_half ? position_m : Vec2(Vec2(0, 0) - position_m);  // never -0
}

inline Frame published(const Frame& frame, bool blue_on_positive_half) {
  return blue_on_positive_half ? frame : rotated(frame);
}

inline OtherDetections published(const OtherDetections& others, bool blue_on_positive_half) {
  return blue_on_positive_half ? others : rotated(others);
}

// In a signal, sides stand for colours, so they stay the same.
inline RefereeSignal published(RefereeSignal signal) {
  if (signal.placement)
    signal.placement->target_m =
        published(signal.placement->target_m, signal.blue_on_positive_half);
  return signal;
}

// The side whose goal is at the given end of the field: west is -x, east is +x.
constexpr Side side_at(Side end, bool blue_on_positive_half) {
  return blue_on_positive_half ? end : opponent_of(end);
}

// The end of the field that yellow defends, "west" or "east".
constexpr std::string_view end_of_yellow(bool blue_on_positive_half) {
  return name_of(side_at(Side::kWest, blue_on_positive_half));
}

}  // namespace autoref
