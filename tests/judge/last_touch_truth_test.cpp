// The referee's last touch, from vision alone, compared with the simulator's contacts.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "game/loop/game.hpp"
#include "referee/touch/kept_touch.hpp"
#include "sim/presets.hpp"

namespace autoref::judge {
namespace {

class TouchEvaluator final : public game::Observer {
 public:
  void on_frame(const Frame&, const RefereeSignal&, const sim::World& world) override {
    for (const sim::Touch& touch : world.touches()) truth_ = touch.robot.side;
  }
  void on_decision(const referee::Decision& decision) override {
    const bool needs_touch = decision.finding.event == referee::Event::kThrowIn ||
                             decision.finding.event == referee::Event::kCornerKick ||
                             decision.finding.event == referee::Event::kGoalKick ||
                             decision.finding.event == referee::Event::kTouchLineUnknown;
    if (!needs_touch || !truth_) return;
    const std::optional<Side>& said = decision.last_touch.side;
    ++(!said ? unknown : *said == *truth_ ? right : wrong);
  }

  int right = 0;
  int wrong = 0;
  int unknown = 0;

 private:
  std::optional<Side> truth_;
};

TouchEvaluator evaluate_under(const char* camera) {
  TouchEvaluator judge;
  for (std::uint64_t seed = 5001; seed <= 5004; ++seed) {
    game::GameConfiguration game;
    game.match.half_s = 300;
    game.seed = seed;
    sim::apply_camera_preset(camera, game.sim);
    game::play(game, &judge);
  }
  return judge;
}

TEST(LastTouch, IsRightAtNearlyEveryExitOfTheBall) {
  const TouchEvaluator judge = evaluate_under("paper");
  const int all = judge.right + judge.wrong + judge.unknown;
  ASSERT_GT(all, 100);
  EXPECT_LE(judge.wrong, 0.015 * all) << judge.wrong << " wrong of " << all;
  EXPECT_GE(judge.right, 0.97 * all) << judge.right << " right of " << all;
}

// In 20 games (seeds 5001 to 5020), 97.1 % of the touches were right, 1.9 % wrong and 1.0 %
// unknown.
TEST(LastTouch, IsMostlyRightUnderRealisticVision) {
  const TouchEvaluator judge = evaluate_under("realistic");
  const int all = judge.right + judge.wrong + judge.unknown;
  ASSERT_GT(all, 100);
  EXPECT_LE(judge.wrong, 0.04 * all) << judge.wrong << " wrong of " << all;
  EXPECT_GE(judge.right, 0.94 * all) << judge.right << " right of " << all;
}

// All frames of a game, with the robot that has truly touched the ball last.
class FrameRecorder final : public game::Observer {
 public:
  struct TrueFrame {
    Frame frame;
    std::optional<RobotId> toucher;
    CommandKind command = CommandKind::kHalt;
    std::uint32_t command_counter = 0;
  };

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    for (const sim::Touch& touch : world.touches()) toucher_ = touch.robot;
    true_frames.push_back({frame, toucher_, signal.command.kind, signal.command_counter});
  }

  std::vector<TrueFrame> true_frames;

 private:
  std::optional<RobotId> toucher_;
};

using TrueFrames = std::vector<FrameRecorder::TrueFrame>;

bool is_play(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

referee::FrameHistory history_until(const TrueFrames& true_frames, std::size_t newest) {
  constexpr std::size_t kFrames = referee::kDetectionsAtGap;
  referee::FrameHistory history;
  history.restart(true_frames[newest - kFrames].frame, std::nullopt);
  for (std::size_t i = newest - kFrames + 1; i <= newest; ++i) history.push(true_frames[i].frame);
  return history;
}

struct KeptTouches {
  int count = 0;
  int right = 0;
  double promised = 0;  // sum of the probabilities

  void add(const TrueFrames& true_frames, std::size_t before, std::size_t after, bool by_holder) {
    if (true_frames[before].command_counter != true_frames[after].command_counter ||
        !is_play(true_frames[before].command) || !true_frames[before].toucher)
      return;
    const referee::FrameHistory seen_before = history_until(true_frames, before);
    const referee::FrameHistory seen_after = history_until(true_frames, after);
    if (seen_before.detections() == 0 || seen_after.detections() < referee::kDetectionsAtGap)
      return;
    referee::LastTouch last;
    last.side = true_frames[before].toucher->side;
    last.robot = true_frames[before].toucher;
    const referee::BeforeGap gap = referee::before_gap(seen_before, 0, last, 0);
    if (gap.holder.has_value() != by_holder) return;
    const auto kept = referee::kept_touch(gap, seen_after);
    if (!kept) return;
    ++count;
    right += kept->side == true_frames[after].toucher->side ? 1 : 0;
    promised += kept->kept;
  }
};

// Gaps of a second at all times, in games of teams from which the probabilities were not taken.
KeptTouches kept_over_a_second(bool by_holder) {
  KeptTouches kept;
  for (const char* team : {"zone", "cobalt1"}) {
    FrameRecorder recorder;
    game::GameConfiguration game;
    game.match.half_s = 300;
    game.seed = 77;
    game.a.strategy = game.b.strategy = team;
    game::play(game, &recorder);
    const TrueFrames& true_frames = recorder.true_frames;
    for (std::size_t i = 10; i + 70 < true_frames.size(); i += 3)
      kept.add(true_frames, i, i + 62, by_holder);
  }
  return kept;
}

TEST(KeptTouch, OfABallThatRollsOnIsAsOftenRightAsItSays) {
  const KeptTouches kept = kept_over_a_second(false);
  ASSERT_GT(kept.count, 300);
  EXPECT_NEAR(kept.right, kept.promised, 0.06 * kept.count) << kept.right << " of " << kept.count;
}

TEST(KeptTouch, OfTheRobotThatHadTheBallIsAsOftenRightAsItSays) {
  const KeptTouches kept = kept_over_a_second(true);
  ASSERT_GT(kept.count, 100);
  EXPECT_NEAR(kept.right, kept.promised, 0.15 * kept.count) << kept.right << " of " << kept.count;
}

}  // namespace
}  // namespace autoref::judge
