// What a simulated world is made of, as plain numbers.
#pragma once

#include <boost/container/static_vector.hpp>

#include "soccer/field.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {

// Two-phase ball on carpet: it slides after a kick, then rolls.
struct BallParameters {
  double slide_mps2 = 3.4;           // deceleration while sliding
  double roll_mps2 = 0.30;           // deceleration while rolling
  double switch_ratio = 0.67;        // rolls once slower than this share of the kick's speed
  double hop_first_xy = 0.75;        // share of the horizontal speed kept at a chip's first landing
  double hop_later_xy = 0.95;        // and at later ones
  double hop_z = 0.5;                // share of the vertical speed kept at each landing
  double rest_mps = 0.010;           // at rest below
  double rolls_below_hop_m = 0.010;  // a hop lower than this ends the flight
  double net_mps2 = 10.0;  // what a ball loses inside a goal on its way out: the net holds it
  double mass_kg = 0.046;  // golf ball, 46 g (Laws 2014, law 2)
  // Friction between the ball and what it hits, which takes some of its spin; the league's
  // simulators use 0.2 to 0.35.
  double contact_friction = 0.22;
};

// What happens where two bodies meet. A restitution is the share of the closing speed that is left
// as speed apart; Box2D takes the greater one of a pair. Sources: ER-Force's and grSim's models,
// and measurements of the league's robots.
struct ContactParameters {
  double body_restitution = 0.55;      // ball against a robot's round hull
  double plate_restitution = 0.4;      // ball against a front plate
  double dribbling_restitution = 0.2;  // ball against a front plate whose dribbler runs
  double robot_restitution = 0.2;      // robot against robot
  double wall_restitution = 0.3;       // walls around the field and sides of the goals
  double net_restitution = 0.1;        // a goal's back
  double bar_restitution = 0.3;        // ball against the bar, as at the goal's sides
  // Share of the vertical speed that a ball keeps when it comes down on a robot or on a goal's net,
  // as on the carpet.
  double top_restitution = 0.5;
  // It leaves them at least this fast, upwards and to the outside, so that none stays up there.
  double top_leaving_mps = 0.5;
  double friction = 0.22;  // of bodies that slide along each other (grSim)
  // Slower hits do not bounce: a ball that lies at a plate must come to rest there.
  double least_bounce_mps = 0.03;
};

// One robot's body and drive. Four omni wheels; limits are per wheel and overall.
struct RobotParameters {
  double mass_kg = 2.5;
  double speed_mps = 3.0;                // top speed (paper, section 3: up to 3 m/s)
  double acceleration_mps2 = 3.0;        // overall limit when speeding up
  double braking_mps2 = 5.0;             // overall limit when slowing down
  double wheel_acceleration_mps2 = 4.5;  // tangential limit of each wheel
  double angular_speed_radps = 15.0;
  double angular_acceleration_radps2 = 40.0;
  double front_wheels_deg = 35.0;  // wheels at plus and minus this angle from the front
  double back_wheels_deg = 135.0;
  double wheel_distance_m = 80_mm;  // from the centre to each wheel, inside the hull of 90 mm
  double speed_noise = 0.01;        // standard deviation of each speed a robot aims at, share of it
};

struct KickerParameters {
  double reach_m = 15_mm;        // the ball's surface within this distance of the plate
  double speed_limit_mps = 8.0;  // paper, section 3
  double chip_limit_mps = 5.5;
  double chip_angle_deg = 45.0;
  double dead_time_s = 100_ms;       // between two kicks
  double speed_noise = 0.025;        // standard deviation, share of the speed
  double direction_noise_deg = 1.5;  // standard deviation
};

struct DribblerParameters {
  double force_n = 0.45;   // the most it pulls the ball with
  double reach_m = 10_mm;  // the ball's surface within this distance of the plate
  bool holds = false;      // takes all of the ball's motion relative to the plate
  // A dribbler that does not hold pulls the ball towards the plate's middle like a spring, at its
  // limit from about 5 mm off. The damping is near critical for a rolling ball, which resists as
  // one and a half times its mass.
  double stiffness_npm = 90.0;
  double damping_nspm = 5.0;
  double centring_mps = 0.2;  // the fastest that one which holds moves the ball along the plate
  bool operator==(const DribblerParameters&) const = default;
};

// The referee's hand: it first stops the ball, then carries it over the robots and pushes none.
struct PlacementParameters {
  double speed_mps = 3.0;  // of the ball while it is dragged
  double acceleration_mps2 = 4.0;
  double catch_mps2 = 20.0;  // what a ball still moving loses before it is dragged
  // The ball's centre passes the goals this far off: its radius and a margin.
  double clearance_m = 50_mm;
};

// How well vision sees. Defaults are the preset `paper`: true positions and the ball's height, as
// the paper's simulator reported them (section 3, "Simulator"). camera_presets.hpp has others.
struct VisionParameters {
  double ball_noise_m = 0.0;  // standard deviation of each coordinate
  double robot_noise_m = 0.0;
  double robot_noise_rad = 0.0;
  double ball_misses = 0.0;    // share of the frames in which a ball in sight is missed
  double robot_misses = 0.0;   // and a robot
  bool reports_height = true;  // else a flying ball is seen before the carpet
  bool robots_hide_ball = false;
  // Four cameras hang above the middles of the field's quarters, 4 m high (Laws 2014, section
  // on vision); each sees its quarter and this much beyond the middle lines.
  double camera_height_m = 4.0;
  double camera_overlap_m = 0.5;
  bool operator==(const VisionParameters&) const = default;
};

struct RadioParameters {
  double command_loss = 0.0;  // share of the commands that do not arrive, by robot and frame
  double hold_s = 100_ms;     // a robot without an order for so long stops
};

// Where the robots stand before a game: in rows along the touch line, in their own half. Distances
// are those of robots' centres.
struct LineUpParameters {
  double gap_m = 300_mm;                // between neighbours; less on short fields
  double from_halfway_line_m = 300_mm;  // of the first in a row
  double from_touch_line_m = 200_mm;
  double from_goal_line_m = 150_mm;  // at least, of the last
};

struct Configuration {
  int substeps = 4;  // physics steps per camera frame, 1 to 16
  int contact_free_substeps =
      2;  // and while nothing can meet anything; as many or more: no difference
  double frame_rate_hz = 60.0;
  VisionParameters vision;
  RadioParameters radio;
  double latency_s = 40_ms;  // from a frame until the commands decided on it move the robots
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
  double acceleration_factor = 1.0;  // scales acceleration and braking, the wheels' limit too
};

// The robots of one side, by number.
struct TeamSpec {
  using Robots = boost::container::static_vector<RobotSpec, kMaxRobots>;
  Robots robots;
};

// Throw std::invalid_argument that names the field, its value and the allowed range; for a robot
// also its side and number, such as "east robot 3: robot.mass_kg is 0; ...".
void validate(const Configuration& configuration);
void validate(const RobotSpec& robot);
void validate(const PerSide<TeamSpec>& specs);
void validate(const Field& field);

// The fastest that a body can be with as many sub-steps: Box2D slows down what is faster.
double fastest_mps(const Configuration& configuration);

// The fastest that a robot may drive or kick.
double fastest_mps(const RobotSpec& robot);

}  // namespace autoref::sim
