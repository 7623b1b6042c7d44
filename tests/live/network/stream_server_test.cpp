#include "live/network/stream_server.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "io/errors.hpp"
#include "league/team/delimited.hpp"
#include "tests/live/simulator/caller.hpp"

namespace autoref::live {
namespace {

constexpr std::chrono::hours kLong{1};

// A server that answers each message with the same, in brackets.
class StreamServerTest : public testing::Test {
 protected:
  static std::string in_brackets(std::string_view message, const Address&) {
    return "<" + std::string(message) + ">";
  }

  NetworkThread thread_;
  StreamServer server_{thread_, {}, in_brackets, kLong};
};

TEST_F(StreamServerTest, AnswersMessagesInOrder) {
  Caller caller(server_.port());
  caller.say("one");
  caller.say("two");
  EXPECT_EQ(caller.hear(), "<one>");
  EXPECT_EQ(caller.hear(), "<two>");
}

TEST_F(StreamServerTest, ReadsMessagesThatComeInPieces) {
  Caller caller(server_.port());
  std::string bytes;
  league::append_delimited(std::string(300, 'x'), bytes);
  for (const char byte : bytes) caller.send({&byte, 1});
  EXPECT_EQ(caller.hear(), "<" + std::string(300, 'x') + ">");
}

TEST_F(StreamServerTest, ReadsMessagesOf64KiB) {
  Caller caller(server_.port());
  ASSERT_TRUE(caller.say(std::string(65534, 'x')));
  EXPECT_EQ(caller.hear().size(), 65536U);
}

TEST_F(StreamServerTest, ClosesAConnectionWhoseMessageIsTooLong) {
  Caller caller(server_.port());
  caller.send("\x81\x80\x04");  // 65537
  EXPECT_EQ(caller.hear(), "closed");
  EXPECT_EQ(server_.troubles().invalid, 1);
}

TEST_F(StreamServerTest, SendsLaterToTheOneWhoAsked) {
  Caller first(server_.port());
  Caller second(server_.port());
  first.say("first");
  second.say("second");
  first.hear();
  second.hear();
  server_.send("later", {kLoopback, second.port()});
  server_.send("last", {kLoopback, first.port()});
  EXPECT_EQ(second.hear(), "later");
  EXPECT_EQ(first.hear(), "last");
}

TEST_F(StreamServerTest, IgnoresResponsesToConnectionsThatAreClosed) {
  int port = 0;
  {
    Caller caller(server_.port());
    port = caller.port();
    caller.say("hello");
    caller.hear();
  }
  server_.send("later", {kLoopback, port});
  Caller other(server_.port());
  other.say("still there?");
  EXPECT_EQ(other.hear(), "<still there?>");
}

// As many connections as there is room for, each with an answered message.
std::vector<std::unique_ptr<Caller>> callers_of(const StreamServer& server) {
  std::vector<std::unique_ptr<Caller>> callers;
  for (std::size_t i = 0; i < kMostConnections; ++i) {
    callers.push_back(std::make_unique<Caller>(server.port()));
    callers.back()->say("hello");
    EXPECT_EQ(callers.back()->hear(), "<hello>");
  }
  return callers;
}

TEST_F(StreamServerTest, RefusesConnectionsWhileTheOthersAreNotSilent) {
  const auto callers = callers_of(server_);
  Caller late(server_.port());
  EXPECT_EQ(late.hear(), "closed");
  EXPECT_EQ(server_.troubles().refused, 1);
}

TEST_F(StreamServerTest, TheConnectionThatIsSilentForLongestGivesWay) {
  StreamServer server(thread_, {}, in_brackets, std::chrono::milliseconds(0));
  const auto callers = callers_of(server);
  callers.front()->say("not the longest");
  EXPECT_EQ(callers.front()->hear(), "<not the longest>");
  Caller late(server.port());
  late.say("hello");
  EXPECT_EQ(late.hear(), "<hello>");
  EXPECT_EQ(callers[1]->hear(), "closed");
}

TEST_F(StreamServerTest, ClosesAConnectionWhoseResponsesAreNotRead) {
  Caller caller(server_.port());
  // More than the server keeps and the system's buffers hold.
  for (int i = 0; i < 4000; ++i) {
    if (!caller.say(std::string(60000, 'x'))) break;
  }
  while (caller.hear() != "closed") {
  }
  EXPECT_EQ(server_.troubles().unread, 1);
}

TEST_F(StreamServerTest, APortInUseIsAnErrorThatNamesItsOption) {
  try {
    const StreamServer second(thread_, {kLoopback, "", server_.port(), "--blue-port"}, in_brackets);
    FAIL() << "the port is free";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--blue-port"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace autoref::live
