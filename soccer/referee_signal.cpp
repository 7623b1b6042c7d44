#include "soccer/referee_signal.hpp"

namespace autoref {

int league_number(Command command) {
  const int kind = static_cast<int>(command.kind);
  if (!is_for_one_side(command.kind)) return kind;
  // Commands for one side are numbered in pairs: yellow, then blue.
  const int first_pair = static_cast<int>(CommandKind::kPrepareKickoff);
  return first_pair + 2 * (kind - first_pair) + (command.side == Side::kEast ? 1 : 0);
}

std::string name_of(Command command) {
  std::string name(name_of(command.kind));
  if (is_for_one_side(command.kind)) name += command.side == Side::kWest ? "_YELLOW" : "_BLUE";
  return name;
}

}  // namespace autoref
