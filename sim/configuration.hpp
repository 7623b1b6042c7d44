// Parameters of a simulated world.
#pragma once

#include <boost/container/static_vector.hpp>
#include <stdexcept>
#include <string>

#include "soccer/field.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {

// Two-phase ball model on carpet: the ball slides after a kick, then rolls.
struct BallParameters {
  double slide_mps2 = 3.4;     // deceleration while sliding
  double roll_mps2 = 0.30;     // deceleration while rolling, at low speed
  double roll_per_s = 0.0;     // additional deceleration while rolling, per m/s of speed
  double switch_ratio = 0.67;  // speed at which rolling starts, relative to the kick's speed
  double hop_first_xy = 0.75;  // fraction of the horizontal speed kept at a chip's first landing
  double hop_later_xy = 0.95;  // fraction kept at later landings
  double hop_first_z = 0.5;    // fraction of the vertical speed kept at a chip's first landing
  double hop_later_z = 0.5;    // fraction kept at later landings
  double rest_mps = 0.010;     // below this speed the ball stops
  double rolls_below_hop_m = 0.010;  // a lower bounce ends the flight
  double net_mps2 = 10.0;            // deceleration by the net of a ball leaving a goal
  double mass_kg = 0.046;            // golf ball, 46 g (Laws 2014, law 2)
  // Friction between the ball and what it hits, which removes some of its spin; the league's
  // simulators use 0.2 to 0.35.
  double contact_friction = 0.22;
};

// Contacts between bodies. A restitution is the ratio of separation to closing speed; Box2D uses
// the greater one of a pair. Sources: ER-Force's and grSim's models, and measurements of the
// league's robots.
struct ContactParameters {
  double body_restitution = 0.55;      // ball against a robot's round hull
  double plate_restitution = 0.4;      // ball against a front plate
  double dribbling_restitution = 0.2;  // ball against a front plate with its dribbler running
  double robot_restitution = 0.2;      // robot against robot
  double wall_restitution = 0.3;       // outer walls and sides of the goals
  double net_restitution = 0.1;        // a goal's back
  double bar_restitution = 0.3;        // ball against the crossbar, as for the goal's sides
  // Fraction of the vertical speed that a ball keeps when it lands on a robot or on a goal's net,
  // as on the carpet.
  double top_restitution = 0.5;
  // Minimum speed, upwards and outwards, at which a ball leaves a robot or a net that it landed on,
  // so that no ball stays up there.
  double top_leaving_mps = 0.5;
  double friction = 0.22;  // between bodies sliding along each other (grSim)
  // Slower impacts do not bounce, so that a ball can come to rest against a plate.
  double least_bounce_mps = 0.03;
};

// One robot's body and its drive with four omni wheels; limits are per wheel and overall.
struct RobotParameters {
  double mass_kg = 2.5;
  double speed_mps = 3.0;                // top speed (paper, section 3: up to 3 m/s)
  double acceleration_mps2 = 3.0;        // overall limit when accelerating
  double braking_mps2 = 5.0;             // overall limit when braking
  double wheel_acceleration_mps2 = 4.5;  // tangential limit of each wheel
  double angular_speed_radps = 15.0;
  double angular_acceleration_radps2 = 40.0;
  double front_wheels_deg = 35.0;  // wheels at plus and minus this angle from the front
  double back_wheels_deg = 135.0;
  double wheel_distance_m = 80_mm;  // from the centre to each wheel, inside the 90 mm hull
  double speed_noise = 0.01;        // relative standard deviation of each commanded speed
};

struct KickerParameters {
  double reach_m = 15_mm;        // maximum gap between ball and plate
  double speed_limit_mps = 8.0;  // paper, section 3
  double chip_limit_mps = 5.5;
  double chip_angle_deg = 45.0;
  double dead_time_s = 100_ms;        // between two kicks
  double speed_noise = 0.025;         // relative standard deviation of the ball's speed
  double direction_noise_deg = 1.5;   // standard deviation
  double chip_angle_noise_deg = 0.0;  // standard deviation of a chip's elevation
  bool operator==(const KickerParameters&) const = default;
};

struct DribblerParameters {
  double force_n = 0.45;   // maximum pull on the ball
  double reach_m = 10_mm;  // maximum gap between ball and plate
  bool holds = false;      // cancels all motion of the ball relative to the plate
  // A dribbler that does not hold pulls the ball towards the plate's centre like a spring,
  // saturating at about 5 mm. The damping is near critical for a rolling ball, whose effective mass
  // is one and a half times its own.
  double stiffness_npm = 90.0;
  double damping_nspm = 5.0;
  double centring_mps = 0.2;  // maximum speed at which a holding dribbler centres the ball
  bool operator==(const DribblerParameters&) const = default;
};

// Ball placement: first stops the ball, then carries it over the robots without pushing any.
struct PlacementParameters {
  double speed_mps = 3.0;  // speed of the dragged ball
  double acceleration_mps2 = 4.0;
  double catch_mps2 = 20.0;  // deceleration of a moving ball before it is carried
  // Minimum distance of the ball's centre from the goals: its radius and a margin.
  double clearance_m = 50_mm;
};

// Vision quality. Defaults are the preset `paper`: true positions and the ball's height, as the
// paper's simulator reported them (section 3, "Simulator"). camera_presets.hpp has others.
struct VisionParameters {
  double ball_noise_m = 0.0;  // standard deviation of each coordinate
  double robot_noise_m = 0.0;
  double robot_noise_rad = 0.0;
  double ball_misses = 0.0;    // proportion of frames in which a visible ball is missed
  double robot_misses = 0.0;   // likewise for each robot
  bool reports_height = true;  // false: reports a flying ball at its projection on the carpet
  bool robots_hide_ball = false;
  // 4: above the centres of the field's quarters, at a height of 4 m (Laws 2014, section on
  // vision); 2: above the centres of its halves; 1: above its centre. Each covers its part and this
  // overlap beyond the field's axes.
  int cameras = 4;
  double camera_height_m = 4.0;
  double camera_overlap_m = 0.5;
  // Systematic error of each camera, root mean square over the field: a constant offset and a
  // smooth warp, drawn once per game. Neighbouring cameras have opposite errors, so that they
  // disagree by twice this value.
  double camera_error_m = 0.0;     // of a position
  double camera_error_rad = 0.0;   // of a robot's heading
  double false_balls_per_s = 0.0;  // per robot, each in a single frame, just ahead of the robot
  double misread_numbers = 0.0;    // proportion of detections with the number of a team-mate
  bool operator==(const VisionParameters&) const = default;
};

struct RadioParameters {
  double command_loss = 0.0;  // proportion of commands lost, per robot and frame
  double hold_s = 100_ms;     // a robot that receives no command for this time stops
};

// Where the robots stand before a game: in rows along the touch line, in their own half. Distances
// are between robots' centres.
struct LineUpParameters {
  double gap_m = 300_mm;                // between neighbours; less on short fields
  double from_halfway_line_m = 300_mm;  // distance of the first robot in a row
  double from_touch_line_m = 200_mm;
  double from_goal_line_m = 150_mm;  // minimum distance of the last robot in a row
};

struct Configuration {
  int substeps = 4;               // physics steps per camera frame, 1 to 16
  int contact_free_substeps = 2;  // of a body that can meet nothing; no effect if >= substeps
  bool free_motion = true;        // without Box2D while a body can meet nothing; false: to compare
  double frame_rate_hz = 60.0;
  VisionParameters vision;
  RadioParameters radio;
  // From a frame until the resulting commands move the robots: that of the preset `paper`.
  double latency_s = 5 / 60.0;
  // Standard deviation of what a team believes the latency to be; drawn for each game and team.
  double latency_error_s = 0.0;
  BallParameters ball;
  ContactParameters contacts;
  PlacementParameters placement;
  LineUpParameters line_up;
};

// One robot and its handicap.
struct RobotSpec {
  RobotParameters body;
  KickerParameters kicker;
  DribblerParameters dribbler;
  double speed_factor = 1.0;         // scales the top speed
  double acceleration_factor = 1.0;  // scales acceleration and braking, including the wheels' limit
};

// The robots of one side, by number.
struct TeamSpec {
  using Robots = boost::container::static_vector<RobotSpec, kMaxRobots>;
  Robots robots;
};

// A number outside its allowed range.
class OutOfRange : public std::invalid_argument {
 public:
  // what() is the name followed by `text`, such as "ball.hop_later_z" and " is 2; it must be
  // from 0 to 0.95".
  OutOfRange(const std::string& name, const std::string& text)
      : std::invalid_argument(name + text), name_(name), text_(text) {}

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

 private:
  std::string name_;
  std::string text_;
};

// Throw OutOfRange for the first invalid number. If both sides' robots are checked,
// std::invalid_argument also names side and number, for example "east robot 3: robot.mass_kg is 0;
// ...".
void validate(const Configuration& configuration);
void validate(const RobotSpec& robot);
void validate(const PerSide<TeamSpec>& specs);
void validate(const Field& field);

// The maximum speed of a body with this number of sub-steps: Box2D slows down faster bodies.
double fastest_mps(const Configuration& configuration);

// The maximum speed at which a robot may drive or kick.
double fastest_mps(const RobotSpec& robot);

}  // namespace autoref::sim
