#include "runner/game/game_record.hpp"

namespace autoref::runner {

std::string_view name_of(EndReason reason) {
  static constexpr std::array<std::string_view, 6> kNames = {"time",      "goals",     "shootout",
                                                             "forfeit_a", "forfeit_b", "void"};
  return kNames[static_cast<std::size_t>(reason)];
}

std::string_view name_of(Status status) {
  static constexpr std::array<std::string_view, 3> kNames = {"ok", "forfeit", "void"};
  return kNames[static_cast<std::size_t>(status)];
}

}  // namespace autoref::runner
