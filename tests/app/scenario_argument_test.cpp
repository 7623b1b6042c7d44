#include "app/scenario_argument.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

class FoundScenario : public testing::Test {
 protected:
  FoundScenario() {
    std::filesystem::create_directories(prefix_ / "share/autoref/scenarios");
    write_content(installed_, "schema: 1\n");
  }

  TemporaryFolder prefix_;
  std::filesystem::path program_ = prefix_ / "bin/autoref";
  std::filesystem::path installed_ = prefix_ / "share/autoref/scenarios/not-here.yaml";
};

TEST_F(FoundScenario, IsTheInstalledOneIfThereIsNoneHere) {
  EXPECT_EQ(found_scenario("scenarios/not-here.yaml", program_), installed_);
}

TEST_F(FoundScenario, IsTheUsersOwnIfItExists) {
  const std::string own = prefix_ / "own.yaml";
  write_content(own, "");
  EXPECT_EQ(found_scenario(own, program_), own);
}

TEST_F(FoundScenario, IsTheGivenNameIfNoneExists) {
  EXPECT_EQ(found_scenario("scenarios/nowhere.yaml", program_), "scenarios/nowhere.yaml");
  EXPECT_EQ(found_scenario("", program_), "");
  EXPECT_EQ(found_scenario("scenarios", program_), "scenarios") << "a folder";
}

TEST_F(FoundScenario, IsNeverOutsideTheInstalledFolder) {
  write_content(prefix_ / "share/secret.yaml", "");
  EXPECT_EQ(found_scenario("../secret.yaml", program_), "../secret.yaml");
  EXPECT_EQ(found_scenario("/not-here.yaml", program_), "/not-here.yaml");
}

TEST_F(FoundScenario, IsLookedUpInTheFolderScenarios) {
  EXPECT_EQ(found_scenario("not-here.yaml", program_), installed_);
  EXPECT_EQ(found_scenario("../scenarios/not-here.yaml", program_), "../scenarios/not-here.yaml");
}

// In a folder with a folder scenarios.
class ScenarioHere : public testing::Test {
 protected:
  ScenarioHere() {
    std::filesystem::current_path(folder_.path());
    std::filesystem::create_directories("scenarios/lab");
    write_content("scenarios/short-game.yaml",
                  "schema: 1\nkind: game\nmatch: { half_s: 0.1, break_s: 0 }\n");
    write_content("scenarios/lab/bounce.yaml", "");
    write_content("cup-game.yaml", "");
  }
  ~ScenarioHere() override { std::filesystem::current_path(before_); }

  std::filesystem::path before_ = std::filesystem::current_path();
  TemporaryFolder folder_;
};

TEST_F(ScenarioHere, IsFoundInTheFolderScenarios) {
  const Answer answer = answer_to({"play", "short-game.yaml"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_EQ(answer.err.find("autoref: reading scenarios/short-game.yaml\n"), 0U) << answer.err;
}

TEST_F(ScenarioHere, IsSuggestedByEveryVerbThatReadsOne) {
  for (const char* verb : {"play", "live", "run", "check", "judge", "experiment lab"}) {
    const Answer answer = answer_to(verb, {"shrot-game.yaml"});
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_EQ(answer.err,
              "autoref: shrot-game.yaml: the file cannot be read: No such file or directory; did "
              "you mean 'scenarios/short-game.yaml'?\n")
        << verb;
  }
  const Answer submission = answer_to({"experiment", "submit", "shrot-game.yaml", "--slurm"});
  EXPECT_NE(submission.err.find("did you mean 'scenarios/short-game.yaml'?"), std::string::npos);
  const Answer drawing = answer_to({"show", "situation", "bonce.yaml", "x", "-o", "x.svg"});
  EXPECT_NE(drawing.err.find("did you mean 'scenarios/lab/bounce.yaml'?"), std::string::npos)
      << drawing.err;
}

TEST_F(ScenarioHere, IsNotNeededForHelp) {
  const Answer answer = answer_to({"play", "shrot-game.yaml", "--help"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_EQ(answer.out, answer_to({"play", "--help"}).out);
}

TEST_F(ScenarioHere, IsSuggestedIfItsFolderIsMissingOrItsNameIsBegun) {
  EXPECT_NE(answer_to({"experiment", "lab", "bounce.yaml"})
                .err.find("did you mean 'scenarios/lab/bounce.yaml'?"),
            std::string::npos);
  EXPECT_NE(answer_to({"run", "cup"}).err.find("did you mean 'cup-game.yaml'?"), std::string::npos);
  EXPECT_EQ(answer_to({"run", "xy.yaml"}).err.find("did you mean"), std::string::npos);
}

}  // namespace
}  // namespace autoref::app
