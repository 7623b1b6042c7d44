// How often simulated vision sees the ball in whole games with the camera presets of 2026, by the
// distance from the ball's centre to the centre of the nearest robot. The expected values were
// measured in ten games of 2026 (sim/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::game {
namespace {

struct Distance {
  double from_m;
  double to_m;
  double seen;  // fraction of frames, as measured
};

constexpr std::array kDistances = {Distance{0.08, 0.10, 0.63}, Distance{0.10, 0.12, 0.73},
                                   Distance{0.12, 0.14, 0.79}, Distance{0.14, 0.17, 0.85},
                                   Distance{0.17, 0.22, 0.91}, Distance{0.22, 0.28, 0.95}};

class SeenBalls final : public Observer {
 public:
  void on_frame(const Frame& frame, const RefereeSignal& /*signal*/,
                const sim::World& world) override {
    const sim::WorldState& state = world.state();
    if (state.ball.height_m > 0.0) return;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const Side side : kSides) {
      for (const sim::RobotState& robot : state.robots[side])
        nearest_m = std::min(nearest_m, (robot.position_m - state.ball.position_m).norm());
    }
    const bool is_seen =
        frame.ball && (frame.ball->position_m - state.ball.position_m).norm() < 0.08;
    for (std::size_t i = 0; i < kDistances.size(); ++i) {
      if (nearest_m < kDistances[i].from_m || nearest_m >= kDistances[i].to_m) continue;
      ++frames[i];
      seen[i] += is_seen ? 1 : 0;
    }
  }

  std::array<int, kDistances.size()> frames{};
  std::array<int, kDistances.size()> seen{};
};

SeenBalls seen_balls(const std::string& division) {
  GameSettings game;
  choose_rules("2026-" + division, game);
  set_by_path(game, "sim.camera", "rc2026-" + division);
  game.match.half_s = 300;
  game.a.strategy = "cobalt";
  game.b.strategy = "counter";
  SeenBalls seen;
  play(resolved(game), &seen);
  return seen;
}

// Within 0.12 m, the fraction depends on how often teams dribble and where: in real games, dribbled
// balls were seen in 32 to 85 % of frames, depending on the venue.
TEST(VisionOf2026, SeesTheBallNearRobotsAsOftenAsMeasured) {
  const SeenBalls b = seen_balls("b");
  const SeenBalls a = seen_balls("a");
  for (std::size_t i = 0; i < kDistances.size(); ++i) {
    const Distance& distance = kDistances[i];
    const double frames = b.frames[i] + a.frames[i];
    ASSERT_GT(frames, 1000);
    EXPECT_NEAR((b.seen[i] + a.seen[i]) / frames, distance.seen,
                distance.to_m <= 0.12 ? 0.12 : 0.05)
        << "from " << distance.from_m << " m";
  }
}

}  // namespace
}  // namespace autoref::game
