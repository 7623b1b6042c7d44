// Finds out which end of the field the yellow team defends in a log.
#pragma once

#include <optional>

#include "league/messages/referee.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::logs {

// The end that yellow defends by where a keeper stands; nullopt if it is not near a goal. `team` is
// the keeper's.
std::optional<Side> yellow_end_by(const Field& field, Side team, const Vec2& keeper_m);

// Evidence from the beginning of a game, before the teams change ends. Sources, in order of
// preference: the referee's packets, if they say so; the keepers that they name, near a goal in the
// first minute; the mean position of each team's robots in the first ten seconds.
class YellowEnd {
 public:
  explicit YellowEnd(const Field& field) : field_(field) {}

  // Frames must be in order of time.
  void take(const Frame& frame);
  void take(const league::RefereePacket& packet);

  // kWest: the goal at -x. nullopt without evidence.
  std::optional<Side> end() const;

 private:
  void take_keeper(Side team, const RobotObservation& keeper);

  Field field_;
  std::optional<double> first_s_;
  std::optional<Side> said_;  // by the referee
  PerSide<std::optional<int>> keepers_;
  PerSide<int> votes_;  // for each end, frames in which a keeper says that it is yellow's
  double apart_m_ = 0;  // blue's mean x minus yellow's, summed over frames
  int frames_apart_ = 0;
};

}  // namespace autoref::logs
