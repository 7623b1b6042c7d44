#include "logs/recorded_ends.hpp"

#include <gtest/gtest.h>

namespace autoref::logs {
namespace {

Frame recorded_frame_at(double time_s, double yellow_x_m, double blue_x_m) {
  Frame frame;
  frame.time_s = time_s;
  frame.robots[Side::kWest] = {{2, {yellow_x_m, 0.1}, {1, 0}}};
  frame.robots[Side::kEast] = {{7, {blue_x_m, -0.1}, {1, 0}}};
  return frame;
}

league::RefereePacket packet_with_keepers(std::uint32_t yellow, std::uint32_t blue) {
  league::RefereePacket packet;
  packet.mutable_yellow()->set_goalkeeper(yellow);
  packet.mutable_blue()->set_goalkeeper(blue);
  return packet;
}

TEST(YellowEnd, IsUnknownWithoutEvidence) {
  YellowEnd yellow{Field{}};
  EXPECT_FALSE(yellow.end());
  yellow.add(recorded_frame_at(0, 0.1, 0.2));
  EXPECT_FALSE(yellow.end());
}

TEST(YellowEnd, IsWhatTheRefereeSaidFirst) {
  YellowEnd yellow{Field{}};
  league::RefereePacket packet = packet_with_keepers(0, 0);
  packet.set_blue_team_on_positive_half(false);
  yellow.add(packet);
  packet.set_blue_team_on_positive_half(true);  // after half-time
  yellow.add(packet);
  yellow.add(recorded_frame_at(0, -2, 2));
  EXPECT_EQ(yellow.end(), Side::kEast);
}

// Yellow's keeper stands at +x, although its robots are at -x on average.
TEST(YellowEnd, IsWhereTheNamedKeeperStands) {
  YellowEnd yellow{Field{}};
  yellow.add(packet_with_keepers(2, 9));
  Frame frame = recorded_frame_at(20, 2.8, 0);
  frame.robots[Side::kWest].push_back({3, {-3, 0}, {1, 0}});
  frame.robots[Side::kWest].push_back({4, {-3, 1}, {1, 0}});
  yellow.add(frame);
  EXPECT_EQ(yellow.end(), Side::kEast);
}

TEST(YellowEnd, FollowsFromTheOtherTeamsKeeper) {
  YellowEnd yellow{Field{}};
  yellow.add(packet_with_keepers(9, 7));
  yellow.add(recorded_frame_at(0, 0, 2.9));
  EXPECT_EQ(yellow.end(), Side::kWest);
}

TEST(YellowEnd, IsWhereItsRobotsStandAtFirst) {
  YellowEnd yellow{Field{}};
  for (int second = 0; second <= 10; ++second) yellow.add(recorded_frame_at(5.0 + second, 1.5, -1));
  for (int second = 11; second <= 100; ++second)
    yellow.add(recorded_frame_at(5.0 + second, -1.5, 1));
  EXPECT_EQ(yellow.end(), Side::kEast);
}

}  // namespace
}  // namespace autoref::logs
