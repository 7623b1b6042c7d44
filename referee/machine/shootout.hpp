// The order of a shoot-out's kicks, and when it is decided (Laws 2014, appendix A; 2026).
//
// The sides kick in turns; whoever kicked off the game begins, so that the choice of sides and of
// the kick-off is all that there is to draw lots for.
#pragma once

#include "referee/configuration.hpp"
#include "referee/machine/referee_state.hpp"

namespace autoref::referee {

// A shoot-out still level after so many kicks of each side is a draw: ours, for teams that cannot
// shoot.
inline constexpr int kMostShootoutKicks = 50;

Side next_kicker(const ShootoutBook& book, const Configuration& configuration);

// Whether no kick that is left can change who wins: of `kicks` each, and then of one more each.
bool is_decided(const ShootoutBook& book, int kicks);

// Whether it is decided, or has gone on for too long.
bool is_over(const ShootoutBook& book, int kicks);

}  // namespace autoref::referee
