// A side of a recorded game, compared with the game that the log records.
#include "logs/logged_ghost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/loop/game.hpp"
#include "game/loop/log_recorder.hpp"
#include "sim/presets.hpp"
#include "soccer/referee_signal.hpp"
#include "tests/league/scratch_log.hpp"
#include "tests/logs/sketched_log.hpp"
#include "tests/support/short_game.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

// The true state of a game in a frame, in the program's coordinates.
struct TrueFrame {
  double time_s = 0;
  sim::WorldState world;
  PerSide<bool> touches;  // whether the side has touched the ball since the last frame
  RefereeSignal signal;

  bool is_play_on() const {
    const CommandKind kind = signal.command.kind;
    return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
           kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
  }
};

// Writes the log of a game and keeps its true frames.
class TrueFrameRecorder final : public game::LogRecorder {
 public:
  using LogRecorder::LogRecorder;
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    LogRecorder::on_frame(frame, signal, world);
    frames.push_back({frame.time_s, world.state(), {}, signal});
    for (const sim::Touch& touch : world.touches()) frames.back().touches[touch.robot.side] = true;
  }
  std::vector<TrueFrame> frames;
};

// Has goals: `b` is weak.
game::GameConfiguration game_for_ghosts() {
  game::GameConfiguration game = short_game_by("2026-b", 20, 1);
  game.a.strategy = "cobalt";
  game.b.strategy = "basic";
  game.b.robots.resize(1);
  sim::apply_camera_preset("none", game.sim);
  return game;
}

class LoggedGhostTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    log_ = *folder_ / "game.log";
    const game::GameConfiguration game = game_for_ghosts();
    TrueFrameRecorder recorder(log_, game);
    game::play(game, &recorder);
    recorder.close();
    frames_ = recorder.frames;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  // The first frame at or after a time from which on play stays on for `on_s` in that stage.
  static std::size_t in_play(Stage stage, double on_s, double from_s = 0) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const TrueFrame& frame = frames_[i];
      if (!frame.is_play_on() || frame.signal.stage != stage || frame.time_s < from_s)
        first = i + 1;
      else if (frame.time_s - frames_[first].time_s >= on_s)
        return first;
    }
    ADD_FAILURE() << "play is never on for that long";
    return 0;
  }

  // The first frame from this one on in which play is stopped.
  static std::size_t stop_after(std::size_t frame) {
    while (frame + 1 < frames_.size() && frames_[frame].is_play_on()) ++frame;
    return frame;
  }

  static std::string error_at(double at_s, const std::string& log = log_) {
    try {
      logged_ghost(log, at_s, Side::kWest);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "read";
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::string log_;
  static std::vector<TrueFrame> frames_;
};

std::unique_ptr<TemporaryFolder> LoggedGhostTest::folder_;
std::string LoggedGhostTest::log_;
std::vector<TrueFrame> LoggedGhostTest::frames_;

void expect_near_truth(const game::GhostFrame& frame, const TrueFrame& truth, Side side) {
  const auto& robots = truth.world.robots[side];
  ASSERT_EQ(frame.robots.size(), robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    EXPECT_EQ(frame.robots[i].number, robots[i].number);
    EXPECT_LT((frame.robots[i].position_m - robots[i].position_m).norm(), 0.03);
    EXPECT_GT(frame.robots[i].heading.dot(robots[i].heading), 0.98);
    EXPECT_LT((frame.robots[i].velocity_mps - robots[i].velocity_mps).norm(), 1.0);
  }
  ASSERT_TRUE(frame.ball);
  EXPECT_LT((frame.ball->position_m - truth.world.ball.position_m).norm(), 0.2);
}

// Compares the first second with the game.
void expect_ghost(const LoggedGhost& logged, const std::vector<TrueFrame>& frames,
                  std::size_t first, Side side) {
  EXPECT_EQ(logged.ghost.side, side);
  ASSERT_GT(logged.ghost.frames.size(), 60U);
  EXPECT_EQ(logged.ghost.frames[0].time_s, 0);
  for (std::size_t i = 0; i <= 60; ++i) {
    const TrueFrame& truth = frames[first + i];
    EXPECT_NEAR(logged.ghost.frames[i].time_s, truth.time_s - frames[first].time_s, 1e-6);
    expect_near_truth(logged.ghost.frames[i], truth, side);
    if (testing::Test::HasFailure()) FAIL() << "frame " << i;
  }
}

TEST_F(LoggedGhostTest, MovesLikeTheSideInTheGame) {
  const std::size_t first = in_play(Stage::kFirstHalf, 2);
  for (const Side side : kSides)
    expect_ghost(logged_ghost(log_, frames_[first].time_s, side), frames_, first, side);
}

TEST_F(LoggedGhostTest, HasYellowInTheWestAfterHalfTime) {
  const std::size_t first = in_play(Stage::kSecondHalf, 2);
  ASSERT_FALSE(frames_[first].signal.blue_on_positive_half);
  for (const Side side : kSides)
    expect_ghost(logged_ghost(log_, frames_[first].time_s, side), frames_, first, side);
}

TEST_F(LoggedGhostTest, BeginsWithTheLastFrameAtOrBeforeTheTime) {
  const std::size_t first = in_play(Stage::kFirstHalf, 2);
  const LoggedGhost logged = logged_ghost(log_, frames_[first].time_s + 0.01, Side::kWest);
  expect_near_truth(logged.ghost.frames[0], frames_[first], Side::kWest);
  EXPECT_EQ(logged.ghost.frames[0].time_s, 0);
  EXPECT_NEAR(logged.ghost.frames[1].time_s, 1 / 60.0 - 0.01, 1e-6);
}

TEST_F(LoggedGhostTest, EndsWithTheStop) {
  const std::size_t first = in_play(Stage::kFirstHalf, 1);
  const double lasts_s = frames_[stop_after(first)].time_s - frames_[first].time_s;
  const LoggedGhost logged = logged_ghost(log_, frames_[first].time_s, Side::kEast);
  EXPECT_NEAR(logged.ghost.frames.back().time_s, lasts_s, 0.12);  // ten packets per second
}

TEST_F(LoggedGhostTest, KnowsWhenTheOtherSideTouchedTheBallFirst) {
  int times = 0;
  int right = 0;
  for (const double from_s : {8.0, 11.0, 14.0, 17.0, 20.0, 23.0}) {
    const std::size_t first = in_play(Stage::kFirstHalf, 0.5, from_s);
    const std::size_t stop = stop_after(first);
    for (const Side side : kSides) {
      const auto touch =
          std::find_if(frames_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                       frames_.begin() + static_cast<std::ptrdiff_t>(stop),
                       [&](const TrueFrame& frame) { return frame.touches[opponent_of(side)]; });
      const bool is_touched = touch != frames_.begin() + static_cast<std::ptrdiff_t>(stop);
      const auto touches_s = logged_ghost(log_, frames_[first].time_s, side).ghost.touches_s;
      ++times;
      if (is_touched == touches_s.empty()) continue;
      right += !is_touched ||
               std::abs(touches_s.front() - (touch->time_s - frames_[first].time_s)) < 0.15;
    }
  }
  EXPECT_GE(right, times - 2) << "of " << times;
}

// The side whose score grows in the frame.
std::optional<Side> scorer_in(const TrueFrame& frame, const TrueFrame& before) {
  for (const Side side : kSides)
    if (frame.signal.goals[side] > before.signal.goals[side]) return side;
  return std::nullopt;
}

TEST_F(LoggedGhostTest, KnowsWhoScored) {
  std::size_t goal = 1;
  while (goal < frames_.size() && !scorer_in(frames_[goal], frames_[goal - 1])) ++goal;
  ASSERT_LT(goal, frames_.size()) << "nobody scores";
  std::size_t last = goal;
  while (!frames_[last].is_play_on()) --last;
  EXPECT_EQ(logged_ghost(log_, frames_[last].time_s - 0.2, Side::kEast).scorer,
            scorer_in(frames_[goal], frames_[goal - 1]));
}

TEST_F(LoggedGhostTest, NeedsATimeInPlay) {
  const std::size_t stop = stop_after(in_play(Stage::kFirstHalf, 1));
  const std::string error = error_at(frames_[stop].time_s + 0.2);
  EXPECT_NE(error.find("play is stopped at"), std::string::npos) << error;
  EXPECT_NE(error.find("STOP"), std::string::npos) << error;
}

TEST_F(LoggedGhostTest, IsAnErrorBeyondTheLogOrWithoutALog) {
  EXPECT_NE(error_at(9999).find("9999 s is outside the log"), std::string::npos);
  EXPECT_NE(error_at(9999).find("which covers 0.000 to"), std::string::npos);
  EXPECT_NE(error_at(-1).find("-1 s is outside the log"), std::string::npos);
  EXPECT_NE(error_at(1, log_ + ".no").find(".no"), std::string::npos);
}

TEST(LoggedGhostOfASketch, LastsAsLongAsTheLogIfThereIsNoReferee) {
  const league::ScratchFile file(".log");
  write_sketch({.has_referee = false}, file.path());
  const LoggedGhost logged = logged_ghost(file.path(), 2, Side::kWest);
  EXPECT_EQ(logged.ghost.frames.front().robots.size(), 6U);
  EXPECT_NEAR(logged.ghost.frames.back().time_s, 4, 0.05);
  EXPECT_TRUE(logged.ghost.touches_s.empty());
  EXPECT_EQ(logged.scorer, std::nullopt);
}

TEST(LoggedGhostOfASketch, EndsWhereTheLogShowsNothing) {
  const league::ScratchFile file(".log");
  const auto with_gap_s = [](double time_s) { return time_s < 3 ? time_s : time_s + 5; };
  write_sketch({.has_referee = false, .capture_s = with_gap_s, .record_s = with_gap_s},
               file.path());
  EXPECT_NEAR(logged_ghost(file.path(), 2, Side::kWest).ghost.frames.back().time_s, 1, 0.05);
  EXPECT_THROW(logged_ghost(file.path(), 6, Side::kWest), std::invalid_argument);
}

// Play is on until 4 s. Blue's goal counts from 4.5 s on, and play is resumed at 5 s.
void sketch_goal(double time_s, league::RefereePacket& packet) {
  if (time_s < 4) return;
  const Command command{time_s < 5 ? CommandKind::kStop : CommandKind::kForceStart};
  packet.set_command(league_number(command));
  packet.set_command_counter(time_s < 5 ? 4 : 5);
  if (time_s > 4.5) packet.mutable_blue()->set_score(1);
  if (time_s > 5.5) packet.mutable_yellow()->set_score(1);
}

TEST(LoggedGhostOfASketch, HasTheScorerByTheScoreWhenPlayIsResumed) {
  const league::ScratchFile file(".log");
  write_sketch({.change_referee = sketch_goal}, file.path());
  const LoggedGhost logged = logged_ghost(file.path(), 2, Side::kWest);
  EXPECT_NEAR(logged.ghost.frames.back().time_s, 2, 0.05);
  EXPECT_EQ(logged.scorer, Side::kEast);
  EXPECT_EQ(logged_ghost(file.path(), 5.2, Side::kWest).scorer, Side::kWest);
}

}  // namespace
}  // namespace autoref::logs
