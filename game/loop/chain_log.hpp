// Possession chains, the actions in them and their shots as tables: one row per chain, action or
// shot, in the order in which they ended.
#pragma once

#include "game/loop/event_log.hpp"
#include "game/play_counts/ball_actions.hpp"
#include "game/play_counts/possession_chains.hpp"
#include "io/table_columns.hpp"

namespace autoref::game {

struct ChainRow {
  int number = 1;  // counted from 1
  PossessionChain chain;
};

// The columns. Positions are seen from the row's team, as strategies see them: its own goal is at
// -x, and y points to its left. `game` names the teams.
io::TableColumns<ChainRow> chain_columns(const EventGame& game, double frame_rate_hz);
io::TableColumns<BallAction> action_columns(const EventGame& game, double frame_rate_hz);
io::TableColumns<Shot> shot_columns(const EventGame& game, double frame_rate_hz);

}  // namespace autoref::game
