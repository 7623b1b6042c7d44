// Games that are played again from their recorded commands.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"
#include "tests/game/team_programs/shell_teams.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::game {
namespace {

class RecordedGame : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "game.gz";
};

// Plays the recorded commands as far as they go.
GameRecord replayed_part(const GameConfiguration& game, GamePrograms& programs) {
  Game again(game, nullptr, programs.maker());
  while (programs.before_step(again) && again.step()) {
  }
  return again.record();
}

TEST_F(RecordedGame, IsRepeatedUpToItsInterruption) {
  const GameConfiguration game = shell_game(idle_script());
  GameRecord part;
  {
    GamePrograms programs = GamePrograms::live(game, {file_});
    Game interrupted(game, nullptr, programs.maker());
    for (int i = 0; i < 20; ++i) interrupted.step();
    part = interrupted.record();
    programs.finish(part, true);
  }
  GamePrograms programs = GamePrograms::recorded(game, file_);
  const GameRecord again = replayed_part(game, programs);
  EXPECT_EQ(again.frames, 20);
  EXPECT_EQ(again.state_hash, part.state_hash);
  EXPECT_TRUE(programs.finish(again));
}

TEST_F(RecordedGame, IsRepeatedAlmostUpToTheKill) {
  const GameConfiguration game = shell_game(idle_script());
  {
    ProgramFiles files;
    files.commands = file_;
    files.commands_kind = io::FileKind::kGrowing;
    GamePrograms programs = GamePrograms::live(game, files);
    Game killed(game, nullptr, programs.maker());
    for (int i = 0; i < 20; ++i) killed.step();
  }
  GamePrograms programs = GamePrograms::recorded(game, file_, io::FileKind::kFileOrPipe);
  const GameRecord again = replayed_part(game, programs);
  EXPECT_EQ(again.frames, 19);  // the last step may be incomplete
  EXPECT_EQ(again.status, Status::kOk) << again.void_reason;
  EXPECT_TRUE(programs.is_truncated());
  EXPECT_TRUE(programs.finish(again));
}

GameRecord played(const GameConfiguration& game, GamePrograms programs, bool& is_same) {
  GameRecord record = play(game, nullptr, programs.maker());
  is_same = programs.finish(record);
  return record;
}

TEST_F(RecordedGame, IsRepeatedAlthoughItsProgramDoesNotRepeatIt) {
  const GameConfiguration game = shell_game(changing_script(folder_ / "mark"));
  bool is_same = false;
  const GameRecord live = played(game, GamePrograms::live(game, {file_}), is_same);
  ASSERT_EQ(live.status, Status::kOk) << live.void_reason;
  const GameRecord other = played(game, GamePrograms::live(game, {}), is_same);
  EXPECT_NE(other.state_hash, live.state_hash);
  const GameRecord replayed = played(game, GamePrograms::recorded(game, file_), is_same);
  EXPECT_EQ(replayed.state_hash, live.state_hash);
  EXPECT_TRUE(is_same);
}

TEST_F(RecordedGame, IsRepeatedWithItsFault) {
  const GameConfiguration game = shell_game(script_that(5, "echo no >&2; exit 3"));
  bool is_same = false;
  const GameRecord live = played(game, GamePrograms::live(game, {file_}), is_same);
  const GameRecord replayed = played(game, GamePrograms::recorded(game, file_), is_same);
  EXPECT_EQ(replayed.void_reason, live.void_reason);
  EXPECT_TRUE(is_same);
}

TEST_F(RecordedGame, OfOtherTeamsEndsInAnotherState) {
  const GameConfiguration game = shell_game(idle_script());
  bool is_same = false;
  played(game, GamePrograms::live(game, {file_}), is_same);
  GameConfiguration other = game;
  other.a.robots.resize(3);
  GamePrograms programs = GamePrograms::recorded(other, file_);
  const GameRecord record = play(other, nullptr, programs.maker());
  EXPECT_FALSE(programs.finish(record));
}

}  // namespace
}  // namespace autoref::game
