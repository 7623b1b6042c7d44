// Teams that change ends at half-time, in logs, event logs and pages (Laws 2014, law 8).
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "league/game_packets.hpp"
#include "league/log_contents.hpp"
#include "logs/log_referee.hpp"
#include "sim/camera.hpp"
#include "tests/support/event_lines.hpp"
#include "tests/support/temporary_folder.hpp"
#include "view/game_recording.hpp"

namespace autoref::logs {
namespace {

// Writes the log of a game and keeps what its referee decided and what pages show of it.
class LogObserver final : public game::Observer {
 public:
  LogObserver(const std::filesystem::path& path, const game::GameConfiguration& game)
      : log(path, game.field, cameras_of(game.field), {}) {}

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World&) override {
    log.add(frame, signal);
  }
  void on_decision(const referee::Decision& decision) override {
    if (decision.command) log.note(*decision.command);
    shown.push_back(view::recorded(game::decision_object(decision)));
    decisions.push_back(decision);
    events += game::decision_json(decision) + "\n";
  }

  league::GameLog log;
  std::vector<view::RecordedDecision> shown;
  std::vector<referee::Decision> decisions;
  std::string events;

 private:
  static std::vector<CameraPosition> cameras_of(const Field& field) {
    const auto positions = sim::camera_positions(field, 4, 4);
    return {positions.begin(), positions.end()};
  }
};

// Where yellow's keeper was, relative to its goal according to the referee packets before the
// frame: positive on its own half.
class KeeperVisitor final : public league::LogVisitor {
 public:
  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    yellow_end_ = packet.blue_team_on_positive_half() ? -1 : 1;
    stage_ = packet.stage();
  }
  void on_frame(const Frame& frame) override {
    for (const RobotObservation& robot : frame.robots[Side::kWest]) {
      if (robot.number != 0) continue;
      (yellow_end_ * robot.position_m.x() > 0 ? at_own_goal : elsewhere) += 1;
      if (stage_ == static_cast<int>(Stage::kFirstHalf)) first_half_m = robot.position_m;
      if (stage_ == static_cast<int>(Stage::kSecondHalf)) second_half_m = robot.position_m;
    }
  }

  int at_own_goal = 0;
  int elsewhere = 0;
  Vec2 first_half_m{0, 0};
  Vec2 second_half_m{0, 0};

 private:
  double yellow_end_ = -1;
  int stage_ = 0;
};

game::GameConfiguration game_by(const char* book) {
  game::GameConfiguration game = short_game_by(book, 20, 5);
  game.a.strategy = "cobalt";
  game.b.strategy = "counter";
  return game;
}

class ChangedEnds : public testing::TestWithParam<const char*> {
 protected:
  ChangedEnds() {
    game::play(game_, &live_);
    live_.log.close();
  }

  const TemporaryFolder folder_;
  const std::string log_ = folder_ / "game.log";
  const game::GameConfiguration game_ = game_by(GetParam());
  LogObserver live_{log_, game_};
};

TEST_P(ChangedEnds, AreSeenByVision) {
  KeeperVisitor keeper;
  league::read_log(log_, keeper);
  EXPECT_GT(keeper.at_own_goal, 2000);
  EXPECT_EQ(keeper.elsewhere, 0);
  EXPECT_LT(keeper.first_half_m.x(), -1);
  EXPECT_GT(keeper.second_half_m.x(), 1);
}

// For the referee, yellow defends the goal at -x in both halves.
TEST_P(ChangedEnds, HoldForThePositionsOfEvents) {
  for (std::size_t i = 0; i < live_.decisions.size(); ++i) {
    const referee::Decision& decision = live_.decisions[i];
    const YAML::Node line = YAML::Load(game::decision_json(decision));
    if (decision.stage == Stage::kHalfTime) continue;
    const bool is_second = decision.stage > Stage::kHalfTime;
    EXPECT_EQ(line["yellow_defends"].as<std::string>(), is_second ? "east" : "west");
    if (!decision.finding.position_m) continue;
    const Vec2 shown_m = (is_second ? -1 : 1) * *decision.finding.position_m;
    EXPECT_EQ(live_.shown[i].position_m, shown_m);
    EXPECT_EQ(line["position_m"][0].as<double>(), shown_m.x());
    EXPECT_EQ(line["position_m"][1].as<double>(), shown_m.y());
  }
}

void expect_the_same(const YAML::Node& one, const YAML::Node& other) {
  for (const char* key : {"time_s", "transition", "event", "command", "offender", "yellow_defends"})
    EXPECT_EQ(YAML::Dump(one[key]), YAML::Dump(other[key]));
  ASSERT_EQ(one["position_m"].IsNull(), other["position_m"].IsNull());
  if (one["position_m"].IsNull()) return;
  for (const int i : {0, 1})
    EXPECT_NEAR(one["position_m"][i].as<double>(), other["position_m"][i].as<double>(), 1e-5);
}

TEST_P(ChangedEnds, LeadToTheSameCallsFromTheLog) {
  const LogRefereeResult refereed =
      referee_log(log_, facts_of(log_), {game::referee_configuration(game_)});
  EXPECT_EQ(refereed.agreement.right, refereed.agreement.recorded);
  std::istringstream live(live_.events);
  std::istringstream read(refereed.events);
  std::string live_line;
  std::string read_line;
  while (std::getline(live, live_line)) {
    ASSERT_TRUE(std::getline(read, read_line));
    expect_the_same(YAML::Load(live_line), YAML::Load(read_line));
  }
  EXPECT_FALSE(std::getline(read, read_line));
}

INSTANTIATE_TEST_SUITE_P(ByTheBook, ChangedEnds, testing::Values("2014", "2026-b"),
                         [](const auto& book) {
                           std::string name = book.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(KeptEnds, AreThoseOfThePapersGames) {
  const TemporaryFolder folder;
  const std::string log = folder / "game.log";
  const game::GameConfiguration game = game_by("paper");
  LogObserver live(log, game);
  game::play(game, &live);
  live.log.close();
  KeeperVisitor keeper;
  league::read_log(log, keeper);
  EXPECT_EQ(keeper.elsewhere, 0);
  EXPECT_LT(keeper.second_half_m.x(), -1);
  EXPECT_EQ(live.events.find(R"("yellow_defends": "east")"), std::string::npos);
}

}  // namespace
}  // namespace autoref::logs
