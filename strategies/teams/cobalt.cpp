#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {

TeamPlaybook cobalt_playbook() {
  Style style;
  return {style};
}

}  // namespace autoref::strategies
