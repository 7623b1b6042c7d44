// Finds out which end of the field the yellow team of a recorded game defends, and keeps track of
// it.
#pragma once

#include <optional>
#include <set>
#include <utility>

#include "league/messages/referee.pb.h"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// The end that yellow defends, judged by a keeper's position; nullopt if the keeper is not near a
// goal. `team` is the keeper's team.
std::optional<Side> yellow_end_by(const Field& field, Side team, const Vec2& keeper_m);

// Evidence from the beginning of a game, before the teams change ends. Sources, in order of
// preference: the referee's packets, if they give the ends; the keepers they name, if near a goal
// in the first minute; the mean position of each team's robots in the first ten seconds.
class YellowEnd {
 public:
  explicit YellowEnd(const Field& field) : field_(field) {}

  // Frames must be in order of time.
  void add(const Frame& frame);
  void add(const league::RefereePacket& packet);

  // kWest: the goal at -x. nullopt without evidence.
  std::optional<Side> end() const;

 private:
  void take_keeper(Side team, const RobotObservation& keeper);

  Field field_;
  std::optional<double> first_s_;
  std::optional<Side> said_;  // by the referee
  PerSide<std::optional<int>> keepers_;
  PerSide<int> votes_;  // for each end, frames in which a keeper makes it yellow's
  double apart_m_ = 0;  // blue's mean x minus yellow's, summed over frames
  int frames_apart_ = 0;
};

// Stages in which the referee's packets name the wrong ends, for example because nobody switched
// them.
using TurnedStages = std::set<Stage>;

// Follows the ends given in the referee's packets. If packets do not give them, the teams change
// ends before every half after the first if the rule book demands it.
class RecordedEnds {
 public:
  // `at_first` holds until a packet says otherwise; west is -x.
  RecordedEnds(Side at_first, bool change_ends, TurnedStages turned = {})
      : yellow_(at_first), change_ends_(change_ends), turned_(std::move(turned)) {}

  void add(const league::RefereePacket& packet, Stage stage) {
    if (packet.has_blue_team_on_positive_half()) {
      yellow_ = packet.blue_team_on_positive_half() != turned_.contains(stage) ? Side::kWest
                                                                               : Side::kEast;
    } else if (change_ends_ && stage != stage_ && begins_after_change(stage)) {
      yellow_ = opponent_of(yellow_);
    }
    stage_ = stage;
  }

  Side yellow() const { return yellow_; }

 private:
  static bool begins_after_change(Stage stage) {
    return stage == Stage::kSecondHalfPre || stage == Stage::kExtraFirstHalfPre ||
           stage == Stage::kExtraSecondHalfPre;
  }

  Side yellow_;
  bool change_ends_;
  TurnedStages turned_;
  Stage stage_ = Stage::kFirstHalfPre;
};

}  // namespace autoref::logs
