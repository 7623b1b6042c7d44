// Ratings of the versions of teams over time, and the offset between two builds of AutoRef.
//
// A rating is in goals per game. In a gauntlet, it is the mean goal difference against the field;
// in a round robin, the rating by least squares (experiments/statistics/ratings.hpp). The unit of
// all statistics here is the pair number: all games of a pair number have the same seeds, so its
// games give one value of each team's rating. A team's rating is the mean of these values, over the
// pair numbers in which the team completed all its games, and its interval is Student's. Ratings of
// two teams or two builds are compared pair number by pair number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/schedule/team_versions.hpp"
#include "experiments/statistics/paired_difference.hpp"

namespace autoref::experiments {

// The opponents to which ratings are relative.
enum class RatedAgainst {
  kField,      // of a gauntlet
  kEachOther,  // the other teams of a round robin
};

struct VersionRating {
  std::string team;
  TeamVersion version;  // its date is empty for an anchor or another team that is not a version
  // The rating from the games of each pair number, with the offset of a team that is not played
  // again.
  DifferenceByPair by_pair;
  int games = 0;      // number of games behind the rating
  std::string build;  // the build that played them; empty without games
  bool is_anchor = false;
  // What was added because other builds of AutoRef play differently: for each later build, the mean
  // offset over the pair numbers of the rating at that time. nullopt if the team is played by the
  // current build.
  std::optional<double> offset;
  // Change from the version before in the same line; nullopt for the first one.
  std::optional<PairedDifference> change;

  std::optional<double> rating() const { return mean_of(values_of(by_pair)); }
  std::optional<Interval> interval() const { return mean_interval(values_of(by_pair)); }
};

// What another build of AutoRef does to ratings: the mean, over the anchors, of the rating now
// minus the rating in the earlier folder, over the pair numbers that all anchors completed in both.
struct BuildOffset {
  std::string from;  // the build of the earlier folder
  std::string to;    // the build of the games here; empty without games
  std::size_t anchors = 0;
  DifferenceByPair by_pair;
  // Anchors whose change differs from the mean change of the other anchors (paired t test with
  // Holm's correction); a single offset then does not describe what the build changes.
  struct Deviation {
    std::string anchor;
    PairedDifference from_others;
  };
  std::vector<Deviation> deviations;
};

struct VersionRatings {
  std::vector<VersionRating> teams;   // by line and date, then those without a date by name
  std::optional<BuildOffset> offset;  // nullopt if no rating needs one
};

// The ratings of all teams in `played`, and of those that are taken over. `matchups` come from
// grouped(), and `build` is the build of their games, empty without games.
VersionRatings version_ratings(const TeamVersions& versions, const std::vector<std::string>& played,
                               const std::vector<Group>& matchups, const std::string& build,
                               RatedAgainst against);

}  // namespace autoref::experiments
