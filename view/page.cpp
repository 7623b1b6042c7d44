#include "view/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "io/json.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_shape.hpp"
#include "view/field_marks.hpp"
#include "view/live_messages.hpp"
#include "view/packed_column.hpp"
#include "view/page_parts.hpp"

namespace autoref::view {
namespace {

// Escapes JSON for use in a script element. An unescaped "<" could end the element; in JSON, "<"
// only occurs in strings.
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

// The parts that differ between pages.
struct PageText {
  std::string game;    // the game as JSON
  std::string frames;  // the frames as Base64
  std::string_view allowed;
  std::string style;
  std::string script;
};

std::string page_with(const PageText& text) {
  std::string_view rest = page_frame();
  std::string page(text_before("@ALLOWED@", rest));
  page.append(text.allowed).append(text_before("@STYLE@", rest));
  page.append(text.style).append(text_before("@GAME@", rest));
  page.append(escaped_for_script(text.game)).append(text_before("@FRAMES@", rest));
  page.append(text.frames).append(text_before("@SCRIPT@", rest));
  return page.append(text.script).append(rest);
}

std::string joined(std::string_view first, std::string_view second) {
  return std::string(first).append(second);
}

// Distances checked by the rules, the same under the Laws of 2014 and the 2026 rules.
constexpr double kToBallAtRestarts_m = 0.5;
constexpr double kAttackerToArea_m = 0.2;

// Converts to millimetres, rounded to a tenth.
io::Json mm_json(double metres) { return io::rounded(metres * 1000, 1); }

io::Json position_json(const Vec2& position_m) {
  return io::Json::array({mm_json(position_m.x()), mm_json(position_m.y())});
}

template <typename T, typename Make>
io::Json list_json(const T& values, const Make& json_of) {
  io::Json list = io::Json::array();
  for (const auto& value : values) list.push_back(json_of(value));
  return list;
}

io::Json outline_json(const Outline& outline) {
  const auto line_json = [](const MarkLine& line) {
    return io::Json::array({position_json(line.from_m), position_json(line.to_m)});
  };
  const auto arc_json = [](const MarkArc& arc) -> io::Json {
    return {{"centre_mm", position_json(arc.centre_m)},
            {"radius_mm", mm_json(arc.radius_m)},
            {"from_rad", arc.from_rad},
            {"to_rad", arc.to_rad}};
  };
  return {{"lines", list_json(outline.lines, line_json)},
          {"arcs", list_json(outline.arcs, arc_json)}};
}

io::Json field_json(const Field& field) {
  const auto penalty_mark = [&](Side side) { return position_json(field.penalty_mark_at(side)); };
  const auto goal = [&](Side side) { return list_json(goal_walls_m(field, side), position_json); };
  const auto near_area = [&](Side side) {
    return outline_json(around_defence_area(field, side, kAttackerToArea_m));
  };
  return {{"halfLength_mm", mm_json(field.half_length_m())},
          {"halfWidth_mm", mm_json(field.half_width_m())},
          {"wall_mm", position_json({field.wall_x_m(), field.wall_y_m()})},
          {"lineWidth_mm", mm_json(field.line_width_m)},
          {"marks", outline_json(field_lines(field))},
          {"penaltyMarks", list_json(kSides, penalty_mark)},
          {"goals", list_json(kSides, goal)},
          {"nearAreas", list_json(kSides, near_area)},
          {"toBall_mm", mm_json(kToBallAtRestarts_m)}};
}

// Shape constants of ball and robots, the same for all games.
io::Json shapes_json() {
  return {{"ballRadius_mm", mm_json(kBallRadius_m)},
          {"robotRadius_mm", mm_json(kRobotRadius_m)},
          {"robotFront_mm", mm_json(kFrontDistance_m)}};
}

io::Json signal_json(const RecordedSignal& recorded) {
  const RefereeSignal& signal = recorded.signal;
  return {{"time_s", recorded.time_s},
          {"command", name_of(signal.command)},
          {"counter", signal.command_counter},
          {"stage", name_of(signal.stage)},
          {"goals", signal.goals.values},
          {"shootoutGoals", signal.shootout_goals.values},
          {"yellowCards", signal.yellow_cards.values},
          {"redCards", signal.red_cards.values},
          {"yellowDefends", end_of_yellow(signal.blue_on_positive_half)},
          {"target_mm", signal.placement ? position_json(signal.placement->target_m) : io::Json()},
          {"next", signal.next_command ? io::Json(name_of(*signal.next_command)) : io::Json()}};
}

io::Json clock_json(const ClockMark& mark) { return io::Json::array({mark.time_s, mark.left_s}); }

// The number of a side in the page's script.
int number_of(Side side) { return side == Side::kWest ? 0 : 1; }

io::Json robot_json(RobotId robot) {
  return io::Json::array({number_of(robot.side), robot.number});
}

constexpr int kTimeDecimals = 3;  // of times in seconds
constexpr int kProbabilityDecimals = 3;

// Chains, shots, actions and win probabilities are arrays, which the page's scripts name: a game
// has hundreds.
io::Json chain_json(const RecordedChain& chain) {
  return io::Json::array({io::rounded(chain.start_s, kTimeDecimals),
                          io::rounded(chain.end_s, kTimeDecimals), number_of(chain.team),
                          chain.start, chain.end, chain.passes, chain.shots,
                          io::rounded(chain.xg, kProbabilityDecimals)});
}

io::Json shot_json(const RecordedShot& shot) {
  return io::Json::array({io::rounded(shot.time_s, kTimeDecimals), number_of(shot.team),
                          position_json(shot.from_m), io::rounded(shot.xg, kProbabilityDecimals),
                          shot.has_scored});
}

io::Json action_json(const RecordedAction& action) {
  return io::Json::array(
      {io::rounded(action.start_s, kTimeDecimals), io::rounded(action.end_s, kTimeDecimals),
       number_of(action.team), action.robot, action.kind, position_json(action.from_m),
       position_json(action.to_m), io::rounded(action.worth, kProbabilityDecimals)});
}

io::Json win_probability_json(const RecordedWinProbability& probability) {
  return io::Json::array({io::rounded(probability.time_s, kTimeDecimals),
                          io::rounded(probability.west, kProbabilityDecimals),
                          io::rounded(probability.draw, kProbabilityDecimals)});
}

io::Json kinds_json(const ChainKinds& kinds) {
  return {{"starts", kinds.starts}, {"ends", kinds.ends}};
}

io::Json fact_json(const PageFact& fact) { return io::Json::array({fact.what, fact.value}); }

io::Json compared_json(const ComparedCall& call) {
  return {{"time_s", call.time_s},
          {"recorded", call.recorded},
          {"autoref", call.autoref},
          {"other", call.other},
          {"autoref_s", call.autoref_s ? io::Json(*call.autoref_s) : io::Json()}};
}

}  // namespace

std::string page_of(const PageContent& content) {
  return page_with({io::json_text(game_json(content)), base64_of(content.recording.bytes()), "",
                    std::string(page_style()), joined(page_script(), page_start())});
}

std::string page_part(const GameRecording& part) {
  return fmt::format("<script type=\"application/json\" class=\"part\">{}</script>\n",
                     escaped_for_script(part_message(part)));
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string run_page(std::string_view title) {
  std::string_view rest = page_run();
  const std::string safe_title = html_text(title);
  std::string page(text_before("@TITLE@", rest));
  page.append(safe_title).append(text_before("@STYLE@", rest));
  page.append(page_style()).append(page_bracket_style()).append(page_run_style());
  page.append(text_before("@TITLE@", rest)).append(safe_title);
  page.append(text_before("@SCRIPT@", rest)).append(page_run_script());
  return page.append(rest);
}

std::string live_page() {
  return page_with({"null", "", "; connect-src 'self'", joined(page_style(), page_live_style()),
                    joined(page_script(), page_live_script())});
}

void fill_recording(const GameRecording& recording, io::Json& json) {
  json["frames"] = recording.frames();
  json["robots"] = list_json(recording.robots(), robot_json);
  json["signals"] = list_json(recording.signals(), signal_json);
  json["clock"] = list_json(recording.clock(), clock_json);
  json["decisions"] = list_json(recording.decisions(), page_json);
  json["chains"] = list_json(recording.chains(), chain_json);
  json["shots"] = list_json(recording.shots(), shot_json);
  json["actions"] = list_json(recording.actions(), action_json);
  json["winProbabilities"] = list_json(recording.win_probabilities(), win_probability_json);
}

io::Json game_json(const PageContent& content) {
  io::Json json = {{"teams", content.names.values},
                   {"field", field_json(content.field)},
                   {"shapes", shapes_json()}};
  fill_recording(content.recording, json);
  json["compared"] = content.compared ? list_json(*content.compared, compared_json) : io::Json();
  json["chainKinds"] = content.chain_kinds ? kinds_json(*content.chain_kinds) : io::Json();
  json["facts"] = list_json(content.facts, fact_json);
  return json;
}

}  // namespace autoref::view
