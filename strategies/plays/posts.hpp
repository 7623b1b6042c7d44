// Posts: places that a play wants filled, each by the same robot for as long as that makes sense.
#pragma once

#include <boost/container/static_vector.hpp>

#include "strategies/plays/plays.hpp"

namespace autoref::strategies {

struct Post {
  int key = 1;  // names the post from frame to frame, from 1 on: a zone's number, an opponent's
  Waypoint place;
};
using Posts = boost::container::static_vector<Post, kMaxRobots>;  // the most important first

// Gives each post a robot: the one that had it, else the nearest without one; two change where
// that shortens their ways clearly. Who has another part now gives its post up.
void man_posts(Playbook& book, Cast& cast, const Posts& posts);

// The same, but the robot at the ball keeps its post, which stays empty meanwhile. Those of the
// first `count` posts go there; the others' robots stay free for something else.
void man_own_posts(Playbook& book, Cast& cast, const Posts& posts, int count = kMaxRobots);

// Those `count` of the free robots that are farthest ahead run for passes.
void send_ahead(Playbook& book, Cast& cast, int count);

// `place_m`, far enough from the opponents' area for every rule, and `more_m` farther; facing the
// ball.
Waypoint off_their_area(const Outlook& outlook, const Vec2& place_m, double more_m = 0);

}  // namespace autoref::strategies
