// Versions of teams over time, and ratings taken over from an earlier experiment. Neither changes
// the settings, the id or the seed of any game.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {

// Names of the keys, which messages also mention.
inline constexpr const char* kVersion = "version";
inline constexpr const char* kVersionOf = "version_of";
inline constexpr const char* kAnchors = "anchors";
inline constexpr const char* kEarlier = "earlier";

struct TeamVersion {
  std::string date;  // such as "2026-09-01", so dates sort as text; empty: not a version
  std::string line;  // name of its line of versions, which may be empty
};

// The rating of a team in an earlier results folder.
struct EarlierTeam {
  std::string build;  // the build of AutoRef that played the team's games
  double offset = 0;  // the sum of the mean offsets in `by_pair`, in goals per game
  int games = 0;      // number of games behind the rating
  // The team's rating from the games of each pair number, in goals per game.
  DifferenceByPair by_pair;
};

struct TakenOver {
  std::string build;  // the build that played the games of the earlier folder
  // The anchors of the earlier folder, and the teams that are not played again.
  std::map<std::string, EarlierTeam> teams;
};

struct TeamVersions {
  std::map<std::string, TeamVersion> of_teams;  // by the team's name
  std::vector<std::string> anchors;             // teams that every build of AutoRef plays
  // An earlier results folder, absolute; empty: none.
  std::filesystem::path earlier;
  // What take_over_versions() (experiments/run/earlier_versions.hpp) found there; nullopt before.
  std::optional<TakenOver> taken_over;

  // Whether ratings over time are wanted.
  bool are_followed() const { return !of_teams.empty() || !anchors.empty() || !earlier.empty(); }
  bool is_anchor(const std::string& team) const;
  // Whether the team's rating is taken over instead of playing its games again.
  bool is_taken_over(const std::string& team) const;
};

// The teams of an experiment whose ratings can be followed over time.
struct VersionedTeams {
  TeamVersions* versions = nullptr;
  Teams* rated = nullptr;        // the teams that can be versions
  const Teams* field = nullptr;  // the opponents that are not rated; null if there are none
  const game::GameSettings* base = nullptr;
  std::uint64_t seed = 0;
};

// The settings `version` and `version_of` of a team, below `prefix`, such as "teams.mine.".
std::vector<game::Setting> settings_of(TeamVersion& version, const std::string& prefix);

// Whether the text is a date of the calendar in the form 2026-09-01.
bool is_date(std::string_view text);

// The days from the first date to the second. Both must be dates.
int days_between(const std::string& from, const std::string& to);

// The date that follows `date` after some days.
std::string date_after(const std::string& date, int days);

// Those of `teams` whose games are played.
Teams played_teams(const Teams& teams, const TeamVersions& versions);

// Throws SettingError if a date is invalid, a team has a line but no date, an anchor is not one of
// the teams, or an anchor is named twice. `branch` is the path of the teams in the file.
void check(const TeamVersions& versions, const Teams& teams, std::string_view branch);

}  // namespace autoref::experiments
