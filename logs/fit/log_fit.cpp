#include "logs/fit/log_fit.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "logs/fit/chip_fit.hpp"
#include "logs/fit/contact_fit.hpp"
#include "logs/fit/kick_fit.hpp"
#include "logs/fit/kicks.hpp"
#include "logs/fit/robot_fit.hpp"

namespace autoref::logs {
namespace {

// The numbers of vision keep what was seen in each second; those of robots and ball keep less.
constexpr double kLongestVision_s = 36'000;

// The fits of the second pass need the ball's decelerations, those of the third pass also the ratio
// at which it begins to roll.
class Fitter {
 public:
  explicit Fitter(const std::vector<NamedLog>& logs) : logs_(logs) {}

  LogFit result() {
    fit_.packets =
        pass([&](const NamedLog& log, const RecordedMotion& motion) { add_first(log, motion); });
    const RollEstimates roll = ball_.roll();
    take("roll_mps2", roll.roll_mps2, ball_model_.roll_mps2);
    take("roll_per_s", roll.roll_per_s, ball_model_.roll_per_s);
    take("slide_mps2", ball_.slide_mps2(), ball_model_.slide_mps2);
    pass([&](const NamedLog& /*log*/, const RecordedMotion& motion) {
      const std::vector<Kick> kicks = kicks_in(motion, ball_model_);
      kicks_.insert(kicks_.end(), kicks.begin(), kicks.end());
      directions_.add(motion, kicks);
    });
    take("switch_ratio", switch_ratio_of(kicks_), ball_model_.switch_ratio);
    ContactFit contacts(ball_model_);
    pass([&](const NamedLog& /*log*/, const RecordedMotion& motion) { contacts.add(motion); });
    fill_ball(contacts);
    fill_vision();
    fill_teams();
    return std::move(fit_);
  }

 private:
  // Returns the number of vision packets.
  template <typename Use>
  std::int64_t pass(const Use& use) {
    std::int64_t packets = 0;
    for (const NamedLog& log : logs_)
      packets += for_each_motion(log.path, [&](const RecordedMotion& motion) { use(log, motion); });
    return packets;
  }

  // Adds a number of the ball, which later passes use.
  void take(const char* key, const Estimate& estimate, double& parameter) {
    fit_.ball.push_back({"ball", key, estimate});
    if (estimate.number) parameter = estimate.number->value;
  }

  void add_first(const NamedLog& log, const RecordedMotion& motion) {
    ball_.add(motion);
    chips_.add(motion);
    if (fit_.length_s < kLongestVision_s) camera_.add(motion);
    rig_.add(motion);
    for (const Side side : kSides) {
      const std::string& name = log.names[side];
      const bool is_unclear = name.empty() || name == log.names[opponent_of(side)];
      teams_[is_unclear ? colour_of(side) : name].add(motion, side);
    }
    fit_.reports_height = fit_.reports_height || motion.has_heights;
    fit_.length_s += motion.times_s.back() - motion.times_s.front();
    fit_.running_s += motion.interval_s * static_cast<double>(std::count_if(
                                              motion.is_running.begin(), motion.is_running.end(),
                                              [](char is_running) { return is_running != 0; }));
    if (!motion.cameras.empty()) {
      const double sum_m = std::accumulate(
          motion.cameras.begin(), motion.cameras.end(), 0.0,
          [](double sum, const auto& camera) { return sum + camera.second.height_m; });
      fit_.camera_height_m = sum_m / static_cast<double>(motion.cameras.size());
    }
  }

  // Unknown without the noise of headings, which scatters the angles, too.
  Estimate direction_noise_deg() const {
    const Estimate noise_rad = camera_.robot_noise_rad();
    Estimate estimate =
        directions_.direction_noise_deg(noise_rad.number ? noise_rad.number->value : 0);
    if (!noise_rad.number) estimate.number.reset();
    return estimate;
  }

  static std::string colour_of(Side side) { return side == Side::kWest ? "yellow" : "blue"; }

  void fill_ball(const ContactFit& contacts) {
    fit_.ball.insert(fit_.ball.end(),
                     {{"ball", "hop_first_xy", chips_.hop_first_xy()},
                      {"ball", "hop_first_z", chips_.hop_first_z()},
                      {"ball", "hop_later_xy", chips_.hop_later_xy()},
                      {"contacts", "wall_restitution", contacts.wall_restitution()},
                      {"contacts", "body_restitution", contacts.body_restitution()}});
    fit_.kicker = {{"kicker", "direction_noise_deg", direction_noise_deg()},
                   {"kicker", "chip_angle_deg", chips_.chip_angle_deg()},
                   {"kicker", "chip_angle_noise_deg", chips_.chip_angle_noise_deg()}};
    fit_.roll_prediction = ball_.roll_prediction(sim::BallParameters{});
  }

  void fill_vision() {
    fit_.vision = {{"", "frame_rate_hz", camera_.frame_rate_hz()},
                   {"vision", "ball_noise_m", camera_.ball_noise_m()},
                   {"vision", "robot_noise_m", camera_.robot_noise_m()},
                   {"vision", "robot_noise_rad", camera_.robot_noise_rad()},
                   {"vision", "ball_misses", camera_.ball_misses()},
                   {"vision", "ball_misses_near_robots", camera_.ball_misses_near_robots()},
                   {"vision", "near_robots_m", camera_.near_robots_m()},
                   {"vision", "robot_misses", camera_.robot_misses()},
                   {"vision", "robot_gaps", camera_.robot_gaps()},
                   {"vision", "robot_gap_s", camera_.robot_gap_s()},
                   {"vision", "false_balls_per_s", camera_.false_balls_per_s()},
                   {"vision", "camera_error_m", rig_.camera_error_m()}};
    fit_.drifts = {{"", "ball_drift_m", camera_.ball_drift_m()},
                   {"", "robot_drift_m", camera_.robot_drift_m()}};
    fit_.cameras = rig_.cameras();
    fit_.cameras_run_freely = rig_.cameras_run_freely();
    fit_.ball_seen = camera_.ball_seen();
  }

  void fill_teams() {
    fit_.teams.reserve(teams_.size());
    for (const auto& [name, team] : teams_) {
      fit_.teams.push_back(
          {name,
           {{"robot", "speed_mps", team.speed_mps()},
            {"robot", "acceleration_mps2", team.acceleration_mps2()},
            {"robot", "braking_mps2", team.braking_mps2()},
            {"robot", "angular_speed_radps", team.angular_speed_radps()},
            {"robot", "angular_acceleration_radps2", team.angular_acceleration_radps2()}}});
    }
  }

  const std::vector<NamedLog>& logs_;
  LogFit fit_;
  sim::BallParameters ball_model_;
  BallFit ball_;
  ChipFit chips_;
  CameraFit camera_;
  RigFit rig_;
  std::map<std::string, RobotFit> teams_;
  std::vector<Kick> kicks_;
  KickFit directions_;
};

}  // namespace

LogFit fit_of(const std::vector<NamedLog>& logs) { return Fitter(logs).result(); }

}  // namespace autoref::logs
