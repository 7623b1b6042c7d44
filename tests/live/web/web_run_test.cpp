#include "live/web/web_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "tests/support/web_client.hpp"

namespace autoref::live {
namespace {

const std::string kTitle = "Cup <b>of</b> \"five\" & more";

class WebRunTest : public testing::Test {
 protected:
  int port() const {
    const std::string url = run_.url();
    return std::stoi(url.substr(url.rfind(':') + 1));
  }

  std::string get(const std::string& path, const std::string& host = "localhost") const {
    return answer(port(), fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", path, host));
  }

  // The first messages to a new watcher.
  std::vector<io::Json> messages(std::size_t count) const {
    WebClient client(port());
    client.send(upgrade_request(port()));
    client.header();
    std::vector<io::Json> all;
    while (all.size() < count) all.push_back(io::Json::parse(client.message().value()));
    return all;
  }

  io::Json games() {
    run_.show({});
    return messages(4)[3];
  }

  WebRun run_{{}, kTitle, [](const std::string& id) -> std::optional<std::string> {
                return id == "p0001-1" ? std::optional<std::string>("its page") : std::nullopt;
              }};
};

TEST_F(WebRunTest, ServesAPageWithTheTitleAsText) {
  const std::string page = get("/");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200"));
  EXPECT_NE(page.find("<h1>Cup &lt;b&gt;of&lt;/b&gt; &quot;five&quot; &amp; more</h1>"),
            std::string::npos);
  EXPECT_EQ(page.find("<b>of"), std::string::npos);
}

// Results are HTML. If a name got into them as markup, it could not run anything.
TEST_F(WebRunTest, AllowsOnlyItsOwnScript) {
  const std::string page = get("/");
  EXPECT_NE(page.find("script-src 'nonce-run'"), std::string::npos);
  EXPECT_EQ(page.find("script-src 'unsafe-inline'"), std::string::npos);
}

TEST_F(WebRunTest, LooksLikeTheGamesPage) {
  const std::string page = get("/");
  EXPECT_NE(page.find("--accent: #58d09a;"), std::string::npos);
  EXPECT_NE(page.find(".bracket {"), std::string::npos);
}

TEST_F(WebRunTest, RefusesOtherHosts) {
  EXPECT_TRUE(get("/", "evil.example").starts_with("HTTP/1.1 421"));
}

TEST_F(WebRunTest, ServesPagesOfGames) {
  EXPECT_NE(get("/game?p0001-1").find("its page"), std::string::npos);
  EXPECT_TRUE(get("/game?p0002-1").starts_with("HTTP/1.1 404"));
}

TEST_F(WebRunTest, SendsNewWatchersTheNewestOfEachKind) {
  run_.show({1, 12, "1/12 games"});
  run_.show({2, 12, "2/12 games", "Do not stop early."});
  run_.show_results("<h2>Standings</h2>");
  const std::vector<io::Json> all = messages(4);
  EXPECT_EQ(all[0]["type"], "start");
  EXPECT_EQ(all[0]["title"], kTitle);
  EXPECT_EQ(all[1]["done"], 2);
  EXPECT_EQ(all[1]["total"], 12);
  EXPECT_EQ(all[1]["text"], "2/12 games");
  EXPECT_EQ(all[1]["remark"], "Do not stop early.");
  EXPECT_EQ(all[2]["html"], "<h2>Standings</h2>");
}

TEST_F(WebRunTest, SaysToLateWatchersThatTheRunIsOver) {
  run_.end("The run is over.");
  EXPECT_EQ(messages(5)[4]["text"], "The run is over.");
}

TEST_F(WebRunTest, ListsRunningGamesAndThenTheirResults) {
  run_.start_game({"p0001-1", "a : b", true});
  run_.start_game({"p0001-2", "b : a", false});
  run_.start_game({"p0001-2", "b : a", false});  // its worker died
  EXPECT_EQ(run_.end_game("p0001-1", "a 3:1 b"), std::nullopt);
  const io::Json list = games();
  ASSERT_EQ(list["running"].size(), 1U);
  EXPECT_EQ(list["running"][0]["id"], "p0001-2");
  EXPECT_EQ(list["running"][0]["has_page"], false);
  ASSERT_EQ(list["ended"].size(), 1U);
  EXPECT_EQ(list["ended"][0]["text"], "a 3:1 b");
  EXPECT_EQ(list["ended"][0]["has_page"], true);
}

// A run of short scenes ends more than a hundred per second.
TEST_F(WebRunTest, SendsTheListOfGamesOnlyWithTheProgress) {
  WebClient client(port());
  client.send(upgrade_request(port()));
  client.header();
  for (int i = 0; i < 4; ++i) client.message();
  for (int i = 0; i < 1000; ++i) {
    run_.start_game({std::to_string(i), "a : b", true});
    run_.end_game(std::to_string(i), "a 0:0 b");
  }
  run_.show({1000, 2000, "1000/2000 games"});
  run_.show({1001, 2000, "1001/2000 games"});
  for (const char* const type : {"progress", "games", "progress"})
    EXPECT_EQ(io::Json::parse(client.message().value())["type"], type);
}

TEST_F(WebRunTest, ListsALimitedNumberOfGames) {
  const std::size_t count = WebRun::kMostRunning + WebRun::kMostEnded + 1;
  for (std::size_t i = 0; i < count; ++i) run_.start_game({std::to_string(i), "a : b", true});
  EXPECT_EQ(games()["running"].size(), WebRun::kMostRunning);
  std::optional<std::string> dropped;
  for (std::size_t i = 0; i <= WebRun::kMostEnded; ++i)
    dropped = run_.end_game(std::to_string(i), "a 0:0 b");
  EXPECT_EQ(dropped, "0");
  EXPECT_EQ(games()["ended"].size(), WebRun::kMostEnded);
}

}  // namespace
}  // namespace autoref::live
