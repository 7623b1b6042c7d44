#include "runner/results/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "referee/machine/machine.hpp"
#include "runner/io/checksum.hpp"
#include "runner/io/csv.hpp"
#include "runner/io/words.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

constexpr std::size_t kLongestReason = 300;  // characters

std::string first_half_goals(const GameRecord& record, std::size_t team) {
  return std::to_string(record.goals_by_half.empty() ? 0 : record.goals_by_half.front()[team]);
}

// Empty where there was no shoot-out.
std::string shootout_goals(const GameRecord& record, std::size_t team) {
  return record.shootout ? std::to_string((*record.shootout)[team]) : "";
}

// Sorted, so that the order in which the transitions came does not matter.
std::string transitions_cell(const GameRecord& record) {
  std::vector<std::string_view> labels = record.transitions;
  std::sort(labels.begin(), labels.end());
  return fmt::format("{}", fmt::join(labels, "+"));
}

}  // namespace

void append(Cells& cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

RowFormat::RowFormat(const std::vector<std::string>& factors)
    : RowFormat(factors, outcome_columns()) {}

RowFormat::RowFormat(const std::vector<std::string>& factors, const Cells& outcome)
    : columns_({"game_id", "pair", "leg"}) {
  append(columns_, factors);
  append(columns_, {"team_a", "team_b", "side_a", "seed"});
  first_outcome_ = columns_.size();
  append(columns_, outcome);
  columns_.emplace_back("config_hash");
  reproducible_ = columns_.size();
  append(columns_, {"build", "host", "cpu", "wall_s", "attempt", "shard", "row_crc"});
}

std::size_t RowFormat::column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  assert(found != columns_.end());
  return static_cast<std::size_t>(found - columns_.begin());
}

std::string RowFormat::line(const ScheduledGame& game, const Cells& outcome,
                            const Circumstances& circumstances) const {
  const GameConfiguration& c = game.configuration;
  Cells cells = {game.id, std::to_string(game.pair), std::to_string(game.leg)};
  append(cells, game.values);
  append(cells,
         {game.team_a, game.team_b, std::string(name_of(c.match.a_plays)), std::to_string(c.seed)});
  append(cells, outcome);
  cells.push_back(hash_text(configuration_hash(c)));
  append(cells, {circumstances.build, circumstances.host, circumstances.cpu,
                 fmt::format("{:.3f}", circumstances.wall_s), std::to_string(circumstances.attempt),
                 circumstances.shard});
  assert(cells.size() + 1 == columns_.size());
  std::string line = csv_line(cells);
  return line + "," + crc_text(line);
}

std::optional<Cells> RowFormat::read(std::string_view line) const {
  const std::size_t comma = line.rfind(',');
  if (comma == std::string_view::npos) return std::nullopt;
  if (line.substr(comma + 1) != crc_text(line.substr(0, comma))) return std::nullopt;
  std::optional<Cells> cells = csv_cells(line);
  const bool is_whole = cells && cells->size() == columns_.size() && has_scores(*cells);
  return is_whole ? cells : std::nullopt;
}

// Results rely on these cells being numbers.
bool RowFormat::has_scores(const Cells& cells) const {
  for (std::size_t i = first_outcome_; i < reproducible_; ++i) {
    const std::string& name = columns_[i];
    const bool is_goals = name == "goals_a" || name == "goals_b" || name == "goal_diff";
    const bool is_shootout = name == "shootout_a" || name == "shootout_b";
    if (!is_goals && !(is_shootout && !cells[i].empty())) continue;
    if (!number_in(cells[i])) return false;
  }
  return true;
}

Cells RowFormat::reproducible(const Cells& cells) const {
  return {cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(reproducible_)};
}

Cells outcome_columns() {
  Cells columns = {
      "goals_a",    "goals_b", "goal_diff",  "first_half_goals_a", "first_half_goals_b",
      "end_reason", "status",  "void_reason"};
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (is_call(entry.event)) columns.push_back(fmt::format("calls_{}", entry.name));
  }
  for (const NamedCount& count : named(GameRecord{}.counts)) columns.push_back(count.name);
  append(columns, {"shootout_a", "shootout_b", "transitions", "ball_in_play_s", "sim_s", "frames",
                   "state_hash"});
  return columns;
}

Cells evaluation_columns() { return {"status", "void_reason", "state_hash", "evaluation"}; }

Cells outcome_of(const GameRecord& record) {
  Cells cells = {std::to_string(record.goals_a),
                 std::to_string(record.goals_b),
                 std::to_string(record.goals_a - record.goals_b),
                 first_half_goals(record, 0),
                 first_half_goals(record, 1),
                 std::string(name_of(record.end_reason)),
                 std::string(name_of(record.status)),
                 record.void_reason.substr(0, kLongestReason)};
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (is_call(entry.event)) cells.push_back(std::to_string(record.count(entry.event)));
  }
  for (const NamedCount& count : named(record.counts)) cells.push_back(count.value);
  append(cells, {shootout_goals(record, 0), shootout_goals(record, 1), transitions_cell(record),
                 fmt::format("{:.3f}", record.ball_in_play_s), fmt::format("{:.3f}", record.sim_s),
                 std::to_string(record.frames), hash_text(record.state_hash)});
  return cells;
}

std::vector<std::string> transitions_never_used(const RowFormat& format,
                                                const std::vector<Cells>& rows) {
  const std::size_t transitions = format.column("transitions");
  const auto takes = [transitions](std::string_view label) {
    return [=](const Cells& row) {
      return fmt::format("+{}+", row[transitions]).find(fmt::format("+{}+", label)) !=
             std::string::npos;
    };
  };
  std::vector<std::string> never;
  for (const auto& part :
       {referee::transitions_in_figure(), referee::transitions_outside_figure()}) {
    for (const referee::Transition& transition : part) {
      if (std::none_of(rows.begin(), rows.end(), takes(transition.label))) {
        never.emplace_back(transition.label);
      }
    }
  }
  return never;
}

}  // namespace autoref::runner
