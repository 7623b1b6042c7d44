#include "strategies/teams/dummy.hpp"

namespace autoref::strategies {

void Dummy::decide(const TeamView& /*view*/, TeamOrders& /*orders*/) {}

}  // namespace autoref::strategies
