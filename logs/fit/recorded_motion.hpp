// The motion of ball and robots in a part of a log, as vision reported it, for estimating the
// parameters of a simulation.
//
// Unlike the referee's tracks, nothing is smoothed here: positions are detections, with their own
// times of capture and from one camera as long as that camera sees the object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// Where the ball was in a frame.
struct BallSight {
  Vec2 position_m{0, 0};     // interpolated between detections if it is not seen
  double time_s = 0;         // time of the capture; the frame's time if it is not seen
  std::uint32_t camera = 0;  // the camera that saw it, or that saw it last
  bool is_seen = false;
};

struct RobotSight {
  Vec2 position_m{0, 0};   // interpolated if it is not seen
  double heading_rad = 0;  // continuous: it may leave [-pi, pi]
  std::uint32_t camera = 0;
  bool is_seen = false;
  bool is_known = false;  // seen, or missed for at most kLongestGap_s
  double time_s = 0;      // of the capture; the frame's time if it is not seen
};

struct RobotMotion {
  RobotId id;                      // yellow is west
  std::vector<RobotSight> sights;  // one per frame
};

// A detection of a ball that is not the ball in play.
struct OtherBall {
  std::size_t frame = 0;
  Vec2 position_m{0, 0};
};

// A robot that two cameras see in the same frame.
struct DoubleSight {
  std::size_t frame = 0;
  RobotId id;
  std::uint32_t first_camera = 0;  // with a smaller number than the second
  std::uint32_t second_camera = 0;
  Vec2 difference_m{0, 0};  // from where the first camera sees it to where the second one does
};

// A part of a log. All vectors with one element per frame have the same size, at least 4.
struct RecordedMotion {
  static constexpr double kLongestGap_s = 0.5;
  static constexpr double kLongest_s = 900;
  static constexpr double kLeastNoise_m = 1e-4;  // what a simulation's steps or rounding leave
  static constexpr std::size_t kMostFrames = 90'000;

  Field field;  // standard values where the log's geometry has none
  std::map<std::uint32_t, CameraPosition> cameras;  // those in the log's geometry
  bool has_heights = false;                         // whether vision reports the ball's height
  double interval_s = 0;                            // median time between two frames

  std::vector<double> times_s;  // of the latest capture in a frame; increasing
  // Whether the recorded referee's last command lets play run; always before the first one.
  std::vector<char> is_running;
  std::vector<BallSight> ball;
  std::vector<RobotMotion> robots;  // those seen in at least 2 % of the frames
  std::vector<OtherBall> other_balls;
  std::vector<std::size_t>
      spikes;  // frames whose ball was dropped because it was far off its track

  std::vector<double>
      nearest_m;  // distance from the ball to the nearest robot's centre; 9 m if none
  std::vector<std::size_t> nearest_robot;  // its index in `robots`

  std::map<std::uint32_t, std::vector<double>> captures_s;  // of each camera, increasing
  std::vector<DoubleSight> double_sights;                   // in order of frames

  double ball_noise_m = 0;  // standard deviation in x and y, at least kLeastNoise_m

  std::size_t frames() const { return times_s.size(); }
  // The robot's pose between two frames; its `is_seen` is true if both frames see it. Times outside
  // the recording give the first or last pose.
  RobotSight robot_at(std::size_t robot, double time_s) const;
  // The last frame whose time is at most `time_s`; 0 if there is none.
  std::size_t frame_at(double time_s) const;
};

// Passes on the log in parts of at most kLongest_s and kMostFrames, in order. `path` must be
// readable several times (user_log.hpp). Parts that are shorter than a second, or that
// have less than 5 or more than 1000 frames a second, are left out. Throws
// league::LogError if the file is not a log. Returns the number of vision packets.
std::int64_t for_each_motion(const std::string& path,
                             const std::function<void(const RecordedMotion&)>& use);

}  // namespace autoref::logs
