// Classifies a kick when it is fired. play_statistics.hpp tracks its outcome.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::game {

struct KickAway {
  RobotId robot;
  std::int64_t frame = 0;  // as in sim::Touch
  Vec2 from_m{0, 0};
  bool is_at_goal = false;        // its path is that of a shot
  bool is_between_posts = false;  // and under the bar; only if is_at_goal
  bool is_for_mate = false;       // its path is that of a pass
};

// Returns nullopt if the ball does not leave the robot fast enough. `now` is the world at the end
// of the kick's frame. Definitions and thresholds are in play_counts.hpp.
std::optional<KickAway> kick_away(const sim::Touch& kick, const sim::WorldState& now,
                                  const Field& field, const sim::BallParameters& ball);

}  // namespace autoref::game
