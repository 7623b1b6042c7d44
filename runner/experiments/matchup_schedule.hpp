// Schedules the games of experiments between named teams.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runner/experiments/gauntlet.hpp"
#include "runner/experiments/roundrobin.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/experiments/sprt_match.hpp"

namespace autoref::runner {

// The games in playing order. The two legs of a pair are adjacent, and each pair number is played
// in all matchups before the next. Within a pair number the teams take turns (playing_order.hpp):
// at any time, they have played equally many games, except for one pair and the running games. Ids
// look like "bold~zone-p0007-2".
//
// A game depends only on its two teams, its pair and its leg, so adding teams or pairs changes no
// other game. Sides, first kick-off and seed are those of leg_of(); equal pair numbers have equal
// seeds in every matchup. Throws std::invalid_argument if a setting is invalid; the message starts
// with the setting's path, such as "teams.bold.params.pass_risk".
std::vector<ScheduledGame> scheduled_games(const RoundRobin& robin);

// The games of a round robin between the two teams with the maximum number of pairs. The test
// usually ends the match earlier (sprt_match_state.hpp).
std::vector<ScheduledGame> scheduled_games(const SprtMatch& match);

// A game equals the corresponding round-robin game if the challenger's name sorts before its
// opponent's (compared as bytes); otherwise teams a and b are swapped.
std::vector<ScheduledGame> scheduled_games(const Gauntlet& gauntlet);

// Schedules games between named teams, which share their settings. Does not check these.
class MatchupScheduler {
 public:
  explicit MatchupScheduler(const NamedTeams& named);

  // A game between two of the teams.
  ScheduledGame game(const Matchup& matchup, int pair, int leg) const;

 private:
  SharedSettings base_;
  std::map<std::string, std::shared_ptr<const TeamSettings>> teams_;
  std::uint64_t seed_;
};

// Throws std::invalid_argument if a setting of the base or of a team is invalid. `branch` is the
// path of the teams in the file.
void check(const GameSettings& base, const Teams& teams, std::string_view branch = "teams");

}  // namespace autoref::runner
