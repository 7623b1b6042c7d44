// Plays a short game with a noisy camera and writes one touch in that game as tables for gnuplot:
//
//     touch_example FOLDER       called by scripts/draw-touch-example
//
// The chosen touch is the last one before the ball's first exit at which the online detector is
// wrong and the retrospective detector is right.
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "game/loop/game.hpp"
#include "referee/touch/hypothesis_tracker.hpp"
#include "referee/touch/online_touch_detector.hpp"
#include "sim/presets.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::referee {
namespace {

constexpr double kBefore_s = 0.5;  // the tables begin this long before the online detector's touch

bool is_play(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

class TouchExample final : public game::Observer {
 public:
  TouchExample(const tracking::VisionNoise& noise, std::string folder)
      : folder_(std::move(folder)), online_(history_, Field{}, TouchParameters{}, noise) {
    parameters_.motion.detection_m = noise.ball_m;
    parameters_.intersection.robot_m = noise.robot_m;
    parameters_.intersection.robot_rad = noise.robot_rad;
    parameters_.near_m += 3 * noise.ball_m;
  }

  void on_decision(const Decision& decision) override {
    const Event event = decision.finding.event;
    is_exit_ = event == Event::kThrowIn || event == Event::kCornerKick || event == Event::kGoalKick;
    called_ = decision.last_touch.side;
  }

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    if (!world.touches().empty()) true_touch_ = world.touches().back();
    if (is_play_) {
      frames_.push_back(frame);
      history_.push(frame);
      online_.update();
      const Side truth = true_touch_.robot.side;
      if (is_exit_ && online_.last().side != truth && called_ == truth) write();
    }
    is_exit_ = false;
    const bool starts = !is_play_ && is_play(signal.command.kind);
    is_play_ = is_play(signal.command.kind);
    if (!starts) return;
    frames_ = {frame};
    history_.restart(frame, world.state().ball.position_m);
    online_.restart();
  }

 private:
  void write() {
    if (std::exchange(is_written_, true)) return;
    write_ball();
    const auto touched = std::find_if(frames_.begin(), frames_.end(), [this](const Frame& frame) {
      return frame.number >= true_touch_.frame;
    });
    write_robots(*touched);
    fmt::output_file(folder_ + "/touch.dat")
        .print("{:.4f} {:.4f} {:.4f} {:.4f}\n", true_touch_.ball_m.x(), true_touch_.ball_m.y(),
               touched->time_s, online_.last().time_s);
  }

  // For each detection: time and position; the prediction, the radius of its gate and the
  // normalised innovation squared; and the minimum deviance, given the detections so far, for the
  // cases that no robot, a west robot or an east robot made the last touch.
  void write_ball() {
    auto out = fmt::output_file(folder_ + "/ball.dat");
    FrameHistory history;
    const Field field;
    BallMotionFilter filter;
    std::int64_t first = 0;
    for (const Frame& frame : frames_) {
      const double before_s = history[history.newest()].ball.time_s;
      history.push(frame);
      if (!frame.ball || frame.time_s < online_.last().time_s - kBefore_s) continue;
      const Vec2& ball_m = frame.ball->position_m;
      out.print("{:.4f} {:.4f} {:.4f} ", frame.time_s, ball_m.x(), ball_m.y());
      if (first == 0) {
        first = history.newest();
        filter.start(ball_m, parameters_.motion);
        out.print("{:.4f} {:.4f} 0 0 ", ball_m.x(), ball_m.y());
      } else {
        write_innovation(out, filter, ball_m, frame.time_s - before_s);
      }
      SideMinima before;
      before.offer(kNobody, 0, {});
      const SideMinima best = HypothesisTracker({field, parameters_, history}).track(first, before);
      out.print("{:.2f} {:.2f} {:.2f}\n", best.deviance[kNobody], best.deviance[kWest],
                best.deviance[kEast]);
    }
  }

  // Predicts and corrects the filter. An innovation outside the gate counts as a touch.
  void write_innovation(fmt::ostream& out, BallMotionFilter& filter, const Vec2& ball_m,
                        double duration_s) const {
    filter.predict(duration_s, parameters_.motion);
    const Vec2 predicted_m = filter.position_after(0);
    const double variance_m2 =
        filter.position_variance_after(0) + square(parameters_.motion.detection_m);
    const double gate_m = parameters_.surely * std::sqrt(variance_m2);
    const double off_m = (ball_m - predicted_m).norm();
    out.print("{:.4f} {:.4f} {:.4f} {:.3f} ", predicted_m.x(), predicted_m.y(), gate_m,
              square(off_m) / variance_m2);
    if (off_m > gate_m) filter.touch(duration_s, false, parameters_.motion);
    filter.correct(ball_m, parameters_.motion);
  }

  // Hulls as closed lines, one file per side.
  void write_robots(const Frame& frame) {
    for (const Side side : kSides) {
      auto out = fmt::output_file(folder_ + (side == Side::kWest ? "/west.dat" : "/east.dat"));
      for (const RobotObservation& robot : frame.robots[side]) {
        for (int degree = 0; degree <= 360; degree += 5) {
          Vec2 corner_m = kRobotRadius_m * heading_of(to_radians(degree));
          corner_m.x() = std::min(corner_m.x(), kFrontDistance_m);
          const Vec2 at_m = robot.position_m + to_world(corner_m, robot.heading);
          out.print("{:.4f} {:.4f}\n", at_m.x(), at_m.y());
        }
        out.print("\n");
      }
    }
  }

  std::string folder_;
  TouchHypothesisParameters parameters_;
  FrameHistory history_;
  OnlineTouchDetector online_;
  std::vector<Frame> frames_;  // frames of the current play
  bool is_play_ = false;
  bool is_exit_ = false;        // whether the referee has just called an exit of the ball
  std::optional<Side> called_;  // side of the last touch in that call
  bool is_written_ = false;
  sim::Touch true_touch_;
};

}  // namespace
}  // namespace autoref::referee

int main(int argc, char** argv) {
  using namespace autoref;
  if (argc != 2) return 2;
  game::GameConfiguration game;
  game.match.half_s = 75;
  game.seed = 6;
  sim::apply_camera_preset("realistic", game.sim);
  const auto& vision = game.sim.vision;
  referee::TouchExample example({vision.ball_noise_m, vision.robot_noise_m, vision.robot_noise_rad},
                                argv[1]);
  game::play(game, &example);
  return 0;
}
