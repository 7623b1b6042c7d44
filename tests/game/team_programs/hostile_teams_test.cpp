// Teams that fail in every way we know: the fault is theirs, and nothing is left behind.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>

#include "experiments/run/program_versions.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"
#include "game/team_programs/program_process.hpp"
#include "tests/game/team_programs/shell_teams.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/time_limit.hpp"

namespace autoref::game {
namespace {

struct HostileTeam {
  std::string name;
  std::string script;
  std::string reason;  // part of the row's
  double answer_s = 60;
};

std::string team_name(const testing::TestParamInfo<HostileTeam>& info) { return info.param.name; }

class HostileTeams : public testing::TestWithParam<HostileTeam> {};

TEST_P(HostileTeams, LoseTheirGameAndNothingElse) {
  GameConfiguration game = shell_game(GetParam().script);
  game.a.program->answer_s = GetParam().answer_s;
  for (const referee::OnTeamFault consequence :
       {referee::OnTeamFault::kVoid, referee::OnTeamFault::kForfeit}) {
    game.match.on_team_fault = consequence;
    const GameRecord record = play(game, nullptr, make_program_or_registered_team);
    const bool is_void = consequence == referee::OnTeamFault::kVoid;
    EXPECT_EQ(record.status, is_void ? Status::kVoid : Status::kForfeit);
    EXPECT_EQ(record.end_reason, is_void ? EndReason::kVoid : EndReason::kForfeitA);
    EXPECT_EQ(record.void_reason.find("team a /bin/sh "), 0U) << record.void_reason;
    EXPECT_NE(record.void_reason.find(GetParam().reason), std::string::npos) << record.void_reason;
    EXPECT_EQ(marked_processes(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, HostileTeams,
    testing::Values(
        HostileTeam{"HangsAtTheStart", "sleep 1000", "did not answer within 1 s", 1},
        HostileTeam{"Hangs", script_that(2, "sleep 1000"), "did not answer within 1 s", 1},
        HostileTeam{"NeverReads", kGreets + "sleep 1000", "did not answer within 1 s", 1},
        HostileTeam{"EndsAtTheStart", "echo no licence >&2; exit 4",
                    "ended with status 4; its last lines on standard error:\nno licence"},
        HostileTeam{"Ends", script_that(2, "exit 0"), "ended with status 0"},
        HostileTeam{"Crashes", script_that(2, "kill -SEGV $$"), "killed by signal 11"},
        HostileTeam{"KillsItself", script_that(2, "kill -KILL $$"), "killed by signal 9"},
        HostileTeam{"KillsEverybody",
                    script_that(2, "kill -KILL -1; kill -KILL $PPID; kill -KILL $$"),
                    "killed by signal 9"},
        HostileTeam{"ClosesItsOutput", script_that(2, "exec >&-; sleep 100"), "closed its output"},
        HostileTeam{"GreetsInAnotherProtocol", "echo HELLO; sleep 100", "HELLO"},
        HostileTeam{"NeverEndsItsGreeting", "while :; do printf x; done",
                    "sent bad output: the first line begins with"},
        HostileTeam{"WritesBeforeTheStart", kGreets + "echo '{\"frame\":0}'; sleep 1000", "", 1},
        HostileTeam{"SendsGarbage", script_that(2, "echo garbage"), "garbage"},
        HostileTeam{"SendsZeros", script_that(2, "head -c 100000 /dev/zero; sleep 100"), "sent "},
        HostileTeam{"SendsTooMuch", script_that(2, "yes | tr -d '\\n'"), "65536"},
        HostileTeam{"SendsNotANumber",
                    script_that(2, "answer ',\"commands\":[{\"robot\":1,\"vx_mps\":NaN}]'"),
                    "sent "},
        HostileTeam{"SendsAnInfiniteNumber",
                    script_that(2, "answer ',\"commands\":[{\"robot\":1,\"vx_mps\":1e999}]'"),
                    "sent "},
        HostileTeam{"CommandsARobotThatDoesNotExist",
                    script_that(2, "answer ',\"commands\":[{\"robot\":16}]'"), "robot is 16"},
        HostileTeam{"AnswersTwice", script_that(2, "answer; answer; sleep 100"), ""},
        HostileTeam{"AnswersAhead", script_that(2, "answer; while :; do answer; sleep 0.01; done"),
                    ""},
        HostileTeam{"AnswersAnotherFrame", script_that(2, "frame=7000; answer"),
                    "answered frame 7000 instead of"},
        HostileTeam{"IsAForkBomb", script_that(2, "bomb() { bomb | bomb & }; bomb; sleep 100"), ""},
        HostileTeam{"TakesAllMemory", script_that(2, "x=xxxxxxxx; while :; do x=$x$x; done"), ""}),
    team_name);

GameRecord record_with(const std::string& script, double half_s = 0.2) {
  return play(shell_game(script, half_s), nullptr, make_program_or_registered_team);
}

TEST(TeamPrograms, PlayTheWholeGame) {
  const GameRecord record = record_with(idle_script());
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(marked_processes(), 0);
}

TEST(TeamPrograms, MayFloodTheirStandardError) {
  const GameRecord record = record_with("yes flood >&2 &\n" + idle_script());
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(marked_processes(), 0);
}

// Plays a game whose team a runs `before` when its standard error's file, $file, does not exist
// yet, in a folder that it may change. Returns what AutoRef says.
std::string messages_after(const std::string& before, GameRecord& record) {
  const TimeLimit limit;
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "stderr");
  std::filesystem::permissions(folder / "stderr", std::filesystem::perms::all);
  GameConfiguration game = shell_game("");
  game.id = "game";
  game.a = shell_team("file='" + (folder / "stderr/game.a.txt").string() + "'\n" + before +
                      "\necho one >&2\n" + kGreets + kReads + kAnswers +
                      "while :; do next; [ -z \"$frame\" ] || { echo two >&2; answer; }; done\n");
  testing::internal::CaptureStderr();
  record = experiments::play_live(game, folder.path());
  return testing::internal::GetCapturedStderr();
}

TEST(TeamPrograms, CannotStallTheirGameByAPipeInPlaceOfTheirStandardErrorsFile) {
  GameRecord record;
  const std::string messages = messages_after("mkfifo \"$file\"", record);
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(marked_processes(), 0);
  const std::string text =
      "stderr/game.a.txt: another program has created a file there; the rest of the program's "
      "standard error in this game is discarded\n";
  const std::size_t first = messages.find(text);
  ASSERT_NE(first, std::string::npos) << messages;
  EXPECT_EQ(messages.find(text, first + 1), std::string::npos) << messages;
}

TEST(TeamPrograms, CannotOverwriteAFileByALinkInPlaceOfTheirStandardErrorsFile) {
  const TemporaryFolder folder;
  write_content(folder / "other", "kept");
  GameRecord record;
  messages_after("ln -s '" + (folder / "other").string() + "' \"$file\"", record);
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(content_of(folder / "other"), "kept");
}

TEST(TeamPrograms, LeaveNoChildBehind) {
  const GameRecord record = record_with("setsid sleep 1000 >/dev/null 2>&1 &\n" + idle_script());
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(marked_processes(), 0);
}

TEST(TeamPrograms, ThatDoNotExistLoseTheirGame) {
  GameConfiguration game = shell_game("");
  game.a.program->command = {"/no/such/team"};
  const GameRecord record = play(game, nullptr, make_program_or_registered_team);
  EXPECT_EQ(record.status, Status::kVoid);
  EXPECT_NE(record.void_reason.find("cannot start /no/such/team: No such file or directory"),
            std::string::npos)
      << record.void_reason;
}

TEST(TeamPrograms, HaveNoWinnerIfBothFail) {
  GameConfiguration game = shell_game("exit 1");
  game.b = shell_team("exit 1");
  game.match.on_team_fault = referee::OnTeamFault::kForfeit;
  const GameRecord record = play(game, nullptr, make_program_or_registered_team);
  EXPECT_EQ(record.status, Status::kVoid);
}

TEST(TeamPrograms, LoseToProgramsThatPlay) {
  GameConfiguration game = shell_game(idle_script());
  game.b = shell_team(script_that(2, "exit 1"));
  game.match.on_team_fault = referee::OnTeamFault::kForfeit;
  const GameRecord record = play(game, nullptr, make_program_or_registered_team);
  EXPECT_EQ(record.end_reason, EndReason::kForfeitB);
  EXPECT_EQ(record.status, Status::kForfeit);
}

// Ends the supervisor of this thread's first program, as somebody outside may.
void kill_supervisor() {
  std::ifstream children("/proc/thread-self/children");
  pid_t supervisor = 0;
  ASSERT_TRUE(children >> supervisor);
  kill(supervisor, SIGKILL);
}

TEST(TeamPrograms, ThatAreKilledFromOutsidePlayAgainAndThatIsCounted) {
  ProgramSpec any;
  any.command = {"true"};
  if (!ProgramProcess(any).has_namespace()) GTEST_SKIP() << "PID namespaces are not allowed here";
  const TemporaryFolder folder;
  const GameConfiguration game = shell_game(idle_script());
  GameRecord record;
  int plays = 0;
  experiments::play_live(game, folder.path(), [&](GamePrograms& programs) -> GameRecord& {
    const TeamMaker maker = programs.maker();
    record = play(game, nullptr, [&](const auto& team, const auto& context) {
      auto made = maker(team, context);
      if (team.program && plays++ < 2) kill_supervisor();
      return made;
    });
    return record;
  });
  EXPECT_EQ(plays, 3);
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.attempts, 3);
}

TEST(TeamPrograms, ThatKillThemselvesGetNoOtherAttempt) {
  const TemporaryFolder folder;
  GameConfiguration game = shell_game(script_that(2, "kill -KILL $$"));
  game.match.on_team_fault = referee::OnTeamFault::kForfeit;
  const GameRecord record = experiments::play_live(game, folder.path());
  EXPECT_EQ(record.status, Status::kForfeit);
  EXPECT_EQ(record.end_reason, EndReason::kForfeitA);
  EXPECT_EQ(record.attempts, 1);
}

}  // namespace
}  // namespace autoref::game
