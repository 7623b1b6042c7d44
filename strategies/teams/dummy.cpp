#include "strategies/teams/dummy.hpp"

namespace autoref::strategies {

void Dummy::decide(const TeamView& /*view*/, TeamCommands& /*commands*/) {}

}  // namespace autoref::strategies
