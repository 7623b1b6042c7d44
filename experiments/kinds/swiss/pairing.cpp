#include "experiments/kinds/swiss/pairing.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <stdexcept>

namespace autoref::experiments {
namespace {

using NotMet = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

// The least number of rematches if all of these teams are paired. Teams that a largest matching
// leaves over have all met each other, so that each two of them make one rematch.
std::size_t fewest_rematches(const std::vector<DrawnTeam>& teams, const Encounters& past) {
  NotMet graph(teams.size());
  for (std::size_t i = 0; i < teams.size(); ++i) {
    for (std::size_t j = i + 1; j < teams.size(); ++j)
      if (!past.have_met(teams[i], teams[j])) boost::add_edge(i, j, graph);
  }
  std::vector<NotMet::vertex_descriptor> mates(teams.size());
  boost::edmonds_maximum_cardinality_matching(graph, mates.data());
  return teams.size() / 2 - boost::matching_size(graph, mates.data());
}

std::vector<DrawnTeam> without(std::vector<DrawnTeam> teams, std::size_t position) {
  teams.erase(teams.begin() + static_cast<std::ptrdiff_t>(position));
  return teams;
}

// Moves the first team and the next one that it can meet from `left` to the meetings. `rematches`
// is the least number of those that are left.
void pair_first(std::vector<DrawnTeam>& left, std::size_t& rematches, RoundPairing& pairing,
                const Encounters& past) {
  for (std::size_t i = 1; i < left.size(); ++i) {
    const std::size_t its = past.have_met(left[0], left[i]) ? 1 : 0;
    if (its > rematches) continue;
    std::vector<DrawnTeam> rest = without(without(left, i), 0);
    const std::size_t of_rest = fewest_rematches(rest, past);
    if (its + of_rest > rematches) continue;
    pairing.meetings.emplace_back(left[0], left[i]);
    left = std::move(rest);
    rematches = of_rest;
    return;
  }
  throw std::logic_error("the teams of a round cannot be paired");
}

// The position of the team that gets a bye.
std::size_t position_of_bye(const std::vector<DrawnTeam>& ranking, const Encounters& past) {
  std::optional<std::size_t> best;
  std::size_t fewest = 0;
  for (std::size_t i = ranking.size(); i-- > 0;) {
    if (past.had_bye(ranking[i])) continue;
    const std::size_t rematches = fewest_rematches(without(ranking, i), past);
    if (best && rematches >= fewest) continue;
    best = i;
    fewest = rematches;
    if (fewest == 0) break;
  }
  if (!best) throw std::logic_error("all teams have had a bye");
  return *best;
}

}  // namespace

RoundPairing first_pairing(std::size_t teams) {
  RoundPairing pairing;
  const std::size_t half = teams / 2;
  for (DrawnTeam team = 0; team < half; ++team) pairing.meetings.emplace_back(team, half + team);
  if (teams % 2 == 1) pairing.bye = teams - 1;
  return pairing;
}

RoundPairing next_pairing(const std::vector<DrawnTeam>& ranking, const Encounters& past) {
  RoundPairing pairing;
  std::vector<DrawnTeam> left = ranking;
  if (left.size() % 2 == 1) {
    const std::size_t position = position_of_bye(ranking, past);
    pairing.bye = ranking[position];
    left = without(std::move(left), position);
  }
  std::size_t rematches = fewest_rematches(left, past);
  while (!left.empty()) pair_first(left, rematches, pairing, past);
  return pairing;
}

}  // namespace autoref::experiments
