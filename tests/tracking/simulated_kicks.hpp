// Kicks simulated with the ball models of the league's simulators, and the resulting
// detections, without heights.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "soccer/random.hpp"
#include "soccer/trigonometry.hpp"
#include "tracking/chip_flight.hpp"

namespace autoref::tracking {

inline constexpr double kCameraHeight_m = 4_m;

// How balls decelerate and bounce in the league's simulators.
struct BallModel {
  double slide_mps2 = 0;
  double roll_mps2 = 0;
  double rolls_below = 0;  // fraction of the kick's speed
  double along_first = 0;  // fractions of the speed kept by bounces
  double along_later = 0;
  double upwards = 0;
};
inline constexpr std::array<BallModel, 4> kModels = {{{.slide_mps2 = 3.4,
                                                       .roll_mps2 = 0.30,
                                                       .rolls_below = 0.67,
                                                       .along_first = 0.75,
                                                       .along_later = 0.95,
                                                       .upwards = 0.5},
                                                      {.slide_mps2 = 3.92,
                                                       .roll_mps2 = 0.35,
                                                       .rolls_below = 0.69,
                                                       .along_first = 0.715,
                                                       .along_later = 1.0,
                                                       .upwards = 0.566},
                                                      {.slide_mps2 = 3.0,
                                                       .roll_mps2 = 0.26,
                                                       .rolls_below = 0.667,
                                                       .along_first = 0.8,
                                                       .along_later = 0.85,
                                                       .upwards = 0.47},
                                                      {.slide_mps2 = 10.3,
                                                       .roll_mps2 = 0.70,
                                                       .rolls_below = 0.70,
                                                       .along_first = 0.59,
                                                       .along_later = 0.95,
                                                       .upwards = 0.49}}};

struct Kick {
  double time_s = 0;
  Vec2 from_m{0, 0};
  Vec2 along{1, 0};
  double speed_mps = 0;  // along the carpet
  double rise_mps = 0;   // 0: a straight kick
  BallModel model = kModels[0];

  double landing_s() const { return time_s + 2 * rise_mps / kGravity_mps2; }
  Vec2 landing_m() const { return from_m + along * speed_mps * (landing_s() - time_s); }
  bool is_up(double at_s) const { return at_s > time_s && at_s < landing_s(); }
};

struct Truth {
  Vec2 position_m{0, 0};
  double height_m = 0;
};

inline double rolled_m(const Kick& kick, double t) {
  const double v = kick.speed_mps;
  const BallModel& m = kick.model;
  const double slides_s = std::min(t, (1 - m.rolls_below) * v / m.slide_mps2);
  const double rolls_s = std::min(t - slides_s, m.rolls_below * v / m.roll_mps2);
  return v * slides_s - m.slide_mps2 / 2 * slides_s * slides_s + m.rolls_below * v * rolls_s -
         m.roll_mps2 / 2 * rolls_s * rolls_s;
}

// A flight with bounces, after which the ball keeps a constant velocity.
inline Truth flight_at(const Kick& kick, double t) {
  double along_m = 0;
  double speed = kick.speed_mps;
  double rise = kick.rise_mps;
  for (bool first = true; rise * rise > 2 * kGravity_mps2 * 10_mm; first = false) {
    const double hop_s = 2 * rise / kGravity_mps2;
    const double up_s = std::min(t, hop_s);
    along_m += speed * up_s;
    if (t < hop_s) {
      return {kick.from_m + kick.along * along_m, rise * t - kGravity_mps2 / 2 * t * t};
    }
    t -= hop_s;
    speed *= first ? kick.model.along_first : kick.model.along_later;
    rise *= kick.model.upwards;
  }
  return {kick.from_m + kick.along * (along_m + speed * t), 0};
}

inline Truth truth_at(const Kick& kick, double time_s) {
  const double t = std::max(time_s - kick.time_s, 0.0);
  if (kick.rise_mps > 0) return flight_at(kick, t);
  return {kick.from_m + kick.along * rolled_m(kick, t), 0};
}

// The detection by the camera above the quarter of a 9 x 6 m field that the ball is in.
inline BallDetection seen(const Truth& truth, double time_s) {
  const Vec2 camera(truth.position_m.x() < 0 ? -2.25 : 2.25, truth.position_m.y() < 0 ? -1.5 : 1.5);
  const double stretch = kCameraHeight_m / (kCameraHeight_m - truth.height_m);
  return {time_s, camera + (truth.position_m - camera) * stretch, camera, kCameraHeight_m};
}

struct Vision {
  double noise_m;
  RandomStream chance;

  BallDetection see(const Truth& truth, double time_s) {
    BallDetection detection = seen(truth, time_s);
    const double x = chance.normal();
    const double y = chance.normal();
    detection.reported_m += noise_m * Vec2(x, y);
    return detection;
  }
  bool misses() { return chance.uniform() < 0.05; }
};

inline Kick any_kick(RandomStream& chance) {
  Kick kick;
  kick.model = kModels[static_cast<std::size_t>(4 * chance.uniform())];
  kick.time_s = (1 + chance.uniform()) / 60;
  kick.from_m.x() = 9 * chance.uniform() - 4.5;
  kick.from_m.y() = 6 * chance.uniform() - 3;
  kick.along = heading_of(2 * kPi * chance.uniform());
  return kick;
}

inline Kick straight_kick(RandomStream& chance) {
  Kick kick = any_kick(chance);
  kick.speed_mps = 1 + 5.5 * chance.uniform();
  return kick;
}

inline Kick chip_inside_the_field(RandomStream& chance) {
  for (int tries = 0; tries < 1000; ++tries) {
    Kick kick = any_kick(chance);
    kick.speed_mps = (2 + 3.5 * chance.uniform()) / std::sqrt(2.0);
    kick.rise_mps = kick.speed_mps;
    const Vec2 end_m = kick.landing_m();
    if (std::abs(end_m.x()) < 4.5 && std::abs(end_m.y()) < 3) return kick;
  }
  throw std::logic_error("no chip lands inside the field");
}

// Feeds one kick to an estimator at 60 Hz and calls `look(time, truth, estimate)` at each
// detection.
template <class Look>
void follow(const Kick& kick, Vision& vision, double until_s, Look look) {
  ChipFlight flight(vision.noise_m);
  BallDetection before = vision.see(truth_at(kick, 0), 0);
  for (int n = 1; n < 60 * until_s; ++n) {
    const double time_s = n / 60.0;
    const Truth truth = truth_at(kick, time_s);
    const BallDetection detection = vision.see(truth, time_s);
    if (vision.misses()) continue;
    if (time_s > kick.time_s && before.time_s <= kick.time_s) {
      flight.begin({(before.time_s + time_s) / 2, (time_s - before.time_s) / std::sqrt(12.0),
                    before.reported_m, vision.noise_m});
    }
    before = detection;
    if (time_s > kick.time_s) look(time_s, truth, flight.add(detection));
  }
}

}  // namespace autoref::tracking
