#include "runner/game/event_log.hpp"

#include "runner/io/json.hpp"

namespace autoref::runner {
namespace {

const std::string kNull = "null";

std::string json_of(RobotId robot) {
  return JsonObject()
      .add("side", json_text(name_of(robot.side)))
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
      .add("side", json_text(touch.side ? name_of(*touch.side) : "unknown"))
      .add("robot", touch.robot ? std::to_string(touch.robot->number) : kNull)
      .add("time_s", json_number(touch.time_s))
      .add("gap_m", json_number(touch.gap_m))
      .add("speed_change_mps", json_number(touch.speed_change_mps))
      .add("runner_up", json_of(touch.runner_up))
      .text();
}

}  // namespace

std::string decision_json(const referee::Decision& d) {
  const referee::EventEntry& entry = referee::entry_of(d.finding.event);
  std::vector<std::string> robots;
  for (const RobotId robot : d.finding.robots) robots.push_back(json_of(robot));
  const bool is_measured = !d.finding.unit.empty();
  return JsonObject()
      .add("time_s", json_number(d.time_s))
      .add("transition", json_text(d.transition))
      .add("from", json_text(name_of(d.from)))
      .add("to", json_text(name_of(d.to)))
      .add("command", d.command ? json_text(name_of(*d.command)) : kNull)
      .add("event", json_text(entry.name))
      .add("league_event", entry.league_event.empty() ? kNull : json_text(entry.league_event))
      .add("rule", json_text(d.finding.rule))
      .add("value", is_measured ? json_number(d.finding.value) : kNull)
      .add("threshold", is_measured ? json_number(d.finding.threshold) : kNull)
      .add("unit", is_measured ? json_text(d.finding.unit) : kNull)
      .add("robots", json_list(robots))
      .add("offender", d.finding.offender ? json_text(name_of(*d.finding.offender)) : kNull)
      .add("card",
           d.finding.card == referee::Card::kNone ? kNull : json_text(name_of(d.finding.card)))
      .add("position_m", json_of(d.finding.position_m))
      .add("restart", d.restart() ? json_text(name_of(*d.restart())) : kNull)
      .add("last_touch", json_of(d.last_touch))
      .add("evidence", d.finding.evidence.empty() ? kNull : json_text(d.finding.evidence))
      .text();
}

}  // namespace autoref::runner
