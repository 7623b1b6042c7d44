#include "strategies/teams/plans.hpp"

namespace autoref::strategies {

// The style's standards are this team's.
Plan cobalt_plan() { return {}; }

}  // namespace autoref::strategies
