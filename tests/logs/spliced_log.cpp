#include "tests/logs/spliced_log.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "league/log_file.hpp"
#include "league/message_fields.hpp"
#include "league/messages/vision.pb.h"
#include "soccer/robot_shape.hpp"

namespace autoref::logs {
namespace {

using referee::Event;

constexpr double kPlayed_s = 0.3;  // play has been on for so long
constexpr double kQuiet_s = 2.1;   // after a call; a foul may cancel a goal for 2 s
constexpr double kLongestFrame_s = 0.05;
constexpr double kShortestSplice_s = 0.3;  // of the ball's path: ten frames of a slow camera
constexpr double kFromLines_m = 0.1;       // to the place of the kick
constexpr double kFromPosts_m = 0.15;
constexpr double kFromRobots_m = 0.25;  // of the ball's centre to other robots' centres
constexpr double kKick_s = 0.1;         // meanwhile, the kicker may follow the ball
constexpr double kSteepness = 0.15;
constexpr double kGap_m = 0.002;  // from the kicker to the ball

// Whether play is on until `to_s` and has been for a while, and nothing was called recently.
bool is_quiet(const RefereedLog& log, double from_s, double to_s) {
  bool is_on = false;
  double called_s = from_s - kQuiet_s;
  for (const referee::Decision& decision : log.decisions) {
    if (decision.time_s > to_s) break;
    is_on = decision.to == referee::State::kRun && decision.time_s <= from_s - kPlayed_s;
    if (referee::is_call(decision.finding.event)) called_s = decision.time_s;
  }
  return is_on && called_s <= from_s - kQuiet_s;
}

bool has_gaps(std::span<const Frame> frames) {
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (frames[i].time_s - frames[i - 1].time_s > kLongestFrame_s) return true;
  }
  return false;
}

bool is_near_a_post(const Field& field, const Crossing& crossing) {
  return crossing.line != ExitLine::kTouchLine &&
         std::abs(std::abs(crossing.position_m.y()) - field.half_goal_m()) < kFromPosts_m;
}

// Whether no robot is in the ball's path.
bool is_clear(const Splice& splice, std::span<const Frame> frames) {
  for (const Frame& frame : frames) {
    if (frame.time_s < splice.from_s) continue;
    const std::optional<Vec2> ball_m = splice.ball_m(frame.time_s);
    for (const Side side : kSides) {
      for (const RobotObservation& robot : frame.robots[side]) {
        const bool is_kicker = RobotId{side, robot.number} == splice.kicker;
        if (is_kicker && frame.time_s < splice.from_s + kKick_s) continue;
        if (ball_m && (robot.position_m - *ball_m).norm() < kFromRobots_m) return false;
      }
    }
  }
  return true;
}

// Fills in the call. In the log, yellow defends the goal at -x if `blue_on_positive_half`.
void expect_call(Splice& splice, bool blue_on_positive_half) {
  const Side end = splice.crossing.position_m.x() < 0 ? Side::kWest : Side::kEast;
  const Side defending = blue_on_positive_half ? end : opponent_of(end);
  const Side kicking = splice.kicker.side;
  splice.restart = opponent_of(kicking);
  if (splice.crossing.line == ExitLine::kGoal) {
    splice.event = Event::kGoal;
    splice.restart = defending;
  } else if (splice.crossing.line == ExitLine::kGoalLine) {
    splice.event = defending == kicking ? Event::kCornerKick : Event::kGoalKick;
  }
  const double over_m = kBallRadius_m / splice.crossing.steepness;
  splice.call_s = splice.from_s + splice.exit->time_at_s(over_m) - splice.exit_from_s;
}

class SpliceFinder {
 public:
  SpliceFinder(const BallExit& exit, const RefereedLog& log) : exit_(exit), log_(log) {}

  std::vector<Splice> all() {
    for (const Frame& frame : log_.frames) {
      for (const Side side : kSides) {
        for (const RobotObservation& robot : frame.robots[side])
          try_kick(frame.time_s, {side, robot.number}, robot);
      }
    }
    return found_;
  }

 private:
  // From shortly before `from_s` until the first frame after `to_s`; empty if the log ends before.
  std::span<const Frame> frames_around(double from_s, double to_s) const {
    const auto at = [this](double time_s) {
      return std::upper_bound(log_.frames.begin(), log_.frames.end(), time_s,
                              [](double s, const Frame& frame) { return s < frame.time_s; });
    };
    const auto last = at(to_s);
    if (last == log_.frames.end()) return {};
    return {at(from_s - kPlayed_s), last + 1};
  }

  void try_kick(double time_s, RobotId kicker, const RobotObservation& robot) {
    const Vec2 ball_m =
        robot.position_m + (kFrontDistance_m + kBallRadius_m + kGap_m) * robot.heading;
    if (std::abs(ball_m.x()) > log_.field.half_length_m() - kFromLines_m ||
        std::abs(ball_m.y()) > log_.field.half_width_m() - kFromLines_m)
      return;
    const Crossing crossing = crossing_of(log_.field, ball_m, robot.heading);
    const bool fits = crossing.line == exit_.line && !is_near_a_post(log_.field, crossing) &&
                      crossing.distance_m < exit_.length_m() &&
                      std::abs(crossing.steepness - exit_.steepness) < kSteepness;
    if (!fits) return;
    Splice splice{&exit_, time_s,   exit_.time_at_s(-crossing.distance_m),
                  kicker, crossing, robot.heading};
    const bool is_seen_at_kick = splice.ball_m(splice.from_s).has_value();
    if (!is_seen_at_kick || exit_.time_at_s(0) - splice.exit_from_s < kShortestSplice_s) return;
    if (!is_quiet(log_, splice.from_s, splice.to_s() + kKick_s)) return;
    const std::span<const Frame> frames = frames_around(splice.from_s, splice.to_s());
    if (frames.empty() || has_gaps(frames) || !is_clear(splice, frames)) return;
    expect_call(splice, log_.decisions.front().blue_on_positive_half);
    found_.push_back(splice);
  }

  const BallExit& exit_;
  const RefereedLog& log_;
  std::vector<Splice> found_;
};

void replace_ball(const std::optional<Vec2>& position_m, league::DetectionFrame& detection) {
  detection.clear_balls();
  if (!position_m) return;
  league::DetectionBall& ball = *detection.add_balls();
  ball.set_confidence(1);
  ball.set_x(league::to_mm(position_m->x()));
  ball.set_y(league::to_mm(position_m->y()));
  ball.set_pixel_x(0);
  ball.set_pixel_y(0);
}

class Splicer {
 public:
  explicit Splicer(const Splice& splice) : splice_(splice) {}

  // Replaces the ball if the record is the cameras'. Returns false after the splice.
  bool takes(league::LogRecord& record) {
    const bool is_vision =
        record.kind == static_cast<std::int32_t>(league::MessageKind::kVision2014) &&
        packet_.ParseFromString(record.message) && packet_.has_detection();
    if (!is_vision) return true;
    league::DetectionFrame& detection = *packet_.mutable_detection();
    if (detection.camera_id() != 0) throw std::invalid_argument("more than one camera");
    if (!first_s_) first_s_ = detection.t_capture();
    const double time_s = detection.t_capture() - *first_s_;
    if (time_s > splice_.to_s()) return false;
    if (time_s >= splice_.from_s) replace_ball(splice_.ball_m(time_s), detection);
    record.message = packet_.SerializeAsString();
    return true;
  }

 private:
  const Splice& splice_;
  league::VisionPacket packet_;
  std::optional<double> first_s_;  // the first frame's time
};

}  // namespace

std::optional<Vec2> Splice::ball_m(double time_s) const {
  const std::optional<BallExit::Detection> ball = exit->at(exit_from_s + time_s - from_s);
  if (!ball) return std::nullopt;
  return Vec2(crossing.position_m + to_world({ball->along_m, ball->across_m}, direction));
}

std::vector<Splice> splices_of(const BallExit& exit, const RefereedLog& log) {
  return SpliceFinder(exit, log).all();
}

void write_spliced(const std::filesystem::path& log, const Splice& splice,
                   const std::filesystem::path& spliced) {
  league::LogReader reader(log);
  league::LogWriter writer(spliced);
  league::LogRecord record;
  Splicer splicer(splice);
  while (reader.read(record) && splicer.takes(record))
    writer.write(record.time_ns, static_cast<league::MessageKind>(record.kind), record.message);
  writer.close();
}

}  // namespace autoref::logs
