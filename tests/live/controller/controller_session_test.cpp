#include "live/controller/controller_session.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "league/messages/game_controller.pb.h"
#include "league/team/delimited.hpp"

namespace autoref::live {
namespace {

constexpr int kOk = 1;
constexpr int kRejected = 2;

std::string reply(int status, const std::string& reason = "") {
  league::ControllerToAutoRef message;
  message.mutable_controller_reply()->set_status_code(status);
  message.mutable_controller_reply()->set_reason(reason);
  std::string bytes;
  league::append_delimited(message, bytes);
  return bytes;
}

template <typename Message>
Message message_in(const std::string& bytes) {
  Message message;
  const auto extent = league::find_delimited(bytes);
  EXPECT_TRUE(extent && extent->end == bytes.size());
  const std::string content = extent ? bytes.substr(extent->begin, extent->size) : std::string();
  EXPECT_TRUE(message.ParseFromString(content));
  return message;
}

GameEvent event_called(const std::string& id) {
  GameEvent event;
  event.type = GameEventType::kGoal;
  event.id = id;
  return event;
}

class ControllerSessionTest : public testing::Test {
 protected:
  ControllerSessionTest() { session_.begin(0); }

  void register_at(double now_s) {
    session_.receive(reply(kOk), now_s);
    session_.send(now_s);
    session_.receive(reply(kOk), now_s);
  }

  // The id of the event that is sent now; empty for a sign of life or nothing.
  std::string sent_at(double now_s) {
    const std::string bytes = session_.send(now_s);
    return bytes.empty() ? "" : message_in<league::AutoRefToController>(bytes).game_event().id();
  }

  ControllerSession session_{"AutoRef"};
};

TEST_F(ControllerSessionTest, TheControllerSpeaksFirst) {
  EXPECT_EQ(session_.send(0.1), "");
  session_.receive(reply(kOk), 0.2);
  EXPECT_EQ(message_in<league::AutoRefRegistration>(session_.send(0.3)).identifier(), "AutoRef");
  EXPECT_FALSE(session_.is_registered());
  session_.receive(reply(kOk), 0.4);
  EXPECT_TRUE(session_.is_registered());
}

TEST_F(ControllerSessionTest, ARefusedRegistrationIsAFaultWithTheReason) {
  session_.receive(reply(kOk), 0);
  session_.send(0);
  try {
    session_.receive(reply(kRejected, "name taken"), 0);
    FAIL() << "was accepted";
  } catch (const ControllerFault& fault) {
    EXPECT_NE(std::string(fault.what()).find("name taken"), std::string::npos) << fault.what();
  }
}

TEST_F(ControllerSessionTest, OneEventAtATimeWaitsForItsReply) {
  register_at(0);
  session_.report(event_called("1"), 0);
  session_.report(event_called("2"), 0);
  EXPECT_EQ(sent_at(0), "1");
  EXPECT_EQ(session_.send(0.1), "");
  session_.receive(reply(kOk), 0.2);
  EXPECT_EQ(sent_at(0.2), "2");
  session_.receive(reply(kRejected, "unknown"), 0.3);
  EXPECT_EQ(session_.counts().accepted, 1);
  EXPECT_EQ(session_.counts().rejected, 1);
  EXPECT_EQ(session_.counts().last_rejection, "unknown");
}

TEST_F(ControllerSessionTest, AnEventWithoutAReplyIsSentAgainOverTheNextConnection) {
  register_at(0);
  session_.report(event_called("1"), 0);
  EXPECT_EQ(sent_at(0), "1");
  session_.begin(2);
  register_at(2);
  EXPECT_EQ(sent_at(2), "1");
}

TEST_F(ControllerSessionTest, EventsThatWaitedTooLongAreDroppedAndCounted) {
  session_.report(event_called("1"), 0);
  const double later_s = ControllerSession::kLongestWait_s + 1;
  session_.begin(later_s);
  register_at(later_s);
  EXPECT_EQ(sent_at(later_s), "");
  EXPECT_EQ(session_.counts().dropped, 1);
}

TEST_F(ControllerSessionTest, AFullQueueDropsTheOldestEvent) {
  for (std::size_t i = 0; i <= ControllerSession::kMostWaiting; ++i)
    session_.report(event_called(std::to_string(i)), 0);
  EXPECT_EQ(session_.waiting(), ControllerSession::kMostWaiting);
  EXPECT_EQ(session_.counts().dropped, 1);
  register_at(0);
  EXPECT_EQ(sent_at(0), "1");
}

TEST_F(ControllerSessionTest, ASignOfLifeFollowsEverySilentSecond) {
  register_at(0);
  EXPECT_EQ(session_.send(0.9), "");
  const std::string sign = session_.send(1.1);
  EXPECT_FALSE(message_in<league::AutoRefToController>(sign).has_game_event());
  EXPECT_FALSE(sign.empty());
}

TEST_F(ControllerSessionTest, AMissingReplyIsAFaultAfterAWhile) {
  register_at(0);
  session_.report(event_called("1"), 0);
  session_.send(0);
  EXPECT_EQ(session_.send(ControllerSession::kLongestReply_s - 0.1), "");
  EXPECT_THROW(session_.send(ControllerSession::kLongestReply_s + 0.1), ControllerFault);
}

TEST_F(ControllerSessionTest, RepliesMayArriveInPieces) {
  const std::string bytes = reply(kOk);
  session_.receive(bytes.substr(0, 1), 0);
  EXPECT_EQ(session_.send(0), "");
  session_.receive(bytes.substr(1), 0);
  EXPECT_NE(session_.send(0), "");
}

TEST_F(ControllerSessionTest, BytesThatAreNoReplyAreAFault) {
  EXPECT_THROW(session_.receive("\xff\xff\xff\xff\xff", 0), ControllerFault);
  EXPECT_THROW(ControllerSession("AutoRef").receive("\x02\xff\xff", 0), ControllerFault);
}

}  // namespace
}  // namespace autoref::live
