#include "experiments/report/folder_report.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

// A folder with 12 games of each of two builds, with different results.
class MixedBuilds : public testing::Test {
 protected:
  void SetUp() override {
    ExperimentOptions options = fake_options(folder_.path());
    run_experiment(small_sweep(), options);
    options.build = "0.1.0-other";
    options.allow_mixed_build = true;
    options.play = [](const game::GameConfiguration& game) {
      game::GameRecord record = fake_game(game);
      ++record.goals_a;
      return record;
    };
    run_experiment(small_sweep(), options);
  }
  app::Answer report() const { return app::answer_to({"report", folder_.path().c_str()}); }

  TemporaryFolder folder_;
};

TEST_F(MixedBuilds, AreReportedSeparately) {
  EXPECT_EQ(report().code, io::kDone);
  for (const char* build : {"build-0.1.0-test", "build-0.1.0-other"}) {
    EXPECT_EQ(line_count(content_of(folder_ / build / "results.csv")), 13) << build;
    EXPECT_TRUE(std::filesystem::exists(folder_ / build / "report.html")) << build;
  }
}

TEST_F(MixedBuilds, AreListedInOneOverview) {
  report();
  const std::string overview = content_of(folder_ / "report.md");
  EXPECT_NE(overview.find("| 0.1.0-test | 12 | 12 | 0 |\n"), std::string::npos) << overview;
  EXPECT_NE(overview.find("[report.md](build-0.1.0-other/report.md)"), std::string::npos);
}

TEST_F(MixedBuilds, GiveOneReportForARequestedBuild) {
  const app::Answer answer =
      app::answer_to({"report", folder_.path().c_str(), "--build", "0.1.0-test"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "build-0.1.0-test"));
  EXPECT_NE(content_of(folder_ / "report.md")
                .find("| rows of build 0.1.0-other (not counted here) | 12 |\n"),
            std::string::npos);
}

TEST(BuildFolder, IsASubfolderOfTheResultsFolder) {
  EXPECT_EQ(build_folder("results", "0.1.0-5bf"), "results/build-0.1.0-5bf");
  EXPECT_THROW(build_folder("results", "/../../x"), io::InputError);
}

}  // namespace
}  // namespace autoref::experiments
