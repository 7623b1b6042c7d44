#include "runner/experiments/roundrobin.hpp"

namespace autoref::runner {

std::vector<Matchup> matchups_of(const RoundRobin& robin) {
  std::vector<Matchup> matchups;
  for (auto a = robin.teams.begin(); a != robin.teams.end(); ++a) {
    for (auto b = std::next(a); b != robin.teams.end(); ++b) {
      matchups.push_back({a->first, b->first});
    }
  }
  return matchups;
}

}  // namespace autoref::runner
