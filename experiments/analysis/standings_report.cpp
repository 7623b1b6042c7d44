#include "experiments/analysis/standings_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/statistics/mean_interval.hpp"

namespace autoref::experiments {
namespace {

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
