// `log fit`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

class FitVerb : public testing::Test {
 protected:
  Answer fit(std::vector<const char*> more = {}) {
    more.insert(more.begin(), log_.c_str());
    return answer_to("log fit", more);
  }

  void SetUp() override {
    const Answer answer = answer_to(
        "play", {game_.c_str(), "--log", log_.c_str(), "--set", "match.rules=2026-b", "--set",
                 "match.half_s=40", "--set", "sim.camera=rc2026-b", "--set", "a.strategy=cobalt"});
    ASSERT_EQ(answer.code, io::kDone) << answer.err;
  }

  TemporaryFolder folder_;
  std::string game_ = in_checkout("scenarios/paper-game.yaml");
  std::string log_ = folder_ / "game.log";
  std::string file_ = folder_ / "mine.yaml";
};

TEST_F(FitVerb, PrintsEstimatesIntervalsAndWhatIsNotEnough) {
  const Answer answer = fit();
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(has(answer.out, "frame_rate_hz")) << answer.out;
  EXPECT_TRUE(has(answer.out, "ball.roll_mps2")) << answer.out;
  EXPECT_TRUE(has(answer.out, "not enough")) << answer.out;
  EXPECT_TRUE(has(answer.out, "robot.speed_mps")) << answer.out;
}

TEST_F(FitVerb, WritesFilesWithWhichAGameIsPlayed) {
  const Answer answer = fit({"-o", file_.c_str()});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
  std::vector<std::string> robots;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("mine-")) robots.push_back(entry.path().string());
  }
  ASSERT_EQ(robots.size(), 2U);
  EXPECT_TRUE(has(content_of(file_), "frame_rate_hz: 73.2 ")) << content_of(file_);
  EXPECT_TRUE(has(content_of(file_), "  roll_mps2: ")) << content_of(file_);
  const std::string ball = "sim.ball=" + file_;
  const std::string camera = "sim.camera=" + file_;
  const std::string type = "a.type=" + robots[0];
  const std::string other_type = "b.type=" + robots[1];
  const Answer game =
      answer_to("play", {game_.c_str(), "--set", ball.c_str(), "--set", camera.c_str(), "--set",
                         type.c_str(), "--set", other_type.c_str(), "--set", "match.half_s=5"});
  EXPECT_EQ(game.code, io::kDone) << game.err;
}

TEST_F(FitVerb, KeepsExistingFilesUnlessForced) {
  write_content(file_, "precious");
  const Answer answer = fit({"-o", file_.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(has(answer.err, "--force")) << answer.err;
  EXPECT_EQ(content_of(file_), "precious");
  EXPECT_EQ(fit({"-o", file_.c_str(), "--force"}).code, io::kDone);
  EXPECT_NE(content_of(file_), "precious");
}

TEST_F(FitVerb, JsonHasTheSameNumbers) {
  const Answer answer = fit({"--json"});
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["teams"].size(), 2U);
  const auto rate =
      std::find_if(json["numbers"].begin(), json["numbers"].end(),
                   [](const auto& number) { return number["setting"] == "sim.frame_rate_hz"; });
  ASSERT_NE(rate, json["numbers"].end());
  EXPECT_NEAR((*rate)["estimate"], 73.2, 0.01);
}

TEST_F(FitVerb, RefusesANameThatGamesRefuse) {
  for (const char* name : {"mine", "mine.yml", "my.game.yaml"}) {
    const std::string path = folder_ / name;
    const Answer answer = fit({"-o", path.c_str()});
    EXPECT_EQ(answer.code, io::kBadInput) << name;
    EXPECT_EQ(answer.out, "") << name;
  }
}

TEST_F(FitVerb, SkipsAFileThatIsNotALog) {
  const std::string other = folder_ / "other.log";
  write_content(other, "not a log");
  const Answer alone = answer_to("log fit", {other.c_str()});
  EXPECT_EQ(alone.code, io::kBadInput);
  EXPECT_EQ(alone.out, "");
  const Answer both = fit({other.c_str()});
  EXPECT_EQ(both.code, io::kBadInput);
  EXPECT_TRUE(has(both.out, "frame_rate_hz")) << both.out;
}

}  // namespace
}  // namespace autoref::app
