#include "runner/cli/scenario_argument.hpp"

#include <gtest/gtest.h>

#include "tests/runner/support/temporary_folder.hpp"

namespace autoref::runner {
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

}  // namespace
}  // namespace autoref::runner
