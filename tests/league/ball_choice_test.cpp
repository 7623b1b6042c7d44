#include "league/followed_body.hpp"

#include <gtest/gtest.h>

namespace autoref::league {
namespace {

constexpr double kFrame_s = 0.0125;

Detected ball(const Vec2& position_m, float confidence = 0.9F, std::uint32_t camera = 0) {
  return {camera, confidence, position_m, {1, 0}};
}

// Chooses for that long among balls that depend on the time, and returns the last choice.
class BallsSeen : public testing::Test {
 protected:
  template <typename Seen>
  std::optional<Vec2> after(double duration_s, const Seen& seen) {
    const Detected* chosen = nullptr;
    for (const double end_s = time_s_ + duration_s; time_s_ < end_s; time_s_ += kFrame_s) {
      const std::vector<Detected> all = seen(time_s_);
      chosen = choice_.choose(time_s_, all);
    }
    return chosen == nullptr ? std::nullopt : std::optional(chosen->position_m);
  }

  BallChoice choice_;
  double time_s_ = 0;
};

const Detected kOurs = ball({1, 0});
const Detected kOther = ball({-2, 1});

TEST_F(BallsSeen, TheFirstIsTheMostConfident) {
  EXPECT_EQ(after(kFrame_s,
                  [](double) {
                    return std::vector{kOther, ball({1, 0}, 0.95F)};
                  }),
            Vec2(1, 0));
}

TEST_F(BallsSeen, StaysWithTheFollowedOneWhateverTheConfidence) {
  after(1, [](double) { return std::vector{kOurs}; });
  EXPECT_EQ(after(1, [](double) { return std::vector{ball({-2, 1}, 1), kOurs}; }), Vec2(1, 0));
}

TEST_F(BallsSeen, AnotherBallIsNotTakenForAHiddenOne) {
  after(1, [](double) { return std::vector{kOurs, kOther}; });
  EXPECT_EQ(after(2, [](double) { return std::vector{kOther}; }), std::nullopt);
  EXPECT_EQ(after(1, [](double) { return std::vector{kOther, kOurs}; }), Vec2(1, 0));
}

TEST_F(BallsSeen, AnotherBallIsTakenIfTheFollowedOneDisappears) {
  after(1, [](double) { return std::vector{kOurs, kOther}; });
  EXPECT_EQ(after(4, [](double) { return std::vector{kOther}; }), Vec2(-2, 1));
}

TEST_F(BallsSeen, AMovingBallIsTakenIfTheFollowedOneLiesStill) {
  const auto both = [](double time_s) {
    return std::vector{kOther, ball({-4 + 0.5 * time_s, -2})};
  };
  after(3, [](double) { return std::vector{kOther}; });
  EXPECT_GT(after(2, both)->x(), -2.5);
  EXPECT_EQ(after(kFrame_s, both)->y(), -2);
}

TEST_F(BallsSeen, AKickIsFollowedWithinOneFrame) {
  after(1, [](double) { return std::vector{kOurs}; });
  const Vec2 kicked_m = Vec2(1, 0) + Vec2(0, 6.5 * kFrame_s);
  EXPECT_EQ(after(kFrame_s, [&](double) { return std::vector{ball(kicked_m)}; }), kicked_m);
}

// If there are false detections.
TEST_F(BallsSeen, ABallPutElsewhereIsTakenAfterHalfASecond) {
  after(1, [](double) { return std::vector{kOurs}; });
  after(kFrame_s, [](double) { return std::vector{kOurs, ball({3, -1}), ball({0, 2})}; });
  EXPECT_EQ(after(0.4, [](double) { return std::vector{kOther}; }), std::nullopt);
  EXPECT_EQ(after(0.2, [](double) { return std::vector{kOther}; }), Vec2(-2, 1));
}

// A ball that was carried to another robot by hand, or hidden on its way, is kicked there.
TEST_F(BallsSeen, AKickElsewhereIsFollowedAtOnce) {
  after(1, [](double) { return std::vector{kOurs}; });
  const double kick_s = time_s_;
  const auto kicked = [&](double time_s) {
    return std::vector{ball(Vec2(-2, 1) + Vec2(0, 5 * (time_s - kick_s)))};
  };
  EXPECT_TRUE(after(kFrame_s, kicked));
}

TEST_F(BallsSeen, NothingIsChosenFromNothing) {
  EXPECT_EQ(after(1, [](double) { return std::vector<Detected>(); }), std::nullopt);
}

}  // namespace
}  // namespace autoref::league
