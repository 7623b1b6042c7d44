// Who touched the ball last, judged in hindsight.
//
// What was seen of the ball since play started is explained by stories: a chain of free ways
// (free_way.hpp), joined by touches. Each story costs minus twice the logarithm of its likelihood:
// of the sightings along each way, of each touch at all, and of its robot (meetings.hpp): the way
// before must lead to that robot's hull, and the way after must come from there, or out of its
// mouth along its heading, without going through anybody. Whenever the ball comes near a robot, a
// new story tells that it was touched there. So a touch is weighed with what the ball did long
// after it, and one that noise hid at first shows later.
//
// The side whose cheapest story costs less touched the ball last; where both cost about the same,
// nobody knows.
//
// It owns the last pictures and the cheapest stories. The referee restarts it when play starts,
// feeds it each frame of play, and asks it when the ball has left the field.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>

#include "referee/decision.hpp"
#include "referee/free_way.hpp"
#include "referee/story_parameters.hpp"
#include "referee/meetings.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/tracker.hpp"

namespace autoref::referee {

class TouchStories {
 public:
  TouchStories(const Field& field, const StoryParameters& parameters, const VisionNoise& noise);

  // Play starts: nobody has touched the ball, which lies still at `ball_m`, if it was ever seen.
  void restart(const Frame& frame, const std::optional<Vec2>& ball_m);

  // The ball's place jumps: vision takes it to fly, or no longer does.
  void lose_sight() { jumps_ = true; }

  // Takes in one frame of play. Frames not later than the one before are skipped.
  void update(const Frame& frame);

  // The last touch; of nobody's side where both may have been. None where no touch is known.
  std::optional<LastTouch> judge() const;

 private:
  // A robot that may have sent the ball on its way.
  struct Candidate {
    RobotId robot;
    double seen_gap_m = 1;    // to the ball's first sighting on its way
    double cost_until_s = 0;  // of the story until the touch
    double bounce_cost = 0;   // of the way before, for a bounce and for a kick
    double kick_cost = 0;
    double cost = 0;  // of both ways together
    double time_s = 0;
    double gap_m = 0;
  };
  // The cheapest explanations by whose touch was the last: nobody's, west's, east's.
  static constexpr std::size_t kNobody = 0;
  struct Touch {
    RobotId robot;
    double time_s = 0;
    double gap_m = 0;
    double speed_change_mps = 0;
  };
  struct Explanations {
    std::array<double, 3> cost{kNever, kNever, kNever};
    std::array<Touch, 3> touch;
    double least() const;
  };
  struct Story {
    FreeWay way;
    std::int64_t start = 0;   // the first picture of the way
    double start_s = 0;       // its time
    std::int64_t before = 0;  // and the one with a ball before it
    int sightings = 0;
    bool is_soft = false;       // whether the last touch was
    bool jumps = false;         // or the ball's place jumped instead
    double way_cost = 0;        // of the way's sightings
    Vec2 before_mps{0, 0};      // velocity before the touch
    double goal_cost = kNever;  // of the way to a goal's post or wall
    Explanations untouched;     // where no robot sent the ball on this way
    boost::container::static_vector<Candidate, 2 * kMaxRobots> candidates;
    Explanations explained;  // until this way, with who sent the ball on it
  };
  static constexpr std::size_t kStories = 10;
  using Stories = boost::container::static_vector<Story, kStories + 4>;

  void begin(const Explanations& explained);
  void follow(const Picture& now, double duration_s);
  void tell_rolling();
  bool slides_still(const Story& story) const;
  void tell_touch();
  const Story& cheapest() const;
  bool may_be_touched(const Vec2& onwards_m) const;
  double goal_cost(const Vec2& onwards_m) const;
  double cost_without_robot(const Story& story, const FreeWay& way) const;
  void add_candidates(Story& story, const FreeWay& way, double cost_until_s) const;
  double gap_now_m(RobotId id) const;
  void explain(Story& story) const;
  void weigh_candidates(Story& story, const FreeWay& way) const;
  FreeWay way_from_start(const Story& story) const;
  Explanations best_explanations() const;
  void forget_unlikely();

  Field field_;
  StoryParameters parameters_;
  Pictures pictures_;
  std::int64_t seen_ = -1;  // the newest picture with a ball
  std::int64_t former_ = -1;
  bool jumps_ = false;
  Stories stories_;
};

}  // namespace autoref::referee
