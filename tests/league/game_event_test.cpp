#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "league/game_event_message.hpp"
#include "league/game_packets.hpp"
#include "league/log_contents.hpp"
#include "tests/league/scratch_log.hpp"

namespace autoref::league {
namespace {

using enum GameEventType;

GameEventMessage message_of(const GameEvent& event) {
  GameEventMessage message;
  fill_game_event(event, message);
  return message;
}

// The league's numbers: those of type and field differ for the first eight.
TEST(GameEvents, UseTheLeaguesNumbersForTypeAndField) {
  const std::map<GameEventType, std::pair<int, int>> numbers = {
      {kBoundaryCrossing, {41, 43}},
      {kInvalidGoal, {42, 44}},
      {kPenaltyKickFailed, {43, 45}},
      {kChallengeFlag, {44, 46}},
      {kEmergencyStop, {45, 47}},
      {kChallengeFlagHandled, {46, 48}},
      {kBotDroppedParts, {47, 51}},
      {kExcessiveBotSubstitution, {48, 52}},
      {kAttackerTouchedOpponentInDefenseAreaSkipped, {40, 42}},
      {kPossibleGoal, {39, 39}},
      {kPlacementSucceeded, {5, 5}},
      {kBotKickedBallTooFast, {18, 18}}};
  for (const auto& [type, expected] : numbers) {
    GameEvent event;
    event.type = type;
    const GameEventMessage message = message_of(event);
    EXPECT_TRUE(message.IsInitialized()) << name_of(type);
    EXPECT_EQ(message.type(), expected.first) << name_of(type);
    EXPECT_EQ(static_cast<int>(message.event_case()), expected.second) << name_of(type);
  }
}

TEST(GameEvents, OfEveryTypeAreReadBack){
#define AUTOREF_GAME_EVENT(id, number, name)                      \
  {                                                               \
    GameEvent event;                                              \
    event.type = id;                                              \
    EXPECT_EQ(game_event_of(message_of(event)).type, id) << name; \
    EXPECT_EQ(game_event_type(name), id);                         \
  }
#include "soccer/rules/game_events.def"
#undef AUTOREF_GAME_EVENT
}

TEST(GameEvents, KeepWhatTheirMessageHolds) {
  GameEvent goal;
  goal.type = kPossibleGoal;
  goal.origin = {"AutoRef", "TIGERs"};
  goal.created_us = 1'783'000'000'000'000;
  goal.id = "7";
  goal.by_team = Side::kEast;
  goal.kicking_team = Side::kEast;
  goal.kicking_bot = 0;
  goal.location_m = Vec2(-4.5, 0.25);
  goal.kick_location_m = Vec2(1, -2);
  goal.max_ball_height_m = 0.125;
  goal.num_robots_by_team = 6;
  goal.last_touch_by_team_us = 1'782'999'999'000'000;
  goal.message = "in";
  EXPECT_EQ(game_event_of(message_of(goal)), goal);
}

TEST(GameEvents, LeaveOutWhatTheirMessageLacks) {
  GameEvent exit;
  exit.type = kBallLeftFieldTouchLine;
  exit.by_bot = 4;
  exit.distance_m = 3;
  const GameEvent read = game_event_of(message_of(exit));
  EXPECT_EQ(read.by_bot, 4);
  EXPECT_FALSE(read.by_team);
  EXPECT_FALSE(read.distance_m);
}

TEST(GameEvents, OfLaterEditionsKeepTheirNumber) {
  GameEventMessage message;
  ASSERT_TRUE(message.ParseFromString("\xC0\x02\x63"));  // field 40, a varint: 99
  EXPECT_EQ(static_cast<int>(game_event_of(message).type), 99);
  EXPECT_EQ(message_of(game_event_of(message)).type(), 99);
}

TEST(GameEvents, IgnoreNumbersThatAreNotFinite) {
  GameEventMessage message;
  GameEventMessage::BotTooFastInStop& fast = *message.mutable_bot_too_fast_in_stop();
  fast.set_by_team(7);
  fast.set_by_bot(4'000'000'000U);
  fast.set_speed(std::nanf(""));
  fast.mutable_location()->set_x(INFINITY);
  fast.mutable_location()->set_y(0);
  const GameEvent read = game_event_of(message);
  EXPECT_EQ(read.type, kBotTooFastInStop);
  EXPECT_FALSE(read.by_team || read.by_bot || read.speed_mps || read.location_m);
}

class Packets final : public LogVisitor {
 public:
  void on_referee(double /*time_s*/, const RefereePacket& packet) override {
    longest = std::max(longest, packet.ByteSizeLong());
    newest = game_events_of(packet);
    for (const GameEvent& event : newest) seen[event.id] = event;
  }
  std::size_t longest = 0;
  std::vector<GameEvent> newest;
  std::map<std::string, GameEvent> seen;
};

TEST(GameLog, WritesGameEventsUntilPlayGoesOn) {
  const ScratchFile file(".log");
  GameLog log(file.path(), Field{}, {CameraPosition{}}, {});
  GameEvent event;
  event.type = kPenaltyKickFailed;
  event.reason = std::string(200, 'x');
  Frame frame;
  for (int i = 0; i < 10; ++i) {
    log.note(event);
    log.add(frame, {});
    frame.time_s += 0.01;
  }
  Packets packets;
  log.note(Command{CommandKind::kForceStart});
  RefereeSignal signal;
  signal.command_counter = 1;
  log.add(frame, signal);
  log.close();
  read_log(file.path(), packets);
  EXPECT_EQ(packets.seen.size(), 10U);
  EXPECT_TRUE(packets.newest.empty());
  EXPECT_LT(packets.longest, 1024U);
  EXPECT_GT(packets.longest, 500U);
}

}  // namespace
}  // namespace autoref::league
