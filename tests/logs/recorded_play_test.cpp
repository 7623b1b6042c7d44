// Possession chains of a log, compared with those of the simulated game that it records.
#include "logs/recorded_play.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/log_recorder.hpp"
#include "logs/log_referee.hpp"
#include "referee/referee_configuration.hpp"
#include "sim/presets.hpp"
#include "tests/league/scratch_log.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::logs {
namespace {

using game::PossessionChain;

constexpr std::int64_t kSameStart_frames = 18;  // 0.3 s

// Writes the log of a game and keeps its chains.
class ChainRecorder final : public game::LogRecorder {
 public:
  ChainRecorder(const std::filesystem::path& path, const game::GameConfiguration& game)
      : LogRecorder(path, game), frame_rate_hz_(game.sim.frame_rate_hz) {}
  void on_chain(const PossessionChain& chain) override {
    chains.push_back(chain);
    chains.back().first_frame = std::llround(static_cast<double>(chain.first_frame) /
                                             frame_rate_hz_ * RecordedPlay::kRate_hz);
  }

  std::vector<PossessionChain> chains;  // first_frame as in PlayOfLog

 private:
  double frame_rate_hz_;
};

game::GameConfiguration game_for_chains(const std::string& camera) {
  game::GameConfiguration game = short_game_by("2026-b", 90, 7);
  game.match.halves = 1;
  game.a.strategy = "possession";
  game.b.strategy = "cobalt";
  sim::apply_camera_preset(camera, game.sim);
  return game;
}

PlayOfLog play_of_log(const std::filesystem::path& log, game::GameConfiguration game,
                      referee::Control control) {
  game.match.control = control;
  return referee_log(log, facts_of(log), {game::referee_configuration(game)}).play;
}

bool is_same_chain(const PossessionChain& a, const PossessionChain& b) {
  return a.team == b.team && std::abs(a.first_frame - b.first_frame) <= kSameStart_frames;
}

// The share of `chains` that `others` contain, with the same way of beginning.
double share_in(const std::vector<PossessionChain>& chains,
                const std::vector<PossessionChain>& others) {
  const auto is_found = [&](const PossessionChain& chain) {
    return std::any_of(others.begin(), others.end(), [&](const PossessionChain& other) {
      return is_same_chain(chain, other) && chain.start == other.start;
    });
  };
  return static_cast<double>(std::count_if(chains.begin(), chains.end(), is_found)) /
         static_cast<double>(chains.size());
}

class ChainsOfLog : public testing::Test {
 protected:
  void play(const std::string& camera) {
    game_ = game_for_chains(camera);
    ChainRecorder recorder(file_.path(), game_);
    record_ = game::play(game_, &recorder);
    recorder.close();
    chains_ = recorder.chains;
    ASSERT_GT(chains_.size(), 10U);
  }

  const league::ScratchFile file_{".log"};
  game::GameConfiguration game_;
  game::GameRecord record_;
  std::vector<PossessionChain> chains_;
};

TEST_F(ChainsOfLog, AreThoseOfTheGameIfVisionIsExact) {
  play("none");
  const PlayOfLog found = play_of_log(file_.path(), game_, referee::Control::kHuman);
  EXPECT_GE(share_in(chains_, found.chains), 0.85);
  EXPECT_GE(share_in(found.chains, chains_), 0.85);
  EXPECT_NEAR(found.ball_in_play_s, record_.ball_in_play_s, 0.02 * record_.ball_in_play_s);
  for (const Side side : kSides) {
    const game::PlayCounts& real = record_.counts[side == game_.match.a_plays ? 0 : 1];
    EXPECT_NEAR(found.counts[side].shots, real.shots, 1);
    EXPECT_NEAR(found.counts[side].passes_completed, real.passes_completed, 2);
    EXPECT_NEAR(found.counts[side].possession_s, real.possession_s, 5);
  }
}

TEST_F(ChainsOfLog, AreMostlyThoseOfTheGameIfVisionIsNoisy) {
  play("rc2026-b");
  const PlayOfLog found = play_of_log(file_.path(), game_, referee::Control::kHuman);
  EXPECT_GE(share_in(found.chains, chains_), 0.7);
}

TEST_F(ChainsOfLog, EndWithAutoRefsCallsIfNobodyCommandsTheGame) {
  play("none");
  const PlayOfLog found = play_of_log(file_.path(), game_, referee::Control::kNone);
  const auto is_out = [](const PossessionChain& chain) {
    return chain.end == game::ChainEnd::kOut;
  };
  EXPECT_GT(std::count_if(found.chains.begin(), found.chains.end(), is_out), 0);
}

TEST_F(ChainsOfLog, DoNotOverlap) {
  play("rc2026-b");
  const PlayOfLog found = play_of_log(file_.path(), game_, referee::Control::kHuman);
  for (std::size_t i = 1; i < found.chains.size(); ++i)
    EXPECT_GE(found.chains[i].first_frame, found.chains[i - 1].last_frame);
}

}  // namespace
}  // namespace autoref::logs
