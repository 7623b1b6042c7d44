// Tables of many logs: a summary per log and team, tracks, possession chains, actions and shots.
// Each row names its log; teams are named by their colours, "yellow" and "blue".
#pragma once

#include <string>
#include <vector>

#include "game/loop/chain_log.hpp"
#include "io/table_columns.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_facts.hpp"
#include "logs/speeds.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// A team in a log.
struct SummaryRow {
  std::string log;  // the path that the user gave
  const RecordedFacts* facts = nullptr;
  const LogRefereeResult* result = nullptr;
  const TeamSpeeds* speeds = nullptr;
  Side side = Side::kWest;
};
io::TableColumns<SummaryRow> summary_columns();

// An object in a frame: a robot or the ball. Positions are those of the log.
struct TrackRow {
  std::string log;
  double time_s = 0;
  std::string object;           // "ball" or the team's colour
  std::optional<int> number{};  // nullopt for the ball
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  std::optional<double> heading_deg{};  // counter-clockwise from x; nullopt for the ball
  std::optional<double> height_m{};     // of the ball's lowest point; nullopt for robots
  bool is_seen = true;                  // whether vision saw it in this frame
};
io::TableColumns<TrackRow> track_columns();

// The objects in the referee's newest frame.
std::vector<TrackRow> track_rows(const std::string& log, const LogReferee& referee);

struct LoggedChain {
  std::string log;
  game::ChainRow row;
};
// As those of game::chain_columns().
io::TableColumns<LoggedChain> logged_chain_columns();

struct LoggedAction {
  std::string log;
  game::BallAction action;
};
// As those of game::action_columns().
io::TableColumns<LoggedAction> logged_action_columns();

struct LoggedShot {
  std::string log;
  game::Shot shot;
};
// As those of game::shot_columns().
io::TableColumns<LoggedShot> logged_shot_columns();

// What game::chain_columns() needs to know: teams are named by their colours.
game::EventGame game_of_colours();

}  // namespace autoref::logs
