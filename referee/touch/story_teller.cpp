#include "referee/touch/story_teller.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/senders.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// A ball that rolls rather than slides, or the other way, by so much less cost does so surely.
constexpr double kRollsSurely = 20;
// A story that costs so much more than the cheapest does not catch up; twice what a touch by nobody
// costs.
constexpr double kTooCostly = 60;
constexpr double kLeastSliding_mps2 = 3.0;  // what sliding takes on the slickest carpet
constexpr double kBeforeKnown_s = 50_ms;    // a new way's speed is not known sooner
constexpr std::int64_t kLongestGap = 64;    // pictures, 1 s; more tell nothing of what was before

}  // namespace

Explanations StoryTeller::tell(std::int64_t first, const Explanations& before) {
  now_ = former_ = first;
  begin(before);
  for (std::int64_t i = first + 1; i <= basis_.pictures.newest(); ++i) {
    if (!basis_.pictures[i].has_ball) continue;
    former_ = now_;
    now_ = i;
    go_on();
  }
  return best_explanations();
}

// Nothing is known of the ball but this sighting, and what was before.
void StoryTeller::begin(const Explanations& explained) {
  stories_.clear();
  stories_.emplace_back();
  Story& story = stories_.back();
  story.way.start(now().ball_m, basis_.parameters.way);
  story.start = story.before = now_;
  story.sightings = 1;
  story.untouched = story.explained = explained;
}

void StoryTeller::go_on() {
  if (now_ - former_ > kLongestGap) {
    begin(best_explanations());
    return;
  }
  tell_rolling();
  tell_touch();
  follow();
  forget_unlikely();
}

// The cheapest story in which the ball slides goes on with a ball that rolls; in those in which it
// would have slid for too long it rolls anyway.
void StoryTeller::tell_rolling() {
  const auto roll = [this](Story& story) {
    story.way.begin_to_roll(basis_.parameters.way);
    story.way_cost += basis_.parameters.roll_cost;
  };
  for (Story& story : stories_) {
    if (!story.way.rolls() && !slides_still(story)) roll(story);
  }
  const Story* slides = cheapest_sliding();
  if (slides == nullptr) return;
  Story rolls = *slides;
  roll(rolls);
  stories_.push_back(rolls);
}

const Story* StoryTeller::cheapest_sliding() const {
  const Story* cheapest = nullptr;
  for (const Story& story : stories_) {
    if (story.way.rolls() || story.sightings < 2) continue;
    if (cheapest == nullptr || story.cost() < cheapest->cost()) cheapest = &story;
  }
  return cheapest;
}

// A ball slides for at most a third of its speed and its spin's, and spins as it rolled before.
bool StoryTeller::slides_still(const Story& story) const {
  const double former_mps = story.before_mps.norm();
  const double at_first_mps = 1.5 * story.way.velocity_mps().norm();
  const double longest_s = 0.3 * (former_mps + at_first_mps) / kLeastSliding_mps2 + kBeforeKnown_s;
  return now().time_s - basis_.pictures[story.start].time_s <= longest_s;
}

const Story& StoryTeller::cheapest() const {
  return *std::min_element(stories_.begin(), stories_.end(),
                           [](const Story& a, const Story& b) { return a.cost() < b.cost(); });
}

// The stories until now go on with a touch since the sighting before: a soft one and a hard one.
void StoryTeller::tell_touch() {
  const WayParameters& parameters = basis_.parameters.way;
  const FreeWay& way = cheapest().way;
  FreeWay onwards = way;
  onwards.predict(since_former_s(), parameters);
  const Vec2 onwards_m = onwards.place_after(0);
  const double variance_m2 = onwards.place_variance_after(0) + square(parameters.sighting_m);
  const bool turns =
      (now().ball_m - onwards_m).squaredNorm() > square(basis_.parameters.surely) * variance_m2;
  if (!turns && !now().jumps && !may_be_touched(basis_, former_, now_, onwards_m)) return;
  Story story = story_of_touch(way, onwards_m);
  story.is_soft = true;
  stories_.push_back(story);
  story.is_soft = false;
  stories_.push_back(story);
}

Story StoryTeller::story_of_touch(const FreeWay& way, const Vec2& onwards_m) const {
  Story story;
  story.way = way;
  story.start = now_;
  story.before = former_;
  story.before_mps = way.velocity_mps();
  story.goal_cost = cost_of_goal(basis_, former_, now_, onwards_m);
  story.jumps = now().jumps;
  story.explained = story.untouched = best_explanations();
  story.cost_until_touch = story.explained.least() + basis_.parameters.touch_cost;
  const double lowest_m = std::min(now().height_m, basis_.pictures[former_].height_m);
  if (lowest_m <= kRobotHeight_m) find_senders(story, basis_);
  return story;
}

void StoryTeller::follow() {
  if (now().jumps) {
    follow_jump();
    return;
  }
  for (Story& story : stories_) {
    follow(story);
    // Who sent the ball on its way is the same whether it then slid or rolled.
    const auto twin = std::find_if(stories_.begin(), stories_.end(), [&story](const Story& other) {
      return other.start == story.start;
    });
    if (&*twin == &story) {
      explain(story, now_, basis_);
    } else {
      story.explained = twin->explained;
    }
  }
}

// All but the newest story have lost the ball.
void StoryTeller::follow_jump() {
  stories_.erase(stories_.begin(), stories_.end() - 1);
  Story& story = stories_.back();
  story.way.jump(now().ball_m, basis_.parameters.way);
  ++story.sightings;
  explain(story, now_, basis_);
}

void StoryTeller::follow(Story& story) const {
  const StoryParameters& p = basis_.parameters;
  const bool is_new = story.start == now_;
  if (!is_new && now_ - former_ > 1) {
    // A ball unseen goes through nobody either.
    const Walk unseen = walk(story.way, basis_.pictures, former_, now_, p.meeting);
    story.way_cost += std::min(unseen.through_cost, p.unlikely_cost);
  }
  story.way.predict(since_former_s(), p.way);
  if (is_new) story.way.touch(since_former_s(), story.is_soft, p.way);
  story.way_cost += story.way.correct(now().ball_m, p.way);
  ++story.sightings;
}

Explanations StoryTeller::best_explanations() const {
  Explanations best;
  for (const Story& story : stories_) {
    for (const Toucher toucher : {kNobody, kWest, kEast}) {
      best.offer(toucher, story.explained.cost[toucher] + story.way_cost,
                 story.explained.touch[toucher]);
    }
  }
  return best;
}

void StoryTeller::forget_unlikely() {
  Costs costs;
  for (const Story& story : stories_) costs.push_back(story.cost());
  double most = *std::min_element(costs.begin(), costs.end()) + kTooCostly;
  strike_twins(costs);
  if (costs.size() > kStories) {
    Costs sorted = costs;
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

// Of stories that begin with the same touch one is enough once the ball rolls in both, or surely in
// one.
void StoryTeller::strike_twins(Costs& costs) const {
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
}

}  // namespace autoref::referee
