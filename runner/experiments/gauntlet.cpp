#include "runner/experiments/gauntlet.hpp"

namespace autoref::runner {

std::vector<Matchup> matchups_of(const Gauntlet& gauntlet) {
  std::vector<Matchup> matchups;
  for (const auto& [challenger, its] : gauntlet.challengers) {
    for (const auto& [team, settings] : gauntlet.teams) matchups.push_back({challenger, team});
  }
  return matchups;
}

NamedTeams everyone_in(const Gauntlet& gauntlet) {
  NamedTeams everyone = gauntlet;
  everyone.teams.insert(gauntlet.challengers.begin(), gauntlet.challengers.end());
  return everyone;
}

}  // namespace autoref::runner
