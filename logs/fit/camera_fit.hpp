// How the cameras of recorded games see ball and robots, as parameters of simulated vision.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "logs/fit/miss_curve.hpp"
#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// How often the ball was seen in frames in which it was about `distance_m` from the centre of the
// nearest robot.
struct SeenShare {
  double distance_m = 0;
  std::int64_t frames = 0;
  std::int64_t seen = 0;
};

// Collects how vision sees the objects in parts of logs, and estimates the parameters of
// sim::VisionParameters with the same names. All parts count the same, from whichever log.
class CameraFit {
 public:
  CameraFit();

  void add(const RecordedMotion& motion);

  Estimate frame_rate_hz() const;

  // Standard deviations of the noise that changes from frame to frame.
  Estimate ball_noise_m() const;     // of balls away from robots
  Estimate robot_noise_m() const;    // of robots that stand still
  Estimate robot_noise_rad() const;  // of the same robots' headings

  // Standard deviations, along x and y, of the part of the noise that changes slowly: of the mean
  // positions of resting objects in windows of a quarter of a second, beyond what the noise above
  // explains. Errors that stay the same for seconds are not included, and a third of the deviation
  // is missed if the drift's memory is one second. For robots, only the calmest tenth of rests
  // counts, as robots that hold their position move a little themselves. 0 if the drift may be
  // zero, or at most that motion.
  Estimate ball_drift_m() const;
  Estimate robot_drift_m() const;

  // The three parameters of the probability that a ball which no robot hides is not seen:
  // 1 - (1 - ball_misses) (1 - ball_misses_near_robots exp(-gap / near_robots_m)), where `gap` is
  // the distance of the ball's centre from a disc of kRobotRadius_m. Whether a robot hides the ball
  // is only known in logs with camera positions. Otherwise, or if the ball was rarely near robots,
  // the first comes from balls far from robots, and the others have no result.
  Estimate ball_misses() const;
  Estimate ball_misses_near_robots() const;
  Estimate near_robots_m() const;

  // A robot is missed in single frames, or in gaps of one frame to twice the mean duration.
  Estimate robot_misses() const;  // share of frames
  Estimate robot_gaps() const;    // share of frames
  Estimate robot_gap_s() const;   // mean duration

  // Rate of balls that appear right ahead of a robot while the ball is elsewhere, per robot.
  Estimate false_balls_per_s() const;

  // Frames with the ball on the field, including those in which a robot hides it.
  const std::vector<SeenShare>& ball_seen() const { return ball_seen_; }

 private:
  // Mean squares of the noise of a robot that stands still for some frames.
  struct StillRobot {
    double noise_m2 = 0;
    double noise_rad2 = 0;
  };
  // Of all robots together. Missed frames that follow each other are a run.
  struct RobotCounts {
    double frames = 0;
    double missed = 0;
    double long_runs = 0;
    double missed_in_long_runs = 0;
  };
  struct FalseBalls {
    double count = 0;
    double robots_s = 0;  // time in which robots could have had one, summed over robots
  };
  static constexpr std::size_t kGapBins = 201;
  static constexpr std::size_t kFarBin = 50;  // without misses near robots and hiding from here on
  static constexpr int kLongRun = 4;          // misses of single frames hardly make up longer runs
  using GapBins = std::array<GapBin, kGapBins>;

  // What some seconds of a part show. Blocks are the groups of the bootstrap.
  struct Block {
    std::vector<double> intervals_s;
    std::vector<double> ball_differences_m;  // absolute third differences in x and y
    std::vector<StillRobot> still_robots;
    GapBins gaps;
    RobotCounts robots;
    FalseBalls false_balls;
  };
  using Groups = std::span<const std::size_t>;  // blocks
  struct MissEstimates {
    Estimate far;
    Estimate near;
    Estimate near_m;
  };
  struct RobotMissEstimates {
    Estimate misses;
    Estimate gaps;
    Estimate gap_s;
  };

  Block& block_at(const RecordedMotion& motion, std::size_t frame);
  void add_intervals(const RecordedMotion& motion);
  void add_ball_noise(const RecordedMotion& motion);
  void add_still_robots(const RecordedMotion& motion, const RobotMotion& robot);
  void add_ball_sights(const RecordedMotion& motion);
  void count_ball(const RecordedMotion& motion, std::size_t frame, const Vec2& ball_m);
  void add_robot_sights(const RecordedMotion& motion, const RobotMotion& robot);
  void add_false_balls(const RecordedMotion& motion);

  Estimate robot_noise(double StillRobot::*noise2) const;
  GapBins gaps_of(Groups groups) const;
  MissEstimates miss_estimates() const;
  Estimate far_misses() const;
  RobotCounts robot_counts(Groups groups) const;
  RobotMissEstimates robot_miss_estimates() const;

  std::vector<Block> blocks_;
  std::size_t first_block_ = 0;         // of the part that is being added
  std::vector<double> ball_drifts_m2_;  // excess variance of window means, one per rest
  std::vector<double> robot_drifts_m2_;
  std::vector<SeenShare> ball_seen_;
};

}  // namespace autoref::logs
