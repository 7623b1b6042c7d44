// A hypothesis about the ball's motion: free motion, the touches in between, and their causes.
//
// A deviance is minus twice a log-likelihood, up to a constant that all hypotheses share: the sum
// of normalised innovations squared and log-determinants. It has no unit; the difference of two is
// twice the log-likelihood ratio.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/decision.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/hull_intersections.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// Parameters of the retrospective touch detector (retrospective_touch_detector.hpp). Deviances are
// minus twice log-likelihoods. The deviances below are priors for events, or upper limits that make
// the likelihoods robust against outliers. The values were tuned on games between two `basic`
// teams, seeds 5001 to 5020.
struct TouchHypothesisParameters {
  // The window starts `window_s` before the ball left the field, or `before_reported_s` before the
  // online detector's last touch, whichever is earlier.
  double window_s = 2.0;
  double before_reported_s = 0.5;
  BallMotionParameters motion;
  HullIntersectionParameters intersection;
  double surely = 4;          // gate for the innovation, in standard deviations
  double near_m = 30_mm;      // a robot farther from the ball's path did not touch it
  double touch_deviance = 5;  // a touch near a robot happens in one frame in ten: -2 log 0.1
  double kick_deviance = 2;
  double second_touch_deviance = 1.9;  // another touch by a robot or goal between two frames
  double unlikely_deviance = 30;       // upper limit for the path before a robot's touch
  double at_hull_deviance = 15;        // upper limit for a whole touch if the ball was at the hull
  double off_hull_deviance = 50;  // upper limit for a whole touch if the ball was not at the hull
  double nobody_deviance = 25;    // a velocity change with no robot nearby
  double jump_deviance = 10;      // a jump of a ball that takes off or lands
  double landing_deviance = 4;    // a flying ball loses speed on landing
  double roll_deviance = 4;       // the ball begins to roll in this frame
  double post_off_m = 3_mm;       // standard deviation of the gap at a bounce off a goal
  // If the deviances of the two sides differ by less than this, the nearer robot touched the ball
  // last.
  double lead_deviance = 1.5;
};

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
  double time_s = 0;  // time at which this touch is likeliest
  double gap_m = 0;
};

struct TouchHypothesis {
  BallMotionFilter motion;
  std::int64_t start = 0;      // the first frame after the last touch
  std::int64_t before = 0;     // the detection before that frame; equals `start` if there is none
  int detections = 0;          // number of detections since the last touch
  bool is_soft = false;        // whether the last touch was a brush
  bool jumps = false;          // it begins with a jump of the ball's position, not with a touch
  double motion_deviance = 0;  // deviance of the detections since the last touch
  Vec2 before_mps{0, 0};       // velocity before the touch
  double goal_deviance = kNever;    // deviance of a bounce off a goal, given the path before it
  double deviance_until_touch = 0;  // deviance of everything before, including the touch's prior
  SideMinima untouched;             // deviance if no robot made the last touch
  boost::container::static_vector<TouchSource, 2 * kMaxRobots> sources;
  SideMinima minima;  // minimum over everything that may have made the last touch

  double deviance() const { return minima.least() + motion_deviance; }
};

// The cause of the touch with which a hypothesis begins: a robot, a goal's post or wall, or
// nothing.
//
// The path before the touch must lead to the robot's hull, and the path after it must start there
// (hull_intersections.hpp). The path before the touch is known when the hypothesis begins. The path
// after it is estimated from the detections that follow.

// Whether a robot or a goal may have been on the ball's path from the frame `former` to the frame
// `now`; `onwards_m` is the predicted position of an untouched ball.
bool may_be_touched(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m);

// Deviance of a bounce off a goal's post or wall between these frames, given the path before it;
// kNever if no goal is near.
double goal_deviance_of(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                        const Vec2& onwards_m);

// Lists the robots that may have touched the ball between the frames `before` and `start` of the
// hypothesis. The hypothesis must still contain the motion before the touch.
void find_touch_sources(TouchHypothesis& hypothesis, const HypothesisContext& basis);

// Updates the per-side minima of the hypothesis with its detections until the frame `now`. The
// minima are final after eight detections.
void weigh_sources(TouchHypothesis& hypothesis, std::int64_t now, const HypothesisContext& basis);

}  // namespace autoref::referee
