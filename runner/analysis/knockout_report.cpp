#include "runner/analysis/knockout_report.hpp"

#include <fmt/format.h>

#include "runner/io/csv.hpp"
#include "runner/io/table.hpp"
#include "runner/results/scores.hpp"

namespace autoref::runner {
namespace {

struct Score {
  std::string a, b;                    // goals; empty where no game counts
  std::string shootout_a, shootout_b;  // empty where there was none
};

Score score_of(const Tie& tie, const RowFormat& format, const RowsById& rows) {
  const ScoreColumns at(format);
  Score score;
  for (const std::string& game : tie.games) {
    const Cells& row = rows.at(game);
    if (is_void(row, at)) continue;
    score = {row[at.goals_a], row[at.goals_b], row[at.shootout_a], row[at.shootout_b]};
  }
  return score;
}

std::string winner_of(const Tie& tie) {
  if (!tie.is_decided()) return "";
  return tie.a_won ? *tie.a : *tie.b;
}

// "3:1", "1:1 (4:2)" with a shoot-out, "void" where no game counts, "-" before any.
std::string text_of(const Score& score, const Tie& tie) {
  if (tie.games.empty()) return "-";
  if (score.a.empty()) return "void";
  std::string goals = fmt::format("{}:{}", score.a, score.b);
  if (score.shootout_a.empty()) return goals;
  return fmt::format("{} ({}:{})", goals, score.shootout_a, score.shootout_b);
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

std::string ties_csv(const std::vector<Tie>& ties, const RowFormat& format, const RowsById& rows) {
  std::string csv =
      csv_line({"tie", "round", "team_a", "team_b", "goals_a", "goals_b", "shootout_a",
                "shootout_b", "games", "void_games", "decided_by", "winner"}) +
      "\n";
  for (const Tie& tie : ties) {
    const Score score = score_of(tie, format, rows);
    csv += csv_line({std::to_string(tie.number), tie.name, tie.a.value_or(""), tie.b.value_or(""),
                     score.a, score.b, score.shootout_a, score.shootout_b,
                     std::to_string(tie.games.size()), std::to_string(tie.void_games),
                     name_of(tie.decided_by), winner_of(tie)}) +
           "\n";
  }
  return csv;
}

std::vector<Cells> bracket_rows(const std::vector<Tie>& ties, const RowFormat& format,
                                const RowsById& rows) {
  std::vector<Cells> lines = {{"", "a", "", "b", "goes on", "decided by"}};
  for (const Tie& tie : ties) {
    lines.push_back({tie.name, tie.a.value_or("?"), text_of(score_of(tie, format, rows), tie),
                     tie.b.value_or("?"), winner_of(tie), decision_text(tie)});
  }
  return lines;
}

std::string bracket_table(const std::vector<Tie>& ties, const RowFormat& format,
                          const RowsById& rows) {
  std::string champion;
  for (const Tie& tie : ties) {
    if (tie.name == "final") champion = winner_of(tie);
  }
  const std::string table = aligned(bracket_rows(ties, format, rows), kBracketColumns);
  return champion.empty() ? table : table + fmt::format("\nthe winner is {}\n", champion);
}

}  // namespace autoref::runner
