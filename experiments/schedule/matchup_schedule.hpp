// Schedules the games of experiments between named teams.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/schedule/named_teams.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// The games of matchups in playing order, with `order` as the order of the matchups within a pair
// number. The two legs of a pair are adjacent, and each pair number is played in all matchups
// before the next. With an order of playing_order.hpp the teams take turns: at any time, they have
// played equally many games, except for one pair and the running games. Ids look like
// "bold~zone-p0007-2".
//
// A game depends only on its two teams, its pair and its leg, so adding teams or pairs changes no
// other game. Sides, first kick-off and seed are those of leg_of(); equal pair numbers have equal
// seeds in every matchup. Throws SettingError if there are too many games. Does not check the
// settings.
std::vector<ScheduledGame> games_of(const NamedTeams& named, const std::vector<Matchup>& matchups,
                                    const std::vector<std::size_t>& order, int pairs);

// Schedules games between named teams, which share their settings. Does not check these.
class MatchupScheduler {
 public:
  explicit MatchupScheduler(const NamedTeams& named);

  // A game between two of the teams.
  ScheduledGame game(const Matchup& matchup, int pair, int leg) const;

 private:
  SharedSettings base_;
  std::map<std::string, std::shared_ptr<const game::TeamSettings>> teams_;
  std::uint64_t seed_;
};

// Throws std::invalid_argument if a setting of the base or of a team is invalid. `branch` is the
// path of the teams in the file.
void check(const game::GameSettings& base, const Teams& teams, std::string_view branch = "teams");

}  // namespace autoref::experiments
