#include "referee/touch/meetings.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kNear_m = 0.3;  // robots farther from the ball need no look
constexpr int kSamples = 16;     // of the time between pictures
constexpr int kSamplesUnseen = 6;

struct Sample {
  Vec2 ball_m{0, 0};
  double time_s = 0;
  double variance_m2 = 0;  // of a gap
};

struct Pose {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
};

class Walker {
 public:
  Walker(const FreeWay& way, bool goes_back, const MeetingParameters& parameters)
      : way_(way), goes_back_(goes_back), parameters_(parameters) {}

  // From one picture to the next; without its beginning, unless it is the first.
  void go(const Picture& from, const Picture& to, int samples, double start_s, bool is_first) {
    for (int i = is_first ? 0 : 1; i <= samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      const double time_s = from.time_s + (to.time_s - from.time_s) * share;
      look(from, to, share, sample_at(time_s, start_s));
    }
  }

  const Walk& walk() const { return walk_; }

 private:
  Sample sample_at(double time_s, double start_s) const {
    const double gap_m2 = square(parameters_.contact_m) + square(parameters_.robot_m);
    return {way_.place_after(time_s - start_s), time_s,
            gap_m2 + way_.place_variance_after(time_s - start_s)};
  }

  void look(const Picture& from, const Picture& to, double share, const Sample& sample) {
    double through_cost = walk_.through_cost;
    for (const Picture::Robot& robot : from.robots) {
      if ((robot.position_m - sample.ball_m).squaredNorm() > square(kNear_m)) continue;
      const Pose pose = pose_of(robot, to, share);
      const double gap_m =
          distance_to_hull(sample.ball_m, pose.position_m, pose.heading) - kBallRadius_m;
      Meeting* meeting = meeting_with(robot.id, gap_m);
      if (meeting == nullptr) continue;
      weigh(*meeting, pose, gap_m, sample);
      const double inside_m = std::max(0.0, -gap_m - parameters_.slack_m);
      through_cost = std::max(through_cost, square(inside_m) / sample.variance_m2);
    }
    walk_.through_cost = through_cost;
  }

  static Pose pose_of(const Picture::Robot& robot, const Picture& to, double share) {
    const auto other = std::find_if(to.robots.begin(), to.robots.end(),
                                    [&robot](const auto& r) { return r.id == robot.id; });
    if (other == to.robots.end()) return {robot.position_m, robot.heading};
    const Vec2 heading = robot.heading + (other->heading - robot.heading) * share;
    return {robot.position_m + (other->position_m - robot.position_m) * share,
            direction_of(heading, robot.heading)};
  }

  Meeting* meeting_with(RobotId id, double gap_m) {
    Meetings& met = walk_.met;
    for (std::size_t i = 0; i < met.size(); ++i) {
      if (met[i].robot == id) return &met[i];
    }
    if (met.size() == met.capacity()) return nullptr;
    Meeting meeting;
    meeting.robot = id;
    met.push_back(meeting);
    former_gaps_m_.push_back(gap_m);
    return &met.back();
  }

  void weigh(Meeting& meeting, const Pose& pose, double gap_m, const Sample& sample) {
    double& former_gap_m = former_gaps_m_[static_cast<std::size_t>(&meeting - &walk_.met[0])];
    const bool crosses = (gap_m > 0) != (former_gap_m > 0);
    former_gap_m = gap_m;
    meeting.least_gap_m = std::min(meeting.least_gap_m, gap_m);
    const double least = std::min(meeting.bounce_cost, meeting.kick_cost);
    const double off_m = crosses ? 0 : std::max(0.0, std::abs(gap_m) - parameters_.slack_m);
    const double bounce_cost = walk_.through_cost + square(off_m) / sample.variance_m2;
    const double kick_cost = walk_.through_cost + cost_of_kick(pose, sample);
    meeting.bounce_cost = std::min(meeting.bounce_cost, bounce_cost);
    meeting.kick_cost = std::min(meeting.kick_cost, kick_cost);
    if (std::min(bounce_cost, kick_cost) >= least) return;
    meeting.time_s = sample.time_s;
    meeting.gap_m = std::max(0.0, gap_m);
  }

  double cost_of_kick(const Pose& pose, const Sample& sample) const {
    const Vec2 local_m = to_local(sample.ball_m - pose.position_m, pose.heading);
    const double off_m = 3 * std::sqrt(sample.variance_m2);
    const double before_m = local_m.x() - kFrontDistance_m - kBallRadius_m;
    const bool in_mouth = local_m.x() > kFrontDistance_m - 5_mm &&
                          before_m <= parameters_.reach_m + off_m &&
                          std::abs(local_m.y()) <= kMouthWidth_m / 2 + off_m;
    if (!in_mouth) return kNever;
    if (!goes_back_) return 0;
    const Vec2 along_mps = to_local(way_.velocity_mps(), pose.heading);
    const double angle_variance = square(parameters_.kick_rad) + square(parameters_.robot_rad);
    const double variance =
        angle_variance * along_mps.squaredNorm() + way_.velocity_variance_m2ps2();
    return (square(along_mps.y()) + square(std::min(0.0, along_mps.x()))) / variance;
  }

  const FreeWay& way_;
  bool goes_back_;
  const MeetingParameters& parameters_;
  Walk walk_;
  boost::container::static_vector<double, Meetings::static_capacity> former_gaps_m_;
};

}  // namespace

Walk walk(const FreeWay& way, const Pictures& pictures, std::int64_t from, std::int64_t to,
          const MeetingParameters& parameters) {
  const int step = to > from ? 1 : -1;
  const int samples = from + step == to ? kSamples : kSamplesUnseen;
  Walker walker(way, step < 0, parameters);
  for (std::int64_t i = from; i != to; i += step) {
    walker.go(pictures[i], pictures[i + step], samples, pictures[from].time_s, i == from);
  }
  return walker.walk();
}

}  // namespace autoref::referee
