// Who sent the ball on a way of a story: a robot, a goal's post or wall, or nobody.
//
// A robot must have been where the way before leads and where the way after comes from
// (meetings.hpp). The way before is known when the story begins; the way after shows in the
// sightings that follow.
#pragma once

#include <cstdint>

#include "referee/touch/story.hpp"

namespace autoref::referee {

// Whether a robot or a goal may have been at the ball's way from the picture `former` to the
// picture `now`; `onwards_m` is where it would be had nobody touched it.
bool may_be_touched(const StoryBasis& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m);

// What a touch by a goal's post or wall between these pictures costs by the way before; kNever
// where there was none.
double cost_of_goal(const StoryBasis& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m);

// The robots that may have touched the ball between the pictures `before` and `start` of the story,
// whose way still is the one before.
void find_senders(Story& story, const StoryBasis& basis);

// Weighs who sent the ball on the story's way, with its sightings until the picture `now`. Once
// eight tell where it comes from, the explanations stay.
void explain(Story& story, std::int64_t now, const StoryBasis& basis);

}  // namespace autoref::referee
