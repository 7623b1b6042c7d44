// The order of a shoot-out's kicks, and when it is decided (Laws 2014, appendix A; 2026).
//
// The sides alternate. The side that kicked off the game begins, so lots are drawn only for the
// ends of the field and the kick-off.
#pragma once

#include "referee/configuration.hpp"
#include "referee/machine/referee_state.hpp"

namespace autoref::referee {

// A shoot-out still level after this many kicks per side is a draw. This is AutoRef's own limit,
// for teams that cannot score.
inline constexpr int kMostShootoutKicks = 50;

Side next_kicker(const ShootoutBook& book, const Configuration& configuration);

// Whether the remaining kicks cannot change the winner. Each side has `kicks` kicks; after those,
// each side gets one more at a time.
bool is_decided(const ShootoutBook& book, int kicks);

// Whether the shoot-out is decided or the limit is reached.
bool is_over(const ShootoutBook& book, int kicks);

}  // namespace autoref::referee
