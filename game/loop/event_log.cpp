#include "game/loop/event_log.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_event_fields.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::game {
namespace {

using referee::Decision;
using referee::Finding;
using referee::HalfClock;
using referee::LastTouch;
using referee::ShootoutKick;
using In = const Decision&;
using Whole = const EventGame&;

using column_type::kInteger;
using column_type::kReal;
using column_type::kText;

constexpr const char* kNoColumn = "";

// Null if the text is empty.
io::Json text_or_null(std::string_view text) { return text.empty() ? io::Json() : io::Json(text); }

io::Json json_of(Side side) { return colour_of(side); }

io::Json json_of(RobotId robot) {
  return {{"colour", json_of(robot.side)}, {"number", robot.number}};
}

io::Json json_of(const referee::ConcernedRobots& robots) {
  io::Json list = io::Json::array();
  for (const RobotId robot : robots) list.push_back(json_of(robot));
  return list;
}

// The name of an enumerator or a command; numbers and texts stay as they are.
template <typename T>
io::Json json_of(const T& value) {
  if constexpr (requires { name_of(value); })
    return name_of(value);
  else
    return value;
}

template <typename T>
io::Json json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : io::Json();
}

// A member of an object in the line. It is discarded if there is no such object.
template <typename Object, typename Member>
io::Json part(const Object& object, const Member& member) {
  return object ? json_of(std::invoke(member, *object)) : io::Json(io::Json::value_t::discarded);
}

template <auto kMember>
io::Json of_decision(In d, Whole) {
  return json_of(std::invoke(kMember, d));
}

template <auto kMember>
io::Json of_finding(In d, Whole) {
  return json_of(std::invoke(kMember, d.finding));
}

template <auto kMember>
io::Json of_clock(In d, Whole) {
  return d.clock ? json_of(std::invoke(kMember, *d.clock)) : io::Json();
}

template <auto kMember>
io::Json measurement(In d, Whole) {
  return d.finding.unit.empty() ? io::Json() : json_of(std::invoke(kMember, d.finding));
}

io::Json confidence_in(In d, Whole) {
  return is_call(d.finding.event) ? io::Json(d.finding.confidence) : io::Json();
}

io::Json card_in(In d, Whole) {
  return d.finding.card != referee::Card::kNone ? json_of(d.finding.card) : io::Json();
}

template <Side kSide>
io::Json shootout_goals(In d, Whole) {
  return part(d.stage == Stage::kShootout ? &d.shootout_goals : nullptr,
              [](const PerSide<int>& goals) { return goals[kSide]; });
}

template <int kAxis>
io::Json coordinate(In d, Whole) {
  return part(d.finding.position_m, [&](const Vec2& position_m) {
    return published(position_m, d.blue_on_positive_half)[kAxis];
  });
}

template <auto kMember>
io::Json of_touch(In d, Whole) {
  const LastTouch& touch = d.last_touch;
  const bool is_before_first = !touch.side && touch.time_s == 0;
  return part(is_before_first ? nullptr : &touch, kMember);
}

std::string_view touching_colour(const LastTouch& touch) {
  return touch.side ? colour_of(*touch.side) : "unknown";
}

std::optional<int> touching_robot(const LastTouch& touch) {
  return touch.robot ? std::optional(touch.robot->number) : std::nullopt;
}

template <auto kMember>
io::Json of_kick(In d, Whole) {
  return part(d.shootout_kick, kMember);
}

template <Side kSide, auto kMember>
io::Json of_team(In, Whole game) {
  return text_or_null(std::invoke(kMember, game.teams[kSide]));
}

constexpr DecisionField kFields[] = {
    {"/time_s", kReal, of_decision<&Decision::time_s>},
    {"/stage", kText, of_decision<&Decision::stage>},
    {"/clock_s", kReal, of_clock<&HalfClock::played_s>},
    {"/clock_left_s", kReal, of_clock<&HalfClock::left_s>},
    {"/score/yellow", kInteger, [](In d, Whole) -> io::Json { return d.goals[Side::kWest]; }},
    {"/score/blue", kInteger, [](In d, Whole) -> io::Json { return d.goals[Side::kEast]; }},
    {"/shootout/yellow", kInteger, shootout_goals<Side::kWest>},
    {"/shootout/blue", kInteger, shootout_goals<Side::kEast>},
    {"/transition", kText, of_decision<&Decision::transition>},
    {"/from", kText, of_decision<&Decision::from>, "from_state"},
    {"/to", kText, of_decision<&Decision::to>, "to_state"},
    {"/command", kText, of_decision<&Decision::command>},
    {"/event", kText, of_finding<&Finding::event>},
    {"/league_event", kText,
     [](In d, Whole) { return text_or_null(entry_of(d.finding.event).league_event); }},
    {"/rule", kText, of_finding<&Finding::rule>},
    {"/value", kReal, measurement<&Finding::value>},
    {"/threshold", kReal, measurement<&Finding::threshold>},
    {"/unit", kText, [](In d, Whole) { return text_or_null(d.finding.unit); }},
    {"/confidence", kReal, confidence_in},
    {"/robots", kText, of_finding<&Finding::robots>},
    {"/offender", kText, of_finding<&Finding::offender>},
    {"/card", kText, card_in},
    {"/card_reason", kText, [](In d, Whole) { return text_or_null(d.card_reason); }},
    {"/position_m/0", kReal, coordinate<0>, "position_x_m"},
    {"/position_m/1", kReal, coordinate<1>, "position_y_m"},
    {"/yellow_defends", kText,
     [](In d, Whole) -> io::Json { return end_of_yellow(d.blue_on_positive_half); }},
    {"/restart", kText, of_decision<&Decision::restart>},
    {"/last_touch/colour", kText, of_touch<touching_colour>},
    {"/last_touch/robot", kInteger, of_touch<touching_robot>},
    {"/last_touch/time_s", kReal, of_touch<&LastTouch::time_s>},
    {"/last_touch/gap_m", kReal, of_touch<&LastTouch::gap_m>},
    {"/last_touch/speed_change_mps", kReal, of_touch<&LastTouch::speed_change_mps>},
    {"/last_touch/runner_up", kText, of_touch<&LastTouch::runner_up>},
    {"/last_touch/kept", kReal, of_touch<&LastTouch::kept>, kNoColumn},
    {"/evidence", kText, [](In d, Whole) { return text_or_null(d.finding.evidence); }},
    {"/shootout_kick/kicker", kText, of_kick<&ShootoutKick::kicker>, "shootout_kicker"},
    {"/shootout_kick/number", kInteger, of_kick<&ShootoutKick::number>, "shootout_kick"},
    {"/shootout_kick/scored", kInteger, of_kick<&ShootoutKick::has_scored>, "shootout_scored"},
    {"/rule_changes", kText, [](In, Whole game) { return text_or_null(game.rule_changes); },
     kNoColumn},
    {"/teams/yellow/team", kText, of_team<Side::kWest, &EventTeam::letter>, "team_yellow"},
    {"/teams/yellow/name", kText, of_team<Side::kWest, &EventTeam::name>, kNoColumn},
    {"/teams/blue/team", kText, of_team<Side::kEast, &EventTeam::letter>, "team_blue"},
    {"/teams/blue/name", kText, of_team<Side::kEast, &EventTeam::name>, kNoColumn},
};

}  // namespace

EventGame event_game_of(const GameConfiguration& game) {
  EventGame events{{}, rule_changes_in(game)};
  const PerSide<std::string> names = shown_names(game);
  for (const Side side : kSides) {
    events.teams[side] = {side == game.match.a_plays ? "a" : "b", names[side]};
  }
  return events;
}

std::span<const DecisionField> decision_fields() { return kFields; }

std::string column_of(const DecisionField& field) {
  if (field.column != nullptr) return field.column;
  std::string name = field.path + 1;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

io::Json decision_object(const Decision& decision, const EventGame& game) {
  io::Json object;
  for (const DecisionField& field : kFields) {
    const io::Json::json_pointer path(field.path);
    io::Json value = field.value(decision, game);
    if (value.is_discarded())
      object[path.parent_pointer()] = io::Json();
    else
      object[path] = std::move(value);
  }
  return object;
}

std::string decision_json(const Decision& decision, const EventGame& game) {
  return io::json_text(decision_object(decision, game));
}

void GameEventLog::on_decision(const referee::Decision& decision) {
  std::optional<GameEvent> event = game_event_of(decision, start_unix_s_);
  if (event) events_.push_back({decision.time_s, *std::move(event)});
}

std::string game_event_lines(const std::vector<TimedGameEvent>& events) {
  std::string lines;
  for (const TimedGameEvent& timed : events) lines += game_event_json(timed.event) + "\n";
  return lines;
}

}  // namespace autoref::game
