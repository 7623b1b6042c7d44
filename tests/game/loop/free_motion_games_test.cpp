// Contacts of whole games, played again from the same state with every body in Box2D: they come out
// as they did while Box2D only knew the bodies that could meet.
//
// AUTOREF_CONTACT_GAMES=100 build/release/bin/test_game --gtest_filter='FreeMotionGames.*'
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

constexpr double kSame_m = 0.05_mm;  // within a frame

int contact_games() {
  const char* games = std::getenv("AUTOREF_CONTACT_GAMES");
  return games == nullptr ? 2 : std::stoi(games);
}

sim::RobotSpec without_noise() {
  sim::RobotSpec robot;
  robot.body.speed_noise = 0.0;
  robot.kicker.speed_noise = 0.0;
  robot.kicker.direction_noise_deg = 0.0;
  return robot;
}

sim::World twin(const GameConfiguration& game, bool free_motion) {
  sim::Configuration configuration = game.sim;
  configuration.free_motion = free_motion;
  configuration.contact_free_substeps = 16;  // equal steps for all bodies
  sim::TeamSpec team;
  team.robots.assign(6, without_noise());
  return {game.field, configuration, {{team, team}}, 1};
}

// Puts two worlds into the game's state before each frame, and compares what they make of it.
class ContactReplay final : public Observer {
 public:
  explicit ContactReplay(const GameConfiguration& game)
      : free_(twin(game, true)), whole_(twin(game, false)) {}

  void on_commands(const PerSide<TeamCommands>& commands, const std::optional<Placement>& placement,
                   const sim::World& world) override {
    for (sim::World* twin : {&free_, &whole_}) {
      put(*twin, world.state());
      twin->step(commands, placement);
    }
    if (free_.touches().empty() && free_.collisions().empty()) return;
    ++contacts;
    const bool same_events = free_.touches().size() == whole_.touches().size() &&
                             free_.collisions().size() == whole_.collisions().size();
    others += same_events ? 0 : 1;
    shifted += difference_m() > kSame_m ? 1 : 0;
  }

  int contacts = 0;  // frames with a touch or a collision
  int others = 0;    // of them, with other touches or collisions than in Box2D
  int shifted = 0;   // with a body elsewhere

 private:
  static void put(sim::World& twin, const sim::WorldState& state) {
    for (const Side side : kSides) {
      for (const sim::RobotState& robot : state.robots[side]) {
        twin.put_robot({side, robot.number}, robot);
      }
    }
    twin.put_ball(state.ball);
  }

  double difference_m() const {
    double most_m = (free_.state().ball.position_m - whole_.state().ball.position_m).norm();
    for (const Side side : kSides) {
      const auto& robots = free_.state().robots[side];
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const Vec2& other_m = whole_.state().robots[side][i].position_m;
        most_m = std::max(most_m, (robots[i].position_m - other_m).norm());
      }
    }
    return most_m;
  }

  sim::World free_;
  sim::World whole_;
};

// A ball pinched between robots ends up to half a millimetre away: Box2D solves its contacts in
// another order.
TEST(FreeMotionGames, HaveTheContactsOfBox2d) {
  int contacts = 0;
  int others = 0;
  int shifted = 0;
  for (int seed = 1; seed <= contact_games(); ++seed) {
    GameConfiguration game = short_game(120, static_cast<std::uint64_t>(seed));
    game.a.laws = game.b.laws = std::nullopt;  // for more contacts
    ContactReplay replay(game);
    ASSERT_EQ(play(game, &replay).status, Status::kOk);
    contacts += replay.contacts;
    others += replay.others;
    shifted += replay.shifted;
  }
  fmt::print("{} frames with contacts, {} with other ones in Box2D, {} with a body elsewhere\n",
             contacts, others, shifted);
  EXPECT_GT(contacts, 500 * contact_games());
  EXPECT_LE(others * 2000, contacts);
  EXPECT_LE(shifted * 200, contacts);
}

}  // namespace
}  // namespace autoref::game
