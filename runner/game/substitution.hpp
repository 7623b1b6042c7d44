// The assistant at the touch line: robots leave the field and come back as the referee allows.
#pragma once

#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"
#include "soccer/team_requests.hpp"

namespace autoref::runner {

class SubstitutionController {
 public:
  // `robots` a side has in all.
  SubstitutionController(const Field& field, const PerSide<int>& robots)
      : field_(field), robots_(robots) {}

  // Once per frame, before the world moves on. While play is stopped a side with more robots than
  // allowed loses one after the other: the one it names, else its highest number but the keeper;
  // the first leaves 1 s after the allowance fell. A side that may have more gets its lowest number
  // back at once.
  void act(const RefereeSignal& signal, const PerSide<TeamRequests>& requests, double time_s,
           sim::World& world);

 private:
  void note_allowance(Side side, int allowed, double time_s);
  void call_back(Side side, const RefereeSignal& signal, sim::World& world) const;

  Field field_;
  PerSide<int> robots_;
  PerSide<int> allowed_{{kMaxRobots, kMaxRobots}};
  PerSide<double> fell_s_{};  // when the allowance last fell
};

// A free place in the run-off for a robot of `side` that comes back: as near as can be to the
// halfway line, in its own half, first at the touch line to the right of its goal keeper; its hull
// more than 500 mm from the ball and from where the ball is to be placed. None where all is taken.
std::optional<Vec2> return_position(const Field& field, Side side, const RefereeSignal& signal,
                                    const sim::World& world);

}  // namespace autoref::runner
