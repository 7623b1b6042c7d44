#include "experiments/report/report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "tests/experiments/run/fake_games.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

WrittenReport reported(const fs::path& path) {
  const ResultFolder folder = open_results(path);
  return write_report(
      folder, write_results(path, folder.scenario, folder.format, folder.completed_games.done),
      path);
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().string()] = content_of(entry.path());
  }
  return files;
}

// Replaces PATH during its lifetime.
class Path {
 public:
  explicit Path(const std::string& value) { setenv("PATH", value.c_str(), 1); }
  ~Path() { setenv("PATH", former_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string former_ = std::getenv("PATH");
};

class Report : public testing::Test {
 protected:
  // Plays the games of a small sweep with this `about` text.
  void play(const std::string& about = "A test.", int pairs = 3) {
    Scenario sweep = small_sweep(pairs);
    sweep.about = about;
    run_experiment(sweep, fake_options(folder_.path()));
  }
  std::string markdown() const { return content_of(folder_ / "report.md"); }
  std::string html() const { return content_of(folder_ / "report.html"); }

  TemporaryFolder folder_;
};

// Skipped only if gnuplot is missing, not if it fails; the other tests do not need it.
class DrawnReport : public Report {
 protected:
  void SetUp() override {
    play();
    if (draw({"x", "", "", ""}).is_missing) {
      GTEST_SKIP() << "skipped: missing Debian packages: gnuplot-nox (scripts/setup --tests "
                      "installs it)";
    }
    ASSERT_GT(reported(folder_.path()).drawn, 0);
  }
};

TEST_F(DrawnReport, IsReproducible) {
  const std::map<std::string, std::string> before = files_below(folder_.path());
  for (const auto& [file, content] : before) {
    if (!has(file, "/games/") && !has(file, kEffectiveFile)) fs::remove(file);
  }
  reported(folder_.path());
  EXPECT_EQ(files_below(folder_.path()), before);
}

TEST_F(DrawnReport, HasScriptsThatRedrawThePlots) {
  for (const char* name : {"scores", "difference", "histogram", "running_mean"}) {
    const fs::path svg = folder_ / (std::string("plots/") + name + ".svg");
    const std::string drawn = content_of(svg);
    fs::remove(svg);
    const std::string command = "cd '" + (folder_ / "plots").string() + "' && gnuplot -d " + name;
    ASSERT_EQ(std::system((command + ".gp").c_str()), 0);
    EXPECT_EQ(content_of(svg), drawn) << name;
  }
}

TEST_F(DrawnReport, HasItsPlotsInThePage) {
  EXPECT_TRUE(has(html(), "<title>scores</title>"));
  EXPECT_TRUE(has(markdown(), "![running_mean](plots/running_mean.svg)"));
  EXPECT_FALSE(has(html(), "src="));
}

TEST_F(DrawnReport, DrawsNamesVerbatim) {
  Plot plot{"x", "", "x,y\n1,2\n",
            script_head("x", 200) + "set title " + script_text("a_1^{b} <i> `date` it's") +
                "\nplot data using 'x':'y' notitle\n"};
  const Drawing drawing = draw(plot);
  EXPECT_TRUE(has(drawing.svg, "a_1^{b} &lt;i> `date` it's")) << drawing.trouble;
}

TEST_F(DrawnReport, SaysWhyAPlotIsNotDrawn) {
  const Drawing drawing = draw({"x", "", "", "plot nonsense(\n"});
  EXPECT_TRUE(drawing.svg.empty());
  EXPECT_TRUE(has(drawing.trouble, "gnuplot failed: ")) << drawing.trouble;
  EXPECT_TRUE(has(drawing.trouble, "x.gp")) << drawing.trouble;
}

TEST_F(DrawnReport, DoesNotWaitForeverForAPlot) {
  const Drawing drawing = draw({"x", "", "", "pause 60\n"}, 0.2);
  EXPECT_TRUE(drawing.svg.empty());
  EXPECT_TRUE(has(drawing.trouble, "took longer than 0.2 s")) << drawing.trouble;
}

TEST_F(Report, WorksWithoutGnuplot) {
  play();
  write_content(folder_ / "plots/scores.svg", "of other rows");
  const Path path(folder_.path().string());
  const WrittenReport report = reported(folder_.path());
  EXPECT_EQ(report.drawn, 0);
  ASSERT_EQ(report.troubles.size(), 1U);
  EXPECT_TRUE(has(report.troubles.front(), "apt-get install gnuplot-nox"));
  EXPECT_FALSE(fs::exists(folder_ / "plots/scores.svg"));
}

TEST_F(Report, RemovesPlotsOfAnEarlierReport) {
  play();
  reported(folder_.path());
  for (const char* file : {"crosstable.svg", "crosstable.gp", "crosstable.csv", "ratings.svg"}) {
    write_content(folder_ / "plots" / file, "of a round robin");
  }
  write_content(folder_ / "plots/my-crosstable.gp", "the user's own");
  reported(folder_.path());
  for (const char* file : {"crosstable.svg", "crosstable.gp", "crosstable.csv", "ratings.svg"}) {
    EXPECT_FALSE(fs::exists(folder_ / "plots" / file)) << file;
  }
  EXPECT_EQ(content_of(folder_ / "plots/my-crosstable.gp"), "the user's own");
  EXPECT_TRUE(fs::exists(folder_ / "plots/scores.gp"));
}

TEST_F(Report, WritesDataAndScriptsWithoutGnuplot) {
  play();
  const Path path(folder_.path().string());
  reported(folder_.path());
  EXPECT_FALSE(content_of(folder_ / "plots/scores.csv").empty());
  EXPECT_TRUE(has(content_of(folder_ / "plots/scores.gp"), "set output 'scores.svg'"));
  EXPECT_TRUE(has(markdown(), "apt-get install gnuplot-nox"));
  EXPECT_FALSE(has(html(), "<figure>"));
}

TEST_F(Report, ShowsTheScenariosTextVerbatim) {
  play("<script>alert(1)</script> & \"x\"");
  reported(folder_.path());
  EXPECT_FALSE(has(html(), "<script>"));
  EXPECT_TRUE(has(html(), "<h1>&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;x&quot;</h1>"));
  EXPECT_TRUE(has(markdown(), "# \\<script\\>alert(1)\\</script\\> \\& \"x\"\n"));
}

TEST_F(Report, SaysWhichGamesAreMissing) {
  play();
  const std::string rows = content_of(shard_of(folder_.path()));
  write_content(shard_of(folder_.path()), rows.substr(0, rows.size() * 2 / 3));
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(), "games are missing. Do not stop early because of interim intervals"));
}

TEST_F(Report, DoesNotWarnOfStoppingEarlyWhenAllGamesAreDone) {
  play();
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(), "| games | 12 of 12 |\n")) << markdown();
  EXPECT_TRUE(has(markdown(), "| void games | 0 |\n"));
  EXPECT_FALSE(has(markdown(), "are missing"));
}

TEST_F(Report, NamesVoidGamesAndWhy) {
  ExperimentOptions options = fake_options(folder_.path());
  options.play = [](const game::GameConfiguration& game) {
    if (game.b.robots.size() == 5) throw std::runtime_error("the ball is gone");
    return fake_game(game);
  };
  run_experiment(small_sweep(1), options);
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(), "| void games | 2 |\n"));
  EXPECT_TRUE(has(markdown(), "- b.robots=5-p0001-1: the game threw: the ball is gone\n"))
      << markdown();
}

TEST_F(Report, ListsWhatIsNotTheDefault) {
  Scenario sweep = small_sweep(1);
  sweep.as<Sweep>()->base.match.half_s = 77;
  run_experiment(sweep, fake_options(folder_.path()));
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(), "| match.half\\_s | 77.0 | 600.0 |\n")) << markdown();
  EXPECT_FALSE(has(markdown(), "match.halves"));
}

TEST_F(Report, HasACrosstableForARoundRobin) {
  run_experiment(small_roundrobin({6, 16}, 1), fake_options(folder_.path()));
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(), "| team1 |  | 6 (+")) << markdown();
  EXPECT_TRUE(has(markdown(), "| team0 | 0 (-")) << markdown();
}

TEST_F(Report, HasTheBracketOfACup) {
  Knockout knockout;
  knockout.order = {"team0", "team1", "team2"};
  for (std::size_t i = 0; i < 3; ++i)
    knockout.teams[knockout.order[i]].robots = 4 + static_cast<int>(i);
  ExperimentOptions options = fake_options(folder_.path());
  options.play = [](const game::GameConfiguration& game) {
    game::GameRecord record = fake_game(game);
    record.goals_a = 2;
    record.goals_b = 1;
    return record;
  };
  run_experiment({"A cup.", knockout}, options);
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(),
                  "## Bracket\n\n| semi-finals | final |\n|---|---|\n"
                  "|  | **team0** 2 : 1 team1 |\n"
                  "| **team1** 2 : 1 team2 |  |\n"))
      << markdown();
  EXPECT_TRUE(has(html(), "<strong>team0</strong><strong>2</strong>")) << html();
}

// Each game is drawn, and the team with more robots wins the shoot-out.
game::GameRecord shoot_out(const game::GameConfiguration& game) {
  game::GameRecord record = fake_game(game);
  record.goals_a = record.goals_b = 1;
  record.end_reason = game::EndReason::kShootout;
  const bool a_wins = game.a.robots.size() > game.b.robots.size();
  record.shootout = {{a_wins ? 3 : 2, a_wins ? 2 : 3}};
  return record;
}

TEST_F(Report, CountsTheWinnerOfAShootOutAsTheWinnerEverywhere) {
  ExperimentOptions options = fake_options(folder_.path());
  options.play = shoot_out;
  const ExperimentResults results = run_experiment(small_roundrobin({5, 6}, 2), options).results;
  ASSERT_EQ(results.standings.size(), 2U);
  EXPECT_EQ(results.standings[0].team, "team1");
  EXPECT_EQ(results.standings[0].points(), 12);
  EXPECT_EQ(results.standings[0].goals_for, 4);  // shoot-out kicks do not count as goals
  EXPECT_EQ(results.shown[0].rows[1][4], "4");   // games won, as in the output of the run
  ASSERT_NE(results.json, nullptr);
  const io::Json& first = results.json->at("standings").at(0);
  EXPECT_EQ(first.at("team"), "team1");
  EXPECT_EQ(first.at("points"), 12);
  reported(folder_.path());
  EXPECT_TRUE(has(markdown(), "| team1 |  | 12 (+0.00) |")) << markdown();
  EXPECT_TRUE(has(markdown(), "| team1 | 4 | 100 % \\[40, 100\\] | 0 % \\[0, 60\\] |"))
      << markdown();
  EXPECT_TRUE(has(markdown(), "The winner of a shoot-out wins the game."));
}

}  // namespace
}  // namespace autoref::experiments
