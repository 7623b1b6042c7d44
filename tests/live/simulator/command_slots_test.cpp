#include "live/simulator/command_slots.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace autoref::live {
namespace {

constexpr int kLapse_frames = 6;

league::CommandUpdate forward(int robot, double speed_mps) {
  league::CommandUpdate update;
  update.robot = robot;
  update.motion = league::LocalVelocity{Vec2(speed_mps, 0), 0};
  return update;
}

double speed_of(CommandSlots& slots, int robot, std::int64_t frame) {
  return slots.collect_commands(Side::kWest, frame, {})
      .at(static_cast<std::size_t>(robot))
      .velocity_mps.x();
}

TEST(CommandSlots, TheNewestCommandIsTaken) {
  CommandSlots slots(kLapse_frames);
  slots.add(Side::kWest, {forward(1, 0.5)});
  slots.add(Side::kWest, {forward(1, 1.5), forward(2, 0.25)});
  EXPECT_EQ(speed_of(slots, 1, 0), 1.5);
  EXPECT_EQ(speed_of(slots, 2, 0), 0.25);
  EXPECT_EQ(speed_of(slots, 3, 0), 0);
  EXPECT_EQ(slots.collect_commands(Side::kEast, 0, {})[1].velocity_mps.x(), 0);
}

TEST(CommandSlots, ACommandStaysUntilItLapses) {
  CommandSlots slots(kLapse_frames);
  slots.add(Side::kWest, {forward(1, 0.5)});
  EXPECT_EQ(speed_of(slots, 1, 100), 0.5);
  EXPECT_EQ(speed_of(slots, 1, 100 + kLapse_frames), 0.5);
  EXPECT_EQ(speed_of(slots, 1, 100 + kLapse_frames + 1), 0);
}

TEST(CommandSlots, AnUpdateOfAnotherMemberKeepsACommandAlive) {
  CommandSlots slots(kLapse_frames);
  slots.add(Side::kWest, {forward(1, 0.5)});
  EXPECT_EQ(speed_of(slots, 1, 0), 0.5);
  league::CommandUpdate dribble;
  dribble.robot = 1;
  dribble.dribble = true;
  slots.add(Side::kWest, {dribble});
  EXPECT_EQ(speed_of(slots, 1, 5), 0.5);
  EXPECT_EQ(speed_of(slots, 1, 11), 0.5);
  EXPECT_EQ(speed_of(slots, 1, 12), 0);
}

TEST(CommandSlots, ACommandThatLapsedIsForgotten) {
  CommandSlots slots(kLapse_frames);
  slots.add(Side::kWest, {forward(1, 0.5)});
  speed_of(slots, 1, 0);
  speed_of(slots, 1, 100);
  league::CommandUpdate dribble;
  dribble.robot = 1;
  dribble.dribble = true;
  slots.add(Side::kWest, {dribble});
  EXPECT_EQ(speed_of(slots, 1, 101), 0);
}

TEST(CommandSlots, WaitsForEveryAwaitedSide) {
  CommandSlots slots(kLapse_frames);
  const PerSide<std::int64_t> before = slots.packets();
  const auto soon = CommandSlots::Clock::now() + std::chrono::milliseconds(20);
  slots.add(Side::kWest, {});
  EXPECT_TRUE(slots.wait(before, {{true, false}}, soon));
  EXPECT_FALSE(slots.wait(before, {{true, true}}, soon));
}

TEST(CommandSlots, AWaitEndsWithThePacketOfAnotherThread) {
  CommandSlots slots(kLapse_frames);
  const PerSide<std::int64_t> before = slots.packets();
  std::thread network([&] { slots.add(Side::kEast, {forward(0, 1)}); });
  const auto deadline = CommandSlots::Clock::now() + std::chrono::seconds(60);
  EXPECT_TRUE(slots.wait(before, {{false, true}}, deadline));
  network.join();
}

}  // namespace
}  // namespace autoref::live
