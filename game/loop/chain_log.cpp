#include "game/loop/chain_log.hpp"

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace autoref::game {
namespace {

const PossessionChain& of_row(const ChainRow& row) { return row.chain; }
const BallAction& of_row(const BallAction& row) { return row; }
const Shot& of_row(const Shot& row) { return row; }

template <typename Row>
using Described = std::remove_cvref_t<decltype(of_row(std::declval<const Row&>()))>;

// A column for a time: seconds since the start of the game.
template <typename Row>
io::TableColumn<Row> time_column(std::string name, std::int64_t Described<Row>::*frame,
                                 double frame_rate_hz) {
  return {std::move(name), [=](const Row& row) {
            return std::optional(static_cast<double>(of_row(row).*frame) / frame_rate_hz);
          }};
}

// A column for a coordinate of the ball's position, seen from the row's team.
template <typename Row>
io::TableColumn<Row> ball_column(std::string name, Vec2 Described<Row>::*position_m, int axis) {
  return {std::move(name), [=](const Row& row) {
            const double forward = -goal_sign(of_row(row).team);
            return std::optional(forward * (of_row(row).*position_m)[axis]);
          }};
}

// The columns for times and positions at the start and at the end of what a row describes.
template <typename Row>
io::TableColumns<Row> from_start_to_end(double frame_rate_hz) {
  using Content = Described<Row>;
  return {time_column<Row>("start_s", &Content::first_frame, frame_rate_hz),
          time_column<Row>("end_s", &Content::last_frame, frame_rate_hz),
          ball_column<Row>("start_x_m", &Content::first_m, 0),
          ball_column<Row>("start_y_m", &Content::first_m, 1),
          ball_column<Row>("end_x_m", &Content::last_m, 0),
          ball_column<Row>("end_y_m", &Content::last_m, 1)};
}

template <typename Row>
io::TableColumn<Row> team_column(const EventGame& game) {
  return {"team", [teams = game.teams](const Row& row) { return teams[of_row(row).team].letter; }};
}

}  // namespace

io::TableColumns<ChainRow> chain_columns(const EventGame& game, double frame_rate_hz) {
  return io::joined(
      io::TableColumns<ChainRow>{
          {"number", &ChainRow::number},
          team_column<ChainRow>(game),
          {"start", [](const ChainRow& row) { return std::string(name_of(row.chain.start)); }},
          {"end", [](const ChainRow& row) { return std::string(name_of(row.chain.end)); }}},
      from_start_to_end<ChainRow>(frame_rate_hz),
      io::TableColumns<ChainRow>{
          {"passes", [](const ChainRow& row) { return row.chain.passes; }},
          {"shots", [](const ChainRow& row) { return row.chain.shots; }},
          {"xg", [](const ChainRow& row) { return std::optional(row.chain.xg); }}});
}

io::TableColumns<BallAction> action_columns(const EventGame& game, double frame_rate_hz) {
  return io::joined(
      io::TableColumns<BallAction>{
          team_column<BallAction>(game),
          {"robot",
           [](const BallAction& action) {
             return action.robot < 0 ? io::ColumnValue(std::string())
                                     : io::ColumnValue(action.robot);
           }},
          {"action", [](const BallAction& action) { return std::string(name_of(action.kind)); }}},
      from_start_to_end<BallAction>(frame_rate_hz),
      io::TableColumns<BallAction>{
          {"worth", [](const BallAction& action) { return std::optional(action.worth); }}});
}

io::TableColumns<Shot> shot_columns(const EventGame& game, double frame_rate_hz) {
  return {team_column<Shot>(game),
          time_column<Shot>("time_s", &Shot::frame, frame_rate_hz),
          ball_column<Shot>("x_m", &Shot::from_m, 0),
          ball_column<Shot>("y_m", &Shot::from_m, 1),
          {"xg", [](const Shot& shot) { return std::optional(shot.chance); }},
          {"xgot", [](const Shot& shot) { return std::optional(shot.chance_on_target); }},
          {"is_goal", [](const Shot& shot) { return shot.has_scored ? 1 : 0; }}};
}

}  // namespace autoref::game
