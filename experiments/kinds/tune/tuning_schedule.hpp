// Schedules the games of a tuning.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// A matchup of two teams in one iteration or in the final test.
struct TuningMatchup {
  Matchup names;       // "plus" and "zone"; "plus" and "minus" without opponents
  std::string played;  // prefix of the games' ids: "k0007-plus~zone", "test-result~zone"
  // Parameter values of team a, which is a candidate, the result or the start.
  ParamValues a_values;
  game::TeamSettings b;
  std::size_t candidate = 0;  // index of the candidate that is team a
  std::string opponent;       // name of team b in `opponents`; empty in self-play
  // Master seed: the same for all candidates, so that they can be compared.
  std::uint64_t seed = 0;
};

// The matchups of iteration `number`, counted from 1: every candidate against every opponent. In
// self-play, "plus" plays "minus", or every candidate plays the centre of the search.
std::vector<TuningMatchup> matchups_of(const Tuning& tuning, int number,
                                       const std::vector<Candidate>& candidates,
                                       const Point& centre);

// The matchups of the test: the result and the start against every opponent, or the result against
// the start. Their seeds do not occur in any iteration.
std::vector<TuningMatchup> test_matchups_of(const Tuning& tuning, const ParamValues& result);

// The games of these matchups, pair by pair.
std::vector<ScheduledGame> games_of(const Tuning& tuning,
                                    const std::vector<TuningMatchup>& matchups, int pairs);

// Appends games with unit numbers that follow those of `games`.
void append(std::vector<ScheduledGame>& games, std::vector<ScheduledGame> more);

// The number of games in all iterations, and the number of games per pair number of the final test.
int games_of_search(const Tuning& tuning);
int games_of_test_pair(const Tuning& tuning);

// The games that would be played if all were drawn. Their number is right, but their parameters are
// not. Throws SettingError if the settings contradict each other.
std::vector<ScheduledGame> games_if_drawn(const Tuning& tuning);

}  // namespace autoref::experiments
