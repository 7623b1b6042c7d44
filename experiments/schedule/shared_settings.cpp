#include "experiments/schedule/shared_settings.hpp"

#include <utility>

namespace autoref::experiments {

SharedSettings::SharedSettings(game::GameSettings game)
    : leg_{game.match.a_plays, game.match.first_kickoff, game.seed} {
  game.given.clear();
  const auto base = std::make_shared<const game::GameSettings>(std::move(game));
  a_ = {base, &base->a};
  b_ = {base, &base->b};
  base_ = base;
}

SharedSettings SharedSettings::between(std::shared_ptr<const game::TeamSettings> a,
                                       std::shared_ptr<const game::TeamSettings> b) const {
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

SharedSettings SharedSettings::starting_from(std::shared_ptr<const game::StartState> start) const {
  SharedSettings other = *this;
  other.start_ = std::move(start);
  return other;
}

game::GameSettings SharedSettings::whole() const {
  game::GameSettings game = *base_;
  game.a = *a_;
  game.b = *b_;
  game.match.a_plays = leg_.a_plays;
  game.match.first_kickoff = leg_.first_kickoff;
  game.seed = leg_.seed;
  if (start_) game.start = leg_.a_plays == Side::kWest ? *start_ : game::mirrored(*start_);
  return game;
}

}  // namespace autoref::experiments
