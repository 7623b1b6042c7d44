#include "experiments/export/play_drawings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/export/export_folder.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::experiments {
namespace {

// Two short games.
class PlayDrawings : public testing::Test {
 protected:
  void SetUp() override {
    write_content(folder_ / "short.yaml",
                  "schema: 1\nkind: roundrobin\nseed: 1\npairs: 1\n"
                  "base: { match: { rules: 2026-b, half_s: 30 } }\n"
                  "teams: { one: { strategy: basic }, two: { strategy: counter } }\n");
    const std::string file = (folder_ / "short.yaml").string();
    ASSERT_EQ(app::answer_to({"run", file.c_str(), "-o", results_.c_str()}).code, io::kDone);
  }

  app::Answer draw() const { return app::answer_to({"results", "draw", results_.c_str()}); }
  std::string content(const std::string& file) const {
    return content_of(std::filesystem::path(results_) / file);
  }

  TemporaryFolder folder_;
  std::string results_ = (folder_ / "results").string();
};

TEST_F(PlayDrawings, AreWrittenAndShownInTheReport) {
  EXPECT_EQ(content("report.html").find("shot from"), std::string::npos);
  ASSERT_EQ(draw().code, io::kDone);
  for (const char* file : {"shots.svg", "chains.svg", "losses.svg"}) {
    const std::string svg = content(file);
    EXPECT_NE(svg.find(">one</text>"), std::string::npos) << file;
    EXPECT_NE(svg.find(">games: 2, "), std::string::npos) << file;
    EXPECT_NE(content("report.md").find(std::string("(") + file + ")"), std::string::npos);
  }
  EXPECT_NE(content("report.html").find("shot from"), std::string::npos);
}

// A new report keeps them, unless the rows have changed.
TEST_F(PlayDrawings, ThatShowOtherGamesAreLeftOutOfTheReport) {
  ASSERT_EQ(draw().code, io::kDone);
  ASSERT_EQ(app::answer_to({"report", results_.c_str()}).code, io::kDone);
  EXPECT_NE(content("report.html").find("shot from"), std::string::npos);
  const std::filesystem::path drawing = std::filesystem::path(results_) / "shots.svg";
  write_content(drawing, content("shots.svg") + "<!-- rows 00000000 -->\n");
  ASSERT_EQ(app::answer_to({"report", results_.c_str()}).code, io::kDone);
  EXPECT_EQ(content("report.html").find("shot from"), std::string::npos);
  EXPECT_NE(content("report.html").find("lost the ball."), std::string::npos);
}

// The totals in the drawings are those of the rows.
TEST_F(PlayDrawings, CountTheShotsOfTheRows) {
  const ResultFolder folder = open_results(results_);
  int shots = 0;
  int losses = 0;
  for (const auto& [id, row] : folder.completed_games.done) {
    const bool is_a = row.team_a == "two";
    const game::PlayCounts& counts = row.record.counts[is_a ? 0 : 1];
    shots += counts.shots;
    losses += counts.by_action[static_cast<std::size_t>(game::ActionKind::kLoss)].actions;
  }
  const std::vector<ResultDrawing> drawings = play_drawings(folder, {}, {"two"});
  ASSERT_EQ(drawings.size(), 3U);
  EXPECT_NE(drawings[0].svg.find("games: 2, shots: " + std::to_string(shots) + ","),
            std::string::npos)
      << shots << drawings[0].svg;
  EXPECT_NE(drawings[2].svg.find(fmt::format("losses per game: {:.1f}", losses / 2.0)),
            std::string::npos)
      << losses << drawings[2].svg;
  EXPECT_EQ(drawings[0].svg.find(">one</text>"), std::string::npos);
}

TEST_F(PlayDrawings, OfTeamsWithOneNameHaveAPanelForEach) {
  ResultFolder folder = open_results(results_);
  for (ScheduledGame& game : folder.games) game.team_a = game.team_b = "same";
  for (const auto& chosen : {std::vector<std::string>{}, std::vector<std::string>{"same"}}) {
    const std::string svg = play_drawings(folder, {}, chosen)[0].svg;
    EXPECT_NE(svg.find(">a: same</text>"), std::string::npos);
    EXPECT_NE(svg.find(">b: same</text>"), std::string::npos);
  }
}

TEST_F(PlayDrawings, RefuseFoldersWithoutAGameThatCanBeDrawn) {
  ResultFolder folder = open_results(results_);
  for (auto& [id, row] : folder.completed_games.done) row.record.status = game::Status::kVoid;
  EXPECT_THROW(play_drawings(folder, {}, {}), io::InputError);
}

TEST_F(PlayDrawings, SuggestTheTeamThatWasMeant) {
  const app::Answer answer =
      app::answer_to({"results", "draw", results_.c_str(), "--teams", "twoo"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("'twoo' has no game that can be drawn"), std::string::npos)
      << answer.err;
  EXPECT_NE(answer.err.find("two"), std::string::npos) << answer.err;
}

TEST_F(PlayDrawings, OfManyTeamsNeedAChoice) {
  ResultFolder folder = open_results(results_);
  const ScheduledGame game = folder.games.front();
  const GameRow row = folder.completed_games.done.begin()->second;
  for (int i = 0; i < 12; ++i) {
    ScheduledGame& copy = folder.games.emplace_back(game);
    copy.id = "copy" + std::to_string(i);
    copy.team_a = "t" + std::to_string(i);
    folder.completed_games.done.emplace(copy.id, row);
  }
  try {
    play_drawings(folder, {}, {});
    FAIL() << "draws 14 teams";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("14 teams are too many for a map; choose at most 12"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace autoref::experiments
