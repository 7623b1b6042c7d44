// How the ball bounces in a recorded game.
#pragma once

#include <vector>

#include "logs/fit/bounces.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"
#include "sim/sim_configuration.hpp"

namespace autoref::logs {

// Collects bounces. The estimates are weighted medians of their restitutions.
class ContactFit {
 public:
  // Of `ball`, slide_mps2, roll_mps2, roll_per_s and switch_ratio are used.
  explicit ContactFit(const sim::BallParameters& ball) : ball_(ball) {}

  void add(const RecordedMotion& motion);

  // sim.contacts.wall_restitution. A game in which the ball is never left to bounce off the walls
  // does not show it.
  Estimate wall_restitution() const;
  // sim.contacts.body_restitution.
  Estimate body_restitution() const;

 private:
  sim::BallParameters ball_;
  std::vector<Bounce> off_walls_;
  std::vector<Bounce> off_bodies_;
};

}  // namespace autoref::logs
