#include "game/loop/chain_log.hpp"

#include <optional>
#include <string>

namespace autoref::game {
namespace {

// Frames as seconds since the start of the game.
auto seconds(std::int64_t PossessionChain::*frame, double frame_rate_hz) {
  return [=](const ChainRow& row) {
    return std::optional(static_cast<double>(row.chain.*frame) / frame_rate_hz);
  };
}

auto coordinate(Vec2 PossessionChain::*position_m, int axis) {
  return [=](const ChainRow& row) {
    const double forward = -goal_sign(row.chain.team);
    return std::optional(forward * (row.chain.*position_m)[axis]);
  };
}

}  // namespace

io::TableColumns<ChainRow> chain_columns(const EventGame& game, double frame_rate_hz) {
  return {
      {"number", &ChainRow::number},
      {"team", [teams = game.teams](const ChainRow& row) { return teams[row.chain.team].letter; }},
      {"start", [](const ChainRow& row) { return std::string(name_of(row.chain.start)); }},
      {"end", [](const ChainRow& row) { return std::string(name_of(row.chain.end)); }},
      {"start_s", seconds(&PossessionChain::first_frame, frame_rate_hz)},
      {"end_s", seconds(&PossessionChain::last_frame, frame_rate_hz)},
      {"start_x_m", coordinate(&PossessionChain::first_m, 0)},
      {"start_y_m", coordinate(&PossessionChain::first_m, 1)},
      {"end_x_m", coordinate(&PossessionChain::last_m, 0)},
      {"end_y_m", coordinate(&PossessionChain::last_m, 1)},
      {"passes", [](const ChainRow& row) { return row.chain.passes; }},
      {"shots", [](const ChainRow& row) { return row.chain.shots; }},
      {"xg", [](const ChainRow& row) { return std::optional(row.chain.xg); }}};
}

}  // namespace autoref::game
