// Deals the matchups of a schedule evenly over all pairs of teams.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace autoref::experiments {

// The first `count` matchups (team a, team b) of an endless deal over all pairs of the teams, each
// team also against itself: n (n + 1) / 2 pairs for n teams.
//
// Every pair is dealt once before any pair is dealt again, so after any number of matchups the
// pairs' numbers of games differ by at most one. Within such a cycle come n rounds in which every
// team plays, so the teams' numbers of games also stay close. A pair changes its order from one
// cycle to the next. The rest of the order is random: it depends on `seed` alone. There must be at
// least one team.
std::vector<std::array<std::string, 2>> dealt_matchups(const std::vector<std::string>& teams,
                                                       std::uint64_t seed, std::size_t count);

}  // namespace autoref::experiments
