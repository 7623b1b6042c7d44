// Teams with names, and the schedule of their matchups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/schedule/schedule.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

using Teams = std::map<std::string, game::TeamSettings>;  // teams by name, as in result rows

// Settings shared by all experiments between named teams.
struct NamedTeams {
  game::GameSettings base;  // its teams, seed, a_plays and first_kickoff are ignored
  Teams teams;
  std::uint64_t seed = 1;  // master seed of the experiment
};

// The range of team counts that an experiment accepts.
struct TeamCount {
  std::size_t least = 2;
  std::size_t most = SIZE_MAX;
};

// The names of two teams that play each other.
struct Matchup {
  std::string team_a;
  std::string team_b;
  bool operator==(const Matchup&) const = default;
};

// "bold~zone".
std::string matchup_name(const Matchup& matchup);

// Every pairing of two different teams once, ordered by name (compared as bytes).
std::vector<Matchup> matchups_among(const Teams& teams);

// The games of matchups in playing order. Within a pair number, the matchups are played in the
// order `order`. The two legs of a pair are adjacent, and all matchups play a pair number before
// the next one. With an order from schedule.hpp, the teams take turns: at any time, their numbers
// of games differ by at most one pair, apart from the running games. Ids look like
// "bold~zone-p0007-2".
//
// A game depends only on its two teams, its pair and its leg, so adding teams or pairs changes no
// other game. Sides, first kick-off and seed are those of leg_of(); equal pair numbers have equal
// seeds in every matchup. Throws SettingError if there are too many games. Does not check the
// settings.
std::vector<ScheduledGame> games_of(const NamedTeams& named, const std::vector<Matchup>& matchups,
                                    const std::vector<std::size_t>& order, int pairs);

// Schedules games between named teams. All games share one object with the settings of the base,
// and one for each team. Does not check the settings.
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
