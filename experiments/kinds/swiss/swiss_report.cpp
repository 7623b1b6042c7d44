#include "experiments/kinds/swiss/swiss_report.hpp"

#include <fmt/format.h>

#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

// A meeting, or the bye of `meeting.teams.team_a`.
struct RoundRow {
  int round = 1;  // from 1
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

std::string rounds_csv(const SwissRounds& played) {
  return io::csv_text(io::table_rows(csv_columns(), round_rows(played)));
}

void add_rounds(ExperimentResults& results, const SwissRounds& played) {
  results.files.push_back({"rounds.csv", "a row per meeting", rounds_csv(played)});
  results.table.insert(results.table.begin(), {rounds_table(round_rows(played)), "\n"});
  if (played.byes.empty()) return;
  results.table.emplace_back(
      fmt::format("\nA bye counts {} points, as many as winning all games of a meeting.\n",
                  played.points_of_bye));
}

}  // namespace autoref::experiments
