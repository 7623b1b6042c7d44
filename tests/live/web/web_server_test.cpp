#include "live/web/web_server.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "io/errors.hpp"
#include "tests/support/web_client.hpp"

namespace autoref::live {
namespace {

using std::chrono::milliseconds;

constexpr std::chrono::minutes kPatience{10};  // nobody is disconnected because the machine is busy
constexpr milliseconds kImpatience{300};

WebText web_text(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

class Web : public testing::Test {
 protected:
  explicit Web(const WebOptions& options = {{kLoopback, 0}, 32, kPatience, kPatience})
      : server_(thread_, options,
                {"the page",
                 [] {
                   return WebBacklog{{web_text("so far")}, 0};
                 },
                 [this](const std::string& id) { return game_page(id); }}) {}

  std::string get(const std::string& path) const {
    return answer(server_.port(),
                  fmt::format("GET {} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", path, port()));
  }

  // A connected watcher that has read the backlog.
  std::unique_ptr<WebClient> watcher(std::optional<int> receive_buffer = std::nullopt) const {
    auto client = std::make_unique<WebClient>(port(), receive_buffer);
    client->send(upgrade_request(port()));
    EXPECT_TRUE(client->header().starts_with("HTTP/1.1 101"));
    EXPECT_EQ(client->message(), "so far");
    return client;
  }

  // How many of the messages a watcher gets that are sent while the server's thread is busy.
  int received_while_busy(int count, const std::string& text) {
    const auto client = watcher();
    const WebClient busy(port());
    busy.send(fmt::format("GET /game?p0002-1 HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", port()));
    is_busy_.get_future().wait();
    for (int i = 0; i < count; ++i) send(text, false);
    released_.set_value();
    int messages = 0;
    while (client->message()) ++messages;
    return messages;
  }

  int port() const { return server_.port(); }

  // The page of game p0002-1 keeps the server's thread busy until it is released.
  std::optional<std::string> game_page(const std::string& id) {
    if (id == "p0002-1") {
      is_busy_.set_value();
      released_.get_future().wait();
    }
    return id == "p0001-1" ? std::optional<std::string>("a game") : std::nullopt;
  }

  std::promise<void> is_busy_;
  std::promise<void> released_;
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

TEST_F(Web, SaysToAPersonWhatToDoAboutAnUnknownHost) {
  const std::string refused = answer(port(), "GET / HTTP/1.1\r\nHost: Example.com:80\r\n\r\n");
  EXPECT_TRUE(refused.starts_with("HTTP/1.1 421 ")) << refused;
  EXPECT_TRUE(refused.ends_with(
      "AutoRef does not answer to the name example.com:80. Open the page at this computer's "
      "numeric address, or start AutoRef with --web-host and this name.\n"))
      << refused;
}

constexpr const char* kOtherComputer = "127.0.0.2";

std::vector<std::unique_ptr<WebClient>> silent_clients(int port, const char* from) {
  std::vector<std::unique_ptr<WebClient>> clients;
  for (int i = 0; i < 100; ++i)
    clients.push_back(std::make_unique<WebClient>(port, std::nullopt, from));
  return clients;
}

TEST_F(Web, ConnectionsThatAskForNothingDoNotKeepABrowserOut) {
  const auto silent = silent_clients(port(), kLoopback);
  EXPECT_TRUE(get("/").ends_with("\r\n\r\nthe page"));
}

TEST_F(Web, AnotherComputersConnectionsDoNotEndASlowRequest) {
  WebClient slow(port());
  slow.send("GET / HTTP/1.1\r\n");
  const auto silent = silent_clients(port(), kOtherComputer);
  EXPECT_EQ(silent.front()->rest(), "");  // made room
  slow.send("Host: localhost\r\n\r\n");
  EXPECT_TRUE(slow.rest().ends_with("\r\n\r\nthe page"));
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
  const auto slow = watcher(16'384);
  const auto steady = watcher();
  const std::string frame(10'000, 'x');
  constexpr int kFrames = 400;
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
  EXPECT_LT(received_while_busy(100'000, "a call"), 100'000);
}

TEST_F(Web, DisconnectsWatchersWhenTooManyBytesWaitForTheServer) {
  const std::string call(kMostWaiting_bytes / 100, 'x');
  EXPECT_LT(received_while_busy(200, call), 200);
}

TEST_F(Web, APortInUseIsAnErrorThatNamesTheOption) {
  WebOptions options;
  options.address.port = port();
  try {
    const WebServer second(thread_, options, {"", [] { return WebBacklog{}; }});
    FAIL() << "the port is free";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--web"), std::string::npos) << error.what();
  }
}

TEST_F(Web, AnAddressOfAnotherComputerIsAnError) {
  WebOptions options;
  options.address.host = "192.0.2.1";
  EXPECT_THROW(WebServer(thread_, options, {"", [] { return WebBacklog{}; }}), io::InputError);
}

// Has room for one watcher.
struct SmallWeb : Web {
  explicit SmallWeb(milliseconds header_time = kPatience, milliseconds write_time = kPatience)
      : Web({{kLoopback, 0}, 1, header_time, write_time}) {}

  std::string reply_to_a_watcher() const {
    WebClient client(port());
    client.send(upgrade_request(port()));
    return client.header();
  }

  // Whether another watcher is accepted within a minute.
  bool gets_room() const {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!reply_to_a_watcher().starts_with("HTTP/1.1 101")) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return true;
  }
};

TEST_F(SmallWeb, HasRoomForAFewWatchersOnly) {
  const auto only = watcher();
  EXPECT_TRUE(reply_to_a_watcher().starts_with("HTTP/1.1 503"));
}

TEST_F(SmallWeb, HasRoomAgainWhenAWatcherHasGone) {
  watcher().reset();
  EXPECT_TRUE(gets_room());
}

// Has room for four watchers.
struct SharedWeb : Web {
  SharedWeb() : Web({{kLoopback, 0}, 4, kPatience, kPatience}) {}

  // The new watcher's answer; it goes on watching.
  std::string watch_from(const char* computer) {
    watching_.push_back(std::make_unique<WebClient>(port(), std::nullopt, computer));
    watching_.back()->send(upgrade_request(port()));
    return watching_.back()->header().substr(0, 12);
  }

  std::vector<std::unique_ptr<WebClient>> watching_;
};

TEST_F(SharedWeb, GivesEveryComputerItsShare) {
  for (int i = 0; i < 4; ++i) EXPECT_EQ(watch_from(kOtherComputer), "HTTP/1.1 101");
  EXPECT_EQ(watch_from(kOtherComputer), "HTTP/1.1 503");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(watch_from(kLoopback), "HTTP/1.1 101");
  EXPECT_EQ(watch_from(kLoopback), "HTTP/1.1 503");
  EXPECT_EQ(watch_from(kOtherComputer), "HTTP/1.1 503");
}

struct WebThatWaitsForRequests : SmallWeb {
  WebThatWaitsForRequests() : SmallWeb(kImpatience) {}
};

TEST_F(WebThatWaitsForRequests, DropsOneThatDoesNotEnd) {
  WebClient client(port());
  client.send("GET / HTTP/1.1\r\n");
  EXPECT_EQ(client.rest(), "");
}

TEST_F(WebThatWaitsForRequests, DropsOneThatComesByteByByte) {
  const WebClient client(port());
  client.send("GET / HTTP/1.1\r\nX: ");
  int bytes = 0;
  while (bytes < 1'000 && client.send("x")) {
    ++bytes;
    std::this_thread::sleep_for(milliseconds(20));
  }
  EXPECT_LT(bytes, 1'000);
}

struct WebThatWaitsForWatchers : SmallWeb {
  WebThatWaitsForWatchers() : SmallWeb(kPatience, kImpatience) {}
};

TEST_F(WebThatWaitsForWatchers, DisconnectsOneThatTakesNothing) {
  const auto stopped = watcher();
  const std::string call(60'000, 'x');
  for (int i = 0; i < 200; ++i) send(call, false);  // more than the sockets hold
  EXPECT_TRUE(gets_room());
}

// Its page is more than the sockets hold.
struct WebWithALongPage : testing::Test {
  NetworkThread thread_;
  WebServer server_{thread_,
                    {{kLoopback, 0}, 1, kPatience, kImpatience},
                    {std::string(30'000'000, 'x'), [] { return WebBacklog{}; }}};
};

TEST_F(WebWithALongPage, DisconnectsOneThatDoesNotTakeIt) {
  WebClient client(server_.port(), 16'384);
  client.send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  std::this_thread::sleep_for(10 * kImpatience);
  EXPECT_LT(client.rest().size(), 30'000'000U);
}

}  // namespace
}  // namespace autoref::live
