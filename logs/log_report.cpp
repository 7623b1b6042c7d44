#include "logs/log_report.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "io/json.hpp"
#include "io/table.hpp"
#include "logs/game_event_comparison.hpp"
#include "logs/log_page.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string_view name_of(league::MessageKind kind) {
  static constexpr std::array<std::string_view, 6> kNames = {
      "unknown", "vision 2010", "referee 2013", "vision 2014", "tracker 2020", "index 2021"};
  return kNames[static_cast<std::size_t>(kind) - 1];
}

std::string clock_text(double time_s) {
  const auto whole_min = static_cast<long long>(time_s / 60);
  return fmt::format("{}:{:06.3f}", whole_min, time_s - 60.0 * static_cast<double>(whole_min));
}

std::map<std::string, int> counts_of(const std::vector<RecordedCommand>& commands) {
  std::map<std::string, int> counts;
  for (const RecordedCommand& command : commands) ++counts[name_of(command.command)];
  return counts;
}

std::string records_text(const league::LogSummary& log) {
  std::string text;
  for (const auto& [kind, count] : log.records)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(kind));
  return text.empty() ? "none" : text;
}

std::string field_text(const std::optional<Field>& field) {
  if (!field) return "unknown";
  const bool is_box = field->defence_area.shape == DefenceArea::Shape::kBox;
  return fmt::format("{} x {} m, defence areas {} m deep, {}", field->length_m, field->width_m,
                     field->defence_area.depth_m, is_box ? "boxes" : "quarter circles");
}

std::string score_text(const RecordedFacts& facts) {
  if (!facts.last_signal) return "no referee packets";
  const RefereeSignal& signal = *facts.last_signal;
  return fmt::format("{} (yellow) {} : {} {} (blue), {}", facts.names[Side::kWest],
                     signal.goals[Side::kWest], signal.goals[Side::kEast], facts.names[Side::kEast],
                     name_of(signal.stage));
}

std::string noise_text(const std::optional<tracking::VisionNoise>& noise) {
  if (!noise) return "unknown";
  return fmt::format("ball {:.2f} mm, robots {:.2f} mm and {:.1f} mrad (standard deviations)",
                     1e3 * noise->ball_m, 1e3 * noise->robot_m, 1e3 * noise->robot_rad);
}

io::Json noise_json(const std::optional<tracking::VisionNoise>& noise) {
  if (!noise) return {};
  return {{"ball_m", io::rounded(noise->ball_m, 5)},
          {"robot_m", io::rounded(noise->robot_m, 5)},
          {"robot_rad", io::rounded(noise->robot_rad, 4)}};
}

std::string cameras_table(const RecordedFacts& facts) {
  Rows rows = {{"camera", "packets", "per second", "gaps over 0.1 s", "longest"}};
  for (const auto& [number, camera] : facts.cameras) {
    rows.push_back({std::to_string(number), std::to_string(camera.packets),
                    fmt::format("{:.1f}", camera.rate_hz()), std::to_string(camera.gaps),
                    fmt::format("{:.3f} s", camera.longest_gap_s)});
  }
  return io::aligned(rows);
}

std::string commands_text(const RecordedFacts& facts, bool lists_commands) {
  Rows rows;
  if (lists_commands) {
    rows.push_back({"time", "command"});
    for (const RecordedCommand& command : facts.commands)
      rows.push_back({clock_text(command.time_s), name_of(command.command)});
  } else {
    rows.push_back({"times", "command"});
    for (const auto& [name, count] : counts_of(facts.commands))
      rows.push_back({std::to_string(count), name});
  }
  return io::aligned(rows, {io::Align::kRight, io::Align::kLeft});
}

// The cells of a call. If AutoRef's calls are compared with recorded commands, these are the
// restart, which is compared, and AutoRef's reason. If they are compared with annotations, these
// are the event and the side.
std::string name_of(const std::optional<Call>& call) {
  if (!call) return "-";
  const bool has_restart = call->restart.kind != CommandKind::kHalt;
  const std::string title = title_of(*call);
  return has_restart && !call->event.empty()
             ? fmt::format("{}: {}", autoref::name_of(call->restart), title)
             : title;
}

// Only disagreements have a link.
std::string link_to(const CallPair& pair, const Comparison& comparison) {
  if (comparison.page.empty() || pair.is_right()) return "";
  return moment_in(comparison.page, time_of(pair));
}

std::string verdict_of(const CallPair& pair) {
  if (pair.is_right()) return "right";
  return pair.recorded ? "missed" : "wrong";
}

io::Json link_or_null(const CallPair& pair, const Comparison& comparison) {
  const std::string link = link_to(pair, comparison);
  return link.empty() ? io::Json() : io::Json(link);
}

io::Json json_of(const std::optional<Call>& call) {
  if (!call) return {};
  return {{"stop_s", call->stop_s},
          {"restart_s", call->restart_s},
          {"restart", autoref::name_of(call->restart)},
          {"event", call->event.empty() ? io::Json() : io::Json(call->event)},
          {"side", call->side ? io::Json(colour_of(*call->side)) : io::Json()}};
}

io::Json json_of(const PerSide<int>& goals) {
  return io::Json::array({goals[Side::kWest], goals[Side::kEast]});
}

io::Json recorded_score(const RecordedFacts& facts) {
  return facts.last_signal ? json_of(facts.last_signal->goals) : io::Json();
}

io::Json records_json(const league::LogSummary& log) {
  io::Json records = io::Json::object();
  for (const auto& [kind, count] : log.records) records[name_of(kind)] = count;
  return records;
}

io::Json cameras_json(const RecordedFacts& facts) {
  io::Json cameras = io::Json::array();
  for (const auto& [number, camera] : facts.cameras) {
    cameras.push_back({{"camera", number},
                       {"packets", camera.packets},
                       {"rate_hz", camera.rate_hz()},
                       {"gaps", camera.gaps},
                       {"longest_gap_s", camera.longest_gap_s}});
  }
  return cameras;
}

io::Json clocks_json(const league::MessageFaults& faults) {
  io::Json clocks = io::Json::object();
  for (const auto& [camera, ahead_s] : faults.clocks_ahead_s)
    clocks[std::to_string(camera)] = io::rounded(ahead_s, 4);
  return clocks;
}

io::Json commands_json(const RecordedFacts& facts) {
  io::Json commands = io::Json::array();
  for (const RecordedCommand& command : facts.commands) {
    commands.push_back(
        {{"time_s", command.time_s}, {"command", autoref::name_of(command.command)}});
  }
  return commands;
}

}  // namespace

std::string info_text(const RecordedFacts& facts, bool lists_commands) {
  const league::LogSummary& log = facts.log;
  return fmt::format(
      "length    {} min:s\n"
      "records   {}\n"
      "frames    {}\n"
      "field     {}\n"
      "noise     {}\n"
      "score     {}\n\n{}\n{}",
      clock_text(log.length_s), records_text(log), log.frames, field_text(log.field),
      noise_text(facts.noise), score_text(facts), cameras_table(facts),
      commands_text(facts, lists_commands));
}

std::string info_json(const RecordedFacts& facts) {
  const league::LogSummary& log = facts.log;
  return io::json_text({{"length_s", log.length_s},
                        {"records", records_json(log)},
                        {"frames", log.frames},
                        {"trackers", log.trackers},
                        {"goals", recorded_score(facts)},
                        {"teams", facts.names.values},
                        {"cameras", cameras_json(facts)},
                        {"noise", noise_json(facts.noise)},
                        {"commands", commands_json(facts)},
                        {"unreadable", log.faults.unreadable},
                        {"late", log.faults.late},
                        {"copies", log.faults.copies},
                        {"other_referee", log.faults.of_other_referee},
                        {"clocks_ahead_s", clocks_json(log.faults)},
                        {"damaged_at", log.damage ? io::Json(log.damage->offset) : io::Json()}});
}

io::TextBlocks referee_log_text(const LogRefereeResult& evaluation, const RecordedFacts& facts,
                                const Comparison& comparison) {
  Rows rows = {{"time", comparison.is_annotated ? "annotated" : "recorded", "AutoRef", "",
                "the other referee", comparison.page.empty() ? "" : "moment"}};
  for (const CallPair& pair : evaluation.agreement.pairs) {
    rows.push_back({clock_text(time_of(pair)), name_of(pair.recorded), name_of(pair.refereed),
                    verdict_of(pair), other_referee_text(pair, evaluation.agreement),
                    link_to(pair, comparison)});
  }
  const Agreement& all = evaluation.agreement;
  std::string text = fmt::format(
      "\n"
      "score     recorded {}, AutoRef {}:{}\n"
      "calls     {} recorded, {} by AutoRef, {} of them right\n"
      "precision {:.3f}   recall {:.3f}   F1 {:.3f}   ({})\n"
      "challenge {:+} (1 for a right call, -2 for a wrong one)\n{}",
      facts.last_signal ? fmt::format("{}:{}", facts.last_signal->goals[Side::kWest],
                                      facts.last_signal->goals[Side::kEast])
                        : "-",
      evaluation.goals[Side::kWest], evaluation.goals[Side::kEast], all.recorded, all.refereed,
      all.right, all.precision(), all.recall(), all.f1(),
      comparison.is_annotated ? "same event and side within 2 s"
                              : "same restart, at most 2 s ahead",
      all.challenge_score(),
      game_events_text(compared(facts.game_events, evaluation.game_events, evaluation.control)));
  return {io::TextTable{std::move(rows),
                        {io::Align::kRight, io::Align::kLeft, io::Align::kLeft, io::Align::kLeft,
                         io::Align::kLeft, io::Align::kLeft}},
          std::move(text)};
}

std::string referee_log_json(const LogRefereeResult& evaluation, const RecordedFacts& facts,
                             const Comparison& comparison) {
  const Agreement& all = evaluation.agreement;
  io::Json calls = io::Json::array();
  for (const CallPair& pair : all.pairs) {
    calls.push_back({{"recorded", json_of(pair.recorded)},
                     {"autoref", json_of(pair.refereed)},
                     {"other", other_referee_text(pair, all)},
                     {"moment", link_or_null(pair, comparison)}});
  }
  return io::json_text(
      {{"recorded_goals", recorded_score(facts)},
       {"goals", json_of(evaluation.goals)},
       {"compared_with", comparison.is_annotated ? "annotations" : "commands"},
       {"recorded", all.recorded},
       {"judged", all.refereed},
       {"right", all.right},
       {"precision", all.precision()},
       {"recall", all.recall()},
       {"f1", all.f1()},
       {"challenge_score", all.challenge_score()},
       {"calls", std::move(calls)},
       {"game_events", game_events_json(compared(facts.game_events, evaluation.game_events,
                                                 evaluation.control))}});
}

}  // namespace autoref::logs
