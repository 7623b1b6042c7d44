#include <gtest/gtest.h>

#include <array>

#include "league/game_log.hpp"
#include "runner/game/event_log.hpp"
#include "runner/logs/log_referee.hpp"
#include "runner/logs/user_log.hpp"
#include "sim/camera.hpp"
#include "sim/camera_presets.hpp"
#include "tests/league/scratch_log.hpp"

namespace autoref::runner {
namespace {

using league::ScratchFile;

constexpr Command kStop{CommandKind::kStop};
constexpr Command kThrowIn{CommandKind::kIndirectFree, Side::kEast};
constexpr Command kCorner{CommandKind::kDirectFree, Side::kWest};

// Writes the log of a game and keeps the decisions of its referee.
class Recorder final : public Observer {
 public:
  Recorder(const std::filesystem::path& path, const GameConfiguration& game)
      : log_(path, game.field, cameras_of(game.field), {}) {}

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World&) override {
    log_.add(frame, signal);
  }
  void on_decision(const referee::Decision& decision) override {
    events.on_decision(decision);
    if (decision.command) log_.note(*decision.command);
  }
  void close() { log_.close(); }

  EventLog events;

 private:
  static std::vector<CameraPosition> cameras_of(const Field& field) {
    const auto positions = sim::camera_positions(field, 4);
    return {positions.begin(), positions.end()};
  }

  league::GameLog log_;
};

GameConfiguration short_game() {
  GameConfiguration game;
  game.a.strategy = game.b.strategy = "cobalt";
  game.b.robots.resize(5);
  game.match.half_s = 60;
  game.match.first_kickoff = Side::kEast;
  sim::apply_camera_preset("none", game.sim);
  return game;
}

struct RecordedGame {
  GameRecord record;
  std::string events;
};

RecordedGame played(const GameConfiguration& game, const std::filesystem::path& log) {
  Recorder recorder(log, game);
  RecordedGame recorded{play(game, &recorder), {}};
  recorder.close();
  recorded.events = recorder.events.text();
  return recorded;
}

std::vector<Call> calls_of(const std::vector<std::pair<double, Command>>& commands) {
  CallMaker maker;
  for (const auto& [time_s, command] : commands) maker.take(time_s, command);
  return maker.calls();
}

TEST(RefereedLog, YieldsEveryDecisionOfTheLiveReferee) {
  const ScratchFile file(".log");
  const GameConfiguration game = short_game();
  const RecordedGame live = played(game, file.path());
  const RecordedFacts facts = facts_of(file.path());
  const LogRefereeResult refereed = referee_log(file.path(), facts, {referee_configuration(game)});
  EXPECT_GT(refereed.decisions, 20);
  EXPECT_EQ(refereed.events, live.events);
  EXPECT_EQ(refereed.agreement.right, refereed.agreement.recorded);
  EXPECT_EQ(refereed.agreement.f1(), 1);
}

TEST(RecordedFacts, AreThoseOfTheGame) {
  const ScratchFile file(".log.gz");
  const GameConfiguration game = short_game();
  const RecordedGame live = played(game, file.path());
  const RecordedFacts facts = facts_of(file.path());
  EXPECT_EQ(facts.log.frames, live.record.frames + 1);
  EXPECT_EQ(facts.games.front().half_s, 60);
  EXPECT_EQ(facts.games.front().halves, 2);
  EXPECT_EQ(facts.games.front().first_kickoff, Side::kEast);
  EXPECT_EQ(facts.robots, (PerSide<int>{{6, 5}}));
  EXPECT_EQ(facts.last_signal->goals, (PerSide<int>{{live.record.goals_a, live.record.goals_b}}));
  EXPECT_EQ(facts.cameras.size(), 4U);
  EXPECT_NEAR(facts.cameras.at(2).rate_hz(), 60, 0.1);
}

TEST(RecordedFacts, OfADamagedLogAreThoseBeforeTheDamage) {
  const ScratchFile file(".log");
  played(short_game(), file.path());
  const std::string whole = file.bytes();
  const RecordedFacts facts = facts_of(file.fill(whole.substr(0, whole.size() / 2)).path());
  EXPECT_GT(facts.log.frames, 1000);
  ASSERT_TRUE(facts.log.damage.has_value());
  EXPECT_NE(
      damage_text("game.log", facts.log).find("game.log: the log is only readable up to byte"),
      std::string::npos);
}

TEST(CallMaker, TurnsAStopAndTheRestartAfterItIntoACall) {
  const std::vector<Call> calls = calls_of({{1, kStop},
                                            {2, {CommandKind::kGoal, Side::kWest}},
                                            {3, {CommandKind::kPrepareKickoff, Side::kEast}},
                                            {5, {CommandKind::kNormalStart}},
                                            {9, {CommandKind::kForceStart}}});
  ASSERT_EQ(calls.size(), 1U);
  EXPECT_EQ(calls[0].stop_s, 1);
  EXPECT_EQ(calls[0].restart_s, 3);
  EXPECT_EQ(calls[0].restart.kind, CommandKind::kPrepareKickoff);
}

TEST(Agreement, AcceptsTheSameRestartUpToTwoSecondsEarly) {
  const std::vector<Call> recorded = calls_of({{10, kStop}, {14, kThrowIn}});
  for (const auto& [ahead_s, right] :
       {std::pair{0.0, 1}, {5.9, 1}, {6.1, 0}, {-3.9, 1}, {-4.1, 0}}) {
    const std::vector<Call> refereed = calls_of({{10 - ahead_s, kStop}, {14 - ahead_s, kThrowIn}});
    EXPECT_EQ(agreement_of(recorded, refereed).right, right) << ahead_s;
  }
}

TEST(Agreement, CountsWrongAndMissedCalls) {
  const std::vector<Call> recorded =
      calls_of({{10, kStop}, {14, kThrowIn}, {30, kStop}, {34, kCorner}});
  const std::vector<Call> refereed = calls_of(
      {{10, kStop}, {14, kThrowIn}, {20, kStop}, {24, kCorner}, {50, kStop}, {54, kCorner}});
  const Agreement agreement = agreement_of(recorded, refereed);
  EXPECT_EQ(agreement.right, 1);
  EXPECT_DOUBLE_EQ(agreement.precision(), 1.0 / 3);
  EXPECT_DOUBLE_EQ(agreement.recall(), 0.5);
  EXPECT_DOUBLE_EQ(agreement.f1(), 0.4);
  EXPECT_EQ(agreement.challenge_score(), 1 - 2 * 2);
  EXPECT_EQ(agreement.pairs.size(), 4U);
}

TEST(Agreement, MatchesEachCallOnce) {
  const std::vector<Call> recorded = calls_of({{10, kStop}, {14, kThrowIn}});
  const std::vector<Call> refereed =
      calls_of({{10, kStop}, {11, kThrowIn}, {12, kStop}, {13, kThrowIn}});
  EXPECT_EQ(agreement_of(recorded, refereed).right, 1);
}

}  // namespace
}  // namespace autoref::runner
