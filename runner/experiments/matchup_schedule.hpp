// From teams with names to their lists of games.
#pragma once

#include <string_view>
#include <vector>

#include "runner/experiments/gauntlet.hpp"
#include "runner/experiments/roundrobin.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/experiments/sprt_match.hpp"

namespace autoref::runner {

// The games in the order in which they are played: both legs of a pair back to back, and pair by
// pair over all matchups, so that a run that is cut short is balanced. Ids are such as
// "bold~zone-p0007-2".
//
// A game depends on its two teams, the pair within its matchup and its leg only: adding teams or
// pairs changes no other game. Sides, first kick-off and seed are as set_leg() has them; pairs of
// one number have the same seeds in every matchup. Throws std::invalid_argument where a setting is
// wrong; it begins with the setting's path, such as "teams.bold.params.pass_risk".
std::vector<ScheduledGame> scheduled_games(const RoundRobin& robin);

// Likewise: the games of a match are those of a round robin of its two teams. These are all the
// pairs that there may be; the test mostly ends the match before (sprt_match_state.hpp).
std::vector<ScheduledGame> scheduled_games(const SprtMatch& match);

// Likewise: games equal those of a round robin where a challenger's name comes before that of its
// opponent, as bytes; else a and b are exchanged.
std::vector<ScheduledGame> scheduled_games(const Gauntlet& gauntlet);

// One game of two of the teams, whatever their settings.
ScheduledGame scheduled(const NamedTeams& named, const Matchup& matchup, int pair, int leg);

// Throws std::invalid_argument where a setting is wrong of the base or of teams, which stand below
// `branch` in a file.
void check(const GameSettings& base, const Teams& teams, std::string_view branch = "teams");

}  // namespace autoref::runner
