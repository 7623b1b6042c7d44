// Who touched the ball last, judged in hindsight.
//
// What was seen of the ball in the last seconds is explained by stories (story.hpp): chains of free
// ways (free_way.hpp), joined by touches. Each costs minus twice the logarithm of its likelihood:
// of the sightings along each way, of each touch at all, and of its robot (meetings.hpp): the way
// before must lead to that robot's hull, and the way after must come from there, or out of its
// mouth along its heading, without going through anybody. So one that noise hid at first shows by
// where the ball went later.
//
// The side whose cheapest story costs less touched the ball last; where both cost about the same,
// nobody knows.
//
// It owns the last pictures; the stories are told when asked for. The referee restarts it when play
// starts, feeds it each frame of play, and asks it when the ball has left the field.
#pragma once

#include <optional>

#include "referee/decision.hpp"
#include "referee/touch/pictures.hpp"
#include "referee/touch/story_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class TouchStories {
 public:
  // `noise` is vision's, of the frames to come.
  TouchStories(const Field& field, const StoryParameters& parameters, const VisionNoise& noise);

  // Play starts: nobody has touched the ball, which lies still at `ball_m`, if it was ever seen.
  void restart(const Frame& frame, const std::optional<Vec2>& ball_m);

  // The ball's place jumps: vision takes it to fly, or no longer does.
  void lose_sight() { pictures_.lose_sight(); }

  // Takes in one frame of play. Frames not later than the one before are skipped.
  void update(const Frame& frame) { pictures_.push(frame); }

  // The last touch; of nobody's side where either side's may have been. `told` is what was told
  // while play was on (last_touch.hpp): it is the answer where nobody touched the ball during the
  // seconds that are looked at, `StoryParameters::window_s`.
  LastTouch judge(const LastTouch& told) const;

 private:
  double looks_since_s(const LastTouch& told) const;

  Field field_;
  StoryParameters parameters_;
  Pictures pictures_;
};

}  // namespace autoref::referee
