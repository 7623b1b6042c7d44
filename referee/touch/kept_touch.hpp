// Who touched the ball last, after a gap in vision. The ball's motion after the gap may show that
// nobody touched it in the meantime, or only the robot that had it.
//
// How often this judgement is right was measured against ground truth in 18 games of 10 minutes,
// for gaps at all times during play: six games each of basic (rules: paper), cobalt (2026-b) and
// counter (paper) against themselves, seeds 1 to 6. Percentages for gaps of 1, 1.5 and 2 s:
//                                        basic          cobalt         counter
//   goes straight on, no robot at it     98, 96, 90     97, 95, 91     97, 86, (22 cases)
//   comes from the robot that had it     62, 64, 61     88, 83, 72     82, 74, 53
//   neither, and no robot had it         51, 48, 51     51, 48, 49     56, 52, 51
// So without either kind of evidence, the last touch before the gap says nothing about the one
// after it. A test compares LastTouch::kept with the truth in games of other teams
// (tests/judge/last_touch_truth_test.cpp).
#pragma once

#include <optional>

#include "referee/decision.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// What was known when the ball was last seen before a gap in vision.
struct BeforeGap {
  LastTouch last;
  std::optional<RobotId> holder;  // the only robot at the ball; nullopt if an opponent is near it
  double holder_gap_m = 0;
  double time_s = 0;
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
};

// The number of detections over which a velocity is averaged before and after a gap.
inline constexpr int kDetectionsAtGap = 3;

// `back` is the number of detections since the gap; at least one must precede it. `last` is the
// last touch before the gap, and `noise_m` is the standard deviation of the gap between ball and
// hull.
BeforeGap before_gap(const FrameHistory& frames, int back, const LastTouch& last, double noise_m);

// The last touch before the newest detection, which is the kDetectionsAtGap-th after the gap, with
// LastTouch::kept below 1; nullopt if the last touch cannot be determined.
std::optional<LastTouch> kept_touch(const BeforeGap& before, const FrameHistory& frames);

}  // namespace autoref::referee
