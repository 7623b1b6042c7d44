// The page of a run, with fake games.
#include "app/experiment/shown_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/experiments/run/fake_games.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/web_client.hpp"

namespace autoref::app {
namespace {

// The port in "watch at http://127.0.0.1:8090/".
int port_in(const std::string& message) {
  return std::stoi(message.substr(message.rfind(':') + 1));
}

// A run on any free port.
class ShownRunTest : public testing::Test {
 protected:
  void show(const experiments::Scenario& scenario) {
    testing::internal::CaptureStderr();
    shown_.emplace(scenario, "spring", WebFlags{"0", {}}, options_);
    port_ = port_in(testing::internal::GetCapturedStderr());
  }

  std::string page(const std::string& path = "/") const {
    return answer(port_, fmt::format("GET {} HTTP/1.1\r\nHost: localhost\r\n\r\n", path));
  }

  // The newest message of each type.
  std::map<std::string, io::Json> messages() const {
    WebClient client(port_);
    client.send(upgrade_request(port_));
    client.header();
    std::map<std::string, io::Json> by_type;
    while (by_type.size() < 4) {
      const io::Json message = io::Json::parse(client.message().value());
      by_type[message["type"]] = message;
    }
    return by_type;
  }

  TemporaryFolder folder_;
  experiments::ExperimentOptions options_ = experiments::fake_options(folder_.path());
  std::optional<ShownRun> shown_;
  int port_ = 0;
};

TEST_F(ShownRunTest, HasTheScenariosTextAsTitleOrTheFilesName) {
  experiments::Scenario scenario = experiments::small_roundrobin({6, 16});
  scenario.about = "A <i>league</i>.";
  show(scenario);
  EXPECT_TRUE(has(page(), "<h1>A &lt;i&gt;league&lt;/i&gt;.</h1>"));
  scenario.about.clear();
  show(scenario);
  EXPECT_TRUE(has(page(), "<h1>spring</h1>"));
}

TEST_F(ShownRunTest, ShowsResultsProgressAndGames) {
  const experiments::Scenario scenario = experiments::small_roundrobin({6, 16}, 2);
  show(scenario);
  experiments::run_experiment(scenario, options_);
  std::map<std::string, io::Json> all = messages();
  EXPECT_EQ(all["progress"]["done"], 4);
  EXPECT_EQ(all["progress"]["total"], 4);
  EXPECT_EQ(all["progress"]["remark"], "");
  EXPECT_TRUE(has(all["results"]["html"], "<h2>Standings</h2>"));
  EXPECT_TRUE(all["games"]["running"].empty());
  ASSERT_EQ(all["games"]["ended"].size(), 4U);
  EXPECT_EQ(all["games"]["ended"][0]["has_page"], true);
}

TEST_F(ShownRunTest, WarnsOfInterimIntervalsWhileGamesAreMissing) {
  const experiments::Scenario scenario = experiments::small_roundrobin({6, 16}, 2);
  show(scenario);
  options_.show(scenario.experiment().results({}));
  options_.publish({.total = 4, .done = 1}, "1/4 games");
  EXPECT_TRUE(has(messages()["progress"]["remark"], "Do not stop early"));
}

TEST_F(ShownRunTest, ForgetsGamesThatAreNotListedAnyMore) {
  const experiments::Scenario scenario = experiments::small_roundrobin({6, 16}, 17);
  show(scenario);
  experiments::run_experiment(scenario, options_);
  const io::Json list = messages()["games"];
  ASSERT_EQ(list["ended"].size(), live::WebRun::kMostEnded);
  EXPECT_TRUE(page("/game?team0~team1-p0001-1").starts_with("HTTP/1.1 404"));
}

TEST_F(ShownRunTest, IsNotServedWithoutAnAddress) {
  ShownRun shown(experiments::small_sweep(), "spring", WebFlags{}, options_);
  EXPECT_FALSE(options_.publish);
  EXPECT_FALSE(options_.show);
  shown.end();
}

}  // namespace
}  // namespace autoref::app
