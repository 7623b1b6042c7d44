#include "game/loop/team_controller.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>

#include "io/errors.hpp"
#include "sim/kicker.hpp"
#include "sim/world.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/units.hpp"
#include "strategies/registry.hpp"

namespace autoref::game {
namespace {

// The abilities of the side's robots, by number.
std::array<Abilities, kMaxRobots> abilities_of(const GameConfiguration& c, Side side) {
  std::array<Abilities, kMaxRobots> all;
  const sim::TeamSpec::Robots& robots = team_on(c, side).robots;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const sim::RobotSpec& robot = robots[i];
    all[i] = {robot.body.speed_mps * robot.speed_factor,
              robot.body.acceleration_mps2 * robot.acceleration_factor,
              robot.body.braking_mps2 * robot.acceleration_factor, robot.kicker.speed_limit_mps,
              robot.kicker.chip_limit_mps};
  }
  return all;
}

strategies::KickScatter kick_scatter_of(const TeamConfiguration& team) {
  strategies::KickScatter most{0, 0};
  for (const sim::RobotSpec& robot : team.robots) {
    most.direction_rad = std::max(most.direction_rad, to_radians(robot.kicker.direction_noise_deg));
    most.speed = std::max(most.speed, robot.kicker.speed_noise);
  }
  return most;
}

// Time from a frame until the commands based on it move a robot.
double latency_s(const sim::Configuration& c) {
  const sim::LatencySplit split = sim::split_latency(c);
  return (split.frames + static_cast<double>(split.substeps) / c.substeps) / c.frame_rate_hz;
}

// The latency that the team on this side assumes.
double believed_latency_s(const GameConfiguration& c, Side side) {
  const double true_s = latency_s(c.sim);
  if (c.sim.latency_error_s <= 0) return true_s;
  RandomStream stream = RandomStream::of(c.seed, RandomPurpose::kLatency, side);
  return std::max(0.0, true_s + c.sim.latency_error_s * stream.normal());
}

// The message of the exception that `action` throws; empty if it throws none. An InputOutputError
// is not the team's fault and is rethrown.
template <typename Action>
std::string fault_of(const Action& action) {
  try {
    action();
  } catch (const strategies::StrategyFault& fault) {
    return fault.what();
  } catch (const io::InputOutputError&) {
    throw;
  } catch (const std::exception& error) {
    return fmt::format("threw: {}", error.what());
  } catch (...) {
    return "threw something other than a std::exception";
  }
  return {};
}

std::unique_ptr<strategies::Strategy> make_team_on(const GameConfiguration& c, Side side,
                                                   const TeamMaker& make_team) {
  const TeamConfiguration& team = team_on(c, side);
  strategies::TeamContext context{c.field,
                                  obeyed_rules(c, team),
                                  c.sim.frame_rate_hz,
                                  RandomStream::of(c.seed, RandomPurpose::kStrategy, side),
                                  team.params,
                                  abilities_of(c, side)};
  context.side = side;
  context.robot_count = static_cast<int>(team.robots.size());
  context.latency_s = believed_latency_s(c, side);
  context.random_seed = RandomStream::stream_seed(c.seed, RandomPurpose::kStrategy, side);
  context.enforced = c.match.rules.in_force;
  context.kicks = kick_scatter_of(team);
  return make_team(team, context);
}

}  // namespace

std::unique_ptr<strategies::Strategy> make_registered_team(const TeamConfiguration& team,
                                                           const strategies::TeamContext& context) {
  if (team.on_network)
    throw std::invalid_argument("a team on the network can only play in autoref live");
  const strategies::Entry* entry = strategies::find_strategy(team.strategy);
  if (entry == nullptr)
    throw std::invalid_argument(fmt::format("unknown strategy '{}'", team.strategy));
  return entry->make(context);
}

Sensors::Sensors(const GameConfiguration& configuration, Side side)
    : side_(side),
      robots_(team_on(configuration, side).robots),
      delayed_(sim::split_latency(configuration.sim).frames) {}

void Sensors::update(const Frame& frame, const sim::WorldState& world) {
  latest_.detections = side_ == Side::kWest ? frame : mirrored(frame);
  latest_.ball_in_dribbler_zone.reset();
  for (const sim::RobotState& robot : world.robots[side_]) {
    const auto number = static_cast<std::size_t>(robot.number);
    latest_.ball_in_dribbler_zone[number] = sim::is_in_dribbler_zone(
        robot, world.ball.position_m, world.ball.height_m, robots_[number].kicker.reach_m);
  }
  delayed_.push(latest_);
}

TeamController::TeamController(const GameConfiguration& configuration, Side side,
                               const TeamMaker& make_team)
    : side_(side),
      robots_(static_cast<int>(team_on(configuration, side).robots.size())),
      strategy_(make_team_on(configuration, side, make_team)) {
  view_.latency_s = believed_latency_s(configuration, side);
  if (strategy_->has_sensors()) sensors_.emplace(configuration, side);
}

void TeamController::sense(const Frame& frame, const sim::WorldState& world) {
  if (!sensors_) return;
  sensors_->update(frame, world);
  strategy_->sense(sensors_->readings());
}

void TeamController::prepare(const Tracks& tracks, const RefereeSignal& signal,
                             const Situation& situation) {
  fill_view(tracks, signal, situation, side_, view_);
  fault_ = fault_of([&] { strategy_->prepare(view_); });
}

std::string TeamController::decide(TeamCommands& commands) {
  commands.fill(RobotCommand{});
  if (fault_.empty()) {
    fault_ = fault_of([&] {
      strategy_->decide(view_, commands);
      requests_ = strategy_->requests();
    });
  }
  if (fault_.empty()) fault_ = fault_in(commands);
  if (!fault_.empty()) commands.fill(RobotCommand{});
  return fault_;
}

void TeamController::end(const strategies::GameEnd& end) {
  fault_of([&] { strategy_->end(end); });
}

std::string TeamController::fault_in(const TeamCommands& commands) const {
  for (int number = 0; number < robots_; ++number) {
    if (!is_finite(commands[static_cast<std::size_t>(number)])) {
      return fmt::format("sent a command for robot {} with a value that is not finite", number);
    }
  }
  return {};
}

}  // namespace autoref::game
