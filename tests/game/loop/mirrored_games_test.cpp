// Metamorphic test: if every frame of a game is rotated by 180 degrees and the colours are swapped,
// the referee must make the rotated and swapped calls in the same frames. This detects a referee
// that favours one side.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "game/loop/game.hpp"
#include "sim/presets.hpp"
#include "soccer/rules/rule_book.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

struct MirroredSetup {
  const char* book;
  const char* camera;
};

// Compares the game's referee with a second one that sees every frame rotated.
class TurnedReferee final : public Observer {
 public:
  explicit TurnedReferee(referee::Configuration configuration)
      : referee_(turned(std::move(configuration))) {}

  void on_requests(const PerSide<TeamRequests>& requests) override {
    requests_ = {{requests[Side::kEast], requests[Side::kWest]}};
  }
  void on_decision(const referee::Decision& decision) override { live_.push_back(decision); }
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World&) override {
    const RefereeSignal& other = referee_.update(mirrored(frame), requests_);
    is_same = is_same && other.command == mirrored(signal.command) &&
              other.robots_allowed[Side::kWest] == signal.robots_allowed[Side::kEast];
    is_same = is_same && std::equal(live_.begin(), live_.end(), referee_.decisions().begin(),
                                    referee_.decisions().end(), is_turned);
    if (is_same) last_same_s = frame.time_s;
    decisions += live_.size();
    live_.clear();
  }

  bool is_same = true;
  double last_same_s = 0;
  std::size_t decisions = 0;

 private:
  static referee::Configuration turned(referee::Configuration configuration) {
    std::swap(configuration.robots[Side::kWest], configuration.robots[Side::kEast]);
    configuration.first_kickoff = opponent_of(configuration.first_kickoff);
    return configuration;
  }

  static bool is_turned(const referee::Decision& a, const referee::Decision& b) {
    const bool same_position =
        a.finding.position_m.has_value() == b.finding.position_m.has_value() &&
        (!a.finding.position_m || (*a.finding.position_m + *b.finding.position_m).norm() < 1e-6);
    const bool same_offender = a.finding.offender.has_value() == b.finding.offender.has_value() &&
                               a.finding.offender != b.finding.offender;
    return a.transition == b.transition && same_position &&
           (same_offender || !a.finding.offender) &&
           a.finding.robots.size() == b.finding.robots.size() &&
           std::all_of(a.finding.robots.begin(), a.finding.robots.end(), [&b](RobotId robot) {
             const RobotId other{opponent_of(robot.side), robot.number};
             return std::find(b.finding.robots.begin(), b.finding.robots.end(), other) !=
                    b.finding.robots.end();
           });
  }

  referee::AutoRef referee_;
  PerSide<TeamRequests> requests_;
  std::vector<referee::Decision> live_;
};

class MirroredGame : public testing::TestWithParam<MirroredSetup> {};

// Four games per parameter, twenty in total, played by teams that break every rule.
TEST_P(MirroredGame, GetsTheRotatedCallsInTheSameFrames) {
  for (std::uint64_t seed = 11; seed <= 14; ++seed) {
    GameConfiguration game = short_game_by(GetParam().book, 40, seed);
    game.a.strategy = game.b.strategy = "rowdy";
    sim::apply_camera_preset(GetParam().camera, game.sim);
    TurnedReferee turned(referee_configuration(game));
    play(game, &turned);
    EXPECT_TRUE(turned.is_same) << "seed " << seed << ": calls differ after " << turned.last_same_s
                                << " s";
    EXPECT_GT(turned.decisions, 10U) << "hardly anything was compared";
  }
}

std::string name_of_mirrored(const testing::TestParamInfo<MirroredSetup>& info) {
  std::string name = info.param.book;
  std::replace(name.begin(), name.end(), '-', '_');
  return "Rules" + name;
}

INSTANTIATE_TEST_SUITE_P(Books, MirroredGame,
                         testing::Values(MirroredSetup{"paper", "paper"},
                                         MirroredSetup{"2014", "none"},
                                         MirroredSetup{"2014-double", "realistic"},
                                         MirroredSetup{"2026-b", "realistic"},
                                         MirroredSetup{"2026-a", "none"}),
                         name_of_mirrored);

}  // namespace
}  // namespace autoref::game
