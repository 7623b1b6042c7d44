#include "league/referee_message.hpp"

#include <gtest/gtest.h>

namespace autoref::league {
namespace {

// Half a second over time. The league declared the field as sint32 first: zigzag encodes -500000 as
// 999999 in either width.
TEST(RefereeMessages, EncodeOvertimeAsTheLeagueAlwaysDid) {
  RefereeSignal signal;
  signal.stage_time_left_s = -0.5;
  RefereePacket packet;
  fill_referee(signal, {}, 0, packet);
  EXPECT_NE(packet.SerializeAsString().find("\x18\xBF\x84\x3D"), std::string::npos);
  EXPECT_DOUBLE_EQ(signal_of(packet)->stage_time_left_s, -0.5);
}

TEST(RefereeMessages, HoldTheTimeLeftOfLongStages) {
  RefereeSignal signal;
  signal.stage_time_left_s = 7200;  // more than 2^31 us
  RefereePacket packet;
  fill_referee(signal, {}, 0, packet);
  EXPECT_DOUBLE_EQ(signal_of(packet)->stage_time_left_s, 7200);
}

TEST(RefereeMessages, SurviveGameEventsThatCannotBeParsed) {
  RefereePacket packet;
  fill_referee({}, {}, 0, packet);
  packet.add_game_events("\xff\xff not an event");
  RefereePacket read;
  EXPECT_TRUE(read.ParseFromString(packet.SerializeAsString()));
}

TEST(RefereeMessages, RepresentEveryCommand) {
  for (int number = 0; number <= 17; ++number) {
    ASSERT_TRUE(command_of(number).has_value()) << number;
    EXPECT_EQ(league_number(*command_of(number)), number);
  }
  EXPECT_FALSE(command_of(18).has_value());
  EXPECT_FALSE(command_of(-1).has_value());
}

TEST(RefereeMessages, AreReadBackAsSent) {
  RefereeSignal signal;
  signal.command = {CommandKind::kDirectFree, Side::kEast};
  signal.command_counter = 7;
  signal.command_time_s = 12.5;
  signal.stage = Stage::kSecondHalf;
  signal.stage_time_left_s = 300.25;
  signal.goals = {{3, 4}};
  signal.placement = Placement{{1.25, -0.5}};
  signal.next_command = Command{CommandKind::kPrepareKickoff, Side::kWest};
  signal.blue_on_positive_half = false;
  RefereePacket packet;
  fill_referee(signal, PerSide<LoggedTeam>{{LoggedTeam{"cobalt"}, LoggedTeam{"zone"}}}, 13, packet);
  const RefereeSignal read = signal_of(packet).value();
  EXPECT_EQ(read.command, signal.command);
  EXPECT_EQ(read.goals, signal.goals);
  EXPECT_DOUBLE_EQ(read.stage_time_left_s, 300.25);
  EXPECT_EQ(read.placement->target_m, signal.placement->target_m);
  EXPECT_EQ(read.next_command, signal.next_command);
  EXPECT_FALSE(read.blue_on_positive_half);
}

TEST(RefereeMessages, WithoutEndsHaveBlueOnThePositiveHalf) {
  RefereePacket packet;
  fill_referee({}, {}, 0, packet);
  packet.clear_blue_team_on_positive_half();
  EXPECT_TRUE(signal_of(packet)->blue_on_positive_half);
}

TEST(RefereeMessages, HoldWhatTheTeamsMayDo) {
  RefereeSignal signal;
  signal.robots_allowed = {{11, 9}};
  signal.keepers = {{3, std::nullopt}};
  signal.can_place_ball = {{true, false}};
  RefereePacket packet;
  fill_referee(signal, PerSide<LoggedTeam>{{LoggedTeam{"a", 1}, LoggedTeam{"b", 5}}}, 0, packet);
  EXPECT_EQ(packet.blue().max_allowed_bots(), 9U);
  const RefereeSignal read = signal_of(packet).value();
  EXPECT_EQ(read.robots_allowed, signal.robots_allowed);
  EXPECT_EQ(read.keepers[Side::kWest], 3);
  EXPECT_EQ(read.keepers[Side::kEast], 5);
  EXPECT_EQ(read.can_place_ball, signal.can_place_ball);
}

TEST(RefereeMessages, HoldWhatIsLeftOfCardsAndTimeouts) {
  RefereeSignal signal;
  signal.yellow_left_s[Side::kEast] = {12.5, 119};
  signal.fouls = {{2, 5}};
  signal.timeouts_left = {{4, 3}};
  signal.timeout_left_s = {{300, 250.5}};
  RefereePacket packet;
  fill_referee(signal, {}, 0, packet);
  EXPECT_EQ(packet.blue().yellow_card_times(1), 119'000'000U);
  const RefereeSignal read = signal_of(packet).value();
  EXPECT_EQ(read.yellow_left_s, signal.yellow_left_s);
  EXPECT_EQ(read.fouls, signal.fouls);
  EXPECT_EQ(read.timeouts_left, signal.timeouts_left);
  EXPECT_EQ(read.timeout_left_s, signal.timeout_left_s);
}

// Game controllers keep a card that is over in the list until play stops.
TEST(RefereeMessages, OfCardsThatAreOverOrTooManyKeepTheOthers) {
  RefereePacket packet;
  fill_referee({}, {}, 0, packet);
  for (int i = 0; i < 40; ++i) packet.mutable_yellow()->add_yellow_card_times(i * 1'000'000);
  const auto left_s = signal_of(packet)->yellow_left_s[Side::kWest];
  EXPECT_EQ(left_s.size(), static_cast<std::size_t>(kMaxRobots));
  EXPECT_EQ(left_s.front(), 1);
}

TEST(RefereeMessages, OfOlderRefereesLeaveTheNumberOfRobotsOpen) {
  RefereePacket packet;
  fill_referee({}, {}, 0, packet);
  packet.mutable_yellow()->clear_max_allowed_bots();
  packet.mutable_yellow()->set_yellow_cards(1);
  packet.mutable_yellow()->set_goalkeeper(4'000'000'000U);
  EXPECT_EQ(signal_of(packet)->robots_allowed[Side::kWest], kMaxRobots);
  EXPECT_FALSE(signal_of(packet)->keepers[Side::kWest]);
}

TEST(RefereeMessages, KnowTheAgeOfTheirCommand) {
  RefereePacket packet;
  packet.set_packet_timestamp(1'783'000'000'250'000);  // us: an afternoon in 2026
  packet.set_command_timestamp(1'783'000'000'000'000);
  EXPECT_DOUBLE_EQ(command_age_s(packet).value(), 0.25);
  packet.set_command_timestamp(0);
  EXPECT_FALSE(command_age_s(packet));
  packet.set_command_timestamp(18'000'000'000'000'000'000U);
  EXPECT_FALSE(command_age_s(packet));
}

TEST(RefereeMessages, OfAnUnknownStageAreRejected) {
  RefereePacket packet;
  fill_referee({}, {}, 0, packet);
  packet.set_stage(14);
  EXPECT_FALSE(signal_of(packet).has_value());
}

}  // namespace
}  // namespace autoref::league
