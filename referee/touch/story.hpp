// A story of what the ball did: free ways joined by touches.
//
// Its costs are minus twice the logarithms of likelihoods, up to a constant that all stories share;
// they have no unit.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/decision.hpp"
#include "referee/touch/free_way.hpp"
#include "referee/touch/meetings.hpp"
#include "referee/touch/pictures.hpp"
#include "referee/touch/story_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// What stories are told of.
struct StoryBasis {
  const Field& field;
  const StoryParameters& parameters;
  const Pictures& pictures;
};

// Whose touch was the last.
enum Toucher : std::size_t { kNobody, kWest, kEast };
inline Toucher toucher_of(Side side) { return side == Side::kWest ? kWest : kEast; }

// The cheapest explanations by whose touch was the last.
struct Explanations {
  std::array<double, 3> cost{kNever, kNever, kNever};
  std::array<LastTouch, 3> touch;

  double least() const;
  void offer(Toucher toucher, double offered_cost, const LastTouch& offered_touch);
};

// A robot that may have sent the ball on its way.
struct Sender {
  RobotId robot;
  double seen_gap_m = 1;   // to the ball's first sighting on its way
  double bounce_cost = 0;  // of the way before, for a bounce and for a kick
  double kick_cost = 0;
  double time_s = 0;  // of the likeliest touch, and the gap then
  double gap_m = 0;
};

struct Story {
  FreeWay way;
  std::int64_t start = 0;   // the first picture of the way
  std::int64_t before = 0;  // the one with a ball before it; the same where nothing is known of it
  int sightings = 0;        // of the way
  bool is_soft = false;     // whether the touch that the way begins with was
  bool jumps = false;       // or the ball's place jumped instead
  double way_cost = 0;      // of the way's sightings
  Vec2 before_mps{0, 0};    // velocity before the touch
  double goal_cost = kNever;    // of the way before, for a goal's post or wall
  double cost_until_touch = 0;  // of the way before, and of a robot's touch at all
  Explanations untouched;       // where no robot sent the ball on this way
  boost::container::static_vector<Sender, 2 * kMaxRobots> senders;
  Explanations explained;  // until this way, with who sent the ball on it

  double cost() const { return explained.least() + way_cost; }
};

}  // namespace autoref::referee
