// Tells the stories of what was seen of the ball, and keeps the cheapest.
//
// Whenever the ball comes near a robot, or turns, a new story tells that it was touched there; the
// others go on without. So a touch is weighed with what the ball did long after it.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>

#include "referee/touch/story.hpp"

namespace autoref::referee {

class StoryTeller {
 public:
  // Keeps a reference to what the basis refers to.
  explicit StoryTeller(const StoryBasis& basis) : basis_(basis) {}

  // Tells what happened from the picture `first`, a sighting of the ball, to the newest one. The
  // ball's velocity at `first` is unknown; `before` says who may have touched it last until then.
  // Returns who may have touched it last until now.
  Explanations tell(std::int64_t first, const Explanations& before);

 private:
  static constexpr std::size_t kStories = 10;  // more change no call, fewer do
  // One sighting adds a story of rolling and two of a touch.
  using Stories = boost::container::static_vector<Story, kStories + 4>;
  using Costs = boost::container::static_vector<double, Stories::static_capacity>;

  void begin(const Explanations& explained);
  void go_on();
  void tell_rolling();
  const Story* cheapest_sliding() const;
  bool slides_still(const Story& story) const;
  void tell_touch();
  Story story_of_touch(const FreeWay& way, const Vec2& onwards_m) const;
  const Story& cheapest() const;
  void follow();
  void follow_jump();
  void follow(Story& story) const;
  Explanations best_explanations() const;
  void forget_unlikely();
  void strike_twins(Costs& costs) const;

  const Picture& now() const { return basis_.pictures[now_]; }
  double since_former_s() const { return now().time_s - basis_.pictures[former_].time_s; }

  StoryBasis basis_;
  std::int64_t now_ = 0;     // the sighting told of
  std::int64_t former_ = 0;  // and the one before it
  Stories stories_;
};

}  // namespace autoref::referee
