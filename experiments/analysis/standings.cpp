#include "experiments/analysis/standings.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

int sum_of(const std::vector<double>& goals) {
  return static_cast<int>(std::accumulate(goals.begin(), goals.end(), 0.0));
}

// Adds a matchup's goal differences; `sign` is -1 if the team is team b in the matchup.
void add_differences(Standing& standing, const Group& matchup, double sign) {
  for (const double difference : matchup.differences) {
    standing.differences.push_back(sign * difference);
  }
  for (const double difference : values_of(matchup.pair_differences)) {
    standing.pair_differences.push_back(sign * difference);
  }
  standing.draws += matchup.draws;
  standing.void_games += matchup.void_games;
}

void add_a(Standing& standing, const Group& matchup) {
  standing.wins += matchup.wins_a;
  standing.losses += matchup.wins_b;
  standing.goals_for += sum_of(matchup.goals_a);
  standing.goals_against += sum_of(matchup.goals_b);
  add_differences(standing, matchup, 1);
}

void add_b(Standing& standing, const Group& matchup) {
  standing.wins += matchup.wins_b;
  standing.losses += matchup.wins_a;
  standing.goals_for += sum_of(matchup.goals_b);
  standing.goals_against += sum_of(matchup.goals_a);
  add_differences(standing, matchup, -1);
}

std::vector<RatedMatchup> rated(const std::vector<Group>& matchups) {
  std::vector<RatedMatchup> all;
  all.reserve(matchups.size());
  for (const Group& matchup : matchups)
    all.push_back({matchup.values[0], matchup.values[1], matchup.games_by_pair});
  return all;
}

void rate(const std::vector<Group>& matchups, std::map<std::string, Standing>& by_team) {
  const std::vector<RatedMatchup> all = rated(matchups);
  for (const Rating& rating : goal_ratings_of(all)) by_team[rating.team].goals = rating;
  for (const Rating& rating : bradley_terry_ratings_of(all)) by_team[rating.team].strength = rating;
  for (auto& [team, standing] : by_team) standing.is_rated = true;
}

double mean_difference(const Standing& standing) {
  return standing.differences.empty() ? 0 : mean(standing.differences);
}

bool is_better(const Standing& left, const Standing& right) {
  const double of_left = mean_difference(left);
  const double of_right = mean_difference(right);
  // The comparison is lexicographic. Names break ties, so the order is always the same.
  return std::tuple(-left.points(), -of_left, left.team) <
         std::tuple(-right.points(), -of_right, right.team);
}

std::vector<Standing> ordered(const std::map<std::string, Standing>& by_team) {
  std::vector<Standing> standings;
  standings.reserve(by_team.size());
  for (const auto& [team, standing] : by_team) {
    standings.push_back(standing);
    standings.back().team = team;
  }
  std::sort(standings.begin(), standings.end(), is_better);
  int rank = 0;
  for (Standing& standing : standings) standing.rank = ++rank;
  return standings;
}

using StandingColumns = io::TableColumns<Standing>;

// The columns NAME, NAME_low95 and NAME_high95.
StandingColumns rating_columns(const std::string& name, Rating Standing::*rating) {
  const auto value = [rating](const Standing& standing) { return (standing.*rating).value; };
  const auto interval = [rating](const Standing& standing) { return (standing.*rating).interval; };
  return io::joined(StandingColumns{{name, value}},
                    interval_columns<Standing>(name + "_", interval));
}

StandingColumns record_columns(const StandingColumns& counts) {
  return io::joined(
      StandingColumns{{"rank", &Standing::rank},
                      {"team", &Standing::team, io::kInJson},
                      {"points", &Standing::points, io::kInJson},
                      {"games", &Standing::games, io::kInJson}},
      counts,
      StandingColumns{
          {"void_games", &Standing::void_games},
          {"goals_for", &Standing::goals_for, io::kInJson},
          {"goals_against", &Standing::goals_against, io::kInJson},
          {"mean_diff", [](const Standing& standing) { return mean_of(standing.differences); }},
          {"pairs", &Standing::pairs}},
      interval_columns<Standing>("diff_", [](const Standing& standing) {
        return mean_interval(standing.pair_differences);
      }));
}

StandingColumns standing_columns(bool with_ratings) {
  const StandingColumns counts = {{"wins", &Standing::wins, io::kInJson},
                                  {"draws", &Standing::draws, io::kInJson},
                                  {"losses", &Standing::losses, io::kInJson}};
  StandingColumns columns = record_columns(counts);
  if (with_ratings)
    columns = io::joined(columns, rating_columns("rating_goals", &Standing::goals),
                         rating_columns("bradley_terry", &Standing::strength));
  return io::joined(columns, share_columns(counts));
}

io::TableColumn<Standing> rating_text_column(const char* head, Rating Standing::*rating) {
  return {head, [=](const Standing& standing) {
            return mean_text((standing.*rating).value, (standing.*rating).interval);
          }};
}

StandingColumns standing_text_columns(bool with_ratings) {
  StandingColumns columns = {{"", &Standing::rank},
                             {"team", &Standing::team},
                             {"points", &Standing::points},
                             {kGamesHead, &Standing::games},
                             {"won", &Standing::wins},
                             {"drawn", &Standing::draws},
                             {"lost", &Standing::losses},
                             {"goals", [](const Standing& standing) {
                                return fmt::format("{}:{}", standing.goals_for,
                                                   standing.goals_against);
                              }}};
  if (with_ratings) {
    columns.push_back(rating_text_column(kGoalRatingHead, &Standing::goals));
    columns.push_back(rating_text_column(kStrengthHead, &Standing::strength));
    return columns;
  }
  columns.push_back({kGoalDifferenceHead, [](const Standing& standing) {
                       return difference_text(standing.differences, standing.pair_differences);
                     }});
  return columns;
}

io::TableColumns<Group> team_columns(const char* head_a, const char* head_b) {
  return {{head_a, [](const Group& matchup) { return matchup.values[0]; }},
          {head_b, [](const Group& matchup) { return matchup.values[1]; }}};
}

}  // namespace

std::vector<Group> grouped(const std::vector<Matchup>& matchups, const RowsById& rows) {
  std::vector<io::Cells> values;
  values.reserve(matchups.size());
  for (const Matchup& matchup : matchups) values.push_back({matchup.team_a, matchup.team_b});
  const auto teams_of = [](const GameRow& row) { return io::Cells{row.team_a, row.team_b}; };
  return grouped(values, teams_of, rows);
}

std::vector<Standing> standings_of(const std::vector<Group>& matchups) {
  std::map<std::string, Standing> by_team;
  for (const Group& matchup : matchups) {
    add_a(by_team[matchup.values[0]], matchup);
    add_b(by_team[matchup.values[1]], matchup);
  }
  rate(matchups, by_team);
  return ordered(by_team);
}

std::vector<Standing> standings_of_challengers(const std::vector<Group>& matchups) {
  std::map<std::string, Standing> by_team;
  for (const Group& matchup : matchups) add_a(by_team[matchup.values[0]], matchup);
  return ordered(by_team);
}

bool are_rated(const std::vector<Standing>& standings) {
  return !standings.empty() && standings.front().is_rated;
}

io::TableColumns<Group> matchup_columns() {
  return io::joined(team_columns("team_a", "team_b"), summary_columns(), result_columns());
}

std::string matchups_csv(const std::vector<Group>& matchups) {
  return io::csv_text(io::table_rows(matchup_columns(), matchups));
}

std::string standings_csv(const std::vector<Standing>& standings) {
  return io::csv_text(io::table_rows(standing_columns(are_rated(standings)), standings));
}

io::Json json_of(const std::vector<Standing>& standings) {
  const StandingColumns columns = standing_columns(are_rated(standings));
  io::Json all = io::Json::array();
  for (const Standing& standing : standings) {
    all.push_back(io::Json::object());
    io::add_members(all.back(), columns, standing);
  }
  return all;
}

std::vector<io::Cells> matchups_rows(const std::vector<Group>& matchups) {
  const io::TableColumns<Group> counts = {
      {"a won", &Group::wins_a}, {"drawn", &Group::draws}, {"b won", &Group::wins_b}};
  return io::table_rows(io::joined(team_columns("a", "b"), text_columns(), counts), matchups);
}

std::vector<io::Cells> standings_rows(const std::vector<Standing>& standings) {
  return io::table_rows(standing_text_columns(are_rated(standings)), standings);
}

io::TextTable matchups_table(const std::vector<Group>& matchups) {
  return without_void_games({matchups_rows(matchups), kMatchupsColumns, 2});
}

io::TextTable standings_table(const std::vector<Standing>& standings) {
  return {standings_rows(standings), kStandingsColumns, 2};
}

}  // namespace autoref::experiments
