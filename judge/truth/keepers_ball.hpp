// Whose keeper has the ball.
#pragma once

#include "judge/truth/scene.hpp"

namespace autoref::judge::ground_truth {

// Whether only the keeper of `side` may keep the ball. Laws 2014: the ball is inside its defence
// area, in contact with it. 2026: the ball is inside the area, for whatever reason.
bool is_keepers_ball(const Scene& scene, Side side);

}  // namespace autoref::judge::ground_truth
