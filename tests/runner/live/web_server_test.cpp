#include "runner/live/web_server.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "runner/io/errors.hpp"
#include "tests/runner/live/web_client.hpp"

namespace autoref::runner {
namespace {

using std::chrono::milliseconds;

constexpr int kMostAttempts = 2000;

WebText web_text(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

class Web : public testing::Test {
 protected:
  explicit Web(const WebOptions& options = {})
      : server_(thread_, options,
                {"the page",
                 [] {
                   return WebBacklog{{web_text("so far")}, 0};
                 },
                 [](const std::string& id) {
                   return id == "p0001-1" ? std::optional<std::string>("a game") : std::nullopt;
                 }}) {}

  std::string get(const std::string& path) const {
    return answer(server_.port(),
                  fmt::format("GET {} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", path, port()));
  }

  // A connected watcher that has read the backlog.
  std::unique_ptr<WebClient> watcher() const {
    auto client = std::make_unique<WebClient>(port());
    client->send(upgrade_request(port()));
    EXPECT_TRUE(client->header().starts_with("HTTP/1.1 101"));
    EXPECT_EQ(client->message(), "so far");
    return client;
  }

  int port() const { return server_.port(); }

  NetworkThread thread_;
  WebServer server_;
  std::int64_t sent_ = 0;

  void send(std::string text, bool is_frame) {
    server_.send({web_text(std::move(text)), is_frame, ++sent_});
  }
};

TEST_F(Web, ServesThePage) {
  const std::string page = get("/");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200 OK\r\n")) << page;
  EXPECT_TRUE(page.ends_with("\r\n\r\nthe page")) << page;
}

TEST_F(Web, ServesThePageOfAGameThatItKnows) {
  EXPECT_TRUE(get("/game?p0001-1").ends_with("\r\n\r\na game"));
  EXPECT_TRUE(get("/game?p0001-2").starts_with("HTTP/1.1 404"));
}

TEST_F(Web, HasNothingElse) {
  EXPECT_TRUE(get("/etc/passwd").starts_with("HTTP/1.1 404"));
  EXPECT_TRUE(get("/live").starts_with("HTTP/1.1 426"));
}

TEST_F(Web, RefusesAWebSocketOfAForeignPage) {
  const std::string refused =
      answer(port(), upgrade_request(port(), "Origin: http://example.com\r\n"));
  EXPECT_TRUE(refused.starts_with("HTTP/1.1 403")) << refused;
}

TEST_F(Web, DropsARequestThatIsTooLong) {
  const std::string request = "GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(9000, 'x');
  EXPECT_EQ(answer(port(), request), "");
}

TEST_F(Web, SendsMessagesToAllWatchers) {
  const auto first = watcher();
  const auto second = watcher();
  send("a frame", true);
  send("a call", false);
  for (WebClient* client : {first.get(), second.get()}) {
    EXPECT_EQ(client->message(), "a frame");
    EXPECT_EQ(client->message(), "a call");
  }
}

TEST_F(Web, DisconnectsAWatcherThatSendsALongMessage) {
  const auto client = watcher();
  client->send(text_frame(std::string(17, 'x')));
  EXPECT_EQ(client->message(), std::nullopt);
}

TEST_F(Web, DisconnectsAWatcherThatSendsManyMessages) {
  const auto client = watcher();
  for (int i = 0; i < 101; ++i) client->send(text_frame("x"));
  EXPECT_EQ(client->message(), std::nullopt);
}

TEST_F(Web, LeavesOutFramesForAWatcherThatDoesNotRead) {
  const auto slow = watcher();
  const auto steady = watcher();
  const std::string frame(10'000, 'x');
  constexpr int kFrames = 4000;
  for (int i = 0; i < kFrames; ++i) {
    send(frame, true);
    // Keeps the server from handing over many messages at once.
    EXPECT_EQ(steady->message(), frame);
  }
  send("a call", false);
  EXPECT_EQ(steady->message(), "a call");
  int frames = 0;
  std::optional<std::string> message;
  while ((message = slow->message()) == frame) ++frames;
  EXPECT_EQ(message, "a call");
  EXPECT_LT(frames, kFrames);
}

TEST_F(Web, DisconnectsWatchersWhenTheGameOutrunsTheServer) {
  const auto client = watcher();
  for (int i = 0; i < 100'000; ++i) send("a call", false);
  std::optional<std::string> message;
  int messages = 0;
  while ((message = client->message())) ++messages;
  EXPECT_LT(messages, 100'000);
}

TEST_F(Web, APortInUseIsAnErrorThatNamesTheOption) {
  WebOptions options;
  options.address.port = port();
  try {
    const WebServer second(thread_, options, {"", [] { return WebBacklog{}; }});
    FAIL() << "the port is free";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--web"), std::string::npos) << error.what();
  }
}

TEST_F(Web, AnAddressOfAnotherComputerIsAnError) {
  WebOptions options;
  options.address.host = "192.0.2.1";
  EXPECT_THROW(WebServer(thread_, options, {"", [] { return WebBacklog{}; }}), InputError);
}

struct ImpatientWeb : Web {
  ImpatientWeb() : Web({{kLoopback, 0}, 1, milliseconds(50), milliseconds(50)}) {}

  std::string reply_to_a_watcher() const {
    WebClient client(port());
    client.send(upgrade_request(port()));
    return client.header();
  }

  // Whether another watcher is accepted after some time.
  bool gets_room() const {
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
      if (reply_to_a_watcher().starts_with("HTTP/1.1 101")) return true;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return false;
  }
};

TEST_F(ImpatientWeb, HasRoomForAFewWatchersOnly) {
  const auto only = watcher();
  EXPECT_TRUE(reply_to_a_watcher().starts_with("HTTP/1.1 503"));
}

TEST_F(ImpatientWeb, HasRoomAgainWhenAWatcherHasGone) {
  watcher().reset();
  EXPECT_TRUE(gets_room());
}

TEST_F(ImpatientWeb, DropsARequestThatDoesNotEnd) {
  WebClient client(port());
  client.send("GET / HTTP/1.1\r\n");
  EXPECT_EQ(client.rest(), "");
}

TEST_F(ImpatientWeb, DisconnectsAWatcherThatTakesNothing) {
  const auto stopped = watcher();
  const std::string call(60'000, 'x');
  for (int i = 0; i < 200; ++i) send(call, false);  // more than the sockets hold
  EXPECT_TRUE(gets_room());
}

}  // namespace
}  // namespace autoref::runner
