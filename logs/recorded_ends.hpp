// Follows which end of the field the yellow team of a recorded game defends.
#pragma once

#include <set>
#include <utility>

#include "league/messages/referee.pb.h"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// Stages in which the referee's packets name the wrong ends, as when nobody has switched them.
using TurnedStages = std::set<Stage>;

// The referee's packets say it or, if they do not, the teams change ends before every half after
// the first where the rule book demands it.
class RecordedEnds {
 public:
  // `at_first` holds until a packet says otherwise; west is -x.
  RecordedEnds(Side at_first, bool change_ends, TurnedStages turned = {})
      : yellow_(at_first), change_ends_(change_ends), turned_(std::move(turned)) {}

  void take(const league::RefereePacket& packet, Stage stage) {
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
