#include "experiments/analysis/team_differences.hpp"

#include <iterator>
#include <map>
#include <utility>

#include "experiments/statistics/sample.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kMostTeamDifferences = 15;  // rows of the text table: those of six teams

// The goal differences of a team's pairs against each opponent, from the team's point of view.
using LeadsByOpponent = std::map<std::string, DifferenceByPair>;

std::map<std::string, LeadsByOpponent> leads_of(const std::vector<Group>& matchups) {
  std::map<std::string, LeadsByOpponent> leads;
  for (const Group& matchup : matchups) {
    const std::string& a = matchup.values[0];
    const std::string& b = matchup.values[1];
    leads[a][b] = matchup.pair_differences;
    DifferenceByPair& of_b = leads[b][a];
    for (const auto& [pair, difference] : matchup.pair_differences) of_b[pair] = -difference;
  }
  return leads;
}

std::vector<std::string> common_opponents(const LeadsByOpponent& one,
                                          const LeadsByOpponent& other) {
  std::vector<std::string> opponents;
  for (const auto& [opponent, leads] : one)
    if (other.contains(opponent)) opponents.push_back(opponent);
  return opponents;
}

// The mean over the opponents, for pair numbers with games against all of them.
DifferenceByPair mean_leads(const LeadsByOpponent& leads,
                            const std::vector<std::string>& opponents) {
  std::map<int, std::vector<double>> by_pair;
  for (const std::string& opponent : opponents)
    for (const auto& [pair, lead] : leads.at(opponent)) by_pair[pair].push_back(lead);
  DifferenceByPair means;
  for (const auto& [pair, sample] : by_pair)
    if (sample.size() == opponents.size()) means[pair] = mean(sample);
  return means;
}

io::TableColumns<TeamDifference> team_columns() {
  return {
      {"team", &TeamDifference::team},
      {"other", &TeamDifference::other},
      {"opponents", &TeamDifference::opponents},
      {"pairs", [](const TeamDifference& one) { return static_cast<int>(one.difference.pairs); }}};
}

std::vector<PairedDifference> paired(const std::vector<TeamDifference>& differences) {
  std::vector<PairedDifference> all;
  all.reserve(differences.size());
  for (const TeamDifference& one : differences) all.push_back(one.difference);
  return all;
}

}  // namespace

std::vector<TeamDifference> team_differences(const std::vector<Group>& matchups,
                                             const std::vector<std::string>& teams) {
  const std::map<std::string, LeadsByOpponent> leads = leads_of(matchups);
  std::vector<TeamDifference> differences;
  for (auto team = teams.begin(); team != teams.end(); ++team) {
    for (auto other = std::next(team); other != teams.end(); ++other) {
      const std::vector<std::string> opponents =
          common_opponents(leads.at(*team), leads.at(*other));
      if (opponents.empty()) continue;
      differences.push_back({*team, *other, static_cast<int>(opponents.size()),
                             paired_difference(mean_leads(leads.at(*team), opponents),
                                               mean_leads(leads.at(*other), opponents))});
    }
  }
  correct_by_holm(differences, &TeamDifference::difference);
  return differences;
}

DifferenceByPair leads_by_pair(const std::vector<Group>& matchups, const std::string& team) {
  const std::map<std::string, LeadsByOpponent> leads = leads_of(matchups);
  const auto found = leads.find(team);
  if (found == leads.end()) return {};
  std::vector<std::string> opponents;
  for (const auto& [opponent, its_leads] : found->second) opponents.push_back(opponent);
  return mean_leads(found->second, opponents);
}

std::string team_differences_csv(const std::vector<TeamDifference>& differences) {
  std::vector<io::Cells> rows = io::table_rows(team_columns(), differences);
  io::append_columns(rows, difference_columns("mean_diff", "diff_"), paired(differences));
  return io::csv_text(rows);
}

io::TextBlocks team_differences_table(const std::vector<TeamDifference>& differences) {
  if (differences.empty()) return {};
  if (differences.size() > kMostTeamDifferences)
    return {"\nDifferences between teams against common opponents: differences.csv\n"};
  std::vector<io::Cells> rows = {{"team", "minus", "opponents", "difference [95 %]", "p"}};
  for (const TeamDifference& one : differences) {
    const PairedDifference& difference = one.difference;
    rows.push_back(
        {one.team, one.other, std::to_string(one.opponents),
         difference.mean ? mean_text(*difference.mean, difference.interval, difference.pairs) : "-",
         difference.p_holm ? p_text(*difference.p_holm) : ""});
  }
  return {"\n", io::TextTable{std::move(rows), {io::Align::kLeft, io::Align::kLeft}, 2},
          "\nDifferences are in goals per game against the opponents that both teams played, over "
          "pairs with the same seeds; p is that of the paired t test, with Holm's correction over "
          "the table.\n"};
}

}  // namespace autoref::experiments
