// The settings of one of many games, most of which it shares with the others.
#pragma once

#include <cstdint>
#include <memory>

#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// What differs between the games of two teams: their sides, the first kick-off and the seed.
struct LegSettings {
  Side a_plays = Side::kWest;
  Side first_kickoff = Side::kWest;
  std::uint64_t seed = 42;
};

// An experiment has up to 100,000 games, but few different settings: those of a game take 4.5 kB
// and more, these about 0.1 kB. Copies share their parts.
class SharedSettings {
 public:
  // The settings as they are. Which of them were given explicitly is forgotten, since presets have
  // been applied.
  explicit SharedSettings(game::GameSettings game);

  // The same game with other teams, another leg, or the start of a scene as it is with team a in
  // the west: it is turned if that team plays in the east.
  SharedSettings between(std::shared_ptr<const game::TeamSettings> a,
                         std::shared_ptr<const game::TeamSettings> b) const;
  SharedSettings with(const LegSettings& leg) const;
  SharedSettings starting_from(std::shared_ptr<const game::StartState> start) const;

  const LegSettings& leg() const { return leg_; }
  const game::TeamSettings& a() const { return *a_; }
  const game::TeamSettings& b() const { return *b_; }

  // All settings of the game.
  game::GameSettings whole() const;

 private:
  std::shared_ptr<const game::GameSettings> base_;
  std::shared_ptr<const game::TeamSettings> a_;
  std::shared_ptr<const game::TeamSettings> b_;
  std::shared_ptr<const game::StartState> start_;  // of team a in the west; null: the base's
  LegSettings leg_;
};

}  // namespace autoref::experiments
