// A game that the test referees: teams, tracker and physics are real, but the test sends the
// referee's commands.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "game/loop/game.hpp"
#include "game/loop/substitution.hpp"
#include "sim/camera.hpp"
#include "sim/world.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/team_view.hpp"
#include "tracking/tracker.hpp"

namespace autoref {

struct StagedTeam {
  std::string strategy = "dummy";
  std::size_t robots = 6;
  std::map<std::string, double> params;
};

// Vision is exact and has no delay, so everything that happens is the teams' doing.
class StagedGame {
 public:
  static constexpr double kRate_hz = 60;

  StagedGame(const StagedTeam& west, const StagedTeam& east, const RuleBook& rules = {},
             std::uint64_t seed = 1, const Field& on = {})
      : field(on),
        world(on, world_configuration(), {{spec(west.robots), spec(east.robots)}}, seed),
        teams{{make(west, Side::kWest, on, rules, seed), make(east, Side::kEast, on, rules, seed)}},
        camera_({}, on, kRate_hz, seed),
        situation_(rules),
        substitution_controller_(on,
                                 {{static_cast<int>(west.robots), static_cast<int>(east.robots)}},
                                 rules.opponents_to_ball_m) {
    command(CommandKind::kStop);
  }

  void command(CommandKind kind, Side side = Side::kWest) {
    signal.command = {kind, side};
    ++signal.command_counter;
    signal.command_time_s = time_s();
  }

  void put_ball(const Vec2& position_m, const Vec2& velocity_mps = {0, 0}) {
    world.put_ball({position_m, velocity_mps, 0, 0, true});
  }
  void put_robot(RobotId id, const Vec2& position_m, const Vec2& heading = {1, 0}) {
    world.put_robot(id, {id.number, position_m, heading, {0, 0}, 0});
  }

  void frame() {
    camera_.look(world.state(), frame_);
    const Tracks& tracks = tracker_.update(frame_);
    const Situation situation = situation_.update(
        signal, tracks.ball ? std::optional(tracks.ball->position_m) : std::nullopt);
    PerSide<TeamRequests> requests;
    for (const Side side : kSides) {
      TeamView view;
      fill_view(tracks, signal, situation, side, view);
      commands[side].fill(RobotCommand{});
      teams[side]->decide(view, commands[side]);
      requests[side] = teams[side]->requests();
    }
    substitution_controller_.act(signal, requests, time_s(), world);
    world.step(commands, signal.placement);
  }

  void run(double seconds) {
    for (int f = 0; f < seconds * kRate_hz; ++f) frame();
  }
  // Runs until `is_so` returns true, for at most `seconds`. Returns whether it did.
  template <typename Condition>
  bool happens(double seconds, Condition is_so) {
    for (int f = 0; f < seconds * kRate_hz; ++f) {
      frame();
      if (is_so()) return true;
    }
    return false;
  }

  double time_s() const { return static_cast<double>(world.state().frame) / kRate_hz; }
  const auto& robots(Side side) const { return world.state().robots[side]; }
  const sim::RobotState& robot(RobotId id) const {
    for (const sim::RobotState& robot : robots(id.side)) {
      if (robot.number == id.number) return robot;
    }
    throw std::out_of_range("no such robot on the field");
  }
  const sim::BallState& ball() const { return world.state().ball; }

  Field field;
  sim::World world;
  RefereeSignal signal;
  PerSide<std::unique_ptr<strategies::Strategy>> teams;
  PerSide<TeamCommands> commands{};

 private:
  static sim::Configuration world_configuration() {
    sim::Configuration configuration;
    configuration.latency_s = 0;
    return configuration;
  }
  static sim::TeamSpec spec(std::size_t robots) {
    return {sim::TeamSpec::Robots(robots, sim::RobotSpec{})};
  }
  static std::unique_ptr<strategies::Strategy> make(const StagedTeam& team, Side side,
                                                    const Field& field, const RuleBook& rules,
                                                    std::uint64_t seed) {
    return game::make_registered_team({team.strategy, {}},
                                      {field,
                                       rules,
                                       kRate_hz,
                                       RandomStream::of(seed, RandomPurpose::kStrategy, side),
                                       team.params,
                                       {}});
  }

  sim::Camera camera_;
  tracking::Tracker tracker_;
  SituationTracker situation_;
  game::SubstitutionController substitution_controller_;
  Frame frame_;
};

}  // namespace autoref
