#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {

// This team uses the defaults of Style.
TeamPlaybook cobalt_playbook() { return {}; }

}  // namespace autoref::strategies
