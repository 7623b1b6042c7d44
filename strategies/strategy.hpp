// The interface of a team, which turns its view of the game into commands for its robots once per
// frame, and the team's parameters.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/parameters.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"
#include "soccer/team_view.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {

// Standard deviations of a kick's direction and of its speed, the latter as a fraction of the
// speed.
struct KickScatter {
  double direction_rad = to_radians(kUsualKickError_deg);
  double speed = kUsualKickSpeedError;
};

// The information that a team gets before the game.
struct TeamContext {
  Field field;
  RuleBook rules;  // the rules that the team obeys: the rules of the match and of the team's own
                   // laws (obeyed_rules())
  double frame_rate_hz = 60;
  RandomStream random{0};                    // this team's stream; the only randomness allowed
  std::map<std::string, double> params;      // the team's parameters by name
  std::array<Abilities, kMaxRobots> robots;  // the team's own robots, by number
  Side side = Side::kWest;                   // west plays in yellow
  int robot_count = kMaxRobots;
  double latency_s = 0;           // delay from a frame until a command based on it moves a robot
  std::uint64_t random_seed = 0;  // RandomStream(random_seed) is `random`
  RuleSet enforced = {};          // the rules in force in the match
  KickScatter kicks = {};         // the kick scatter of the team's least accurate robot
};

// Readings from the cameras and the robots' sensors at the time of a view.
struct SensorReadings {
  Frame detections;  // detections in the team's frame; its own robots are listed as west's
  std::bitset<kMaxRobots> ball_in_dribbler_zone;  // for the team's own robots, by number
};

// How a game ended.
struct GameEnd {
  std::string reason;  // the same as in a game's row: "time", "void" and so on
  int goals_own = 0;
  int goals_opponent = 0;
};

// A strategy that cannot continue. what() completes the sentence "team a ...".
class StrategyFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Strategy {
 public:
  virtual ~Strategy() = default;

  // Whether the team uses sensor readings, so that sense() is called.
  virtual bool has_sensors() const { return false; }

  // Called before prepare(), with the sensor readings for the same view.
  virtual void sense(const SensorReadings& /*readings*/) {}

  // Called for both teams before either of them decides, with the view to decide on. A team that
  // runs in another process starts thinking here.
  virtual void prepare(const TeamView& /*view*/) {}

  // Decides on one view. `commands` is all zero on entry, so a robot without a command stands
  // still. A strategy may keep state, but must not read a clock or share anything with other games.
  virtual void decide(const TeamView& view, TeamCommands& commands) = 0;

  virtual TeamRequests requests() const { return {}; }

  // Called once after the last frame.
  virtual void end(const GameEnd& /*end*/) {}
};

// The parameters of a team, which a scenario sets in `params:`. A team's style lists its parameters
// in visit() (soccer/parameters.hpp).

// A parameter that users can set, and its default.
struct Tunable : Parameter {
  double standard = 0;   // the default
  bool is_flag = false;  // whether the value is either 0 or 1
};

// The value in `params`, or the default.
inline double value_of(const Tunable& tunable, const std::map<std::string, double>& params) {
  const auto given = params.find(std::string(tunable.name));
  return given == params.end() ? tunable.standard : given->second;
}

// The parameters of `style`, with their values in `style` as defaults.
template <HasParameters Style>
std::vector<Tunable> tunables_of(const Style& style) {
  std::vector<Tunable> all;
  Style::visit(style, [&all](const auto& value, const Parameter& about) {
    const bool is_flag = std::is_same_v<decltype(value), const bool&>;
    all.push_back({about, static_cast<double>(value), is_flag});
  });
  return all;
}

// A copy of `style` with the values given in `params`. Any value except 0 sets a flag.
template <HasParameters Style>
Style tuned(const Style& style, const std::map<std::string, double>& params) {
  Style result = style;
  Style::visit(result, [&params](auto& value, const Parameter& about) {
    const auto given = params.find(std::string(about.name));
    if (given == params.end()) return;
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, bool>) {
      value = given->second != 0;
    } else {
      value = given->second;
    }
  });
  return result;
}

}  // namespace autoref::strategies
