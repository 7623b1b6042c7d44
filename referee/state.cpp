#include "referee/state.hpp"

#include <array>

namespace autoref::referee {

std::string_view name_of(State state) {
  static constexpr std::array<std::string_view, 9> kNames = {"INIT",    "WAIT_START", "WAIT_STOP",
                                                             "RUN",     "DELAY_WAIT", "OVER",
                                                             "TIMEOUT", "CALLED",     "PLACEMENT"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace autoref::referee
