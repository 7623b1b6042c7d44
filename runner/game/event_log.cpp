#include "runner/game/event_log.hpp"

#include "runner/game/configuration.hpp"
#include "runner/io/json.hpp"
#include "soccer/colour.hpp"

namespace autoref::runner {
namespace {

const std::string kNull = "null";

std::string json_of(RobotId robot) {
  return JsonObject()
      .add("colour", json_text(colour_of(robot.side)))
      .add("number", std::to_string(robot.number))
      .text();
}

std::string json_of(const std::optional<RobotId>& robot) { return robot ? json_of(*robot) : kNull; }

std::string json_of(const std::optional<Vec2>& v) {
  return v ? json_list({json_number(v->x()), json_number(v->y())}) : kNull;
}

// Null before anybody has touched the ball; a touch by nobody knows whom is by "unknown".
std::string json_of(const referee::LastTouch& touch) {
  if (!touch.side && touch.time_s == 0) return kNull;
  return JsonObject()
      .add("colour", json_text(touch.side ? colour_of(*touch.side) : "unknown"))
      .add("robot", touch.robot ? std::to_string(touch.robot->number) : kNull)
      .add("time_s", json_number(touch.time_s))
      .add("gap_m", json_number(touch.gap_m))
      .add("speed_change_mps", json_number(touch.speed_change_mps))
      .add("runner_up", json_of(touch.runner_up))
      .text();
}

std::string text_or_null(const std::string& text) { return text.empty() ? kNull : json_text(text); }

template <typename Value, typename Text>
std::string by_colour(const PerSide<Value>& values, const Text& text_of) {
  JsonObject json;
  for (const Side side : kSides) json.add(colour_of(side), text_of(values[side]));
  return json.text();
}

std::string goals_json(const PerSide<int>& goals) {
  return by_colour(goals, [](int count) { return std::to_string(count); });
}

std::string json_of(const EventTeam& team) {
  return JsonObject()
      .add("team", text_or_null(team.letter))
      .add("name", text_or_null(team.name))
      .text();
}

std::string json_of(const std::optional<referee::ShootoutKick>& kick) {
  if (!kick) return kNull;
  return JsonObject()
      .add("kicker", json_text(colour_of(kick->kicker)))
      .add("number", std::to_string(kick->number))
      .add("scored", kick->has_scored ? "true" : "false")
      .text();
}

void add_standing(JsonObject& json, const referee::Decision& d) {
  json.add("stage", json_text(name_of(d.stage)))
      .add("clock_s", d.clock ? json_number(d.clock->played_s) : kNull)
      .add("clock_left_s", d.clock ? json_number(d.clock->left_s) : kNull)
      .add("score", goals_json(d.goals))
      .add("shootout", d.stage == Stage::kShootout ? goals_json(d.shootout_goals) : kNull);
}

void add_measurement(JsonObject& json, const referee::Finding& finding) {
  const bool is_measured = !finding.unit.empty();
  json.add("rule", json_text(finding.rule))
      .add("value", is_measured ? json_number(finding.value) : kNull)
      .add("threshold", is_measured ? json_number(finding.threshold) : kNull)
      .add("unit", is_measured ? json_text(finding.unit) : kNull);
}

void add_blame(JsonObject& json, const referee::Decision& d) {
  const referee::Finding& finding = d.finding;
  std::vector<std::string> robots;
  for (const RobotId robot : finding.robots) robots.push_back(json_of(robot));
  const bool has_card = finding.card != referee::Card::kNone;
  json.add("robots", json_list(robots))
      .add("offender", finding.offender ? json_text(colour_of(*finding.offender)) : kNull)
      .add("card", has_card ? json_text(name_of(finding.card)) : kNull)
      .add("card_reason", text_or_null(d.card_reason));
}

}  // namespace

PerSide<EventTeam> event_teams_of(const GameConfiguration& game) {
  PerSide<EventTeam> teams;
  const PerSide<std::string> names = shown_names(game);
  for (const Side side : kSides) {
    teams[side] = {side == game.match.a_plays ? "a" : "b", names[side]};
  }
  return teams;
}

std::string decision_json(const referee::Decision& d, const PerSide<EventTeam>& teams) {
  const referee::EventEntry& entry = referee::entry_of(d.finding.event);
  JsonObject json;
  json.add("time_s", json_number(d.time_s));
  add_standing(json, d);
  json.add("transition", json_text(d.transition))
      .add("from", json_text(name_of(d.from)))
      .add("to", json_text(name_of(d.to)))
      .add("command", d.command ? json_text(name_of(*d.command)) : kNull)
      .add("event", json_text(entry.name))
      .add("league_event", entry.league_event.empty() ? kNull : json_text(entry.league_event));
  add_measurement(json, d.finding);
  add_blame(json, d);
  return json.add("position_m", json_of(d.finding.position_m))
      .add("restart", d.restart() ? json_text(name_of(*d.restart())) : kNull)
      .add("last_touch", json_of(d.last_touch))
      .add("evidence", text_or_null(d.finding.evidence))
      .add("shootout_kick", json_of(d.shootout_kick))
      .add("teams", by_colour(teams, [](const EventTeam& team) { return json_of(team); }))
      .text();
}

}  // namespace autoref::runner
