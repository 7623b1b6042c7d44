#include "experiments/kinds/swiss/swiss_standings.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/statistics/linked_groups.hpp"

namespace autoref::experiments {
namespace {

// Whether games link all teams of the ranking.
bool are_linked(const std::vector<std::string>& ranking, const std::vector<Group>& matchups) {
  const auto number_of = [&ranking](const std::string& team) {
    return static_cast<std::size_t>(std::find(ranking.begin(), ranking.end(), team) -
                                    ranking.begin());
  };
  std::vector<MatchupTotals> totals;
  totals.reserve(matchups.size());
  for (const Group& matchup : matchups) {
    totals.push_back({number_of(matchup.values[0]), number_of(matchup.values[1]),
                      static_cast<double>(matchup.games())});
  }
  const std::vector<std::size_t> groups = linked_groups(ranking.size(), totals);
  return std::all_of(groups.begin(), groups.end(), [](std::size_t group) { return group == 0; });
}

}  // namespace

std::vector<Matchup> matchups_of(const SwissRounds& played) {
  std::vector<Matchup> matchups;
  for (const SwissRound& round : played.rounds) {
    for (const Meeting& meeting : round.meetings) {
      if (std::find(matchups.begin(), matchups.end(), meeting.teams) == matchups.end())
        matchups.push_back(meeting.teams);
    }
  }
  return matchups;
}

std::vector<Standing> standings_of(const SwissRounds& played, const std::vector<Group>& matchups) {
  std::map<std::string, Standing> by_team;
  for (Standing& standing : standings_of(matchups)) {
    std::string team = standing.team;
    by_team.emplace(std::move(team), std::move(standing));
  }
  const bool is_rated = are_linked(played.ranking, matchups);
  std::vector<Standing> standings;
  for (const std::string& team : played.ranking) {
    Standing standing = by_team[team];  // empty for a team that has only had a bye
    standing.team = team;
    standing.rank = static_cast<int>(standings.size()) + 1;
    standing.is_rated = is_rated;
    const auto byes = played.byes.find(team);
    if (byes != played.byes.end()) standing.bye_points = byes->second * played.points_of_bye;
    standings.push_back(std::move(standing));
  }
  return standings;
}

}  // namespace autoref::experiments
