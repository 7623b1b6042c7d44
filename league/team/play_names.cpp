#include "league/team/play_names.hpp"

#include <array>

namespace autoref::league {

std::string_view name_of(Play play) {
  static constexpr std::array<std::string_view, 9> kNames = {
      "HALT",    "STOP",        "PREPARE_KICKOFF", "PREPARE_PENALTY", "KICKOFF",
      "PENALTY", "DIRECT_FREE", "INDIRECT_FREE",   "RUNNING"};
  return kNames.at(static_cast<std::size_t>(play));
}

}  // namespace autoref::league
