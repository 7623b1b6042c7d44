#include "experiments/kinds/swiss/swiss_report.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <utility>

#include "experiments/statistics/rated_games.hpp"
#include "io/table_columns.hpp"

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

// A meeting, or the bye of `meeting.teams.team_a`.
struct RoundRow {
  int round = 1;  // number of the round, from 1
  Meeting meeting;

  bool is_bye() const { return meeting.teams.team_b.empty(); }
};

std::vector<RoundRow> round_rows(const SwissRounds& played) {
  std::vector<RoundRow> rows;
  int number = 0;
  for (const SwissRound& round : played.rounds) {
    ++number;
    for (const Meeting& meeting : round.meetings) rows.push_back({number, meeting});
    if (!round.bye) continue;
    Meeting bye{{*round.bye, ""}};
    bye.points_a = played.points_of_bye;
    rows.push_back({number, bye});
  }
  return rows;
}

io::TableColumns<RoundRow> csv_columns() {
  return {{"round", &RoundRow::round},
          {"team_a", [](const RoundRow& row) { return row.meeting.teams.team_a; }},
          {"team_b", [](const RoundRow& row) { return row.meeting.teams.team_b; }},
          {"games", [](const RoundRow& row) { return row.meeting.games; }},
          {"void_games", [](const RoundRow& row) { return row.meeting.void_games; }},
          {"points_a", [](const RoundRow& row) { return row.meeting.points_a; }},
          {"points_b", [](const RoundRow& row) {
             return row.is_bye() ? "" : std::to_string(row.meeting.points_b);
           }}};
}

std::string points_text(const RoundRow& row) {
  if (row.is_bye()) return std::to_string(row.meeting.points_a);
  if (row.meeting.games == 0) return row.meeting.void_games == 0 ? "-" : "void";
  return fmt::format("{}:{}", row.meeting.points_a, row.meeting.points_b);
}

io::TextTable rounds_table(const std::vector<RoundRow>& rows) {
  const io::TableColumns<RoundRow> columns = {
      {"round", &RoundRow::round},
      {"a", [](const RoundRow& row) { return row.meeting.teams.team_a; }},
      {"points", points_text},
      {"b", [](const RoundRow& row) { return row.is_bye() ? "(bye)" : row.meeting.teams.team_b; }}};
  return {io::table_rows(columns, rows),
          {io::Align::kRight, io::Align::kRight, io::Align::kLeft, io::Align::kLeft},
          2};
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

std::string rounds_csv(const SwissRounds& played) {
  return io::csv_text(io::table_rows(csv_columns(), round_rows(played)));
}

void add_rounds(ExperimentResults& results, const SwissRounds& played) {
  results.files.push_back({"rounds.csv", "a row per meeting", rounds_csv(played)});
  results.table.insert(results.table.begin(), {rounds_table(round_rows(played)), "\n"});
  if (played.byes.empty()) return;
  results.table.emplace_back(
      fmt::format("\nA bye is worth {} points, as many as winning all games of a meeting.\n",
                  played.points_of_bye));
}

}  // namespace autoref::experiments
