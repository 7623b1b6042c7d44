// A side that repeats what it did in a recorded game, whatever the other side does now.
//
// Its robots are moved along their recorded paths. The ball follows the recording as well until the
// first touch that differs from it. Whenever a robot of the other side touches the ball, in the
// recording or now, the ball moves as in any other game until shortly after the touch. If it then
// moves as recorded, the touch did not differ, and the ball follows the recording again. Otherwise,
// it stays free, and the ghosts are obstacles to it.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim/world.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// The recorded robots of the side, by number, and the ball at one time.
struct GhostFrame {
  double time_s = 0;  // since the start of the game
  sim::RobotStates robots;
  std::optional<sim::BallState> ball;  // nullopt while the ball is not tracked
};

struct Ghost {
  Side side = Side::kWest;
  std::vector<GhostFrame> frames;  // in increasing order of time, the first one at 0; not empty
  std::vector<double> touches_s;   // when the other side touched the ball in the recording
};

// A position or direction, a robot or a ball as seen from the other end: rotated by 180 degrees.
// No component becomes -0.
Vec2 mirrored(const Vec2& vector);
sim::RobotState mirrored(const sim::RobotState& robot);
sim::BallState mirrored(const sim::BallState& ball);

// The ghost as seen from the other end: rotated by 180 degrees, on the other side.
Ghost mirrored(const Ghost& ghost);

// Moves a ghost through a game.
class GhostMover {
 public:
  explicit GhostMover(Ghost ghost) : ghost_(std::move(ghost)) {}

  Side side() const { return ghost_.side; }

  // Puts robots and ball where they were at `time_s`, interpolated between frames. After the last
  // frame, the robots stand still and the ball is free. A robot that the recording does not show
  // stays where it is, and robots off the field stay off. While the recording does not show the
  // ball, it moves as in any other game. Call after every step of the world, in order of time.
  void move(double time_s, sim::World& world);

  // Whether the ball follows the recording now, and whether it never will again.
  bool moves_ball() const { return !is_free_ && !touch_; }
  bool is_ball_free() const { return is_free_; }

 private:
  // A touch that has not been judged yet, or several in quick succession.
  struct PendingTouch {
    double first_s = 0;
    double last_s = 0;
  };

  bool touches_until(double time_s, const sim::World& world);
  void follow_touches(double time_s, const std::optional<sim::BallState>& recorded,
                      const sim::World& world);

  Ghost ghost_;
  std::size_t next_ = 0;        // the first frame later than the last time
  std::size_t next_touch_ = 0;  // the first recorded touch later than the last time
  std::optional<PendingTouch> touch_;
  bool is_free_ = false;
};

}  // namespace autoref::game
