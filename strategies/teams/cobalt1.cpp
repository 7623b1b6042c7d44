#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {

// This team uses the defaults of Style, which must not change.
TeamPlaybook cobalt1_playbook() { return {}; }

}  // namespace autoref::strategies
