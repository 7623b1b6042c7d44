#include "runner/game/event_log.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "runner/game/configuration.hpp"
#include "runner/io/json.hpp"
#include "soccer/colour.hpp"
#include "soccer/published.hpp"

namespace autoref::runner {
namespace {

// Null if the text is empty.
Json text_or_null(std::string_view text) { return text.empty() ? Json() : Json(text); }

Json json_of(RobotId robot) {
  return {{"colour", colour_of(robot.side)}, {"number", robot.number}};
}

Json json_of(const std::optional<RobotId>& robot) { return robot ? json_of(*robot) : Json(); }

Json json_of(const std::optional<Vec2>& v) { return v ? Json::array({v->x(), v->y()}) : Json(); }

// Null before the first touch; colour "unknown" if it is not known who touched the ball.
Json json_of(const referee::LastTouch& touch) {
  if (!touch.side && touch.time_s == 0) return {};
  return {{"colour", touch.side ? colour_of(*touch.side) : "unknown"},
          {"robot", touch.robot ? Json(touch.robot->number) : Json()},
          {"time_s", touch.time_s},
          {"gap_m", touch.gap_m},
          {"speed_change_mps", touch.speed_change_mps},
          {"runner_up", json_of(touch.runner_up)},
          {"kept", touch.kept}};
}

Json goals_json(const PerSide<int>& goals) {
  return {{colour_of(Side::kWest), goals[Side::kWest]},
          {colour_of(Side::kEast), goals[Side::kEast]}};
}

Json json_of(const EventTeam& team) {
  return {{"team", text_or_null(team.letter)}, {"name", text_or_null(team.name)}};
}

Json json_of(const std::optional<referee::ShootoutKick>& kick) {
  if (!kick) return {};
  return {
      {"kicker", colour_of(kick->kicker)}, {"number", kick->number}, {"scored", kick->has_scored}};
}

void add_standing(Json& json, const referee::Decision& d) {
  json["stage"] = name_of(d.stage);
  json["clock_s"] = d.clock ? Json(d.clock->played_s) : Json();
  json["clock_left_s"] = d.clock ? Json(d.clock->left_s) : Json();
  json["score"] = goals_json(d.goals);
  json["shootout"] = d.stage == Stage::kShootout ? goals_json(d.shootout_goals) : Json();
}

void add_transition(Json& json, const referee::Decision& d) {
  const referee::EventEntry& entry = referee::entry_of(d.finding.event);
  json["transition"] = d.transition;
  json["from"] = name_of(d.from);
  json["to"] = name_of(d.to);
  json["command"] = d.command ? Json(name_of(*d.command)) : Json();
  json["event"] = entry.name;
  json["league_event"] = text_or_null(entry.league_event);
}

void add_measurement(Json& json, const referee::Finding& finding) {
  const bool is_measured = !finding.unit.empty();
  json["rule"] = finding.rule;
  json["value"] = is_measured ? Json(finding.value) : Json();
  json["threshold"] = is_measured ? Json(finding.threshold) : Json();
  json["unit"] = text_or_null(finding.unit);
  json["confidence"] = referee::is_call(finding.event) ? Json(finding.confidence) : Json();
}

void add_position(Json& json, const referee::Decision& d) {
  const std::optional<Vec2>& at_m = d.finding.position_m;
  const bool blue_on_positive_half = d.blue_on_positive_half;
  json["position_m"] =
      json_of(at_m ? std::optional(published(*at_m, blue_on_positive_half)) : std::nullopt);
  json["yellow_defends"] = end_of_yellow(blue_on_positive_half);
}

void add_blame(Json& json, const referee::Decision& d) {
  const referee::Finding& finding = d.finding;
  Json& robots = json["robots"] = Json::array();
  for (const RobotId robot : finding.robots) robots.push_back(json_of(robot));
  json["offender"] = finding.offender ? Json(colour_of(*finding.offender)) : Json();
  json["card"] = finding.card != referee::Card::kNone ? Json(name_of(finding.card)) : Json();
  json["card_reason"] = text_or_null(d.card_reason);
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
  Json json;
  json["time_s"] = d.time_s;
  add_standing(json, d);
  add_transition(json, d);
  add_measurement(json, d.finding);
  add_blame(json, d);
  add_position(json, d);
  json["restart"] = d.restart() ? Json(name_of(*d.restart())) : Json();
  json["last_touch"] = json_of(d.last_touch);
  json["evidence"] = text_or_null(d.finding.evidence);
  json["shootout_kick"] = json_of(d.shootout_kick);
  for (const Side side : kSides) json["teams"][colour_of(side)] = json_of(teams[side]);
  return json_text(json);
}

}  // namespace autoref::runner
