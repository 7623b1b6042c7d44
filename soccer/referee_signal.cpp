#include "soccer/referee_signal.hpp"

#include <array>

namespace autoref {

int league_number(Command command) {
  const int kind = static_cast<int>(command.kind);
  if (!is_for_one_side(command.kind)) return kind;
  // Commands for one side are numbered in pairs: yellow, then blue.
  const int first_pair = static_cast<int>(CommandKind::kPrepareKickoff);
  return first_pair + 2 * (kind - first_pair) + (command.side == Side::kEast ? 1 : 0);
}

std::string_view name_of(CommandKind kind) {
  static constexpr std::array<std::string_view, 11> kNames = {"HALT",
                                                              "STOP",
                                                              "NORMAL_START",
                                                              "FORCE_START",
                                                              "PREPARE_KICKOFF",
                                                              "PREPARE_PENALTY",
                                                              "DIRECT_FREE",
                                                              "INDIRECT_FREE",
                                                              "TIMEOUT",
                                                              "GOAL",
                                                              "BALL_PLACEMENT"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string name_of(Command command) {
  std::string name(name_of(command.kind));
  if (is_for_one_side(command.kind)) name += command.side == Side::kWest ? "_YELLOW" : "_BLUE";
  return name;
}

std::string_view name_of(Stage stage) {
  static constexpr std::array<std::string_view, 14> kNames = {"FIRST_HALF_PRE",
                                                              "FIRST_HALF",
                                                              "HALF_TIME",
                                                              "SECOND_HALF_PRE",
                                                              "SECOND_HALF",
                                                              "EXTRA_TIME_BREAK",
                                                              "EXTRA_FIRST_HALF_PRE",
                                                              "EXTRA_FIRST_HALF",
                                                              "EXTRA_HALF_TIME",
                                                              "EXTRA_SECOND_HALF_PRE",
                                                              "EXTRA_SECOND_HALF",
                                                              "SHOOTOUT_BREAK",
                                                              "SHOOTOUT",
                                                              "POST_GAME"};
  return kNames[static_cast<std::size_t>(stage)];
}

}  // namespace autoref
