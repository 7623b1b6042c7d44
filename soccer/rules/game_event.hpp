// The league's game events as plain values: both those that an automatic referee reports to the
// league's game controller, and those on which the controller decided.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref {

// Numbers of the league's GameEvent.Type. Values without an enumerator are possible: later editions
// add types.
enum class GameEventType : std::int32_t {
  kUnknown = 0,
#define AUTOREF_GAME_EVENT(id, number, name) id = (number),
#include "soccer/rules/game_events.def"
#undef AUTOREF_GAME_EVENT
};

// The league's name, for example "POSSIBLE_GOAL"; empty if the type is unknown.
std::string_view name_of(GameEventType type);

// The type with that name; nullopt if there is none.
std::optional<GameEventType> game_event_type(std::string_view name);

// One event. Each type uses some of the optional members, as described in the league's messages
// (league/messages/game_event.proto).
struct GameEvent {
  GameEventType type = GameEventType::kUnknown;
  std::vector<std::string> origin;          // the automatic referees that reported it
  std::optional<std::uint64_t> created_us;  // Unix time
  std::string id;

  std::optional<Side> by_team;       // nullopt if unknown
  std::optional<Side> kicking_team;  // for a goal
  // Numbers that identify robots.
  std::optional<int> by_bot;
  std::optional<int> kicking_bot;
  std::optional<int> violator;
  std::optional<int> victim;
  std::optional<int> bot_yellow;
  std::optional<int> bot_blue;
  // Counts of robots.
  std::optional<int> num_robots_by_team;
  std::optional<int> num_robots_allowed;
  std::optional<int> num_robots_on_field;
  // Positions in metres, in the coordinates of vision.
  std::optional<Vec2> location_m;
  std::optional<Vec2> kick_location_m;
  std::optional<Vec2> ball_location_m;
  std::optional<Vec2> start_m;
  std::optional<Vec2> end_m;
  // Lengths in metres.
  std::optional<double> distance_m;
  std::optional<double> pushed_distance_m;
  std::optional<double> remaining_distance_m;
  std::optional<double> nearest_own_bot_distance_m;
  std::optional<double> precision_m;
  std::optional<double> max_ball_height_m;
  // Speeds and an angle.
  std::optional<double> speed_mps;
  std::optional<double> initial_ball_speed_mps;
  std::optional<double> crash_speed_mps;
  std::optional<double> speed_diff_mps;
  std::optional<double> crash_angle_rad;
  // Durations in seconds.
  std::optional<double> time_s;
  std::optional<double> time_taken_s;
  std::optional<double> duration_s;

  std::optional<std::uint64_t> last_touch_by_team_us;  // Unix time
  std::optional<bool> chipped;
  std::optional<bool> accepted;
  std::string reason;
  std::string message;

  bool operator==(const GameEvent&) const = default;
};

// Calls `visit(name, member)` for each member that depends on the type. `name` is the member's name
// in the league's messages.
template <typename Event, typename Visitor>
void visit_fields(Event& event, Visitor&& visit) {
  visit("by_team", event.by_team);
  visit("by_bot", event.by_bot);
  visit("violator", event.violator);
  visit("victim", event.victim);
  visit("bot_yellow", event.bot_yellow);
  visit("bot_blue", event.bot_blue);
  visit("kicking_team", event.kicking_team);
  visit("kicking_bot", event.kicking_bot);
  visit("location", event.location_m);
  visit("kick_location", event.kick_location_m);
  visit("ball_location", event.ball_location_m);
  visit("start", event.start_m);
  visit("end", event.end_m);
  visit("distance", event.distance_m);
  visit("pushed_distance", event.pushed_distance_m);
  visit("remaining_distance", event.remaining_distance_m);
  visit("nearest_own_bot_distance", event.nearest_own_bot_distance_m);
  visit("precision", event.precision_m);
  visit("max_ball_height", event.max_ball_height_m);
  visit("speed", event.speed_mps);
  visit("initial_ball_speed", event.initial_ball_speed_mps);
  visit("crash_speed", event.crash_speed_mps);
  visit("speed_diff", event.speed_diff_mps);
  visit("crash_angle", event.crash_angle_rad);
  visit("time", event.time_s);
  visit("time_taken", event.time_taken_s);
  visit("duration", event.duration_s);
  visit("num_robots_by_team", event.num_robots_by_team);
  visit("num_robots_allowed", event.num_robots_allowed);
  visit("num_robots_on_field", event.num_robots_on_field);
  visit("last_touch_by_team", event.last_touch_by_team_us);
  visit("chipped", event.chipped);
  visit("accepted", event.accepted);
  visit("reason", event.reason);
  visit("message", event.message);
}

}  // namespace autoref
