#include "live/simulator/lock_step.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "league/messages/simulation.pb.h"
#include "live/network/network.hpp"
#include "live/network/stream_server.hpp"

namespace autoref::live {
namespace {

constexpr double kRate_hz = 60;

league::SyncRequest request(double step_s, double forward_mps = 0) {
  league::SyncRequest one;
  one.step_s = step_s;
  league::CommandUpdate update;
  update.motion = league::LocalVelocity{Vec2(forward_mps, 0), 0};
  one.commands.updates.push_back(update);
  return one;
}

// A lock-step of teams, advanced by hand.
class LockStepTest : public testing::Test {
 protected:
  explicit LockStepTest(PerSide<bool> is_network = {{true, true}})
      : lock_step_(is_network, kRate_hz) {}

  bool ask(const Participant& from, const league::SyncRequest& request,
           std::size_t longest_bytes = kLongestSent) {
    return lock_step_.add(
        from, request,
        [this, from, longest_bytes](const std::string& bytes) {
          answered_.push_back(from ? std::string(name_of(*from)) : "control");
          EXPECT_LE(bytes.size(), longest_bytes);
          EXPECT_TRUE(response_.ParseFromString(bytes));
        },
        longest_bytes);
  }

  // Plays frames until a step of that length is answered, with this detection in each.
  void play_step(double step_s, const std::string& detection, std::size_t longest_bytes) {
    ask(Side::kWest, request(step_s), longest_bytes);
    ask(Side::kEast, request(step_s), longest_bytes);
    for (std::int64_t frame = 0; goes_on_after(frame); ++frame)
      lock_step_.add_detection(std::to_string(frame) + detection);
  }

  bool goes_on_after(std::int64_t frame) {
    const auto control = [this](const league::SimulatorRequest& one) { control_.push_back(one); };
    return lock_step_.advance(frame, {}, slots_, control, LockStep::Clock::now());
  }

  double speed_of(Side side) { return slots_.collect_commands(side, 0, {})[0].velocity_mps.x(); }

  CommandSlots slots_{6};
  LockStep lock_step_;
  std::vector<std::string> answered_;
  std::vector<league::SimulatorRequest> control_;
  simulation::SimulationSyncResponse response_;
};

class ControlLockStepTest : public LockStepTest {
 protected:
  ControlLockStepTest() : LockStepTest(PerSide<bool>{}) {}
};

TEST_F(LockStepTest, WaitsForEveryTeam) {
  EXPECT_FALSE(goes_on_after(0));
  ask(Side::kWest, request(1 / kRate_hz));
  EXPECT_FALSE(goes_on_after(0));
  EXPECT_EQ(lock_step_.is_awaited(), (PerSide<bool>{{false, true}}));
  ask(Side::kEast, request(1 / kRate_hz));
  EXPECT_TRUE(goes_on_after(0));
  EXPECT_TRUE(answered_.empty());
}

TEST_F(LockStepTest, AnswersWhenTheFrameIsReached) {
  ask(Side::kWest, request(2 / kRate_hz));
  ask(Side::kEast, request(1 / kRate_hz));
  EXPECT_TRUE(goes_on_after(0));
  EXPECT_FALSE(goes_on_after(1));
  EXPECT_EQ(answered_, std::vector<std::string>{"east"});
  ask(Side::kEast, request(1 / kRate_hz));
  EXPECT_TRUE(goes_on_after(1));
  EXPECT_FALSE(goes_on_after(2));
  EXPECT_EQ(answered_, (std::vector<std::string>{"east", "west", "east"}));
}

TEST_F(LockStepTest, CommandsTakeEffectWithTheirRequest) {
  ask(Side::kWest, request(1 / kRate_hz, 0.5));
  ask(Side::kWest, request(1 / kRate_hz, 1.5));
  ask(Side::kEast, request(5 / kRate_hz));
  EXPECT_TRUE(goes_on_after(0));
  EXPECT_EQ(speed_of(Side::kWest), 0.5);
  EXPECT_TRUE(goes_on_after(1));
  EXPECT_EQ(speed_of(Side::kWest), 1.5);
}

TEST_F(LockStepTest, ARequestWithoutAStepIsAnsweredAtOnce) {
  ask(Side::kWest, request(0, 0.5));
  EXPECT_FALSE(goes_on_after(0));
  EXPECT_EQ(answered_, std::vector<std::string>{"west"});
  EXPECT_EQ(speed_of(Side::kWest), 0.5);
}

// At 60 frames per second, 10, 20 and 30 ms end within the frames 1, 2 and 2.
TEST_F(LockStepTest, StepsThatAreNoWholeFramesAddUp) {
  ask(Side::kEast, request(1));
  for (int i = 0; i < 3; ++i) ask(Side::kWest, request(0.01));
  EXPECT_TRUE(goes_on_after(0));
  EXPECT_TRUE(goes_on_after(1));
  EXPECT_EQ(answered_.size(), 1U);
  EXPECT_FALSE(goes_on_after(2));
  EXPECT_EQ(answered_.size(), 3U);
}

TEST_F(LockStepTest, AResponseContainsTheDetectionsSinceTheLastOne) {
  lock_step_.add_detection("first");
  ask(Side::kWest, request(2 / kRate_hz));
  ask(Side::kEast, request(1));
  goes_on_after(0);
  lock_step_.add_detection("second");
  goes_on_after(1);
  lock_step_.add_detection("third");
  goes_on_after(2);
  ASSERT_EQ(response_.detection_size(), 3);
  EXPECT_EQ(response_.detection(0), "first");
  EXPECT_EQ(response_.detection(2), "third");
}

// Its steps count from the frame at which it has joined.
TEST_F(LockStepTest, TheControlPortTakesPartFromItsFirstRequestForAStep) {
  ask(Side::kWest, request(1));
  ask(Side::kEast, request(1));
  EXPECT_TRUE(goes_on_after(0));
  league::SyncRequest control = request(2 / kRate_hz);
  control.control.teleports.emplace_back(league::BallTeleport{});
  ask(std::nullopt, control);
  EXPECT_TRUE(goes_on_after(1));
  EXPECT_TRUE(goes_on_after(2));
  EXPECT_FALSE(goes_on_after(3));
  EXPECT_EQ(answered_, std::vector<std::string>{"control"});
  ASSERT_EQ(control_.size(), 3U);
  EXPECT_EQ(control_.back().teleports.size(), 1U);
}

TEST_F(ControlLockStepTest, WithoutTeamsOnTheNetworkTheControlPortIsAwaited) {
  EXPECT_FALSE(goes_on_after(0));
  ask(std::nullopt, request(1 / kRate_hz));
  EXPECT_TRUE(goes_on_after(0));
}

TEST_F(LockStepTest, AResponseHoldsAllDetectionsOfALongStep) {
  play_step(10, std::string(1000, 'x'), kLongestResponse);
  ASSERT_EQ(response_.detection_size(), 600);
  EXPECT_EQ(response_.detection(0)[0], '0');
  EXPECT_EQ(response_.robot_control_response().errors_size(), 0);
}

TEST_F(LockStepTest, AResponseThatWouldBeTooLongSaysHowLongAStepMayBe) {
  play_step(10, std::string(1000, 'x'), kLongestSent);
  ASSERT_EQ(response_.robot_control_response().errors_size(), 1);
  const simulation::SimulatorError& error = response_.robot_control_response().errors(0);
  EXPECT_EQ(error.code(), "STEP");
  EXPECT_NE(error.message().find("steps of at most 0.900 s"), std::string::npos) << error.message();
  // The newest, up to the last frame.
  EXPECT_GT(response_.detection_size(), 55);
  EXPECT_EQ(response_.detection(response_.detection_size() - 1).substr(0, 3), "599");
}

TEST_F(LockStepTest, StepsOfTheLengthThatWasNamedHoldAllDetections) {
  play_step(0.9, std::string(1000, 'x'), kLongestSent);
  EXPECT_EQ(response_.detection_size(), 54);
  EXPECT_EQ(response_.robot_control_response().errors_size(), 0);
}

TEST_F(LockStepTest, RequestsAreBounded) {
  int taken = 0;
  for (int i = 0; i < 1000; ++i) taken += ask(Side::kWest, request(0)) ? 1 : 0;
  goes_on_after(0);
  EXPECT_EQ(taken, 64);
  EXPECT_EQ(answered_.size(), 64U);
}

}  // namespace
}  // namespace autoref::live
