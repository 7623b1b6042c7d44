// A hypothesis about the ball's motion: free motion, with touches in between.
//
// A deviance is minus twice a log-likelihood, up to a constant that all hypotheses share: the sum
// of normalised innovations squared and log-determinants. It has no unit; the difference of two is
// twice the log-likelihood ratio.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/decision.hpp"
#include "referee/touch/ball_motion_filter.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/hull_intersections.hpp"
#include "referee/touch/touch_hypothesis_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Data shared by all hypotheses.
struct HypothesisContext {
  const Field& field;
  const TouchHypothesisParameters& parameters;
  const FrameHistory& frame_history;
};

// The side of the last touch.
enum Toucher : std::size_t { kNobody, kWest, kEast };
inline Toucher toucher_of(Side side) { return side == Side::kWest ? kWest : kEast; }

// For each side, the likeliest last touch by that side: the minimum of the deviance.
struct SideMinima {
  std::array<double, 3> deviance{kNever, kNever, kNever};
  std::array<LastTouch, 3> touch;

  double least() const;
  void offer(Toucher toucher, double offered_deviance, const LastTouch& offered_touch);
};

// A robot that may have started the ball's current motion by a touch.
struct TouchSource {
  RobotId robot;
  double seen_gap_m = 1;       // gap at the first detection after the touch
  double bounce_deviance = 0;  // deviances of the path before a bounce or kick
  double kick_deviance = 0;
  double time_s = 0;  // time of the likeliest touch
  double gap_m = 0;
};

struct TouchHypothesis {
  BallMotionFilter motion;
  std::int64_t start = 0;      // the first frame after the last touch
  std::int64_t before = 0;     // the detection before that frame; equals `start` if there is none
  int detections = 0;          // since the last touch
  bool is_soft = false;        // whether the last touch was a brush
  bool jumps = false;          // instead of a touch, the ball's position jumped
  double motion_deviance = 0;  // deviance of the detections since the last touch
  Vec2 before_mps{0, 0};       // velocity before the touch
  double goal_deviance = kNever;    // deviance of a bounce off a goal, given the path before
  double deviance_until_touch = 0;  // deviance of everything before, including the touch's prior
  SideMinima untouched;             // deviance if no robot made the last touch
  boost::container::static_vector<TouchSource, 2 * kMaxRobots> sources;
  SideMinima minima;  // minimum over everything that may have made the last touch

  double deviance() const { return minima.least() + motion_deviance; }
};

}  // namespace autoref::referee
