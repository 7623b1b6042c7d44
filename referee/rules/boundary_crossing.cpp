// A kick must not take the ball over the field's boundary, the wall around the run-off (2026). The
// opponents get a free kick from where the ball was kicked. The ball has crossed a line before, so
// the rule also applies in the stop that follows; a ball that somebody carries away during a stop
// does not count. A kick-off or penalty kick that is about to be taken stays the restart. No foul
// is called if the last touch is unknown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/guards.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Our choice: a kicked ball reaches the boundary within this time after the touch.
constexpr double kFlight_s = 4_s;
// Our choice: the ball must be this far beyond the boundary.
constexpr double kBeyondBoundary_m = 150_mm;
// Our choice: a flying ball must be farther out by this many standard deviations of its height. To
// a camera, a ball that is higher than assumed appears farther out: by the height error itself if
// the camera sees it at 45 degrees from the vertical.
constexpr double kDeviations = 3;

double beyond_boundary_m(const Field& field, const Vec2& ball_m) {
  return std::max(std::abs(ball_m.x()) - field.wall_x_m(), std::abs(ball_m.y()) - field.wall_y_m());
}

// Where the ball was at the touch, if the history goes back that far.
std::optional<Vec2> kicked_from_m(const FrameHistory& frames, double touched_s) {
  const std::int64_t number = frames.first_detection(touched_s);
  if (number > frames.newest()) return std::nullopt;
  return frames[number].ball.position_m;
}

std::optional<Finding> find_boundary_crossing(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const LastTouch& touch = input.last_touch;
  if (!input.frame.ball) return std::nullopt;
  const Vec2& ball_m = input.ball->position_m;
  const double beyond_m = beyond_boundary_m(c.field, ball_m);
  bool& is_called = state.watch.boundary_is_crossed;
  if (beyond_m < 0) is_called = false;
  if (!input.ball->height_known) return std::nullopt;
  const double deviation_m = input.tracks.ball ? input.tracks.ball->height_deviation_m : 0.0;
  const double least_m = kBeyondBoundary_m + kDeviations * deviation_m;
  if (beyond_m < least_m || is_called || !touch.side) return std::nullopt;
  if (has_passed(touch.time_s, kFlight_s, input.time_s())) return std::nullopt;
  const std::optional<Vec2> from_m = kicked_from_m(input.frames, touch.time_s);
  if (!from_m) return std::nullopt;
  is_called = true;
  Finding finding =
      offence_of(Event::kBoundaryCrossing, RuleId::kBoundaryCrossing, c, *touch.side, *from_m);
  if (needs_preparation(pending_restart(state))) keep_restart(finding, state);
  if (touch.robot) finding.robots.push_back(*touch.robot);
  finding.value = beyond_m;
  finding.unit = "m";
  finding.evidence =
      fmt::format("{} kicked the ball over the field's boundary.",
                  touch.robot ? text_of(*touch.robot) : std::string(colour_of(*touch.side)));
  return finding;
}

}  // namespace

constinit const Rule kBoundaryCrossingRule{{State::kRun, State::kWaitStop, State::kCalled},
                                           find_boundary_crossing};

}  // namespace autoref::referee
