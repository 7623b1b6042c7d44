// What a kick is at the moment in which it is fired. What becomes of it, play_statistics.hpp tells.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::runner {

struct KickAway {
  RobotId robot;
  std::int64_t frame = 0;  // as in sim::Touch
  Vec2 from_m{0, 0};
  bool is_at_goal = false;        // a shot, by its way
  bool is_between_posts = false;  // and under the bar; of kicks at the goal only
  bool is_for_mate = false;       // a pass, by its way
};

// None where the ball does not leave the robot fast enough. `now` is the world at the end of the
// kick's frame; definitions and thresholds are those of play_counts.hpp.
std::optional<KickAway> kick_away(const sim::Touch& kick, const sim::WorldState& now,
                                  const Field& field, const sim::BallParameters& ball);

}  // namespace autoref::runner
