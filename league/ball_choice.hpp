// Which of the balls that vision reports is the one in play.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "league/followed_body.hpp"

namespace autoref::league {

// Follows one ball; at first, the most confident one. While it is hidden, it may appear again where
// a robot may have carried it or where its velocity brings it; a ball elsewhere, or one that a
// camera sees beside it in most frames, is another ball and remains one. Another ball takes the
// followed one's place
// - if it is the only one in the frame and at most one has been seen beside the followed one in the
//   last 3 s: at once, since it may just be kicked there, and false detections are rare then;
// - if the followed ball has disappeared and the other one was not seen beside it: after 0.1 s if
//   it moves, else after 0.5 s;
// - if both were seen together: 3 s after the followed one has disappeared, or as long after it as
//   it was followed, if the other one appeared later or moves;
// - if the followed ball lies still for 2 s, or since it appeared, while the other moves by 0.5 m.
class BallChoice {
 public:
  // Returns the detection of the ball in play, or nullptr if it is not among `all`, the detections
  // of one frame. Times must increase.
  const Detected* choose(double time_s, std::span<const Detected> all);

 private:
  struct OtherBall {
    Detected seen;
    Vec2 first_m{0, 0};
    double first_s = 0;
    double seen_s = 0;
    std::int64_t first_frame = 0;
    std::int64_t frames = 0;  // in which it was seen
    bool was_beside = false;  // together with the followed ball
  };

  const Detected* find_followed(double time_s, std::span<const Detected> all) const;
  const Detected* find_successor(double time_s, std::span<const Detected> all);
  bool is_steady(const OtherBall& other) const;
  bool replaces(const OtherBall& other, double time_s) const;
  void note_others(double time_s, std::span<const Detected> all, const Detected* chosen);
  OtherBall* other_at(double time_s, const Detected& seen);
  bool may_be_at(const Vec2& position_m, double time_s) const;
  bool is_other(double time_s, const Detected& seen) const;
  void follow(double time_s, std::span<const Detected> all, const Detected& chosen);

  FollowedBody ball_;
  double since_s_ = 0;   // followed since then, with short gaps
  double latest_s_ = 0;  // the latest frame
  std::int64_t frames_ = 0;
  Vec2 rest_m_{0, 0};  // the ball has been near this position
  double rest_s_ = 0;  // since then
  std::vector<OtherBall> others_;
  Detected used_;
};

}  // namespace autoref::league
