#include "runner/experiments/situations.hpp"

namespace autoref::runner {

std::vector<SituationMatchup> matchups_of(const Situations& situations) {
  std::vector<SituationMatchup> matchups;
  for (const auto& [situation, its] : situations.situations) {
    for (const auto& [defenders, theirs] : situations.defenders) {
      for (const auto& [attackers, team] : situations.attackers)
        matchups.push_back({situation, attackers, defenders});
    }
  }
  return matchups;
}

}  // namespace autoref::runner
