#include "runner/analysis/knockout_report.hpp"

#include <fmt/format.h>

#include "runner/io/csv.hpp"
#include "runner/io/table.hpp"
#include "runner/results/scores.hpp"

namespace autoref::runner {
namespace {

// The last game of the tie that is not void; null if there is none.
const GameRecord* deciding_game(const Tie& tie, const RowsById& rows) {
  const GameRecord* last = nullptr;
  for (const std::string& game : tie.games) {
    const GameRecord& record = rows.at(game).record;
    if (!is_void(record)) last = &record;
  }
  return last;
}

// Goals of both teams, then those of the shoot-out; cells are empty if there was no game or
// shoot-out.
Cells score_cells(const GameRecord* game) {
  if (game == nullptr) return {"", "", "", ""};
  Cells cells = {std::to_string(game->goals_a), std::to_string(game->goals_b), "", ""};
  if (!game->shootout) return cells;
  cells[2] = std::to_string((*game->shootout)[0]);
  cells[3] = std::to_string((*game->shootout)[1]);
  return cells;
}

std::string winner_of(const Tie& tie) {
  if (!tie.is_decided()) return "";
  return tie.a_won ? *tie.a : *tie.b;
}

// "3:1", "1:1 (4:2)" with a shoot-out, "void" if all games were void, "-" before the first game.
std::string score_text(const Tie& tie, const RowsById& rows) {
  if (tie.games.empty()) return "-";
  const GameRecord* const game = deciding_game(tie, rows);
  if (game == nullptr) return "void";
  std::string goals = fmt::format("{}:{}", game->goals_a, game->goals_b);
  if (!game->shootout) return goals;
  return fmt::format("{} ({}:{})", goals, (*game->shootout)[0], (*game->shootout)[1]);
}

// "extra time", "goals in game 3", "better seed after 6 games, 1 void".
std::string decision_text(const Tie& tie) {
  const std::size_t games = tie.games.size();
  if (!tie.is_decided()) return games == 0 ? "" : fmt::format("drawn {} times so far", games);
  std::string text = name_of(tie.decided_by);
  if (tie.decided_by == DecidedBy::kSeed)
    text += fmt::format(" after {} games", games);
  else if (games > 1)
    text += fmt::format(" in game {}", games);
  return tie.void_games == 0 ? text : text + fmt::format(", {} void", tie.void_games);
}

}  // namespace

std::string ties_csv(const std::vector<Tie>& ties, const RowsById& rows) {
  std::string csv =
      csv_line({"tie", "round", "team_a", "team_b", "goals_a", "goals_b", "shootout_a",
                "shootout_b", "games", "void_games", "decided_by", "winner"}) +
      "\n";
  for (const Tie& tie : ties) {
    Cells cells = {std::to_string(tie.number), tie.name, tie.a.value_or(""), tie.b.value_or("")};
    append(cells, score_cells(deciding_game(tie, rows)));
    append(cells, {std::to_string(tie.games.size()), std::to_string(tie.void_games),
                   name_of(tie.decided_by), winner_of(tie)});
    csv += csv_line(cells) + "\n";
  }
  return csv;
}

std::vector<Cells> bracket_rows(const std::vector<Tie>& ties, const RowsById& rows) {
  std::vector<Cells> lines = {{"", "a", "", "b", "winner", "decided by"}};
  for (const Tie& tie : ties) {
    lines.push_back({tie.name, tie.a.value_or("?"), score_text(tie, rows), tie.b.value_or("?"),
                     winner_of(tie), decision_text(tie)});
  }
  return lines;
}

TextBlocks bracket_table(const std::vector<Tie>& ties, const RowsById& rows) {
  std::string champion;
  for (const Tie& tie : ties) {
    if (tie.name == "final") champion = winner_of(tie);
  }
  TextBlocks blocks = {TextTable{bracket_rows(ties, rows), kBracketColumns}};
  if (!champion.empty()) blocks.emplace_back(fmt::format("\nthe winner is {}\n", champion));
  return blocks;
}

}  // namespace autoref::runner
