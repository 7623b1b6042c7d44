#include "experiments/results/row_format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "experiments/kinds/sweep/sweep.hpp"
#include "game/settings/game_settings.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

const RowFormat kFormat({"b.robots"});

GameRow sample_row() {
  const ScheduledGame game = small_sweep().as<Sweep>()->games().front();
  GameRow row = row_of(game);
  row.record = fake_game(game::resolved(game.settings.combined()));
  row.circumstances = {.build = "build",
                       .host = "host",
                       .cpu = "A, \"fast\" CPU",
                       .wall_s = 1.5,
                       .attempt = 2,
                       .shard = "0/1"};
  return row;
}

// A row with a value other than the default in every column.
GameRow full_row() {
  GameRow row = sample_row();
  game::GameRecord& record = row.record;
  record.shootout = {4, 2};
  record.end_reason = game::EndReason::kForfeitB;
  record.status = game::Status::kForfeit;
  record.void_reason = "no robots";
  for (std::size_t i = 0; i < record.events.size(); ++i) record.events[i] = static_cast<int>(i + 1);
  for (const int team : {0, 1}) {
    int next = 20 * team;
    for (const auto& field : game::count_fields()) {
      if (field.count != nullptr) record.counts[team].*field.count = ++next;
      if (field.number != nullptr) record.counts[team].*field.number = ++next + 0.25;
    }
    for (const auto& field : game::action_count_fields()) {
      for (game::ActionCounts& counts : record.counts[team].by_action) {
        if (field.count != nullptr) counts.*field.count = ++next;
        if (field.number != nullptr) counts.*field.number = ++next - 0.5;
      }
    }
    for (const auto& field : game::chain_count_fields()) {
      for (const game::ChainGroup& group : game::chain_groups()) {
        game::ChainCounts& counts = group.of(record.counts[team]);
        if (field.count != nullptr) counts.*field.count = ++next;
        if (field.number != nullptr) counts.*field.number = ++next + 0.75;
      }
    }
  }
  int next_count = 60;
  for (const game::GameTotal& one : game::game_totals()) record.*one.count = ++next_count;
  record.transitions = {"begin", "goal", "start"};
  double time_s = 700.125;
  for (const game::MeasuredTime& time : game::measured_times()) record.*time.seconds = time_s++;
  row.side_a = Side::kEast;
  row.rule_changes = "double touch 150 mm (50); offside yes (no)";
  return row;
}

// The row's cells by column name.
std::map<std::string, std::string> cells_by_name(const GameRow& row) {
  const io::Cells names = kFormat.names();
  const io::Cells cells = io::csv_cells(kFormat.line(row)).value();
  std::map<std::string, std::string> by_name;
  for (std::size_t i = 0; i < names.size(); ++i) by_name[names[i]] = cells.at(i);
  return by_name;
}

TEST(Csv, QuotesCellsWithCommasOrQuotes) {
  const std::vector<std::string> cells = {"plain", "a,b", "say \"hi\"", ""};
  EXPECT_EQ(io::csv_line(cells), "plain,\"a,b\",\"say \"\"hi\"\"\",");
  EXPECT_EQ(io::csv_cells(io::csv_line(cells)), cells);
}

TEST(Csv, KeepsARowOnOneLine) { EXPECT_EQ(io::csv_line({"a\nb"}), "\"a b\""); }

TEST(Csv, RefusesUnbalancedQuotes) {
  for (const char* line : {"\"a", "a\"b", "\"a\"b"}) EXPECT_FALSE(io::csv_cells(line)) << line;
}

TEST(RowFormat, HasTheColumnsOfAGameWithTheChecksumLast) {
  const std::string head = io::csv_line(kFormat.names());
  EXPECT_TRUE(head.starts_with(
      "game_id,pair,leg,b.robots,team_a,team_b,side_a,seed,rule_changes,goals_a,goals_b,"
      "goal_diff,first_half_goals_a,first_half_goals_b,end_reason,status,"
      "void_reason,calls_goal,"));
  EXPECT_TRUE(head.ends_with(
      ",ball_in_play_s,sim_s,frames,state_hash,config_hash,build,host,cpu,repeatable,"
      "wall_s,attempt,shard,row_crc"));
}

TEST(RowFormat, HasBothTeamsPlayCounts) {
  GameRow row = sample_row();
  row.record.counts[0] = {.shots = 12,
                          .shots_on_goal = 7,
                          .passes_tried = 30,
                          .passes_completed = 21,
                          .possession_s = 301.25,
                          .fouls = 3,
                          .duels_won = 5};
  row.record.counts[1] = {.shots = 8,
                          .shots_on_goal = 2,
                          .passes_tried = 25,
                          .passes_completed = 9,
                          .possession_s = 200.5,
                          .fouls = 4,
                          .duels_won = 6};
  std::map<std::string, std::string> cells = cells_by_name(row);
  const io::Cells names = {"shots",        "shots_on_goal", "passes_tried", "passes_completed",
                           "possession_s", "fouls",         "duels_won"};
  const io::Cells of_a = {"12", "7", "30", "21", "301.250", "3", "5"};
  const io::Cells of_b = {"8", "2", "25", "9", "200.500", "4", "6"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(cells[names[i] + "_a"], of_a[i]) << names[i];
    EXPECT_EQ(cells[names[i] + "_b"], of_b[i]) << names[i];
  }
}

TEST(RowFormat, HasTheCountsOfPossessionChains) {
  GameRow row = sample_row();
  constexpr auto kCorner = static_cast<std::size_t>(game::ChainStart::kCornerKick);
  row.record.counts[0].by_start[kCorner] = {.chains = 9, .shots = 4, .goals = 2};
  row.record.counts[1].with_pass = {.chains = 8, .shots = 3, .goals = 1};
  std::map<std::string, std::string> cells = cells_by_name(row);
  EXPECT_EQ(cells["chains_corner_kick_a"], "9");
  EXPECT_EQ(cells["shots_corner_kick_a"], "4");
  EXPECT_EQ(cells["goals_corner_kick_a"], "2");
  EXPECT_EQ(cells["goals_corner_kick_b"], "0");
  EXPECT_EQ(cells["chains_with_pass_b"], "8");
  EXPECT_EQ(cells["goals_with_pass_b"], "1");
}

TEST(RowFormat, ReadsBackEveryColumn) {
  const GameRow row = full_row();
  const std::optional<GameRow> read = kFormat.read(kFormat.line(row));
  ASSERT_TRUE(read);
  EXPECT_EQ(kFormat.line(*read), kFormat.line(row));
}

TEST(RowFormat, ReadsBackTypedValues) {
  const GameRow row = full_row();
  const GameRow read = kFormat.read(kFormat.line(row)).value();
  EXPECT_EQ(read.values, row.values);
  EXPECT_EQ(read.side_a, Side::kEast);
  EXPECT_EQ(read.seed, row.seed);
  EXPECT_EQ(read.config_hash, row.config_hash);
  EXPECT_EQ(read.record.goals_b, row.record.goals_b);
  EXPECT_EQ(read.record.goals_by_half.front(), row.record.goals_by_half.front());
  EXPECT_EQ(read.record.shootout, row.record.shootout);
  EXPECT_EQ(read.record.end_reason, game::EndReason::kForfeitB);
  EXPECT_EQ(read.record.status, game::Status::kForfeit);
  EXPECT_EQ(read.record.counts, row.record.counts);
  EXPECT_EQ(read.rule_changes, row.rule_changes);
  for (const game::GameTotal& one : game::game_totals())
    EXPECT_EQ(read.record.*one.count, row.record.*one.count) << one.name;
  for (const game::MeasuredTime& time : game::measured_times())
    EXPECT_DOUBLE_EQ(read.record.*time.seconds, row.record.*time.seconds) << time.name;
  EXPECT_EQ(read.record.transitions, row.record.transitions);
  EXPECT_EQ(read.record.state_hash, row.record.state_hash);
  EXPECT_EQ(read.circumstances.cpu, "A, \"fast\" CPU");
  EXPECT_EQ(read.circumstances.attempt, 2);
}

TEST(RuleNotes, SayWhichRulesAreNotTheOfficialOnes) {
  GameRow official = sample_row();
  GameRow other = official;
  other.rule_changes = "double touch 150 mm (50)";
  EXPECT_EQ(rule_notes({{"1", official}, {"2", official}}), std::vector<std::string>{});
  EXPECT_EQ(rule_notes({{"1", other}, {"2", other}}),
            std::vector<std::string>{"not the official rules: double touch 150 mm (50)"});
  EXPECT_EQ(
      rule_notes({{"1", other}, {"2", official}}),
      std::vector<std::string>{"1 of 2 games: not the official rules: double touch 150 mm (50)"});
}

TEST(RowFormat, KeepsAReasonOnOneLine) {
  GameRow row = sample_row();
  row.record.void_reason = "team a threw: \"x\", then\nmore";
  EXPECT_EQ(kFormat.read(kFormat.line(row))->record.void_reason, "team a threw: \"x\", then more");
}

TEST(RowFormat, SortsTransitions) {
  GameRow row = sample_row();
  row.record.transitions = {"start", "begin", "goal"};
  EXPECT_EQ(cells_by_name(row)["transitions"], "begin+goal+start");
}

TEST(RowFormat, DetectsEveryChangedCharacter) {
  const std::string line = kFormat.line(full_row());
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string changed = line;
    changed[i] = changed[i] == '1' ? '2' : '1';
    EXPECT_FALSE(kFormat.read(changed)) << i;
  }
}

TEST(RowFormat, LeavesCircumstancesOutOfTheResults) {
  EXPECT_EQ(kFormat.reproducible_names().back(), "config_hash");
  GameRow other = full_row();
  other.circumstances = {};
  EXPECT_EQ(kFormat.reproducible(other), kFormat.reproducible(full_row()));
}

TEST(RowFormat, FindsTheFirstColumnThatDiffers) {
  GameRow other = full_row();
  EXPECT_FALSE(kFormat.first_difference(full_row(), other));
  other.record.goals_a += 1;
  const std::optional<ColumnDifference> difference = kFormat.first_difference(full_row(), other);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->column, "goals_a");
  EXPECT_EQ(difference->second, std::to_string(other.record.goals_a));
}

}  // namespace
}  // namespace autoref::experiments
