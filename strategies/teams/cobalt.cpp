#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {

// The style's standards are this team's.
TeamPlaybook cobalt_playbook() { return {}; }

}  // namespace autoref::strategies
