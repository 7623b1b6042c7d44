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

// The end that yellow defends, inferred from a keeper's position; nullopt if the keeper is not near
// a goal. `team` is the keeper's team.
std::optional<Side> yellow_end_by(const Field& field, Side team, const Vec2& keeper_m);

// Evidence for the end that yellow defends, from the beginning of a game, before the teams change
// ends. The best evidence is the referee's packets, if they give the ends. The next best evidence
// is the keepers that the packets name, if they are near a goal in the first minute. The last is
// the mean position of each team's robots in the first ten seconds.
class YellowEnd {
 public:
  explicit YellowEnd(const Field& field) : field_(field) {}

  // Frames must be in order of time.
  void add(const Frame& frame);
  void add(const league::RefereePacket& packet);

  // The end that yellow defends; kWest is the goal at -x. nullopt if there is no evidence.
  std::optional<Side> end() const;

 private:
  void add_keeper(Side team, const RobotObservation& keeper);

  Field field_;
  std::optional<double> first_s_;
  std::optional<Side> said_;  // the end given by the referee's packets
  PerSide<std::optional<int>> keepers_;
  // For each end, number of frames in which a keeper's position indicates that it is yellow's.
  PerSide<int> votes_;
  double apart_m_ = 0;  // mean x of blue's robots minus mean x of yellow's, summed over frames
  int frames_apart_ = 0;
};

// Stages in which the referee's packets name the wrong ends, for example because nobody switched
// the ends at the game controller.
using TurnedStages = std::set<Stage>;

// Follows the ends given in the referee's packets. If packets do not give them, the teams change
// ends before every half after the first if the rule book demands it.
class RecordedEnds {
 public:
  // `at_first` is the end that yellow defends until a packet says otherwise; west is -x.
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
