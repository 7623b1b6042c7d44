#include "referee/touch/touch_stories.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/story.hpp"
#include "referee/touch/story_teller.hpp"

namespace autoref::referee {
namespace {

// Of two robots, one of each side.
LastTouch unknown_touch(const LastTouch& west, const LastTouch& east) {
  LastTouch touch;
  touch.time_s = std::max(west.time_s, east.time_s);
  touch.gap_m = std::min(west.gap_m, east.gap_m);
  touch.speed_change_mps = std::max(west.speed_change_mps, east.speed_change_mps);
  return touch;
}

}  // namespace

TouchStories::TouchStories(const Field& field, const StoryParameters& parameters,
                           const VisionNoise& noise)
    : field_(field), parameters_(parameters) {
  parameters_.way.sighting_m = std::max(noise.ball_m, parameters.way.sighting_m);
  parameters_.meeting.robot_m = noise.robot_m;
  parameters_.meeting.robot_rad = noise.robot_rad;
  parameters_.near_m += 3 * noise.ball_m;
}

void TouchStories::restart(const Frame& frame, const std::optional<Vec2>& ball_m) {
  pictures_.clear();
  if (!ball_m) return;
  Frame still = frame;
  still.ball = BallObservation{*ball_m, 0.0};
  pictures_.push(still);
}

double TouchStories::looks_since_s(const LastTouch& told) const {
  if (pictures_.empty()) return 0;
  const double now_s = pictures_[pictures_.newest()].time_s;
  return std::min(now_s - parameters_.window_s, told.time_s - parameters_.before_told_s);
}

LastTouch TouchStories::judge(const LastTouch& told) const {
  const std::int64_t first = pictures_.first_sighting(looks_since_s(told));
  if (first > pictures_.newest()) return told;
  const bool is_told_before = told.side && told.time_s < pictures_[first].time_s;
  Explanations before;
  before.offer(is_told_before ? toucher_of(*told.side) : kNobody, 0, told);
  const Explanations best = StoryTeller({field_, parameters_, pictures_}).tell(first, before);
  if (best.cost[kNobody] <= std::min(best.cost[kWest], best.cost[kEast])) return told;
  const double lead = best.cost[kEast] - best.cost[kWest];
  if (std::abs(lead) < parameters_.lead_cost) {
    return unknown_touch(best.touch[kWest], best.touch[kEast]);
  }
  LastTouch last = best.touch[lead > 0 ? kWest : kEast];
  const LastTouch& other = best.touch[lead > 0 ? kEast : kWest];
  if (other.robot) last.runner_up = other.robot;
  return last;
}

}  // namespace autoref::referee
