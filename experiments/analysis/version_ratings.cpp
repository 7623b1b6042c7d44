#include "experiments/analysis/version_ratings.hpp"

#include <algorithm>
#include <tuple>

#include "experiments/analysis/team_differences.hpp"

namespace autoref::experiments {
namespace {

int games_of_team(const std::vector<Group>& matchups, const std::string& team) {
  int games = 0;
  for (const Group& matchup : matchups)
    if (matchup.values[0] == team || matchup.values[1] == team) games += matchup.games();
  return games;
}

// In a complete round robin of n teams, a team's least-squares rating is the sum of its mean goal
// differences against the others, divided by n: it also counts as an opponent of itself.
DifferenceByPair ratings_by_pair(const std::vector<Group>& matchups, const std::string& team,
                                 std::size_t teams, RatedAgainst against) {
  DifferenceByPair ratings = leads_by_pair(matchups, team);
  if (against == RatedAgainst::kField) return ratings;
  const auto count = static_cast<double>(teams);
  for (auto& [pair, rating] : ratings) rating *= (count - 1) / count;
  return ratings;
}

// The pair numbers that all have, with the mean of their values.
DifferenceByPair mean_of_all(const std::vector<DifferenceByPair>& all) {
  DifferenceByPair means;
  if (all.empty()) return means;
  for (const auto& [pair, first] : all.front()) {
    std::vector<double> values;
    for (const DifferenceByPair& one : all)
      if (const auto found = one.find(pair); found != one.end()) values.push_back(found->second);
    if (values.size() == all.size()) means[pair] = *mean_of(values);
  }
  return means;
}

// The sums, or differences, over the pair numbers that both have.
DifferenceByPair combined(const DifferenceByPair& one, const DifferenceByPair& other, double sign) {
  DifferenceByPair result;
  for (const auto& [pair, value] : one)
    if (const auto found = other.find(pair); found != other.end())
      result[pair] = value + sign * found->second;
  return result;
}

// Compares each anchor's change with the mean of the others'. With two anchors, both comparisons
// are the same, so the second one is left out.
std::vector<BuildOffset::Deviation> deviations_among(const std::vector<std::string>& anchors,
                                                     const std::vector<DifferenceByPair>& changes) {
  std::vector<BuildOffset::Deviation> all;
  if (changes.size() < 2) return all;
  for (std::size_t i = 0; i < (changes.size() == 2 ? 1 : changes.size()); ++i) {
    std::vector<DifferenceByPair> others = changes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    all.push_back({anchors[i], paired_difference(changes[i], mean_of_all(others))});
  }
  correct_by_holm(all, &BuildOffset::Deviation::from_others);
  std::erase_if(all, [](const BuildOffset::Deviation& one) {
    return one.from_others.p_holm.value_or(1) > kSignificant;
  });
  return all;
}

// The offset from the anchors that have ratings both in the earlier folder and in `teams`.
BuildOffset offset_of(const TeamVersions& versions, const std::vector<VersionRating>& teams,
                      const std::string& build) {
  BuildOffset offset{versions.taken_over->build, build, 0, {}, {}};
  std::vector<std::string> anchors;
  std::vector<DifferenceByPair> changes;
  for (const VersionRating& now : teams) {
    const auto then = versions.taken_over->teams.find(now.team);
    if (!now.is_anchor || then == versions.taken_over->teams.end()) continue;
    anchors.push_back(now.team);
    changes.push_back(combined(now.by_pair, then->second.by_pair, -1));
  }
  offset.anchors = anchors.size();
  offset.by_pair = mean_of_all(changes);
  offset.deviations = deviations_among(anchors, changes);
  return offset;
}

VersionRating taken_over_rating(const std::string& name, const EarlierTeam& team,
                                const BuildOffset& offset) {
  VersionRating rating{name, {}, {}, team.games, team.build, false, {}, {}};
  rating.by_pair = combined(team.by_pair, offset.by_pair, 1);
  // The mean over the pair numbers of the rating, so that the rating without it is the earlier
  // rating over these.
  std::vector<double> added;
  for (const auto& [pair, sum] : rating.by_pair) added.push_back(offset.by_pair.at(pair));
  rating.offset = team.offset + mean_of(added).value_or(0);
  return rating;
}

bool precedes(const VersionRating& one, const VersionRating& other) {
  const auto place = [](const VersionRating& team) {
    return std::tuple(team.version.date.empty(), team.version.line, team.version.date, team.team);
  };
  return place(one) < place(other);
}

void set_changes(std::vector<VersionRating>& teams) {
  for (std::size_t i = 1; i < teams.size(); ++i) {
    const VersionRating& former = teams[i - 1];
    VersionRating& team = teams[i];
    if (team.version.date.empty() || former.version.line != team.version.line) continue;
    team.change = paired_difference(team.by_pair, former.by_pair);
  }
}

bool needs_offset(const TeamVersions& versions, const std::string& build) {
  if (!versions.taken_over) return false;
  const auto& teams = versions.taken_over->teams;
  const bool is_other_build = !build.empty() && versions.taken_over->build != build;
  return is_other_build || std::any_of(teams.begin(), teams.end(), [&](const auto& team) {
           return versions.is_taken_over(team.first);
         });
}

}  // namespace

VersionRatings version_ratings(const TeamVersions& versions, const std::vector<std::string>& played,
                               const std::vector<Group>& matchups, const std::string& build,
                               RatedAgainst against) {
  VersionRatings ratings;
  for (const std::string& name : played) {
    VersionRating team{name, {}, {}, games_of_team(matchups, name), build, versions.is_anchor(name),
                       {},   {}};
    team.by_pair = ratings_by_pair(matchups, name, played.size(), against);
    ratings.teams.push_back(std::move(team));
  }
  if (needs_offset(versions, build)) {
    ratings.offset = offset_of(versions, ratings.teams, build);
    for (const auto& [name, team] : versions.taken_over->teams)
      if (versions.is_taken_over(name))
        ratings.teams.push_back(taken_over_rating(name, team, *ratings.offset));
  }
  for (VersionRating& team : ratings.teams)
    if (const auto found = versions.of_teams.find(team.team); found != versions.of_teams.end())
      team.version = found->second;
  std::sort(ratings.teams.begin(), ratings.teams.end(), precedes);
  set_changes(ratings.teams);
  return ratings;
}

}  // namespace autoref::experiments
