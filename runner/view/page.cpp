#include "runner/view/page.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "runner/io/json.hpp"
#include "runner/view/base64.hpp"
#include "runner/view/field_marks.hpp"
#include "runner/view/page_parts.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::runner {
namespace {

// Distances checked by the rules (both Laws 2014 and rules of 2026).
constexpr double kToBallAtRestarts_m = 0.5;
constexpr double kAttackerToArea_m = 0.2;

std::string mm_json(double metres) { return json_number(std::round(metres * 10'000) / 10); }

std::string position_json(const Vec2& position_m) {
  return json_list({mm_json(position_m.x()), mm_json(position_m.y())});
}

template <typename T, typename Text>
std::string list_json(const T& values, const Text& text_of) {
  std::vector<std::string> texts;
  texts.reserve(std::size(values));
  for (const auto& value : values) texts.push_back(text_of(value));
  return json_list(texts);
}

std::string pair_json(const PerSide<int>& counts) {
  return list_json(counts.values, [](int count) { return std::to_string(count); });
}

std::string outline_json(const Outline& outline) {
  const auto line_json = [](const MarkLine& line) {
    return json_list({position_json(line.from_m), position_json(line.to_m)});
  };
  const auto arc_json = [](const MarkArc& arc) {
    return JsonObject()
        .add("centre_mm", position_json(arc.centre_m))
        .add("radius_mm", mm_json(arc.radius_m))
        .add("from_rad", json_number(arc.from_rad))
        .add("to_rad", json_number(arc.to_rad))
        .text();
  };
  return JsonObject()
      .add("lines", list_json(outline.lines, line_json))
      .add("arcs", list_json(outline.arcs, arc_json))
      .text();
}

std::string field_json(const Field& field) {
  return JsonObject()
      .add("halfLength_mm", mm_json(field.half_length_m()))
      .add("halfWidth_mm", mm_json(field.half_width_m()))
      .add("runOff_mm", mm_json(field.run_off_m))
      .add("lineWidth_mm", mm_json(field.line_width_m))
      .add("marks", outline_json(field_lines(field)))
      .add("penaltyMarks",
           list_json(kSides, [&](Side side) { return position_json(field.penalty_mark_at(side)); }))
      .add("goals", list_json(kSides,
                              [&](Side side) {
                                return list_json(goal_walls_m(field, side), position_json);
                              }))
      .add("nearAreas",
           list_json(kSides,
                     [&](Side side) {
                       return outline_json(around_defence_area(field, side, kAttackerToArea_m));
                     }))
      .add("toBall_mm", mm_json(kToBallAtRestarts_m))
      .text();
}

// Shape constants of ball and robots, the same for all games.
std::string shapes_json() {
  return JsonObject()
      .add("ballRadius_mm", mm_json(kBallRadius_m))
      .add("robotRadius_mm", mm_json(kRobotRadius_m))
      .add("robotFront_mm", mm_json(kFrontDistance_m))
      .text();
}

std::string signal_json(const RecordedSignal& recorded) {
  const RefereeSignal& signal = recorded.signal;
  return JsonObject()
      .add("time_s", json_number(recorded.time_s))
      .add("command", json_text(name_of(signal.command)))
      .add("counter", std::to_string(signal.command_counter))
      .add("stage", json_text(name_of(signal.stage)))
      .add("goals", pair_json(signal.goals))
      .add("shootoutGoals", pair_json(signal.shootout_goals))
      .add("yellowCards", pair_json(signal.yellow_cards))
      .add("redCards", pair_json(signal.red_cards))
      .add("target_mm", signal.placement ? position_json(signal.placement->target_m) : "null")
      .add("next", signal.next_command ? json_text(name_of(*signal.next_command)) : "null")
      .text();
}

std::string clock_json(const ClockMark& mark) {
  return json_list({json_number(mark.time_s), std::to_string(mark.left_s)});
}

std::string robot_json(RobotId robot) {
  return json_list({robot.side == Side::kWest ? "0" : "1", std::to_string(robot.number)});
}

std::string fact_json(const PageFact& fact) {
  return json_list({json_text(fact.what), json_text(fact.value)});
}

std::string game_json(const PageContent& content) {
  const GameRecording& recording = content.recording;
  return JsonObject()
      .add("teams", list_json(content.names.values, json_text))
      .add("field", field_json(content.field))
      .add("shapes", shapes_json())
      .add("frames", std::to_string(recording.frames()))
      .add("robots", list_json(recording.robots(), robot_json))
      .add("signals", list_json(recording.signals(), signal_json))
      .add("clock", list_json(recording.clock(), clock_json))
      .add("decisions", content.decisions)
      .add("facts", list_json(content.facts, fact_json))
      .text();
}

// Escapes JSON for a script element, which "<" could end. In JSON, "<" only occurs in strings.
std::string escaped_for_script(const std::string& json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<') {
      escaped += "\\u003c";
    } else {
      escaped += letter;
    }
  }
  return escaped;
}

// Removes the template's text up to and including `mark` from `rest`; returns the part before
// `mark`.
std::string_view text_before(std::string_view mark, std::string_view& rest) {
  const std::size_t index = rest.find(mark);
  if (index == std::string_view::npos)
    throw std::logic_error("a part of the page has no placeholder");
  const std::string_view before = rest.substr(0, index);
  rest.remove_prefix(index + mark.size());
  return before;
}

}  // namespace

std::string page_of(const PageContent& content) {
  std::string_view rest = page_frame();
  std::string page(text_before("@STYLE@", rest));
  page.append(page_style()).append(text_before("@GAME@", rest));
  page.append(escaped_for_script(game_json(content))).append(text_before("@FRAMES@", rest));
  page.append(base64_of(content.recording.bytes())).append(text_before("@SCRIPT@", rest));
  return page.append(page_script()).append(rest);
}

}  // namespace autoref::runner
