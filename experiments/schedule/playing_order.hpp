// In which order the matchups or combinations of values of an experiment are played, so that every
// team and every value has been played about as often at any time.
#pragma once

#include <cstddef>
#include <vector>

namespace autoref::experiments {

// The matchups of a round robin as indices into matchups_of(RoundRobin). In every beginning of the
// order, the teams' numbers of matchups differ by at most one.
//
// An even number of teams plays in the rounds of the circle method: one team stays in its place,
// the others move around a circle, and in each round every team plays once. With an odd number, a
// team would sit out each round and fall behind; there, the matchups are Walecki's Hamiltonian
// cycles through all teams (B. Alspach, "The wonderful Walecki construction", Bulletin of the ICA
// 52, 2008), in each of which every team plays twice: first every other matchup along the cycle,
// then the rest.
std::vector<std::size_t> round_robin_order(std::size_t teams);

// The combinations of several lists' values as indices into all combinations in which the last list
// changes fastest. `sizes` are the lists' lengths, at least 1. In every beginning of the order, the
// numbers of combinations with each value of a list differ by at most one.
std::vector<std::size_t> combinations_order(const std::vector<std::size_t>& sizes);

}  // namespace autoref::experiments
