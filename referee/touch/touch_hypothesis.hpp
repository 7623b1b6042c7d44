// A hypothesis of what the ball did: free ways joined by touches.
//
// Its costs are minus twice the logarithms of likelihoods, up to a constant that all hypotheses
// share; they have no unit.
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

// What hypotheses are told of.
struct HypothesisContext {
  const Field& field;
  const TouchHypothesisParameters& parameters;
  const FrameHistory& frame_history;
};

// Whose touch was the last.
enum Toucher : std::size_t { kNobody, kWest, kEast };
inline Toucher toucher_of(Side side) { return side == Side::kWest ? kWest : kEast; }

// The cheapest explanations by whose touch was the last.
struct SideMinima {
  std::array<double, 3> nll{kNever, kNever, kNever};
  std::array<LastTouch, 3> touch;

  double least() const;
  void offer(Toucher toucher, double offered_nll, const LastTouch& offered_touch);
};

// A robot that may have sent the ball on its way.
struct TouchSource {
  RobotId robot;
  double seen_gap_m = 1;  // to the ball's first detection on its way
  double bounce_nll = 0;  // of the way before, for a bounce and for a kick
  double kick_nll = 0;
  double time_s = 0;  // of the likeliest touch, and the gap then
  double gap_m = 0;
};

struct TouchHypothesis {
  BallMotionFilter motion;
  std::int64_t start = 0;    // the first frame of the way
  std::int64_t before = 0;   // the one with a ball before it; the same where nothing is known of it
  int detections = 0;        // of the way
  bool is_soft = false;      // whether the touch that the way begins with was
  bool jumps = false;        // or the ball's position jumped instead
  double motion_nll = 0;     // of the way's detections
  Vec2 before_mps{0, 0};     // velocity before the touch
  double goal_nll = kNever;  // of the way before, for a goal's post or wall
  double nll_until_touch = 0;  // of the way before, and of a robot's touch at all
  SideMinima untouched;        // where no robot sent the ball on this way
  boost::container::static_vector<TouchSource, 2 * kMaxRobots> sources;
  SideMinima minima;  // until this way, with who sent the ball on it

  double nll() const { return minima.least() + motion_nll; }
};

}  // namespace autoref::referee
