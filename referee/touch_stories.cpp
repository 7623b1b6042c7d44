#include "referee/touch_stories.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kSurely = 4;               // deviations beyond which a change is not by chance
constexpr double kRollsSurely = 20;         // less costly than to slide
constexpr double kTooCostly = 60;           // more than the cheapest story
constexpr int kTellingSightings = 8;        // they tell where a way comes from
constexpr double kLeastSliding_mps2 = 3.0;  // what sliding takes on the slickest carpet
constexpr double kBeforeKnown_s = 50_ms;    // a new way's speed is not known sooner
constexpr double kFastestRobot_mps = 4.0;
constexpr double kNearGoal_m = 0.5;       // a ball farther from the goal lines meets no post
constexpr std::int64_t kLongestGap = 64;  // pictures; more tell nothing

std::size_t index_of(Side side) { return side == Side::kWest ? 1 : 2; }

double square(double x) { return x * x; }

}  // namespace

TouchStories::TouchStories(const Field& field, const StoryParameters& parameters,
                           const VisionNoise& noise)
    : field_(field), parameters_(parameters) {
  parameters_.way.sighting_m = std::max(noise.ball_m, parameters.way.sighting_m);
  parameters_.meeting.robot_m = noise.robot_m;
  parameters_.meeting.robot_rad = noise.robot_rad;
  parameters_.near_m += 3 * noise.ball_m;
}

double TouchStories::Explanations::least() const { return std::min({cost[0], cost[1], cost[2]}); }

void TouchStories::restart(const Frame& frame, const std::optional<Vec2>& ball_m) {
  stories_.clear();
  pictures_.clear();
  seen_ = former_ = -1;
  jumps_ = false;
  if (!ball_m) return;
  Frame still = frame;
  still.ball = BallObservation{*ball_m, 0.0};
  pictures_.push(still, *ball_m);
  seen_ = pictures_.newest();
  Explanations untouched;
  untouched.cost[kNobody] = 0;
  begin(untouched);
}

// Nothing is known of the ball but this sighting, and what was before.
void TouchStories::begin(const Explanations& explained) {
  jumps_ = false;
  stories_.clear();
  stories_.emplace_back();
  Story& story = stories_.back();
  story.way.start(pictures_[seen_].ball_m, parameters_.way);
  story.start = story.before = seen_;
  story.start_s = pictures_[seen_].time_s;
  story.sightings = 1;
  story.untouched = story.explained = explained;
}

void TouchStories::update(const Frame& frame) {
  const bool is_first = pictures_.newest() < 0;
  if (!is_first && !(frame.time_s > pictures_[pictures_.newest()].time_s)) return;
  const Vec2 last_m = seen_ >= 0 ? pictures_[seen_].ball_m : Vec2(0, 0);
  pictures_.push(frame, frame.ball ? frame.ball->position_m : last_m);
  if (!frame.ball) return;
  former_ = seen_;
  seen_ = pictures_.newest();
  if (stories_.empty() || seen_ - former_ > kLongestGap) {
    Explanations before = best_explanations();
    if (stories_.empty()) before.cost[kNobody] = 0;
    begin(before);
    return;
  }
  const Picture& now = pictures_[seen_];
  tell_rolling();
  tell_touch();
  follow(now, now.time_s - pictures_[former_].time_s);
  forget_unlikely();
}

void TouchStories::follow(const Picture& now, double duration_s) {
  const WayParameters& p = parameters_.way;
  if (jumps_) {
    stories_.erase(stories_.begin(), stories_.end() - 1);
    stories_.back().way.jump(now.ball_m, p);
    ++stories_.back().sightings;
    explain(stories_.back());
    jumps_ = false;
    return;
  }
  for (Story& story : stories_) {
    const bool is_new = story.start == seen_;
    if (!is_new && seen_ - former_ > 1) {
      // A ball unseen goes through nobody either.
      const Walk unseen = walk(story.way, pictures_, former_, seen_, parameters_.meeting);
      story.way_cost += std::min(unseen.through_cost, parameters_.unlikely_cost);
    }
    story.way.predict(duration_s, p);
    if (is_new) story.way.touch(duration_s, story.is_soft, p);
    story.way_cost += story.way.correct(now.ball_m, p);
    ++story.sightings;
    // Who sent the ball on its way is the same whether it then slid or rolled.
    const auto twin = std::find_if(stories_.begin(), stories_.end(), [&story](const Story& other) {
      return other.start == story.start;
    });
    if (&*twin == &story) {
      explain(story);
    } else {
      story.explained = twin->explained;
    }
  }
}

// The cheapest story in which the ball slides goes on with a ball that rolls; in those in which it
// would have slid for too long it rolls anyway.
void TouchStories::tell_rolling() {
  for (Story& story : stories_) {
    if (story.way.rolls() || slides_still(story)) continue;
    story.way.begin_to_roll(parameters_.way);
    story.way_cost += parameters_.roll_cost;
  }
  const Story* slides = nullptr;
  double least = kNever;
  for (const Story& story : stories_) {
    if (story.way.rolls() || story.sightings < 2) continue;
    const double cost = story.explained.least() + story.way_cost;
    if (cost >= least) continue;
    least = cost;
    slides = &story;
  }
  if (slides == nullptr) return;
  Story rolls = *slides;
  rolls.way.begin_to_roll(parameters_.way);
  rolls.way_cost += parameters_.roll_cost;
  stories_.push_back(rolls);
}

// A ball slides for at most a third of its speed and its spin's, and spins as it rolled before.
bool TouchStories::slides_still(const Story& story) const {
  const double former_mps = story.before_mps.norm();
  const double at_first_mps = 1.5 * story.way.velocity_mps().norm();
  const double longest_s = 0.3 * (former_mps + at_first_mps) / kLeastSliding_mps2 + kBeforeKnown_s;
  return pictures_[seen_].time_s - story.start_s <= longest_s;
}

const TouchStories::Story& TouchStories::cheapest() const {
  return *std::min_element(stories_.begin(), stories_.end(), [](const Story& a, const Story& b) {
    return a.explained.least() + a.way_cost < b.explained.least() + b.way_cost;
  });
}

// The stories until now go on with a touch since the sighting before: a hard one and a soft one.
void TouchStories::tell_touch() {
  const FreeWay& way = cheapest().way;
  FreeWay onwards = way;
  onwards.predict(pictures_[seen_].time_s - pictures_[former_].time_s, parameters_.way);
  const Vec2 onwards_m = onwards.place_after(0);
  const double variance_m2 = onwards.place_variance_after(0) + square(parameters_.way.sighting_m);
  const Vec2 miss_m = pictures_[seen_].ball_m - onwards_m;
  const bool turns = miss_m.squaredNorm() > square(kSurely) * variance_m2;
  if (!turns && !jumps_ && !may_be_touched(onwards_m)) return;
  Story story;
  story.way = way;
  story.start = seen_;
  story.start_s = pictures_[seen_].time_s;
  story.before = former_;
  story.before_mps = way.velocity_mps();
  story.goal_cost = goal_cost(onwards_m);
  story.jumps = jumps_;
  story.explained = best_explanations();
  story.untouched = story.explained;
  if (std::min(pictures_[seen_].height_m, pictures_[former_].height_m) <= kRobotHeight_m) {
    add_candidates(story, way, story.explained.least() + parameters_.touch_cost);
  }
  story.is_soft = true;
  stories_.push_back(story);
  story.is_soft = false;
  stories_.push_back(story);
}

// Whether a robot, or a goal, is at the ball's way since the sighting before.
bool TouchStories::may_be_touched(const Vec2& onwards_m) const {
  const Picture& now = pictures_[seen_];
  const Picture& before = pictures_[former_];
  if (now.ball_m.cwiseAbs().x() > field_.half_length_m() - kNearGoal_m) return true;
  const double reach_m = kRobotRadius_m + kBallRadius_m + parameters_.near_m;
  const double fastest_m = kFastestRobot_mps * (now.time_s - before.time_s);
  const auto is_near = [&](const Picture::Robot& robot) {
    return distance_to_segment(robot.position_m, before.ball_m, onwards_m) <= reach_m + fastest_m ||
           distance_to_segment(robot.position_m, before.ball_m, now.ball_m) <= reach_m + fastest_m;
  };
  return std::any_of(now.robots.begin(), now.robots.end(), is_near);
}

double TouchStories::goal_cost(const Vec2& onwards_m) const {
  const Vec2& now_m = pictures_[seen_].ball_m;
  const Vec2& before_m = pictures_[former_].ball_m;
  if (now_m.cwiseAbs().x() <= field_.half_length_m() - kNearGoal_m) return kNever;
  const double gap_m = std::min(gap_to_goals_m(field_, {before_m, now_m}),
                                gap_to_goals_m(field_, {before_m, onwards_m}));
  return gap_m < parameters_.near_m ? square(gap_m / parameters_.post_off_m) : kNever;
}

void TouchStories::add_candidates(Story& story, const FreeWay& way, double cost_until_s) const {
  const Meetings met = walk(way, pictures_, story.before, story.start, parameters_.meeting).met;
  double least = kNever;
  for (const Meeting& m : met) least = std::min({least, m.bounce_cost, m.kick_cost});
  // The first of two touches may have been another's.
  const double most = std::min(least + parameters_.second_touch_cost, parameters_.unlikely_cost);
  for (const Meeting& m : met) {
    const double seen_gap_m = gap_now_m(m.robot);
    if (std::min(m.least_gap_m, seen_gap_m) > parameters_.near_m) continue;
    Candidate candidate;
    candidate.robot = m.robot;
    candidate.seen_gap_m = seen_gap_m;
    candidate.cost_until_s = cost_until_s;
    candidate.bounce_cost = std::min(m.bounce_cost, most);
    candidate.kick_cost = std::min(m.kick_cost, most);
    story.candidates.push_back(candidate);
  }
}

double TouchStories::gap_now_m(RobotId id) const {
  const Picture& now = pictures_[seen_];
  for (const Picture::Robot& robot : now.robots) {
    if (robot.id != id) continue;
    return distance_to_hull(now.ball_m, robot.position_m, robot.heading) - kBallRadius_m;
  }
  return kNever;
}

// Once some sightings tell where a way comes from, its explanations stay.
void TouchStories::explain(Story& story) const {
  if (story.sightings > kTellingSightings || story.start == story.before) return;
  const FreeWay way = way_from_start(story);
  const double turn_cost = cost_without_robot(story, way);
  story.explained = story.untouched;
  for (double& cost : story.explained.cost) cost += turn_cost;
  if (!story.candidates.empty()) weigh_candidates(story, way);
}

// A ball that flies may seem to jump, and loses up to half of its speed when it lands.
double TouchStories::cost_without_robot(const Story& story, const FreeWay& way) const {
  const bool in_air =
      std::max(pictures_[story.start].height_m, pictures_[story.before].height_m) > 0;
  const Vec2& before_mps = story.before_mps;
  const double along = way.velocity_mps().dot(before_mps);
  const double across = cross(way.velocity_mps(), before_mps);
  const double off_mps = std::sqrt(way.velocity_variance_m2ps2());
  const double speed_mps = before_mps.norm();
  const bool goes_on = along > (0.4 * speed_mps - kSurely * off_mps) * speed_mps &&
                       std::abs(across) <= (0.1 * speed_mps + kSurely * off_mps) * speed_mps;
  const double goal_cost = parameters_.touch_cost + story.goal_cost;
  if (!goes_on) return std::min(parameters_.nobody_cost, goal_cost);
  if (story.jumps) return std::min(parameters_.jump_cost, goal_cost);
  return std::min(in_air ? parameters_.landing_cost : parameters_.nobody_cost, goal_cost);
}

void TouchStories::weigh_candidates(Story& story, const FreeWay& way) const {
  const StoryParameters& p = parameters_;
  const Meetings met = walk(way, pictures_, story.start, story.before, p.meeting).met;
  for (Candidate& candidate : story.candidates) {
    const auto m = std::find_if(met.begin(), met.end(), [&candidate](const Meeting& meeting) {
      return meeting.robot == candidate.robot;
    });
    candidate.cost = std::min(candidate.bounce_cost, candidate.kick_cost) + p.second_touch_cost +
                     p.touch_cost + story.goal_cost;
    if (m != met.end()) {
      candidate.cost = std::min({candidate.cost, candidate.bounce_cost + m->bounce_cost,
                                 candidate.kick_cost + m->kick_cost + p.kick_cost});
      candidate.time_s = m->time_s;
      candidate.gap_m = m->gap_m;
    }
    const bool is_at_hull = candidate.seen_gap_m <= p.meeting.slack_m;
    candidate.cost = std::min(candidate.cost, is_at_hull ? p.at_hull_cost : p.off_hull_cost);
    const std::size_t i = index_of(candidate.robot.side);
    const double cost = candidate.cost_until_s + candidate.cost;
    if (cost >= story.explained.cost[i]) continue;
    const double change_mps = (way.velocity_mps() - story.before_mps).norm();
    story.explained.cost[i] = cost;
    story.explained.touch[i] = {candidate.robot, candidate.time_s, candidate.gap_m, change_mps};
  }
}

// Its first sightings, taken in backwards.
FreeWay TouchStories::way_from_start(const Story& story) const {
  std::int64_t last = story.start;
  for (int n = 1; n < kTellingSightings && last < seen_;) n += pictures_[++last].has_ball ? 1 : 0;
  while (!pictures_[last].has_ball) --last;
  FreeWay way;
  way.start(pictures_[last].ball_m, parameters_.way);
  double time_s = pictures_[last].time_s;
  for (std::int64_t i = last - 1; i >= story.start; --i) {
    if (!pictures_[i].has_ball) continue;
    way.predict(pictures_[i].time_s - time_s, parameters_.way);
    time_s = pictures_[i].time_s;
    way.correct(pictures_[i].ball_m, parameters_.way);
  }
  return way;
}

TouchStories::Explanations TouchStories::best_explanations() const {
  Explanations best;
  for (const Story& story : stories_) {
    for (std::size_t i = 0; i < best.cost.size(); ++i) {
      const double cost = story.explained.cost[i] + story.way_cost;
      if (cost >= best.cost[i]) continue;
      best.cost[i] = cost;
      best.touch[i] = story.explained.touch[i];
    }
  }
  return best;
}

// Of stories that begin with the same touch one is enough once the ball rolls in both, or surely in
// one.
void TouchStories::forget_unlikely() {
  boost::container::static_vector<double, Stories::static_capacity> costs;
  for (const Story& story : stories_) costs.push_back(story.explained.least() + story.way_cost);
  const double least = *std::min_element(costs.begin(), costs.end());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Story& a = stories_[i];
      const Story& b = stories_[j];
      if (a.start != b.start || a.is_soft != b.is_soft) continue;
      const bool both_roll = a.way.rolls() && b.way.rolls();
      if (!both_roll && std::abs(costs[i] - costs[j]) < kRollsSurely) continue;
      costs[costs[i] < costs[j] ? j : i] = kNever;
    }
  }
  double most = least + kTooCostly;
  if (costs.size() > kStories) {
    auto sorted = costs;
    std::nth_element(sorted.begin(), sorted.begin() + kStories - 1, sorted.end());
    most = std::min(most, sorted[kStories - 1]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (costs[i] > most || kept == kStories) continue;
    if (kept != i) stories_[kept] = stories_[i];
    ++kept;
  }
  stories_.resize(kept);
}

std::optional<LastTouch> TouchStories::judge() const {
  const Explanations best = best_explanations();
  const std::size_t west = index_of(Side::kWest);
  const std::size_t east = index_of(Side::kEast);
  const double lead = best.cost[east] - best.cost[west];
  if (best.cost[kNobody] <= std::min(best.cost[west], best.cost[east])) return std::nullopt;
  LastTouch last;
  if (std::abs(lead) < parameters_.lead_cost) {
    last.time_s = std::max(best.touch[west].time_s, best.touch[east].time_s);
    last.gap_m = std::min(best.touch[west].gap_m, best.touch[east].gap_m);
    return last;
  }
  const Touch& touch = best.touch[lead > 0 ? west : east];
  last.side = touch.robot.side;
  last.robot = touch.robot;
  last.time_s = touch.time_s;
  last.gap_m = touch.gap_m;
  last.speed_change_mps = touch.speed_change_mps;
  return last;
}

}  // namespace autoref::referee
