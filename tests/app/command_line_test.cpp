// The program as scripts see it: exit codes and messages.
#include "app/command_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdio_ext.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

const std::string kScenarios = in_checkout("scenarios/");
const std::string kPaperGame = kScenarios + "paper-game.yaml";
const std::string kScene = kScenarios + "lab/chip.yaml";
const std::string kSpeedSweep = kScenarios + "handicap-speed.yaml";

// "play", "results status": the reference page has a section for each, and for the groups.
std::vector<std::string> listed_verbs() {
  const std::string kSection = "## autoref ";
  std::vector<std::string> verbs;
  std::istringstream page(answer_to({"reference", "verbs"}).out);
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with(kSection)) continue;
    const std::string verb = line.substr(kSection.size());
    if (!verbs.empty() && verb.starts_with(verbs.back() + " ")) verbs.pop_back();  // a group
    verbs.push_back(verb);
  }
  return verbs;
}

TEST(CommandLine, ShowsAnExampleForEachVerb) {
  const std::vector<std::string> verbs = listed_verbs();
  EXPECT_EQ(verbs.size(), 33U);
  for (const std::string& verb : verbs) {
    const Answer answer = answer_to(verb, {"--help"});
    EXPECT_EQ(answer.code, io::kDone);
    const std::size_t example = answer.out.find("\nExample");
    ASSERT_NE(example, std::string::npos) << verb;
    EXPECT_NE(answer.out.find("\n  autoref " + verb, example), std::string::npos) << verb;
  }
}

TEST(CommandLine, ListsAboutTenVerbsAndTheGroups) {
  const std::string help = answer_to({"--help"}).out;
  const std::size_t verbs = help.find("\nVerbs:\n");
  const std::size_t groups = help.find("\nMore verbs, in groups:\n");
  ASSERT_LT(verbs, groups);
  ASSERT_NE(groups, std::string::npos);
  EXPECT_LE(std::count(help.begin() + verbs, help.begin() + groups, '\n'), 14);
  EXPECT_NE(help.find(": status, verify, replay, export, draw.", groups), std::string::npos)
      << help;
  EXPECT_EQ(help.find("\n  reference"), std::string::npos) << "for those who write the manual";
}

TEST(CommandLine, ExplainsAGroupByItsVerbs) {
  const std::string help = answer_to({"help", "results"}).out;
  EXPECT_NE(help.find("\n  status "), std::string::npos) << help;
  EXPECT_NE(help.find("`autoref help results VERB` explains a verb."), std::string::npos) << help;
}

TEST(CommandLine, PrintsItsVersion) {
  const Answer answer = answer_to({"--version"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_TRUE(answer.out.starts_with("autoref 1.0.0-"));
}

TEST(CommandLine, ReportsUsageErrorsAsBadInput) {
  for (const auto& arguments :
       std::vector<std::vector<const char*>>{{"playy"},
                                             {"play"},
                                             {"play", kPaperGame.c_str(), "--sed", "1"},
                                             {"play", kPaperGame.c_str(), "--seed"},
                                             {"run", kSpeedSweep.c_str(), "-j", "0"},
                                             {"run", kSpeedSweep.c_str(), "-j", "two"}}) {
    const Answer answer = answer_to(arguments);
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_NE(answer.err, "");
    EXPECT_EQ(answer.out, "");
  }
}

struct WrongInput {
  std::vector<const char*> arguments;
  const char* fragment;
};

TEST(CommandLine, NamesTheFlagOrFileThatIsWrong) {
  for (const WrongInput& wrong : std::vector<WrongInput>{
           {{"play", "none.yaml"}, "none.yaml: the file cannot be read"},
           {{"run", "none.yaml"}, "none.yaml: the file cannot be read"},
           {{"play", kSpeedSweep.c_str()}, "autoref run"},
           {{"run", kPaperGame.c_str()}, "autoref play"},
           {{"play", kScene.c_str()}, "autoref experiment lab"},
           {{"experiment", "lab", "none.yaml"}, "none.yaml: the file cannot be read"},
           {{"experiment", "lab", kPaperGame.c_str()}, "kind: expected lab, found 'game'"},
           {{"experiment", "lab", kScene.c_str(), "--csv", "/nonexistent/x"},
            "/nonexistent/x cannot be"},
           {{"run", kSpeedSweep.c_str(), "--shard", "2/2"}, "--shard: expected I/N"},
           {{"results", "status", "none"}, "none: holds no results"},
           {{"play", kPaperGame.c_str(), "--seed", "x"}, "--seed: "},
           {{"play", kPaperGame.c_str(), "--seed", "-1"}, "-1"},
           {{"play", kPaperGame.c_str(), "--set", "b.robots"},
            "--set b.robots: expected KEY=VALUE"},
           {{"play", kPaperGame.c_str(), "--set", "b.robots=17"},
            "--set b.robots=17: expected a whole"},
           {{"play", kPaperGame.c_str(), "--set", "b.robot=5"}, "did you mean 'b.robots'"},
           {{"play", kPaperGame.c_str(), "--set", "a.strategy=none"}, "basic"},
           {{"play", kPaperGame.c_str(), "--set", "a.params.x=1"}, "no parameter 'x'"},
           {{"play", kPaperGame.c_str(), "--set", "a.params.shot_mps=9"},
            "from 0 to 8 m/s, found '9'"},
           {{"show", "teams", "basik"}, "unknown team 'basik'; did you mean 'basic'"},
           {{"show", "rules", "2014", "--machine"}, "--machine: prints a graph"},
           {{"play", kPaperGame.c_str(), "--events", "/nonexistent/e"},
            "/nonexistent/e cannot be"}}) {
    const Answer answer = answer_to(wrong.arguments);
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_NE(answer.err.find(wrong.fragment), std::string::npos) << answer.err;
    EXPECT_EQ(answer.out, "");
  }
}

TEST(CommandLine, PrintsTeamsAndTheirParameters) {
  const Answer all = answer_to({"show", "teams"});
  EXPECT_EQ(all.code, io::kDone);
  EXPECT_NE(all.out.find("\ndummy "), std::string::npos) << all.out;
  EXPECT_NE(answer_to({"show", "teams", "basic"}).out.find("\nshot_mps "), std::string::npos);
  EXPECT_TRUE(
      answer_to({"show", "teams", "basic", "--json"}).out.starts_with("{\"name\": \"basic\""));
}

TEST(CommandLine, ReportsAFolderThatCannotBeWrittenAsInputOutput) {
  const Answer answer = answer_to({"run", kSpeedSweep.c_str(), "-o", "/proc/none"});
  EXPECT_EQ(answer.code, io::kInputOutput);
  EXPECT_NE(answer.err.find("/proc/none"), std::string::npos);
}

TEST(ExitCode, DependsOnTheException) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(exit_code_of([]() -> int { throw io::InputError({"f"}, "k", "m"); }), 2);
  EXPECT_EQ(exit_code_of([]() -> int { throw std::logic_error("m"); }), 70);
  EXPECT_EQ(exit_code_of([]() -> int { throw io::InputOutputError("m"); }), 74);
  EXPECT_EQ(exit_code_of([]() -> int { throw io::Interrupted(); }), 75);
  testing::internal::GetCapturedStderr();
}

// The exit code of `work` if the disk behind standard output is full.
int code_on_a_full_disk(const std::function<int()>& work) {
  std::fflush(stdout);
  const int former = dup(STDOUT_FILENO);
  const int full = open("/dev/full", O_WRONLY);
  dup2(full, STDOUT_FILENO);
  testing::internal::CaptureStderr();
  const int code = exit_code_of(work);
  testing::internal::GetCapturedStderr();
  __fpurge(stdout);
  std::clearerr(stdout);
  dup2(former, STDOUT_FILENO);
  close(former);
  close(full);
  return code;
}

TEST(ExitCode, IsInputOutputWhenTheOutputDoesNotFit) {
  for (const std::size_t length : {10UL, 1000000UL}) {
    EXPECT_EQ(code_on_a_full_disk([length] {
                fmt::print("{}\n", std::string(length, 'x'));
                return 0;
              }),
              74);
  }
  const char* const help[] = {"autoref", "--help"};
  EXPECT_EQ(code_on_a_full_disk([&] { return run_command_line(2, help); }), 74);
}

TEST(CommandLine, AcceptsSettingsInAnyOrder) {
  const char* goal = "field.goal_width_m=3.8";
  const char* field = "field.width_m=9";
  for (const auto& [first, second] : {std::pair(goal, field), std::pair(field, goal)}) {
    const Answer answer = answer_to(
        {"play", kPaperGame.c_str(), "--set", "match.half_s=0.1", "--set", first, "--set", second});
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
  }
}

TEST(CommandLine, KillsAHangingGameAtTheSecondInterrupt) {
  const auto interrupt_twice = [] {
    const char* const play[] = {"autoref", "play", kPaperGame.c_str(), "--set", "match.half_s=0.1"};
    run_command_line(5, play);
    std::raise(SIGINT);
    std::raise(SIGINT);  // as programs such as timeout do
    std::fputs("still here", stderr);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    std::raise(SIGINT);
  };
  EXPECT_EXIT(interrupt_twice(), testing::KilledBySignal(SIGINT), "still here");
}

}  // namespace
}  // namespace autoref::app
