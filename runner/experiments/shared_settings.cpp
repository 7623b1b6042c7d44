#include "runner/experiments/shared_settings.hpp"

#include <utility>

namespace autoref::runner {

SharedSettings::SharedSettings(GameSettings game)
    : leg_{game.match.a_plays, game.match.first_kickoff, game.seed} {
  game.given.clear();
  const auto base = std::make_shared<const GameSettings>(std::move(game));
  a_ = {base, &base->a};
  b_ = {base, &base->b};
  base_ = base;
}

SharedSettings SharedSettings::between(std::shared_ptr<const TeamSettings> a,
                                       std::shared_ptr<const TeamSettings> b) const {
  SharedSettings other = *this;
  other.a_ = std::move(a);
  other.b_ = std::move(b);
  return other;
}

SharedSettings SharedSettings::with(const LegSettings& leg) const {
  SharedSettings other = *this;
  other.leg_ = leg;
  return other;
}

SharedSettings SharedSettings::starting_from(std::shared_ptr<const StartState> start) const {
  SharedSettings other = *this;
  other.start_ = std::move(start);
  return other;
}

GameSettings SharedSettings::whole() const {
  GameSettings game = *base_;
  game.a = *a_;
  game.b = *b_;
  game.match.a_plays = leg_.a_plays;
  game.match.first_kickoff = leg_.first_kickoff;
  game.seed = leg_.seed;
  if (start_) game.start = leg_.a_plays == Side::kWest ? *start_ : mirrored(*start_);
  return game;
}

}  // namespace autoref::runner
