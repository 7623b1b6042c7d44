#include "runner/experiments/sprt_match.hpp"

#include <cassert>

namespace autoref::runner {

Matchup matchup_of(const SprtMatch& match) {
  assert(match.teams.size() == 2);
  return {match.teams.begin()->first, match.teams.rbegin()->first};
}

}  // namespace autoref::runner
