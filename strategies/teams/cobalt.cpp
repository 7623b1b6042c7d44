#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {

// The defaults of Style are this team's.
TeamPlaybook cobalt_playbook() { return {}; }

}  // namespace autoref::strategies
