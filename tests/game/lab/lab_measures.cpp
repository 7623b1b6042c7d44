#include "tests/game/lab/lab_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "tests/game/lab/lab_record.hpp"

namespace autoref::game::lab_measures {
namespace {

constexpr double kSlide_mps2 = 3.4;
constexpr double kRoll_mps2 = 0.30;
constexpr double kNet_mps2 = 10.0;  // deceleration in the net, on top of the carpet's
constexpr double kG_mps2 = 9.81;

// Position and speed at which the ball starts to roll, interpolated between the last frame that
// shows it sliding and the first that shows it rolling.
struct Switch {
  double path_m = 0;
  double speed_mps = 0;
};

Switch switch_of(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState&, const WorldState& now) {
    return now.ball.is_rolling && now.ball.velocity_mps.x() > 0.0;
  });
  const BallState& slides = record.states[f - 1].ball;
  const BallState& rolls = record.states[f].ball;
  const double v_mps = slides.velocity_mps.x();
  const double after_s =
      (v_mps - rolls.velocity_mps.x() - kRoll_mps2 * kFrame_s) / (kSlide_mps2 - kRoll_mps2);
  const double start_m = record.states[0].ball.position_m.x();
  return {slides.position_m.x() + v_mps * after_s - kSlide_mps2 * after_s * after_s / 2 - start_m,
          v_mps - kSlide_mps2 * after_s};
}

// Vertical speed of a flying ball at carpet level, before landing or after take-off.
double carpet_mps(const BallState& ball) {
  return std::sqrt(ball.vertical_mps * ball.vertical_mps + 2 * kG_mps2 * ball.height_m);
}

// The first frame after the landing with number `count`, counted from 1.
std::size_t frame_after_landing(const LabRecord& record, int count) {
  return first_frame(record, [&count](const WorldState& former, const WorldState& now) {
    const bool lands = former.ball.vertical_mps < 0.0 && now.ball.vertical_mps > 0.0;
    return lands && --count == 0;
  });
}

double kept_xy(const LabRecord& record, int landing) {
  const std::size_t f = frame_after_landing(record, landing);
  return record.states[f].ball.velocity_mps.x() / record.states[f - 1].ball.velocity_mps.x();
}

// Restitution of a bounce: computed from the frames around it, corrected for the carpet's
// deceleration before and `loses_mps2` after it.
double rebound(const LabRecord& record, int axis, double loses_mps2 = kSlide_mps2) {
  const std::size_t f =
      first_frame(record, [axis](const WorldState& former, const WorldState& now) {
        return former.ball.velocity_mps[axis] > 0.0 && now.ball.velocity_mps[axis] < 0.0;
      });
  const BallState& last = record.states[f - 1].ball;
  const BallState& first = record.states[f].ball;
  const double to_mps = last.velocity_mps[axis];
  const double from_mps = first.velocity_mps[axis];
  const double after_s =
      (first.position_m[axis] - last.position_m[axis] - from_mps * kFrame_s) / (to_mps - from_mps);
  return (-from_mps + loses_mps2 * (kFrame_s - after_s)) / (to_mps - kSlide_mps2 * after_s);
}

// Distance of the ball from its resting position at the plate's middle.
double off_plate_mm(const WorldState& state, std::size_t robot) {
  const RobotState& its = west(state, robot);
  const Vec2 position_m = its.position_m + its.heading * (kFrontDistance_m + kBallRadius_m);
  return 1000 * (state.ball.position_m - position_m).norm();
}

constexpr std::size_t kHardTurn = 360;     // frame of the command to turn hard, at 6 s
constexpr std::size_t kEvenPull = 36;      // frame in the middle of the gentle pull, at 0.6 s
constexpr std::size_t kHardPull = 108;     // frame of the command to pull hard, at 1.8 s
constexpr std::size_t kKickCommand = 348;  // frame of the command to kick, at 5.8 s

double plate_mps(const WorldState& state) {
  const RobotState& its = west(state);
  const Vec2 arm_m = state.ball.position_m - its.position_m;
  return (its.velocity_mps + its.angular_velocity_radps * left_of(arm_m)).norm();
}

}  // namespace

double slide_m(const LabRecord& record) { return switch_of(record).path_m; }
double switch_mps(const LabRecord& record) { return switch_of(record).speed_mps; }

double roll_m(const LabRecord& record) {
  return record.states.back().ball.position_m.x() - record.states[0].ball.position_m.x() -
         slide_m(record);
}

double chip_m(const LabRecord& record) {
  const BallState& last = record.states[frame_after_landing(record, 1) - 1].ball;
  const double falls_s = (last.vertical_mps + carpet_mps(last)) / kG_mps2;
  return last.position_m.x() + last.velocity_mps.x() * falls_s -
         record.states[0].ball.position_m.x();
}

double first_xy(const LabRecord& record) { return kept_xy(record, 1); }
double later_xy(const LabRecord& record) { return kept_xy(record, 2); }

double hop_z(const LabRecord& record) {
  const std::size_t f = frame_after_landing(record, 1);
  return carpet_mps(record.states[f].ball) / carpet_mps(record.states[f - 1].ball);
}

double rebound_x(const LabRecord& record) { return rebound(record, 0); }
double rebound_net(const LabRecord& record) { return rebound(record, 0, kSlide_mps2 + kNet_mps2); }
double rebound_y(const LabRecord& record) { return rebound(record, 1); }

// The restitution of a bounce in the air, where nothing else slows the ball down.
double rebound_flying(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState& former, const WorldState& now) {
    return former.ball.velocity_mps.x() > 0.0 && now.ball.velocity_mps.x() < 0.0;
  });
  return -record.states[f].ball.velocity_mps.x() / record.states[f - 1].ball.velocity_mps.x();
}

double behind_line_mm(const LabRecord& record) {
  return 1000 * (record.states.back().ball.position_m.x() - Field{}.half_length_m());
}

double most_off_in_slow_turn_mm(const LabRecord& record) {
  double most = 0.0;
  for (std::size_t f = 0; f <= kHardTurn; ++f) {
    most = std::max(most, off_plate_mm(record.states[f], 0));
  }
  return most;
}

// The turning rate at which the ball has left the dribbler's reach.
double loses_at_radps(const LabRecord& record) {
  std::size_t f = kHardTurn;
  while (off_plate_mm(record.states.at(f), 0) < 10.0) ++f;
  return west(record.states[f]).angular_velocity_radps;
}

double off_in_slow_pull_mm(const LabRecord& record) {
  return off_plate_mm(record.states[kEvenPull], 0);
}

// Acceleration of the ball while the dribbler pulls with full force: from 5 mm off the plate to the
// end of its reach.
double most_pull_mps2(const LabRecord& record) {
  std::size_t f = kHardPull;
  while (off_plate_mm(record.states.at(f), 0) < 5.0) ++f;
  std::size_t last = f;
  while (off_plate_mm(record.states.at(last + 1), 0) < 10.0) ++last;
  return (record.states[f].ball.velocity_mps.x() - record.states[last].ball.velocity_mps.x()) /
         (static_cast<double>(last - f) * kFrame_s);
}

double is_lost_in_hard_pull(const LabRecord& record) {
  return off_plate_mm(record.states.back(), 0) > 100.0 ? 1.0 : 0.0;
}

double most_off_when_held_mm(const LabRecord& record) {
  double most = 0.0;
  for (std::size_t f = 0; f <= kKickCommand; ++f) {
    most = std::max(most, off_plate_mm(record.states[f], 0));
  }
  return most;
}

// The largest difference between the ball's speed and the plate's, using the faster of the plate's
// speeds in the same and the previous frame.
double most_faster_when_held_mps(const LabRecord& record) {
  double most = 0.0;
  for (std::size_t f = 1; f <= kKickCommand; ++f) {
    const double plates_mps =
        std::max(plate_mps(record.states[f - 1]), plate_mps(record.states[f]));
    most = std::max(most, record.states[f].ball.velocity_mps.norm() - plates_mps);
  }
  return most;
}

double kicked_mps(const LabRecord& record) {
  return record.states[kKickCommand + 1].ball.velocity_mps.norm() + kSlide_mps2 * kFrame_s;
}

// In the first frame in which the ball moves forwards.
double kick_on_the_run_deg(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState&, const WorldState& now) {
    return now.ball.velocity_mps.x() > 1.0;
  });
  const WorldState& kicked = record.states[f];
  const Vec2& heading = kicked.robots[Side::kWest][0].heading;
  return angle_between(heading, kicked.ball.velocity_mps) * 180.0 / kPi;
}

// In the last frame before the ball is within reach of the receiver's dribbler.
double arrival_mps(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState& former, const WorldState& now) {
    const sim::RobotState& receiver = now.robots[Side::kWest][1];
    const double gap_m =
        receiver.position_m.x() - kFrontDistance_m - kBallRadius_m - now.ball.position_m.x();
    return former.ball.is_rolling && gap_m < sim::DribblerParameters{}.reach_m;
  });
  return record.states[f - 1].ball.velocity_mps.x();
}

double received_off_mm(const LabRecord& record) { return off_plate_mm(record.states.back(), 1); }

}  // namespace autoref::game::lab_measures
