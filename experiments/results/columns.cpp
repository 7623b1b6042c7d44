#include "experiments/results/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <mutex>
#include <set>
#include <string_view>
#include <utility>

#include "experiments/results/call_evaluation.hpp"
#include "game/play_counts/play_counts.hpp"
#include "io/checksum.hpp"
#include "io/words.hpp"
#include "soccer/named.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kLongestReason = 300;  // maximum number of characters

template <typename Integer>
bool read_integer(std::string_view cell, Integer& value, int base = 10) {
  const char* const end = cell.data() + cell.size();
  const auto [last, error] = std::from_chars(cell.data(), end, value, base);
  return error == std::errc() && last == end;
}

// `at` returns a reference to the row's member, which is const if the row is const.
template <typename At>
Column text_column(std::string name, At at) {
  return {std::move(name), [at](const GameRow& row) { return at(row); },
          [at](const std::string& cell, GameRow& row) {
            at(row) = cell;
            return true;
          }};
}

template <typename At>
Column integer_column(std::string name, At at) {
  return {std::move(name), [at](const GameRow& row) { return std::to_string(at(row)); },
          [at](const std::string& cell, GameRow& row) { return read_integer(cell, at(row)); }};
}

// A column with three decimals.
template <typename At>
Column number_column(std::string name, At at) {
  return {std::move(name), [at](const GameRow& row) { return fmt::format("{:.3f}", at(row)); },
          [at](const std::string& cell, GameRow& row) {
            const std::optional<double> number = io::number_in(cell);
            at(row) = number.value_or(0);
            return number.has_value();
          }};
}

template <typename At>
Column hash_column(std::string name, At at) {
  return {std::move(name), [at](const GameRow& row) { return io::hash_text(at(row)); },
          [at](const std::string& cell, GameRow& row) { return read_integer(cell, at(row), 16); }};
}

// An enumeration, by name.
template <typename At>
Column named_column(std::string name, At at) {
  return {std::move(name), [at](const GameRow& row) { return std::string(game::name_of(at(row))); },
          [at](const std::string& cell, GameRow& row) {
            const auto found = find_named<std::remove_reference_t<decltype(at(row))>>(cell);
            if (found) at(row) = *found;
            return found.has_value();
          }};
}

// The cell is empty if there was no shoot-out. Team a's cell is read first.
Column shootout_column(std::string name, std::size_t team) {
  return {std::move(name),
          [team](const GameRow& row) {
            const auto& shootout = row.record.shootout;
            return shootout ? std::to_string((*shootout)[team]) : std::string();
          },
          [team](const std::string& cell, GameRow& row) {
            auto& shootout = row.record.shootout;
            if (team == 0 && !cell.empty()) shootout.emplace();
            if (cell.empty() || !shootout) return cell.empty() && !shootout;
            return read_integer(cell, (*shootout)[team]);
          }};
}

Column first_half_column(std::string name, std::size_t team) {
  return {std::move(name),
          [team](const GameRow& row) {
            const auto& halves = row.record.goals_by_half;
            return std::to_string(halves.empty() ? 0 : halves.front()[team]);
          },
          [team](const std::string& cell, GameRow& row) {
            row.record.goals_by_half.resize(1);
            return read_integer(cell, row.record.goals_by_half.front()[team]);
          }};
}

// A derived column: its cell is only checked, so that a row that contradicts itself is refused.
Column difference_column(std::string name) {
  return {
      std::move(name),
      [](const GameRow& row) { return std::to_string(row.record.goals_a - row.record.goals_b); },
      [](const std::string& cell, GameRow& row) {
        return cell == std::to_string(row.record.goals_a - row.record.goals_b);
      }};
}

Column reason_column() {
  Column column = text_column(
      "void_reason", [](auto& row) -> auto& { return row.record.void_reason; });
  column.text = [](const GameRow& row) { return row.record.void_reason.substr(0, kLongestReason); };
  return column;
}

// A copy of the label that lives as long as the program. There are many labels in rows, but few
// different ones.
std::string_view kept_label(const std::string& label) {
  static std::mutex mutex;
  static std::set<std::string> labels;
  const std::lock_guard lock(mutex);
  return *labels.insert(label).first;
}

// Labels joined by '+', sorted, which makes the cell independent of the transitions' order.
Column transitions_column() {
  return {"transitions",
          [](const GameRow& row) {
            std::vector<std::string_view> labels = row.record.transitions;
            std::sort(labels.begin(), labels.end());
            return fmt::format("{}", fmt::join(labels, "+"));
          },
          [](const std::string& cell, GameRow& row) {
            row.record.transitions.clear();
            for (std::size_t begin = 0; begin < cell.size();) {
              const std::size_t end = std::min(cell.find('+', begin), cell.size());
              row.record.transitions.push_back(kept_label(cell.substr(begin, end - begin)));
              begin = end + 1;
            }
            return true;
          }};
}

// Adds a column per team, with the suffixes "_a" and "_b".
// `counts_of` returns the counts of one of the teams, of a row that may be const.
template <typename Counts, typename CountsOf>
void add_count_columns(std::vector<Column>& columns, const std::string& name,
                       const game::CountField<Counts>& field, CountsOf counts_of) {
  for (const std::size_t team : {0U, 1U}) {
    const std::string column = fmt::format("{}_{}", name, team == 0 ? 'a' : 'b');
    if (field.count != nullptr) {
      columns.push_back(integer_column(
          column, [ team, counts_of, member = field.count ](auto& row) -> auto& {
            return counts_of(row.record.counts[team]).*member;
          }));
    } else {
      columns.push_back(number_column(
          column, [ team, counts_of, member = field.number ](auto& row) -> auto& {
            return counts_of(row.record.counts[team]).*member;
          }));
    }
  }
}

// Columns such as shots_a, chains_corner_kick_a and worth_pass_a.
void add_team_columns(std::vector<Column>& columns) {
  for (const auto& field : game::count_fields()) {
    add_count_columns(
        columns, std::string(field.name), field, [](auto& team) -> auto& { return team; });
  }
  for (const auto& field : game::chain_count_fields()) {
    for (const game::ChainGroup& group : game::chain_groups()) {
      add_count_columns(
          columns, fmt::format("{}_{}", field.name, group.name),
          field, [&group](auto& team) -> auto& { return group.of(team); });
    }
  }
  for (const auto& field : game::action_count_fields()) {
    for (const Named<game::ActionKind>& kind : names_of(game::ActionKind{})) {
      add_count_columns(
          columns, fmt::format("{}_{}", field.name, kind.name),
          field, [value = kind.value](auto& team) -> auto& {
            return game::counts_of(team, value);
          });
    }
  }
}

Column status_column() {
  return named_column(
      "status", [](auto& row) -> auto& { return row.record.status; });
}

Column end_reason_column() {
  return named_column(
      "end_reason", [](auto& row) -> auto& { return row.record.end_reason; });
}

// The cell is empty if repeatability was not tested.
Column repeatable_column() {
  return {"repeatable",
          [](const GameRow& row) -> std::string {
            if (!row.record.is_repeatable) return "";
            return *row.record.is_repeatable ? "yes" : "no";
          },
          [](const std::string& cell, GameRow& row) {
            row.record.is_repeatable = std::nullopt;
            if (!cell.empty()) row.record.is_repeatable = cell == "yes";
            return cell.empty() || cell == "yes" || cell == "no";
          }};
}

Column side_column() {
  return named_column(
      "side_a", [](auto& row) -> auto& { return row.side_a; });
}

Column evaluation_column() {
  return {"evaluation", [](const GameRow& row) { return text_of(row.evaluation); },
          [](const std::string& cell, GameRow& row) {
            std::optional<CallEvaluation> evaluation = evaluation_in(cell);
            if (evaluation) row.evaluation = std::move(*evaluation);
            return evaluation.has_value();
          }};
}

std::vector<Column> played_columns() {
  std::vector<Column> columns = {
      integer_column(
          "goals_a", [](auto& row) -> auto& { return row.record.goals_a; }),
      integer_column(
          "goals_b", [](auto& row) -> auto& { return row.record.goals_b; }),
      difference_column("goal_diff"),
      first_half_column("first_half_goals_a", 0),
      first_half_column("first_half_goals_b", 1),
      end_reason_column(),
      status_column(),
      reason_column()};
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (!is_call(entry.event)) continue;
    columns.push_back(integer_column(
        fmt::format("calls_{}", entry.name),
        [index = static_cast<std::size_t>(entry.event)](auto& row) -> auto& {
          return row.record.events[index];
        }));
  }
  for (const game::GameTotal& one : game::game_totals()) {
    columns.push_back(integer_column(
        std::string(one.name), [member = one.count](auto& row) -> auto& {
          return row.record.*member;
        }));
  }
  add_team_columns(columns);
  columns.push_back(shootout_column("shootout_a", 0));
  columns.push_back(shootout_column("shootout_b", 1));
  columns.push_back(transitions_column());
  for (const game::MeasuredTime& time : game::measured_times()) {
    columns.push_back(number_column(
        std::string(time.name), [member = time.seconds](auto& row) -> auto& {
          return row.record.*member;
        }));
  }
  columns.push_back(integer_column(
      "frames", [](auto& row) -> auto& { return row.record.frames; }));
  return columns;
}

// The row's scene, which is created when the first of its columns is read.
game::SceneRecord& scene_of(GameRow& row) {
  if (!row.record.scene) row.record.scene.emplace();
  return *row.record.scene;
}
const game::SceneRecord& scene_of(const GameRow& row) {
  static const game::SceneRecord kNone;
  return row.record.scene ? *row.record.scene : kNone;
}

// A column with four decimals.
Column scene_number_column(std::string name, double game::SceneRecord::*member) {
  return {std::move(name),
          [member](const GameRow& row) { return fmt::format("{:.4f}", scene_of(row).*member); },
          [member](const std::string& cell, GameRow& row) {
            const std::optional<double> number = io::number_in(cell);
            scene_of(row).*member = number.value_or(0);
            return number.has_value();
          }};
}

Column ended_by_column() {
  return named_column(
      "ended_by", [](auto& row) -> auto& { return scene_of(row).ended_by; });
}

Column ball_kept_column() {
  return {"ball_kept",
          [](const GameRow& row) { return std::string(scene_of(row).ball_kept ? "1" : "0"); },
          [](const std::string& cell, GameRow& row) {
            scene_of(row).ball_kept = cell == "1";
            return cell == "0" || cell == "1";
          }};
}

void add_scene_columns(std::vector<Column>& columns) {
  columns.push_back(scene_number_column("score", &game::SceneRecord::score));
  columns.push_back(ended_by_column());
  columns.push_back(ball_kept_column());
  columns.push_back(scene_number_column("gained_m", &game::SceneRecord::gained_m));
}

std::vector<Column> judged_columns() {
  return {status_column(), reason_column(), transitions_column(), evaluation_column()};
}

}  // namespace

std::vector<Column> game_columns(const std::vector<std::string>& factors) {
  std::vector<Column> columns = {text_column(
                                     "game_id", [](auto& row) -> auto& { return row.game_id; }),
                                 integer_column(
                                     "pair", [](auto& row) -> auto& { return row.pair; }),
                                 integer_column(
                                     "leg", [](auto& row) -> auto& { return row.leg; })};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    columns.push_back(text_column(
        factors[i], [i](auto& row) -> auto& { return row.values[i]; }));
  }
  columns.push_back(text_column(
      "team_a", [](auto& row) -> auto& { return row.team_a; }));
  columns.push_back(text_column(
      "team_b", [](auto& row) -> auto& { return row.team_b; }));
  columns.push_back(side_column());
  columns.push_back(integer_column(
      "seed", [](auto& row) -> auto& { return row.seed; }));
  columns.push_back(text_column(
      "rule_changes", [](auto& row) -> auto& { return row.rule_changes; }));
  return columns;
}

std::vector<Column> outcome_columns(RowKind kind) {
  std::vector<Column> columns = kind == RowKind::kJudged ? judged_columns() : played_columns();
  if (kind == RowKind::kScene) add_scene_columns(columns);
  columns.push_back(hash_column(
      "state_hash", [](auto& row) -> auto& { return row.record.state_hash; }));
  columns.push_back(hash_column(
      "config_hash", [](auto& row) -> auto& { return row.config_hash; }));
  return columns;
}

std::vector<Column> circumstance_columns() {
  return {text_column(
              "build", [](auto& row) -> auto& { return row.circumstances.build; }),
          text_column(
              "host", [](auto& row) -> auto& { return row.circumstances.host; }),
          text_column(
              "cpu", [](auto& row) -> auto& { return row.circumstances.cpu; }),
          repeatable_column(),
          number_column(
              "wall_s", [](auto& row) -> auto& { return row.circumstances.wall_s; }),
          integer_column(
              "attempt", [](auto& row) -> auto& { return row.circumstances.attempt; }),
          text_column(
              "shard", [](auto& row) -> auto& { return row.circumstances.shard; })};
}

}  // namespace autoref::experiments
