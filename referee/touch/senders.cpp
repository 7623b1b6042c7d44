#include "referee/touch/senders.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kFastestRobot_mps = 4.0;  // somewhat more than the league's reach
constexpr double kNearGoal_m = 0.5;        // a ball farther from the goal lines meets no post
// Sightings that tell where a way comes from. With more, the carpet and others bend it.
constexpr int kTellingSightings = 8;
// What a landing leaves of the ball's speed along its way, and may add across: as in the running
// detector, 0.75 at the first hop and 0.5 where it began to spin.
constexpr double kLandedAlong = 0.4;
constexpr double kLandedAcross = 0.1;

// From the ball's surface to the robot in that picture; kNever where it is not in it.
double seen_gap_m(const Picture& picture, RobotId id) {
  for (const Picture::Robot& robot : picture.robots) {
    if (robot.id != id) continue;
    return distance_to_hull(picture.ball_m, robot.position_m, robot.heading) - kBallRadius_m;
  }
  return kNever;
}

// The way's first sightings, taken in backwards: where and how fast it began.
FreeWay way_from_start(const Story& story, std::int64_t now, const StoryBasis& basis) {
  const Pictures& pictures = basis.pictures;
  const WayParameters& parameters = basis.parameters.way;
  std::int64_t last = story.start;
  for (int n = 1; n < kTellingSightings && last < now;) n += pictures[++last].has_ball ? 1 : 0;
  while (!pictures[last].has_ball) --last;
  FreeWay way;
  way.start(pictures[last].ball_m, parameters);
  double time_s = pictures[last].time_s;
  for (std::int64_t i = last - 1; i >= story.start; --i) {
    if (!pictures[i].has_ball) continue;
    way.predict(pictures[i].time_s - time_s, parameters);
    time_s = pictures[i].time_s;
    way.correct(pictures[i].ball_m, parameters);
  }
  return way;
}

// Whether a ball that nobody touched may go on like this after it landed.
bool goes_on(const Story& story, const FreeWay& way, double surely) {
  const Vec2& before_mps = story.before_mps;
  const double along = way.velocity_mps().dot(before_mps);
  const double across = cross(way.velocity_mps(), before_mps);
  const double off_mps = surely * std::sqrt(way.velocity_variance_m2ps2());
  const double speed_mps = before_mps.norm();
  return along > (kLandedAlong * speed_mps - off_mps) * speed_mps &&
         std::abs(across) <= (kLandedAcross * speed_mps + off_mps) * speed_mps;
}

// A ball that flies may seem to jump, and loses up to half of its speed when it lands.
double cost_without_robot(const Story& story, const FreeWay& way, const StoryBasis& basis) {
  const StoryParameters& p = basis.parameters;
  const Pictures& pictures = basis.pictures;
  const bool in_air = std::max(pictures[story.start].height_m, pictures[story.before].height_m) > 0;
  const double goal_cost = p.touch_cost + story.goal_cost;
  if (!goes_on(story, way, p.surely)) return std::min(p.nobody_cost, goal_cost);
  if (story.jumps) return std::min(p.jump_cost, goal_cost);
  return std::min(in_air ? p.landing_cost : p.nobody_cost, goal_cost);
}

const Meeting* meeting_with(const Meetings& met, RobotId robot) {
  const auto found = std::find_if(
      met.begin(), met.end(), [robot](const Meeting& meeting) { return meeting.robot == robot; });
  return found == met.end() ? nullptr : &*found;
}

// What the ways before and after cost together, and the touch. It was this robot's alone, or the
// second between two pictures: then the way after may come from the first one's place.
double cost_of(const Sender& sender, const Meeting* after, double goal_cost,
               const StoryParameters& p) {
  double cost = std::min(sender.bounce_cost, sender.kick_cost) + p.second_touch_cost +
                p.touch_cost + goal_cost;
  if (after != nullptr) {
    cost = std::min({cost, sender.bounce_cost + after->bounce_cost,
                     sender.kick_cost + after->kick_cost + p.kick_cost});
  }
  const bool is_at_hull = sender.seen_gap_m <= p.meeting.slack_m;
  return std::min(cost, is_at_hull ? p.at_hull_cost : p.off_hull_cost);
}

LastTouch touch_of(const Sender& sender, const Meeting* after, double speed_change_mps) {
  LastTouch touch;
  touch.side = sender.robot.side;
  touch.robot = sender.robot;
  touch.time_s = after != nullptr ? after->time_s : sender.time_s;
  touch.gap_m = after != nullptr ? after->gap_m : sender.gap_m;
  touch.speed_change_mps = speed_change_mps;
  return touch;
}

void weigh_senders(Story& story, const FreeWay& way, const StoryBasis& basis) {
  const StoryParameters& p = basis.parameters;
  const Meetings met = walk(way, basis.pictures, story.start, story.before, p.meeting).met;
  const double change_mps = (way.velocity_mps() - story.before_mps).norm();
  for (const Sender& sender : story.senders) {
    const Meeting* after = meeting_with(met, sender.robot);
    const double cost = story.cost_until_touch + cost_of(sender, after, story.goal_cost, p);
    story.explained.offer(toucher_of(sender.robot.side), cost, touch_of(sender, after, change_mps));
  }
}

}  // namespace

bool may_be_touched(const StoryBasis& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m) {
  const Picture& seen = basis.pictures[now];
  const Picture& before = basis.pictures[former];
  if (seen.ball_m.cwiseAbs().x() > basis.field.half_length_m() - kNearGoal_m) return true;
  const double reach_m = kRobotRadius_m + kBallRadius_m + basis.parameters.near_m +
                         kFastestRobot_mps * (seen.time_s - before.time_s);
  const auto is_near = [&](const Picture::Robot& robot) {
    return distance_to_segment(robot.position_m, before.ball_m, onwards_m) <= reach_m ||
           distance_to_segment(robot.position_m, before.ball_m, seen.ball_m) <= reach_m;
  };
  return std::any_of(seen.robots.begin(), seen.robots.end(), is_near);
}

double cost_of_goal(const StoryBasis& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m) {
  const Vec2& now_m = basis.pictures[now].ball_m;
  const Vec2& before_m = basis.pictures[former].ball_m;
  if (now_m.cwiseAbs().x() <= basis.field.half_length_m() - kNearGoal_m) return kNever;
  const double gap_m = std::min(gap_to_goals_m(basis.field, {before_m, now_m}),
                                gap_to_goals_m(basis.field, {before_m, onwards_m}));
  if (gap_m >= basis.parameters.near_m) return kNever;
  return square(gap_m / basis.parameters.post_off_m);
}

void find_senders(Story& story, const StoryBasis& basis) {
  const StoryParameters& p = basis.parameters;
  const Meetings met = walk(story.way, basis.pictures, story.before, story.start, p.meeting).met;
  double least = kNever;
  for (const Meeting& m : met) least = std::min({least, m.bounce_cost, m.kick_cost});
  // The first of two touches may have been another's.
  const double most = std::min(least + p.second_touch_cost, p.unlikely_cost);
  for (const Meeting& m : met) {
    const double gap_m = seen_gap_m(basis.pictures[story.start], m.robot);
    if (std::min(m.least_gap_m, gap_m) > p.near_m) continue;
    story.senders.push_back({m.robot, gap_m, std::min(m.bounce_cost, most),
                             std::min(m.kick_cost, most), m.time_s, m.gap_m});
  }
}

void explain(Story& story, std::int64_t now, const StoryBasis& basis) {
  if (story.sightings > kTellingSightings || story.start == story.before) return;
  const FreeWay way = way_from_start(story, now, basis);
  const double turn_cost = cost_without_robot(story, way, basis);
  story.explained = story.untouched;
  for (double& cost : story.explained.cost) cost += turn_cost;
  if (!story.senders.empty()) weigh_senders(story, way, basis);
}

}  // namespace autoref::referee
