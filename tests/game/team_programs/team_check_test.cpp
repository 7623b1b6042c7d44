#include "game/team_programs/program_check.hpp"

#include <gtest/gtest.h>

#include "tests/game/team_programs/shell_teams.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::game {
namespace {

TEST(TeamCheck, SaysWhatAProgramAskedForAndDid) {
  const TeamCheck check = check_team(shell_game(
      kGreets + kReads + kAnswers +
      "while :; do next; [ -z \"$frame\" ] || answer ',\"keeper\":2,\"timeout\":true,"
      "\"commands\":[{\"robot\":1,\"vx_mps\":1},{\"robot\":3,\"kick_mps\":2}]'; done\n"));
  EXPECT_EQ(check.fault, "");
  ASSERT_TRUE(check.greeting);
  EXPECT_EQ(check.greeting->encoding, league::TeamEncoding::kJson);
  EXPECT_EQ(check.robots_commanded, 2);
  EXPECT_EQ(check.keeper, 2);
  EXPECT_TRUE(check.asked_for_timeout);
  EXPECT_EQ(check.ending, "ended with status 0");
  EXPECT_EQ(check.is_repeatable, true);
  EXPECT_GT(check.answers_ms.size(), 20U);
  EXPECT_GT(check.start_ms, 0);
  EXPECT_LE(check.answers_ms.front(), check.answers_ms.back());
}

TEST(TeamCheck, SaysThatAProgramIsNotRepeatable) {
  const TemporaryFolder folder;
  const TeamCheck check = check_team(shell_game(changing_script(folder / "mark")));
  EXPECT_EQ(check.fault, "");
  EXPECT_EQ(check.is_repeatable, false);
}

TEST(TeamCheck, SaysWhatIsWrong) {
  const TeamCheck check = check_team(shell_game(script_that(3, "echo no >&2; exit 3")));
  EXPECT_NE(check.fault.find("ended with status 3"), std::string::npos) << check.fault;
  EXPECT_EQ(check.is_repeatable, std::nullopt);
  EXPECT_EQ(check.answers_ms.size(), 2U);
}

}  // namespace
}  // namespace autoref::game
