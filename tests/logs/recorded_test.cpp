#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "game/loop/event_log.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/log_recorder.hpp"
#include "league/log_contents.hpp"
#include "logs/log_game.hpp"
#include "logs/log_referee.hpp"
#include "logs/user_log.hpp"
#include "sim/presets.hpp"
#include "soccer/rules/rule_book.hpp"
#include "tests/league/scratch_log.hpp"

namespace autoref::logs {
namespace {

using league::ScratchFile;

constexpr Command kStop{CommandKind::kStop};
constexpr Command kThrowIn{CommandKind::kIndirectFree, Side::kEast};
constexpr Command kCorner{CommandKind::kDirectFree, Side::kWest};

// Writes the log of a game and keeps the decisions of its referee.
class Recorder final : public game::LogRecorder {
 public:
  Recorder(const std::filesystem::path& path, const game::GameConfiguration& game)
      : LogRecorder(path, game), events(event_game_of(game::shown_names(game), game.match.rules)) {}

  void on_other_detections(const OtherDetections& others) override {
    LogRecorder::on_other_detections(others);
    ++frames_with_others;
  }
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    LogRecorder::on_frame(frame, signal, world);
    frames.push_back(frame);
    balls.push_back(world.state().ball);
  }
  void on_decision(const referee::Decision& decision) override {
    LogRecorder::on_decision(decision);
    events.on_decision(decision);
  }

  game::EventLog events;
  std::vector<Frame> frames;
  std::vector<sim::BallState> balls;  // the true one
  int frames_with_others = 0;
};

game::GameConfiguration short_game() {
  game::GameConfiguration game;
  game.a.strategy = game.b.strategy = "cobalt1";
  game.b.robots.resize(5);
  game.match.half_s = 60;
  game.match.first_kickoff = Side::kEast;
  sim::apply_camera_preset("none", game.sim);
  return game;
}

struct PlayedAndLogged {
  game::GameRecord record;
  std::string events;
};

PlayedAndLogged played_and_recorded(const game::GameConfiguration& game,
                                    const std::filesystem::path& log) {
  Recorder recorder(log, game);
  PlayedAndLogged recorded{game::play(game, &recorder), {}};
  recorder.close();
  recorded.events = recorder.events.text();
  return recorded;
}

std::vector<Call> calls_of(const std::vector<std::pair<double, Command>>& commands) {
  CallMaker maker;
  for (const auto& [time_s, command] : commands) maker.add(time_s, command);
  return maker.calls();
}

TEST(RefereedLog, YieldsEveryDecisionOfTheLiveReferee) {
  const ScratchFile file(".log");
  const game::GameConfiguration game = short_game();
  const PlayedAndLogged live = played_and_recorded(game, file.path());
  const RecordedFacts facts = facts_of(file.path());
  const LogRefereeResult refereed =
      referee_log(file.path(), facts, {game::referee_configuration(game)});
  EXPECT_GT(refereed.decisions, 20);
  EXPECT_EQ(refereed.events, live.events);
  EXPECT_EQ(refereed.agreement.right, refereed.agreement.recorded);
  EXPECT_EQ(refereed.agreement.f1(), 1);
}

// A short game with the vision of 2026, and many more false detections.
game::GameConfiguration game_of_2026(const std::string& book, const std::string& camera) {
  game::GameConfiguration game = short_game();
  game.match.half_s = 20;
  game.field = find_game_setup(book)->field;
  sim::apply_camera_preset(camera, game.sim);
  game.sim.vision.false_balls_per_s = 2;
  game.sim.vision.misread_numbers = 0.002;
  game.sim.vision.ball_misses = 0.05;
  return game;
}

class ReadFrames final : public league::LogVisitor {
 public:
  void on_frame(const Frame& frame) override { frames.push_back(frame); }
  void on_vision(double, const league::VisionPacket& packet) override {
    if (packet.has_detection()) cameras.insert(packet.detection().camera_id());
  }
  std::vector<Frame> frames;
  std::set<std::uint32_t> cameras;
};

bool are_equal(const std::optional<BallObservation>& read,
               const std::optional<BallObservation>& live) {
  if (!read || !live) return read.has_value() == live.has_value();
  return read->position_m == live->position_m && read->height_m == live->height_m &&
         read->seen_from.position_m == live->seen_from.position_m &&
         read->seen_from.height_m == live->seen_from.height_m;
}

// Packets hold angles from -pi to pi as floats, which may change the last digit of a heading.
void expect_same_robots(const Frame& read, const Frame& live) {
  for (const Side side : kSides) {
    ASSERT_EQ(read.robots[side].size(), live.robots[side].size());
    for (std::size_t i = 0; i < read.robots[side].size(); ++i) {
      ASSERT_EQ(read.robots[side][i].number, live.robots[side][i].number);
      ASSERT_EQ(read.robots[side][i].position_m, live.robots[side][i].position_m);
      ASSERT_LT((read.robots[side][i].heading - live.robots[side][i].heading).norm(), 1e-6);
    }
  }
}

bool is_false(const BallObservation& seen, const sim::BallState& ball) {
  constexpr double kSeenWell_m = 0.05;
  return ball.height_m > 0 || (seen.position_m - ball.position_m).norm() > kSeenWell_m;
}

// Plays a game and compares its frames with those of its log, which has that many cameras. The
// times of the log begin with the first capture, not with the first frame. The balls differ where
// the live frame has a false one; the log's may still be a false one when the true one appears
// again.
void expect_frames_of_the_live_game(const game::GameConfiguration& game, std::size_t cameras) {
  const ScratchFile file(".log");
  Recorder live(file.path(), game);
  game::play(game, &live);
  live.close();
  EXPECT_GT(live.frames_with_others, 200);
  ReadFrames read;
  league::read_log(file.path(), read);
  EXPECT_EQ(read.cameras.size(), cameras);
  ASSERT_EQ(read.frames.size(), live.frames.size());
  const double first_s = read.frames.front().time_s;
  double oldest_s = 0;
  for (const CameraPosition& camera : game::logged_cameras(game))
    oldest_s = std::max(oldest_s, camera.age_s);
  EXPECT_NEAR(first_s, oldest_s, 1e-9);
  std::size_t lost = 0;
  for (std::size_t i = 0; i < live.frames.size(); ++i) {
    expect_same_robots(read.frames[i], live.frames[i]);
    ASSERT_NEAR(read.frames[i].time_s - first_s, live.frames[i].time_s, 1e-9);
    if (testing::Test::HasFatalFailure()) FAIL() << "frame " << i;
    const std::optional<BallObservation>& ball = live.frames[i].ball;
    const bool is_lost =
        !are_equal(read.frames[i].ball, ball) && ball && !is_false(*ball, live.balls[i]);
    lost += is_lost ? 1 : 0;
  }
  EXPECT_LT(static_cast<double>(lost), 0.01 * static_cast<double>(live.frames.size()));
}

TEST(LogOf2026, OfDivisionBHasOneCameraAndTheFramesOfTheLiveGame) {
  expect_frames_of_the_live_game(game_of_2026("2026-b", "rc2026-b"), 1);
}

TEST(LogOf2026, OfDivisionAHasTwoCamerasAndTheFramesOfTheLiveGame) {
  expect_frames_of_the_live_game(game_of_2026("2026-a", "rc2026-a"), 2);
}

TEST(LoggedCameras, AreThoseOfTheDivisionIfHeightsAreReported) {
  game::GameConfiguration game;
  for (const auto& [book, cameras] : {std::pair{"2026-b", 1U}, {"2026-a", 2U}, {"2014", 4U}}) {
    game.field = find_game_setup(book)->field;
    sim::apply_camera_preset("paper", game.sim);
    EXPECT_EQ(game::logged_cameras(game).size(), cameras) << book;
    sim::apply_camera_preset("realistic", game.sim);
    EXPECT_EQ(game::logged_cameras(game).size(), 4U) << "their positions matter for flying balls";
  }
}

TEST(RecordedFacts, AreThoseOfTheGame) {
  const ScratchFile file(".log.gz");
  const game::GameConfiguration game = short_game();
  const PlayedAndLogged live = played_and_recorded(game, file.path());
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
  played_and_recorded(short_game(), file.path());
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
}  // namespace autoref::logs
