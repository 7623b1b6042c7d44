#include "game/loop/chain_log.hpp"

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace autoref::game {
namespace {

const PossessionChain& of_row(const ChainRow& row) { return row.chain; }
const BallAction& of_row(const BallAction& row) { return row; }

// The columns for the times (seconds since the start of the game) and the positions of the ball at
// the start and at the end of what a row describes.
template <typename Row>
io::TableColumns<Row> from_start_to_end(double frame_rate_hz) {
  const auto seconds = [=](auto frame) {
    return [=](const Row& row) {
      return std::optional(static_cast<double>(of_row(row).*frame) / frame_rate_hz);
    };
  };
  const auto coordinate = [](auto position_m, int axis) {
    return [=](const Row& row) {
      const double forward = -goal_sign(of_row(row).team);
      return std::optional(forward * (of_row(row).*position_m)[axis]);
    };
  };
  using Described = std::remove_cvref_t<decltype(of_row(std::declval<const Row&>()))>;
  return {{"start_s", seconds(&Described::first_frame)},
          {"end_s", seconds(&Described::last_frame)},
          {"start_x_m", coordinate(&Described::first_m, 0)},
          {"start_y_m", coordinate(&Described::first_m, 1)},
          {"end_x_m", coordinate(&Described::last_m, 0)},
          {"end_y_m", coordinate(&Described::last_m, 1)}};
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
             return action.robot < 0 ? std::string() : std::to_string(action.robot);
           }},
          {"action", [](const BallAction& action) { return std::string(name_of(action.kind)); }}},
      from_start_to_end<BallAction>(frame_rate_hz),
      io::TableColumns<BallAction>{
          {"worth", [](const BallAction& action) { return std::optional(action.worth); }}});
}

}  // namespace autoref::game
