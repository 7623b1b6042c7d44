#include "experiments/kinds/knockout/knockout_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/results/game_row.hpp"
#include "io/csv.hpp"
#include "io/table.hpp"

namespace autoref::experiments {
namespace {

// The last game of the tie that is not void; null if there is none.
const game::GameRecord* deciding_game(const Tie& tie, const RowsById& rows) {
  const game::GameRecord* last = nullptr;
  for (const std::string& game : tie.games) {
    const game::GameRecord& record = rows.at(game).record;
    if (!is_void(record)) last = &record;
  }
  return last;
}

// Goals of both teams in the game, then in the shoot-out; cells are empty if there was no game or
// shoot-out.
io::Cells score_cells(const game::GameRecord* game) {
  if (game == nullptr) return {"", "", "", ""};
  io::Cells cells = {std::to_string(game->goals_a), std::to_string(game->goals_b), "", ""};
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
std::string tie_score(const Tie& tie, const RowsById& rows) {
  if (tie.games.empty()) return "-";
  const game::GameRecord* const game = deciding_game(tie, rows);
  return game == nullptr ? "void" : score_text(*game);
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

// The name of the tie at this place; "" for a bye.
std::string tie_at(const BracketPlace& place, const std::vector<Tie>& ties) {
  const auto tie = std::find_if(ties.begin(), ties.end(),
                                [&place](const Tie& one) { return one.place == place; });
  return tie == ties.end() ? "" : tie->name;
}

// Where an unknown team will come from; `side` is 0 for the tie's first team, 1 for its second.
std::string origin_of(const Tie& tie, std::size_t side, const std::vector<Tie>& ties) {
  if (!tie.place) return fmt::format("loser of semi-final {}", side + 1);
  const auto& [ties_in_round, position] = *tie.place;
  return "winner of " + tie_at({2 * ties_in_round, 2 * position + side}, ties);
}

std::array<std::string, 2> goals_texts(const io::Cells& scores) {
  std::array<std::string, 2> texts = {scores[0], scores[1]};
  if (scores[2].empty()) return texts;
  for (std::size_t side = 0; side < 2; ++side) texts[side] += " (" + scores[2 + side] + ")";
  return texts;
}

TieResult tie_result(const Tie& tie, const std::vector<Tie>& ties, const RowsById& rows) {
  const std::string decision = decision_text(tie);
  TieResult result{tie.name, tie.place, {}, decision, decision == name_of(DecidedBy::kGoals)};
  const std::array<std::string, 2> goals = goals_texts(score_cells(deciding_game(tie, rows)));
  for (std::size_t side = 0; side < 2; ++side) {
    const std::optional<std::string>& name = side == 0 ? tie.a : tie.b;
    result.teams[side] = {name ? *name : origin_of(tie, side, ties), name.has_value(), goals[side],
                          tie.is_decided() && tie.a_won == (side == 0)};
  }
  return result;
}

io::Json name_json(const std::optional<std::string>& name) {
  return name ? io::Json(*name) : io::Json();
}

std::optional<std::string> winner_in(const Tie& tie) {
  return tie.is_decided() ? (tie.a_won ? tie.a : tie.b) : std::nullopt;
}

}  // namespace

std::string ties_csv(const std::vector<Tie>& ties, const RowsById& rows) {
  std::string csv =
      io::csv_line({"tie", "round", "team_a", "team_b", "goals_a", "goals_b", "shootout_a",
                    "shootout_b", "games", "void_games", "decided_by", "winner"}) +
      "\n";
  for (const Tie& tie : ties) {
    io::Cells cells = {std::to_string(tie.number), tie.name, tie.a.value_or(""),
                       tie.b.value_or("")};
    io::append(cells, score_cells(deciding_game(tie, rows)));
    io::append(cells, {std::to_string(tie.games.size()), std::to_string(tie.void_games),
                       name_of(tie.decided_by), winner_of(tie)});
    csv += io::csv_line(cells) + "\n";
  }
  return csv;
}

std::vector<io::Cells> bracket_rows(const std::vector<Tie>& ties, const RowsById& rows) {
  std::vector<io::Cells> lines = {{"", "a", "", "b", "winner", "decided by"}};
  for (const Tie& tie : ties) {
    lines.push_back({tie.name, tie.a.value_or("?"), tie_score(tie, rows), tie.b.value_or("?"),
                     winner_of(tie), decision_text(tie)});
  }
  return lines;
}

std::vector<TieResult> tie_results(const std::vector<Tie>& ties, const RowsById& rows) {
  std::vector<TieResult> results;
  results.reserve(ties.size());
  for (const Tie& tie : ties) results.push_back(tie_result(tie, ties, rows));
  return results;
}

io::Json json_of(const std::vector<Tie>& ties) {
  io::Json all = io::Json::array();
  for (const Tie& tie : ties) {
    all.push_back({{"tie", tie.name},
                   {"team_a", name_json(tie.a)},
                   {"team_b", name_json(tie.b)},
                   {"games", tie.games.size()},
                   {"decided_by", name_of(tie.decided_by)},
                   {"winner", name_json(winner_in(tie))}});
  }
  return all;
}

io::TextBlocks bracket_table(const std::vector<Tie>& ties, const RowsById& rows) {
  std::string champion;
  for (const Tie& tie : ties) {
    if (tie.name == "final") champion = winner_of(tie);
  }
  io::TextBlocks blocks = {io::TextTable{bracket_rows(ties, rows), kBracketColumns}};
  if (!champion.empty()) blocks.emplace_back(fmt::format("\nthe winner is {}\n", champion));
  return blocks;
}

}  // namespace autoref::experiments
