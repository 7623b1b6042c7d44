// The league's game controller repeats its events in each packet for as long as they are active.
#include "logs/facts_collector.hpp"

#include <gtest/gtest.h>

#include "league/game_event_message.hpp"

namespace autoref::logs {
namespace {

GameEvent event_of(GameEventType type, const std::string& id = "") {
  GameEvent event;
  event.type = type;
  event.id = id;
  event.by_team = Side::kEast;
  return event;
}

league::RefereePacket referee_packet_of(const std::vector<GameEvent>& events) {
  league::RefereePacket packet;
  for (const GameEvent& event : events) league::add_game_event(event, packet);
  return packet;
}

// Times of the events found, with one packet per second.
std::vector<double> times_in(const std::vector<std::vector<GameEvent>>& packets) {
  RecordedGameEvents recorded;
  double time_s = 0;
  for (const auto& events : packets) recorded.add(time_s++, referee_packet_of(events));
  std::vector<double> times_s;
  for (const game::TimedGameEvent& event : recorded.events()) times_s.push_back(event.time_s);
  return times_s;
}

const GameEvent kTouchLineEvent = event_of(GameEventType::kBallLeftFieldTouchLine, "a");
const GameEvent kFast = event_of(GameEventType::kBotKickedBallTooFast, "b");
using Times = std::vector<double>;

TEST(RecordedGameEvents, CountFromThePacketThatHasThemFirst) {
  EXPECT_EQ(times_in({{},
                      {kTouchLineEvent},
                      {kTouchLineEvent},
                      {kTouchLineEvent, kFast},
                      {kTouchLineEvent, kFast},
                      {}}),
            (Times{1, 3}));
}

TEST(RecordedGameEvents, CountOnceEvenIfTheyAreLeftOutInBetween) {
  EXPECT_EQ(times_in({{}, {kTouchLineEvent}, {}, {kTouchLineEvent}}), (Times{1}));
}

TEST(RecordedGameEvents, CountOnceIfAnotherRefereeReportsThem) {
  GameEvent later = kTouchLineEvent;
  later.origin = {"A", "B"};
  EXPECT_EQ(times_in({{}, {kTouchLineEvent}, {later}}), (Times{1}));
  GameEvent nameless = kTouchLineEvent;
  nameless.id = later.id = "";
  nameless.created_us = later.created_us = 7;
  EXPECT_EQ(times_in({{}, {nameless}, {later}}), (Times{1}));
}

TEST(RecordedGameEvents, WithoutIdsCountAgainWhenTheyComeBack) {
  const GameEvent nameless = event_of(GameEventType::kMultipleCards);
  EXPECT_EQ(times_in({{}, {nameless}, {nameless}, {}, {nameless}}), (Times{1, 4}));
}

TEST(RecordedGameEvents, OfTheFirstPacketHappenedBeforeTheLog) {
  EXPECT_EQ(times_in({{kTouchLineEvent}, {kTouchLineEvent, kFast}}), (Times{1}));
}

TEST(RecordedGameEvents, AreNotProposals) {
  league::GameEventMessage message;
  league::fill_game_event(kTouchLineEvent, message);
  league::RefereePacket packet;
  RecordedGameEvents recorded;
  recorded.add(0, packet);
  std::string group;  // field 1 of a group of proposals, which is field 17 of the packet
  const std::string bytes = message.SerializeAsString();
  group += '\x0a';
  group += static_cast<char>(bytes.size());
  group += bytes;
  std::string proposal = "\x8a\x01";
  proposal += static_cast<char>(group.size());
  proposal += group;
  ASSERT_TRUE(packet.ParsePartialFromString(proposal));
  recorded.add(1, packet);
  EXPECT_TRUE(recorded.events().empty());
}

TEST(RecordedGameEvents, AreBounded) {
  RecordedGameEvents recorded;
  recorded.add(0, {});
  for (std::size_t i = 0; i < RecordedGameEvents::kMostEvents + 10; ++i)
    recorded.add(1, referee_packet_of({event_of(GameEventType::kGoal, std::to_string(i))}));
  EXPECT_EQ(recorded.events().size(), RecordedGameEvents::kMostEvents);
}

}  // namespace
}  // namespace autoref::logs
