// Checks invariants in every frame, and that every game makes progress.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

class Watch final : public Observer {
 public:
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    const Field field;
    const Vec2 ball_m = world.state().ball.position_m;
    farthest_x_m = std::max(farthest_x_m, std::abs(ball_m.x()) - field.wall_x_m());
    farthest_y_m = std::max(farthest_y_m, std::abs(ball_m.y()) - field.wall_y_m());
    all_finite = all_finite && world.is_finite();
    const bool waits = signal.placement.has_value();
    if (!waits) waiting_since_s_ = frame.time_s;
    longest_wait_s = std::max(longest_wait_s, frame.time_s - waiting_since_s_);
  }
  void on_decision(const referee::Decision& decision) override {
    // At a kick-off the referee waits twice: for the preparation and for the start.
    if (decision.finding.event == referee::Event::kReady ||
        decision.finding.event == referee::Event::kReadyTimeout) {
      waiting_since_s_ = decision.time_s;
    }
  }

  double farthest_x_m = -1;
  double farthest_y_m = -1;
  double longest_wait_s = 0;
  bool all_finite = true;

 private:
  double waiting_since_s_ = 0;
};

TEST(GameTrace, GamesEndWithAResultAndStayWithinBounds) {
  Watch watch;
  int goals = 0;
  for (std::uint64_t seed = 1; seed <= AUTOREF_TRACED_GAMES; ++seed) {
    const GameRecord record = play(short_game(20, seed), &watch);
    ASSERT_EQ(record.status, Status::kOk) << "seed " << seed << ": " << record.void_reason;
    goals += record.goals_a + record.goals_b;
  }
  EXPECT_GT(goals, 0);
  EXPECT_LT(watch.farthest_x_m, 0) << "the ball left the walls";
  EXPECT_LT(watch.farthest_y_m, 0) << "the ball left the walls";
  EXPECT_TRUE(watch.all_finite);
  // GOAL and STOP each add one frame to the ready timeout of 15 s.
  EXPECT_LE(watch.longest_wait_s, RuleBook().ready_timeout_s + 0.1);
}

}  // namespace
}  // namespace autoref::game
