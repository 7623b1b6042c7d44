#include "runner/results/game_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/io/checksum.hpp"
#include "runner/io/json.hpp"
#include "runner/results/game_row.hpp"
#include "soccer/colour.hpp"

namespace autoref::runner {
namespace {

double x_real_time(const GameReport& report) {
  return report.wall_s > 0 ? report.record.sim_s / report.wall_s : 0;
}

std::string calls_json(const GameRecord& record) {
  JsonObject calls;
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (is_call(entry.event)) calls.add(entry.name, std::to_string(record.count(entry.event)));
  }
  return calls.text();
}

// "24 throw in, 3 goal": what occurred, spelt for people.
std::string calls_text(const GameRecord& record) {
  std::string text;
  for (const referee::EventEntry& entry : referee::event_table()) {
    const int count = record.count(entry.event);
    if (!is_call(entry.event) || count == 0) continue;
    std::string name(entry.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  }
  return text.empty() ? "none" : text;
}

std::string halves_text(const GameRecord& record) {
  std::string text;
  for (const std::array<int, 2>& goals : record.goals_by_half) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", goals[0], goals[1]);
  }
  return text;
}

std::string line_of(std::string_view what, const std::string& a, const std::string& b) {
  return fmt::format("\n{:16}{:>7}{:>7}", what, a, b);
}

// A line per figure, a column per team.
std::string counts_text(const GameRecord& record) {
  const auto& [a, b] = record.counts;
  const auto count = [&a = a, &b = b](std::string_view what, int PlayCounts::*member) {
    return line_of(what, std::to_string(a.*member), std::to_string(b.*member));
  };
  const auto share = [&](const PlayCounts& team) {
    const double in_play_s = std::max(record.ball_in_play_s, 1e-9);
    return fmt::format("{:.0f} %", 100 * team.possession_s / in_play_s);
  };
  return line_of("", "a", "b") + count("shots", &PlayCounts::shots) +
         count("  on goal", &PlayCounts::shots_on_goal) +
         count("passes tried", &PlayCounts::passes_tried) +
         count("  completed", &PlayCounts::passes_completed) +
         line_of("possession", share(a), share(b)) + count("fouls", &PlayCounts::fouls) +
         count("duels won", &PlayCounts::duels_won);
}

std::string shootout_json(const GameRecord& record) {
  if (!record.shootout) return "null";
  const auto& [a, b] = *record.shootout;
  return json_list({std::to_string(a), std::to_string(b)});
}

std::string team_json(const GameConfiguration& game, Side side) {
  return JsonObject()
      .add("name", json_text(shown_names(game)[side]))
      .add("strategy", json_text(team_on(game, side).strategy))
      .add("colour", json_text(colour_of(side)))
      .add("side", json_text(name_of(side)))
      .text();
}

std::string teams_json(const GameConfiguration& game) {
  const Side a = game.match.a_plays;
  return JsonObject().add("a", team_json(game, a)).add("b", team_json(game, opponent_of(a))).text();
}

}  // namespace

std::string json_of(const GameReport& report) {
  const GameRecord& record = report.record;
  std::vector<std::string> halves;
  for (const std::array<int, 2>& goals : record.goals_by_half) {
    halves.push_back(json_list({std::to_string(goals[0]), std::to_string(goals[1])}));
  }
  JsonObject json;
  json.add("goals_a", std::to_string(record.goals_a))
      .add("goals_b", std::to_string(record.goals_b))
      .add("goals_by_half", json_list(halves))
      .add("end_reason", json_text(name_of(record.end_reason)))
      .add("shootout", shootout_json(record))
      .add("status", json_text(name_of(record.status)))
      .add("void_reason", record.void_reason.empty() ? "null" : json_text(record.void_reason))
      .add("rules", json_text(report.configuration.match.rules.name))
      .add("seed", std::to_string(report.configuration.seed))
      .add("teams", teams_json(report.configuration))
      .add("calls", calls_json(record));
  for (const NamedCount& member : named(record.counts)) json.add(member.name, member.value);
  return json.add("ball_in_play_s", json_number(record.ball_in_play_s))
      .add("sim_s", json_number(record.sim_s))
      .add("wall_s", json_number(report.wall_s))
      .add("x_real_time", json_number(x_real_time(report)))
      .add("state_hash", json_text(hash_text(record.state_hash)))
      .add("build", json_text(report.build))
      .text();
}

std::string text_of(const GameReport& report) {
  const GameConfiguration& game = report.configuration;
  const GameRecord& record = report.record;
  const Side a = game.match.a_plays;
  std::string text =
      fmt::format("a ({}, {})  {} : {}  b ({}, {})", game.a.strategy, name_of(a), record.goals_a,
                  record.goals_b, game.b.strategy, name_of(opponent_of(a)));
  if (!record.goals_by_half.empty()) text += fmt::format("   halves {}", halves_text(record));
  if (record.shootout) {
    text += fmt::format("   shoot-out {}:{}", (*record.shootout)[0], (*record.shootout)[1]);
  }
  if (record.status == Status::kVoid) text += fmt::format("\nvoid: {}", record.void_reason);
  text += fmt::format("\ncalls: {}", calls_text(record));
  text += counts_text(record);
  text += fmt::format("\n{:.0f} s played, ball in play {:.0f} s; took {:.2f} s, {:.0f} x real time",
                      record.sim_s, record.ball_in_play_s, report.wall_s, x_real_time(report));
  return text + fmt::format("\nstate {}   build {}", hash_text(record.state_hash), report.build);
}

}  // namespace autoref::runner
