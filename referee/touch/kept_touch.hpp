// Who touched the ball last, after a gap in vision: what the ball does after it may show that it
// was touched by nobody meanwhile, or by the robot that had it.
//
// How often that is right was measured in 18 games of 10 minutes, from ground truth, for gaps at
// all times during play: six games each of basic (rules: paper), cobalt (2026-b) and counter
// (paper) against themselves, seeds 1 to 6. Percentages for gaps of 1, 1.5 and 2 s:
//                                        basic          cobalt         counter
//   goes straight on, no robot at it     98, 96, 90     97, 95, 91     97, 86, (22 cases)
//   comes from the robot that had it     62, 64, 61     88, 83, 72     82, 74, 53
//   neither, and no robot had it         51, 48, 51     51, 48, 49     56, 52, 51
// So without either evidence, the last touch before the gap says nothing about the one after it.
// A test compares LastTouch::kept with the truth in games of other teams
// (tests/judge/last_touch_truth_test.cpp).
#pragma once

#include <optional>

#include "referee/decision.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// What was known when the ball was last seen.
struct BeforeGap {
  LastTouch last;
  std::optional<RobotId> holder;  // the only robot at the ball, if no opponent is near it
  double holder_gap_m = 0;
  double time_s = 0;
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
};

// Detections over which a velocity is averaged before and after a gap.
inline constexpr int kDetectionsAtGap = 3;

// `back` is the number of detections since the gap; there must be one before it. `last` was the
// last touch then, and `noise_m` is the standard deviation of the gap between ball and hull.
BeforeGap before_gap(const FrameHistory& frames, int back, const LastTouch& last, double noise_m);

// The last touch before the newest detection, which is the kDetectionsAtGap-th after the gap, with
// LastTouch::kept below 1; nullopt if it cannot be known.
std::optional<LastTouch> kept_touch(const BeforeGap& before, const FrameHistory& frames);

}  // namespace autoref::referee
