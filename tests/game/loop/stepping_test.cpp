// Stepping a game frame by frame.
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

GameRecord stepped_to_its_end(Game& game) {
  while (game.step()) {
  }
  return game.record();
}

void expect_same(const GameRecord& one, const GameRecord& other) {
  EXPECT_EQ(one.state_hash, other.state_hash);
  EXPECT_EQ(one.frames, other.frames);
  EXPECT_EQ(one.sim_s, other.sim_s);
  EXPECT_EQ(one.goals_by_half, other.goals_by_half);
  EXPECT_EQ(one.events, other.events);
  EXPECT_EQ(one.transitions, other.transitions);
  EXPECT_EQ(one.counts, other.counts);
  EXPECT_EQ(one.ball_in_play_s, other.ball_in_play_s);
  EXPECT_EQ(one.end_reason, other.end_reason);
  EXPECT_EQ(one.status, other.status);
}

TEST(SteppedGame, HasTheSameRecordAsAPlayedGame) {
  Game game(short_game(30, 4));
  expect_same(stepped_to_its_end(game), play(short_game(30, 4)));
}

TEST(SteppedGame, IsNotInfluencedByAnotherGameSteppedAlternately) {
  Game one(short_game(20, 4));
  Game other(short_game(25, 5));
  while (!one.is_over() || !other.is_over()) {
    one.step();
    other.step();
  }
  expect_same(one.record(), play(short_game(20, 4)));
  expect_same(other.record(), play(short_game(25, 5)));
}

TEST(SteppedGame, ContinuesAfterAMove) {
  Game before(short_game(20, 6));
  for (int i = 0; i < 600; ++i) before.step();
  Game after(std::move(before));
  expect_same(stepped_to_its_end(after), play(short_game(20, 6)));
}

TEST(SteppedGame, DoesNotChangeOnceItIsOver) {
  Game game(short_game(10, 7));
  const GameRecord record = stepped_to_its_end(game);
  const std::int64_t last_frame = game.frame().number;
  EXPECT_TRUE(game.is_over());
  EXPECT_FALSE(game.step());
  EXPECT_EQ(game.frame().number, last_frame);
  expect_same(game.record(), record);
}

TEST(SteppedGame, ShowsWhatHappenedInTheLastFrame) {
  Game game(short_game(10, 8));
  EXPECT_TRUE(game.frame().robots[Side::kWest].empty());
  EXPECT_TRUE(game.decisions().empty());
  std::int64_t decisions = 0;
  std::uint32_t commands = 0;
  for (std::int64_t number = 0; !game.is_over(); ++number) {
    game.step();
    EXPECT_EQ(game.frame().number, number);
    for (const referee::Decision& decision : game.decisions()) {
      EXPECT_EQ(decision.frame, number);
      ++decisions;
    }
    commands = game.signal().command_counter;
  }
  EXPECT_GT(decisions, 4);
  EXPECT_GT(commands, 4U);
  EXPECT_EQ(game.signal().command.kind, CommandKind::kHalt);
}

TEST(SteppedGame, HasARecordOfTheFramesSoFar) {
  Game game(short_game(30, 4));
  for (int i = 0; i < 1200; ++i) ASSERT_TRUE(game.step());
  const GameRecord early = game.record();
  EXPECT_EQ(early.frames, 1200);
  EXPECT_EQ(early.sim_s, 20);
  const GameRecord late = stepped_to_its_end(game);
  EXPECT_GT(late.frames, early.frames);
  EXPECT_NE(late.state_hash, early.state_hash);
}

// Ends the game from inside, as Ctrl-C does.
class Interrupter final : public Observer {
 public:
  void on_frame(const Frame& frame, const RefereeSignal& /*signal*/,
                const sim::World& /*world*/) override {
    if (frame.number == 10) throw std::runtime_error("enough");
  }
};

TEST(SteppedGame, PassesOnItsObserversExceptions) {
  Interrupter interrupter;
  Game game(short_game(10, 9), &interrupter);
  for (int i = 0; i < 10; ++i) game.step();
  EXPECT_THROW(game.step(), std::runtime_error);
}

// Notes which callbacks come, in order.
class Listener final : public Observer {
 public:
  explicit Listener(std::string name, std::vector<std::string>& heard)
      : name_(std::move(name)), heard_(&heard) {}
  void on_phase(Phase /*ended*/) override { note("phase"); }
  void on_requests(const PerSide<TeamRequests>& /*requests*/) override { note("requests"); }
  void on_other_detections(const OtherDetections& /*others*/) override { note("others"); }
  void on_frame(const Frame& /*frame*/, const RefereeSignal& /*signal*/,
                const sim::World& /*world*/) override {
    note("frame");
  }
  void on_commands(const PerSide<TeamCommands>& /*commands*/,
                   const std::optional<Placement>& /*placement*/,
                   const sim::World& /*world*/) override {
    note("commands");
  }
  void on_decision(const referee::Decision& /*decision*/) override { note("decision"); }

 private:
  void note(const std::string& callback) { heard_->push_back(name_ + callback); }

  std::string name_;
  std::vector<std::string>* heard_;
};

TEST(SteppedGame, CallsEveryObserverInOrder) {
  GameConfiguration configuration = short_game(10, 9);
  configuration.sim.vision.false_balls_per_s = 10;
  std::vector<std::string> heard;
  Listener one("1 ", heard);
  Listener other("2 ", heard);
  Observers observers(&one);
  observers.add(&other);
  observers.add(nullptr);
  Game game(configuration, observers);
  for (int i = 0; i < 60; ++i) game.step();
  std::set<std::string> callbacks;
  ASSERT_EQ(heard.size() % 2, 0U);
  for (std::size_t i = 0; i < heard.size(); i += 2) {
    EXPECT_EQ(heard[i], "1 " + heard[i].substr(2));
    EXPECT_EQ(heard[i + 1], "2 " + heard[i].substr(2));
    callbacks.insert(heard[i].substr(2));
  }
  EXPECT_EQ(callbacks, (std::set<std::string>{"phase", "requests", "others", "frame", "commands",
                                              "decision"}));
}

}  // namespace
}  // namespace autoref::game
