#include "logs/log_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/play_counts/play_counts.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::logs {
namespace {

constexpr double kNearlyAll = 0.99;

std::string text_of_colour(Side side) { return std::string(colour_of(side)); }

// Goals are named after their scorer and do not count.
int calls_against(const LogRefereeResult& result, Side side) {
  const auto is_against = [side](const Call& call) {
    return call.side == side && call.event != name_of(referee::Event::kGoal);
  };
  return static_cast<int>(std::count_if(result.calls.begin(), result.calls.end(), is_against));
}

int chains_of(const LogRefereeResult& result, Side side) {
  const auto& chains = result.play.chains;
  return static_cast<int>(
      std::count_if(chains.begin(), chains.end(),
                    [side](const game::PossessionChain& chain) { return chain.team == side; }));
}

// A count of PlayCounts.
auto count(int game::PlayCounts::*member) {
  return [member](const SummaryRow& row) { return row.result->play.counts[row.side].*member; };
}
auto number(double game::PlayCounts::*member) {
  return [member](const SummaryRow& row) {
    return std::optional(row.result->play.counts[row.side].*member);
  };
}

auto mean_speed(SpeedDistribution TeamSpeeds::*speeds) {
  return
      [speeds](const SummaryRow& row) { return std::optional((row.speeds->*speeds).mean_mps()); };
}
auto top_speed(SpeedDistribution TeamSpeeds::*speeds) {
  return [speeds](const SummaryRow& row) {
    return std::optional((row.speeds->*speeds).quantile_mps(kNearlyAll));
  };
}

io::ColumnValue integer_or_empty(const std::optional<int>& value) {
  return value ? io::ColumnValue(*value) : io::ColumnValue(std::string());
}

// A column for the log, followed by `columns`, which describe `member`.
template <typename Row, typename Described>
io::TableColumns<Row> after_log(Described Row::*member,
                                const io::TableColumns<Described>& columns) {
  io::TableColumns<Row> all = {{"log", &Row::log}};
  for (const auto& column : columns) {
    all.push_back({column.name,
                   [value = column.value, member](const Row& row) { return value(row.*member); }});
  }
  return all;
}

TrackRow in_log(TrackRow row, bool is_turned) {
  row.position_m = published(row.position_m, !is_turned);
  row.velocity_mps = published(row.velocity_mps, !is_turned);
  return row;
}

}  // namespace

io::TableColumns<SummaryRow> summary_columns() {
  io::TableColumns<SummaryRow> columns = {
      {"log", &SummaryRow::log},
      {"team", [](const SummaryRow& row) { return text_of_colour(row.side); }},
      {"name", [](const SummaryRow& row) { return row.facts->names[row.side]; }},
      {"length_s", [](const SummaryRow& row) { return std::optional(row.facts->log.length_s); }},
      {"in_play_s",
       [](const SummaryRow& row) { return std::optional(row.result->play.ball_in_play_s); }},
      {"goals",
       [](const SummaryRow& row) {
         const auto& signal = row.facts->last_signal;
         return integer_or_empty(signal ? std::optional(signal->goals[row.side]) : std::nullopt);
       }},
      {"calls", [](const SummaryRow& row) { return calls_against(*row.result, row.side); }},
      {"chains", [](const SummaryRow& row) { return chains_of(*row.result, row.side); }},
      {"shots", count(&game::PlayCounts::shots)},
      {"xg", number(&game::PlayCounts::xg)},
      {"passes_tried", count(&game::PlayCounts::passes_tried)},
      {"passes_completed", count(&game::PlayCounts::passes_completed)},
      {"possession_s", number(&game::PlayCounts::possession_s)},
      {"robots_mean_mps", mean_speed(&TeamSpeeds::robots)},
      {"robots_p99_mps", top_speed(&TeamSpeeds::robots)},
      {"ball_mean_mps", mean_speed(&TeamSpeeds::ball)},
      {"ball_p99_mps", top_speed(&TeamSpeeds::ball)}};
  for (auto& column : columns) column.is_in_json = io::kInJson;
  return columns;
}

io::TableColumns<TrackRow> track_columns() {
  return {{"log", &TrackRow::log},
          {"time_s", [](const TrackRow& row) { return std::optional(row.time_s); }},
          {"object", &TrackRow::object},
          {"number", [](const TrackRow& row) { return integer_or_empty(row.number); }},
          {"x_m", [](const TrackRow& row) { return std::optional(row.position_m.x()); }},
          {"y_m", [](const TrackRow& row) { return std::optional(row.position_m.y()); }},
          {"vx_mps", [](const TrackRow& row) { return std::optional(row.velocity_mps.x()); }},
          {"vy_mps", [](const TrackRow& row) { return std::optional(row.velocity_mps.y()); }},
          {"heading_deg", &TrackRow::heading_deg},
          {"height_m", &TrackRow::height_m},
          {"is_seen", [](const TrackRow& row) { return row.is_seen ? 1 : 0; }}};
}

std::vector<TrackRow> track_rows(const std::string& log, const LogReferee& referee) {
  const Tracks& tracks = referee.referee().tracks();
  const double time_s = referee.referee().frame().time_s;
  const bool is_turned = referee.is_turned();
  std::vector<TrackRow> rows;
  if (tracks.ball) {
    const TrackedBall& ball = *tracks.ball;
    rows.push_back(in_log({log,
                           time_s,
                           "ball",
                           {},
                           ball.position_m,
                           ball.velocity_mps,
                           {},
                           ball.height_m,
                           referee.referee().frame().ball.has_value()},
                          is_turned));
  }
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : tracks.robots[side]) {
      const Vec2 heading = published(robot.heading, !is_turned);
      const double heading_deg = std::atan2(heading.y(), heading.x()) * 180 / std::numbers::pi;
      rows.push_back(in_log({log,
                             time_s,
                             text_of_colour(side),
                             robot.number,
                             robot.position_m,
                             robot.velocity_mps,
                             heading_deg,
                             {},
                             robot.is_seen},
                            is_turned));
    }
  }
  return rows;
}

io::TableColumns<LoggedChain> logged_chain_columns() {
  return after_log(&LoggedChain::row,
                   game::chain_columns(game_of_colours(), RecordedPlay::kRate_hz));
}

io::TableColumns<LoggedAction> logged_action_columns() {
  return after_log(&LoggedAction::action,
                   game::action_columns(game_of_colours(), RecordedPlay::kRate_hz));
}

io::TableColumns<LoggedShot> logged_shot_columns() {
  return after_log(&LoggedShot::shot,
                   game::shot_columns(game_of_colours(), RecordedPlay::kRate_hz));
}

game::EventGame game_of_colours() {
  game::EventGame game;
  for (const Side side : kSides) game.teams[side].letter = text_of_colour(side);
  return game;
}

}  // namespace autoref::logs
