// Parameters of a simulated world.
#pragma once

#include <boost/container/static_vector.hpp>

#include "soccer/field.hpp"
#include "soccer/parameters.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {

// Two-phase ball model on carpet: the ball slides after a kick, then rolls.
struct BallParameters {
  double slide_mps2 = 3.4;
  double roll_mps2 = 0.30;
  double roll_per_s = 0.0;
  double switch_ratio = 0.67;
  double hop_first_xy = 0.75;
  double hop_later_xy = 0.95;
  double hop_first_z = 0.5;
  double hop_later_z = 0.5;
  double rest_mps = 0.010;
  double rolls_below_hop_m = 0.010;
  double net_mps2 = 10.0;
  double mass_kg = 0.046;          // golf ball, 46 g (Laws 2014, law 2)
  double contact_friction = 0.22;  // the league's simulators use 0.2 to 0.35

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.slide_mps2, {"slide_mps2", positive(100), "deceleration when sliding"});
    visitor(self.roll_mps2, {"roll_mps2", positive(100), "deceleration when rolling"});
    visitor(self.roll_per_s,
            {"roll_per_s", {0, 1}, "additional deceleration when rolling, per m/s of speed"});
    visitor(
        self.switch_ratio,
        {"switch_ratio", {0.05, 0.95}, "the ball rolls below this fraction of the kick's speed"});
    visitor(self.hop_first_xy,
            {"hop_first_xy", kFraction, "fraction of horizontal speed kept at the first landing"});
    visitor(self.hop_later_xy,
            {"hop_later_xy", kFraction, "fraction of horizontal speed kept at later landings"});
    visitor(self.hop_first_z,
            {"hop_first_z", {0, 0.95}, "fraction of vertical speed kept at the first landing"});
    visitor(self.hop_later_z,
            {"hop_later_z", {0, 0.95}, "fraction of vertical speed kept at later landings"});
    visitor(self.rest_mps, {"rest_mps", {0, 1}, "the ball is at rest below this speed"});
    visitor(self.rolls_below_hop_m,
            {"rolls_below_hop_m", positive(1), "a hop lower than this ends the flight"});
    visitor(self.net_mps2, {"net_mps2", {0, 1000}, "deceleration in the goal net"});
    visitor(self.mass_kg, {"mass_kg", {0.001, 1}, "mass of the ball"});
    visitor(self.contact_friction,
            {"contact_friction",
             {0, 2},
             "friction between the ball and anything it hits; changes the ball's spin"});
  }
};

// Contacts between bodies. A restitution is the ratio of separation speed to closing speed. For a
// pair of bodies, Box2D uses the greater restitution. Sources: ER-Force's and grSim's models, and
// measurements of the league's robots.
struct ContactParameters {
  double body_restitution = 0.55;
  double plate_restitution = 0.4;
  double dribbling_restitution = 0.2;
  double robot_restitution = 0.2;
  double wall_restitution = 0.3;
  double net_restitution = 0.1;
  double bar_restitution = 0.3;  // the same as for the goal's sides
  double top_restitution = 0.5;  // the same as for the carpet
  // Minimum speed, upwards and outwards, at which a ball leaves a robot or a net that it has landed
  // on, so that it does not stay there.
  double top_leaving_mps = 0.5;
  double friction = 0.22;  // grSim
  // Minimum speed of a bounce; it lets a ball come to rest against a plate.
  double least_bounce_mps = 0.03;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.body_restitution, {"body_restitution", kFraction, "ball and a robot's hull"});
    visitor(self.plate_restitution, {"plate_restitution", kFraction, "ball and front plate"});
    visitor(self.dribbling_restitution,
            {"dribbling_restitution", kFraction, "ball and front plate with the dribbler on"});
    visitor(self.robot_restitution, {"robot_restitution", kFraction, "two robots"});
    visitor(self.wall_restitution,
            {"wall_restitution", kFraction, "walls around the field and goal sides"});
    visitor(self.net_restitution, {"net_restitution", kFraction, "back wall of a goal"});
    visitor(self.bar_restitution, {"bar_restitution", kFraction, "ball and goal bar"});
    visitor(self.top_restitution,
            {"top_restitution",
             {0, 0.95},
             "fraction of vertical speed kept by a bounce on top of a robot or goal"});
    visitor(self.top_leaving_mps, {"top_leaving_mps",
                                   {0.05, 5},
                                   "minimum speed of a ball leaving the top of a robot or goal"});
    visitor(self.friction, {"friction", {0, 2}, "friction between bodies"});
    visitor(self.least_bounce_mps,
            {"least_bounce_mps", {0, 1}, "impacts slower than this do not bounce"});
  }
};

// One robot's body and its drive with four omni wheels; limits are per wheel and overall.
struct RobotParameters {
  double mass_kg = 2.5;
  double speed_mps = kUsualAbilities.speed_mps;
  double acceleration_mps2 = kUsualAbilities.acceleration_mps2;
  double braking_mps2 = kUsualAbilities.braking_mps2;
  double wheel_acceleration_mps2 = 4.5;
  double angular_speed_radps = 15.0;
  double angular_acceleration_radps2 = kUsualTurning_radps2;
  double front_wheels_deg = 35.0;  // wheels at plus and minus this angle
  double back_wheels_deg = 135.0;
  double wheel_distance_m = 80_mm;  // inside the 90 mm hull
  double speed_noise = 0.01;        // fraction of each commanded speed

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    // The minimum is not 0, because Box2D would replace a mass of 0 by 1 kg.
    visitor(self.mass_kg, {"mass_kg", {0.001, 100}, "mass of a robot"});
    visitor(self.speed_mps, {"speed_mps", {0.01, 20}, "top speed"});
    visitor(self.acceleration_mps2, {"acceleration_mps2", positive(100), "maximum acceleration"});
    visitor(self.braking_mps2, {"braking_mps2", positive(100), "maximum deceleration"});
    visitor(self.wheel_acceleration_mps2, {"wheel_acceleration_mps2", positive(100),
                                           "limit on each wheel's tangential acceleration"});
    visitor(self.angular_speed_radps, {"angular_speed_radps", {0.01, 100}, "maximum turning rate"});
    visitor(self.angular_acceleration_radps2,
            {"angular_acceleration_radps2", positive(1000), "maximum angular acceleration"});
    visitor(self.front_wheels_deg,
            {"front_wheels_deg", {5, 85}, "angle of the front wheels from the front"});
    visitor(self.back_wheels_deg,
            {"back_wheels_deg", {95, 175}, "angle of the back wheels from the front"});
    visitor(self.wheel_distance_m,
            {"wheel_distance_m", {0.01, 0.09}, "distance from the robot's centre to each wheel"});
    visitor(self.speed_noise,
            {"speed_noise", {0, 0.5}, "standard deviation as a fraction of the speed"});
  }
};

struct KickerParameters {
  double reach_m = 15_mm;
  double speed_limit_mps = kUsualAbilities.kick_mps;
  double chip_limit_mps = kUsualAbilities.chip_mps;
  double chip_angle_deg = 45.0;
  double dead_time_s = 100_ms;
  double speed_noise = kUsualKickSpeedError;
  double direction_noise_deg = kUsualKickError_deg;
  double chip_angle_noise_deg = 0.0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.reach_m, {"reach_m", {0, 0.1}, "maximum gap between plate and ball"});
    visitor(self.speed_limit_mps, {"speed_limit_mps", {0.1, 20}, "top speed of straight kicks"});
    visitor(self.chip_limit_mps, {"chip_limit_mps", {0.1, 20}, "top speed of chip kicks"});
    visitor(self.chip_angle_deg, {"chip_angle_deg", {5, 85}, "elevation of chip kicks"});
    visitor(self.dead_time_s, {"dead_time_s", {0, 60}, "minimum time between two kicks"});
    visitor(self.speed_noise,
            {"speed_noise", {0, 0.5}, "standard deviation as a fraction of the speed"});
    visitor(self.direction_noise_deg, {"direction_noise_deg", {0, 45}, "standard deviation"});
    visitor(self.chip_angle_noise_deg,
            {"chip_angle_noise_deg", {0, 20}, "standard deviation of a chip's elevation"});
  }
  bool operator==(const KickerParameters&) const = default;
};

// A dribbler that does not hold the ball pulls it towards the plate's centre like a spring, and the
// force saturates at about 5 mm from the centre. The damping is nearly critical for a rolling ball,
// whose effective mass is one and a half times its actual mass.
struct DribblerParameters {
  double force_n = 0.45;
  double force_noise = 0.0;  // drawn each time the dribbler gets hold of the ball
  double reach_m = 10_mm;
  bool holds = false;  // cancels all motion of the ball relative to the plate
  double stiffness_npm = 90.0;
  double damping_nspm = 5.0;
  double centring_mps = 0.2;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.force_n, {"force_n", {0, 100}, "maximum pulling force"});
    visitor(self.force_noise,
            {"force_noise",
             {0, 1},
             "standard deviation of that force as a fraction, from one hold to the next"});
    visitor(self.reach_m, {"reach_m", {0, 0.1}, "maximum gap between plate and ball"});
    visitor(self.holds, {"holds", "holds the ball however the robot moves"});
    visitor(self.stiffness_npm,
            {"stiffness_npm", {0, 1000}, "stiffness of the pull towards the plate's middle"});
    visitor(self.damping_nspm,
            {"damping_nspm", {0, 100}, "damping of the ball's motion along the plate"});
    visitor(self.centring_mps,
            {"centring_mps", {0, 5}, "top speed of a held ball towards the plate's middle"});
  }
  bool operator==(const DribblerParameters&) const = default;
};

// Ball placement: first stops the ball, then carries it over the robots without pushing any robot.
struct PlacementParameters {
  double speed_mps = 3.0;
  double acceleration_mps2 = 4.0;
  double catch_mps2 = 20.0;
  double clearance_m = 50_mm;  // the ball's radius plus a margin

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.speed_mps, {"speed_mps", positive(100), "speed of the ball during placement"});
    visitor(self.acceleration_mps2,
            {"acceleration_mps2", positive(1000), "acceleration of the ball during placement"});
    visitor(self.catch_mps2,
            {"catch_mps2", positive(1000), "deceleration that first stops a moving ball"});
    visitor(self.clearance_m,
            {"clearance_m", {0.025, 0.3}, "minimum distance from a goal to the ball's centre"});
  }
};

// Vision quality. The defaults are the preset `paper`: true positions and the ball's height, as
// reported by the paper's simulator (section 3, "Simulator"). presets.hpp contains other presets.
struct VisionParameters {
  double ball_noise_m = 0.0;
  double robot_noise_m = 0.0;
  double robot_noise_rad = 0.0;
  double ball_misses = 0.0;
  // The fraction of frames that miss a ball at the hull of the nearest robot, kRobotRadius_m from
  // its centre, and the distance over which this fraction falls to 1/e. Both come on top of hiding.
  double ball_misses_near_robots = 0.0;
  double near_robots_m = 120_mm;
  double robot_misses = 0.0;
  double robot_gaps = 0.0;
  double robot_gap_s = 100_ms;
  bool reports_height = true;
  bool robots_hide_ball = false;
  // Laws 2014, section on vision: four cameras at a height of 4 m.
  int cameras = 4;
  double camera_height_m = 4.0;
  double camera_overlap_m = 0.5;
  // Systematic error of each camera, root mean square over the field: a constant offset and a
  // smooth warp. Neighbouring cameras have opposite errors, so they disagree by twice this value.
  double camera_error_m = 0.0;
  double camera_error_rad = 0.0;
  bool cameras_run_freely = false;
  double false_balls_per_s = 0.0;  // each false ball appears in a single frame
  double misread_numbers = 0.0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.ball_noise_m, {"ball_noise_m", {0, 0.1}, "standard deviation along x and y"});
    visitor(self.robot_noise_m, {"robot_noise_m", {0, 0.1}, "standard deviation along x and y"});
    visitor(self.robot_noise_rad,
            {"robot_noise_rad", {0, 0.5}, "standard deviation of the heading"});
    visitor(self.ball_misses, {"ball_misses", {0, 0.9}, "fraction of frames without the ball"});
    visitor(self.ball_misses_near_robots,
            {"ball_misses_near_robots",
             {0, 1},
             "fraction of frames without a ball that is at a robot's hull, in addition"});
    visitor(self.near_robots_m,
            {"near_robots_m", positive(1), "distance over which that fraction falls to 1/e"});
    visitor(self.robot_misses,
            {"robot_misses", {0, 0.9}, "fraction of frames without a robot, each on its own"});
    visitor(self.robot_gaps,
            {"robot_gaps", {0, 0.9}, "fraction of frames without a robot, in longer gaps"});
    visitor(self.robot_gap_s, {"robot_gap_s", {0.01, 10}, "mean duration of such a gap"});
    visitor(
        self.reports_height,
        {"reports_height", "report the ball's height; otherwise the ball appears on the ground"});
    visitor(self.robots_hide_ball,
            {"robots_hide_ball", "robots can hide the ball from the cameras"});
    visitor(self.cameras,
            {"cameras",
             {1, 4},
             "4 above the field's quarters, 2 above its halves or 1 above its centre"});
    visitor(self.camera_height_m, {"camera_height_m", {1, 20}, "height above the carpet"});
    visitor(self.camera_overlap_m,
            {"camera_overlap_m", {0, 5}, "how far each camera sees beyond the middle lines"});
    visitor(self.camera_error_m,
            {"camera_error_m",
             {0, 0.1},
             "systematic error of each camera's positions, drawn for each game"});
    visitor(self.camera_error_rad,
            {"camera_error_rad", {0, 0.5}, "systematic error of each camera's headings"});
    visitor(self.cameras_run_freely,
            {"cameras_run_freely",
             "cameras do not capture at the same time, but at phases drawn for each game"});
    visitor(self.false_balls_per_s,
            {"false_balls_per_s", {0, 10}, "rate of false balls ahead of each robot"});
    visitor(
        self.misread_numbers,
        {"misread_numbers", {0, 0.9}, "fraction of robot detections with a team-mate's number"});
  }
  bool operator==(const VisionParameters&) const = default;
};

struct RadioParameters {
  double command_loss = 0.0;  // probability per robot and frame
  double hold_s = 100_ms;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.command_loss, {"command_loss", {0, 0.9}, "fraction of commands lost"});
    visitor(self.hold_s,
            {"hold_s", {0, 10}, "a robot that receives no command for this long stops"});
  }
};

// Where the robots stand before a game: in rows along the touch line, in their own half. Distances
// are between robots' centres. Even on the smallest field, eight robots fit in a row.
struct LineUpParameters {
  double gap_m = 300_mm;  // gap between neighbours; smaller on short fields
  double from_halfway_line_m = 300_mm;
  double from_touch_line_m = 200_mm;
  double from_goal_line_m = 150_mm;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.gap_m, {"gap_m", {0.19, 1}, "distance between robots before the game"});
    visitor(self.from_halfway_line_m,
            {"from_halfway_line_m", {0.1, 0.35}, "distance to the first robot"});
    visitor(self.from_touch_line_m, {"from_touch_line_m", {0.1, 0.5}, "distance to the first row"});
    visitor(self.from_goal_line_m,
            {"from_goal_line_m", {0.1, 0.35}, "minimum distance to the last robot"});
  }
};

struct Configuration {
  int substeps = 4;
  int contact_free_substeps = 2;  // no effect if >= substeps
  bool free_motion = true;
  double frame_rate_hz = 60.0;
  double latency_s = 5 / 60.0;  // the value in the preset `paper`
  double latency_error_s = 0.0;
  VisionParameters vision;
  RadioParameters radio;
  BallParameters ball;
  ContactParameters contacts;
  PlacementParameters placement;
  LineUpParameters line_up;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.substeps, {"substeps", {1, 16}, "physics steps per frame"});
    visitor(self.contact_free_substeps,
            {"contact_free_substeps",
             {1, 16},
             "physics steps per frame of a body that cannot touch anything"});
    visitor(self.free_motion,
            {"free_motion",
             "bodies that cannot touch anything move without Box2D; false: for comparison"});
    visitor(self.frame_rate_hz, {"frame_rate_hz", {30, 240}, "frames per second"});
    visitor(self.latency_s, {"latency_s", {0, 0.5}, "delay from a frame to the robots' motion"});
    visitor(self.latency_error_s,
            {"latency_error_s",
             {0, 0.1},
             "standard deviation of a team's estimate of that delay, drawn for each game"});
    visitor(self.vision, {"vision", "what the cameras report"});
    visitor(self.radio, {"radio", "commands on their way to the robots"});
    visitor(self.ball, {"ball", "how the ball slides, rolls and hops"});
    visitor(self.contacts, {"contacts", "what happens when bodies meet"});
    visitor(self.placement, {"placement", "how the simulator places the ball"});
    visitor(self.line_up, {"line_up", "where the robots stand before the game"});
  }
};

// The range of the factors by which a handicap can scale a robot's top speed or acceleration.
inline constexpr Range kFactorRange = positive(2);

// One robot and its handicap.
struct RobotSpec {
  RobotParameters body;
  KickerParameters kicker;
  DribblerParameters dribbler;
  double speed_factor = 1.0;         // scales the top speed
  double acceleration_factor = 1.0;  // scales acceleration and braking, including the wheels' limit

  // Visits all parameters except the factors, which belong to the robot's team.
  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.body, {"robot", "the robots' bodies and drives"});
    visitor(self.kicker, {"kicker", "how they kick"});
    visitor(self.dribbler, {"dribbler", "how they dribble"});
  }
};

// The robots of one side, by number.
struct TeamSpec {
  using Robots = boost::container::static_vector<RobotSpec, kMaxRobots>;
  Robots robots;
};

// These functions throw OutOfRange for the first invalid value. If the robots of both sides are
// checked, the std::invalid_argument also gives the robot's side and number, for example "east
// robot 3: robot.mass_kg is 0; ...".
void validate(const Configuration& configuration);
void validate(const RobotSpec& robot);
void validate(const PerSide<TeamSpec>& specs);
void validate(const Field& field);

// The maximum speed that a body can have with the configured number of sub-steps; Box2D slows down
// faster bodies.
double fastest_mps(const Configuration& configuration);

// The maximum speed at which a robot can drive or kick.
double fastest_mps(const RobotSpec& robot);

}  // namespace autoref::sim
